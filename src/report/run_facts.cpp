#include "report/run_facts.hpp"

#include <fmt/format.h>

#include <cmath>

#include "record/flow_fields.hpp"
#include "record/run_fields.hpp"

namespace riffle::inline report {

std::string grouped_number(double value) {
    std::string digits = fmt::format("{:.0f}", value);
    for (std::size_t from_end = 3; from_end < digits.size(); from_end += 3 + 3) {
        digits.insert(digits.size() - from_end, "\u2009");  // three bytes in UTF-8
    }
    return digits;
}

std::string computing_time_text(double seconds) {
    if (seconds < 120) return fmt::format("{:.1f} s", seconds);
    const auto minutes = static_cast<long long>(std::lround(seconds / 60));
    if (minutes < 120) return fmt::format("{:.1f} min", seconds / 60);
    return fmt::format("{} h {:02d} min", minutes / 60, minutes % 60);
}

std::vector<Fact> run_facts(const ReportData& data) {
    std::vector<Fact> facts;
    const auto value = [&](const Field& field) { return find_value(data.summary, field); };
    facts.push_back({"State", !data.failure.empty() ? "failed"
                              : data.complete       ? "complete"
                                                    : "not complete"});
    if (data.series.has(fields::time_series.time)) {
        facts.push_back({"Simulated time", fmt::format("{:.2f} s", recorded_time(data))});
    }
    if (data.window_end > data.window_start) {
        std::string text = fmt::format("{:.2f} to {:.2f} s", data.window_start, data.window_end);
        if (data.profile_samples > 0) {
            text += fmt::format(", {} samples", grouped_number(data.profile_samples));
        }
        facts.push_back({"Averaging window", text});
    }
    if (const auto particles = value(fields::summary.particles)) {
        facts.push_back({"Particles", grouped_number(*particles)});
    }
    facts.push_back({"Particle spacing", fmt::format("{:.3g} mm", 1000 * data.flow.numerics.spacing)});
    if (const auto steps = value(fields::summary.steps)) {
        facts.push_back({"Time steps", grouped_number(*steps)});
    }
    if (const auto seconds = value(fields::summary.wall_clock_seconds)) {
        facts.push_back({"Computing time", computing_time_text(*seconds)});
    }
    if (const auto speed = value(fields::summary.particle_updates_per_second)) {
        facts.push_back({"Speed", fmt::format("{:.2f} million particle updates per second", *speed / 1e6)});
    }
    if (!data.riffle_version.empty()) facts.push_back({"Riffle", data.riffle_version});
    if (!data.build.empty()) facts.push_back({"Build", data.build});
    if (!data.created.empty()) facts.push_back({"Results created", data.created});
    facts.push_back({"Results file", data.source.filename().string()});
    if (!data.flow.measured.source.empty()) facts.push_back({"Measured values", data.flow.measured.source});
    return facts;
}

}  // namespace riffle::inline report
