#include <unistd.h>

#include <cmath>
#include <fstream>
#include <functional>

#include "base/error.hpp"
#include "feed.hpp"
#include "laboratory/probe_calibration.hpp"
#include "laboratory/probe_record.hpp"
#include "laboratory/profile_record.hpp"
#include "laboratory/velocity_series.hpp"

namespace riffle::inputs {

namespace {

/// Whether a reader takes a file; a refusal names the file first.
bool takes(const std::filesystem::path& path, const std::function<void()>& read) {
    try {
        read();
        return true;
    } catch (const Error& e) {
        if (!std::string(e.what()).starts_with(path.string())) {
            throw Failure(std::string("an error message without its place: ") + e.what());
        }
        return false;
    }
}

void require_finite(double value, const char* what) {
    if (!std::isfinite(value)) throw Failure(std::string("a record is taken with no finite ") + what);
}

}  // namespace

Answer feed_csv(std::string_view input) {
    const std::filesystem::path path =
        std::filesystem::temp_directory_path() / ("riffle-input-" + std::to_string(getpid()) + ".csv");
    std::ofstream(path, std::ios::binary) << input;
    bool taken = takes(path, [&] {
        const ProfileRecord profile = read_profile_record(path);
        for (const double z : profile.z) require_finite(z, "height");
    });
    taken |= takes(path, [&] {
        const VelocitySeries series = read_velocity_series(path);
        require_finite(series.sampling_frequency, "frequency");
        try {
            static_cast<void>(point_statistics(series));
        } catch (const InputError&) {
            // fewer than two samples: it speaks of the record, which has no line
        }
    });
    taken |= takes(path, [&] {
        const ProbeRecord record = read_probe_record(path);
        require_finite(record.sampling_frequency, "frequency");
    });
    taken |= takes(path, [&] { static_cast<void>(read_probe_calibrations(path)); });
    std::filesystem::remove(path);
    return taken ? Answer::taken : Answer::refused;
}

}  // namespace riffle::inputs
