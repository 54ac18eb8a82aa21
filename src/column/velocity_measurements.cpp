#include "column/velocity_measurements.hpp"

#include <fmt/format.h>

#include <cmath>
#include <cstddef>
#include <filesystem>
#include <system_error>

#include "base/error.hpp"
#include "hydraulics/channel_laws.hpp"
#include "laboratory/profile_record.hpp"

namespace riffle::inline column {

VelocityMeasurements read_velocity_measurements(const Case& c) {
    const std::filesystem::path& path = c.measured.velocity_profile;
    std::error_code error;
    if (!std::filesystem::exists(path, error)) {
        throw FileError(fmt::format(
            "{}: cannot be read (measured.velocity_profile): give an existing CSV file", path.string()));
    }
    const ProfileRecord record = read_profile_record(path);
    const ProfileColumn* velocity = record.find(ProfileQuantity::velocity);
    if (velocity == nullptr) {
        throw FileError(fmt::format(
            "{}: expected a column u in this measured profile (measured.velocity_profile)", path.string()));
    }
    VelocityMeasurements result;
    for (std::size_t i = 0; i < record.z.size(); ++i) {
        const double height = c.datum() + record.z[i];
        if (!(height > 0.0) || height > c.total_depth()) {
            throw FileError(fmt::format(
                "{}: expected z within the water, {:.6g} to {:.6g} m above the datum, got {:.6g} m",
                record.place(i), -c.datum(), c.channel.depth, record.z[i]));
        }
        const bool weighted = !velocity->uncertainty.empty();
        if (std::isnan(velocity->values[i]) || (weighted && std::isnan(velocity->uncertainty[i]))) {
            throw FileError(fmt::format("{}: expected a number for u{}, it is missing", record.place(i),
                                        weighted ? " and its uncertainty" : ""));
        }
        result.height.push_back(height);
        result.velocity.push_back(velocity->values[i]);
        if (weighted) result.uncertainty.push_back(velocity->uncertainty[i]);
    }
    return result;
}

void check_velocity_measurements(const Case& c) {
    if (!c.measured.velocity_profile.empty()) static_cast<void>(read_velocity_measurements(c));
}

VelocityMeasurements measured_log_law(const Case& c, int points) {
    VelocityMeasurements result;
    if (!c.measured.friction_velocity || !c.measured.equivalent_roughness) return result;
    for (int i = 0; i < points; ++i) {
        const double z = c.crest() + (c.total_depth() - c.crest()) * (i + 0.5) / points;
        result.height.push_back(z);
        result.velocity.push_back(
            rough_log_law(z - c.datum(), *c.measured.friction_velocity, *c.measured.equivalent_roughness));
    }
    return result;
}

}  // namespace riffle::inline column
