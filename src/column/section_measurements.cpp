#include "column/section_measurements.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "base/error.hpp"

namespace riffle::inline column {

SectionPoints section_points_of(const SectionRecord& record, const Case& c) {
    SectionPoints points;
    points.name = record.title.empty() ? record.source.stem().string() : record.title;
    const double width = c.channel.width;
    for (std::size_t i = 0; i < record.y.size(); ++i) {
        double y = record.y[i] + (record.origin == LateralOrigin::centreline ? 0.5 * width : 0.0);
        const double tolerance = 1e-9 * width;
        if (y < -tolerance || y > width + tolerance) {
            throw FileError(
                fmt::format("{}: expected y within the channel, {} to {:.6g} m from {}, got {:.6g} m",
                            record.place(i), record.origin == LateralOrigin::centreline ? -0.5 * width : 0.0,
                            record.origin == LateralOrigin::centreline ? 0.5 * width : width,
                            record.origin == LateralOrigin::centreline ? "the centreline" : "the side wall",
                            record.y[i]));
        }
        if (c.channel.dimensions == 3 && c.channel.sides == Sides::half) y = std::min(y, width - y);
        const double z = record.z[i] + c.datum();
        if (z <= 0.0 || z > c.total_depth()) {
            throw FileError(
                fmt::format("{}: expected z within the water, {:.6g} to {:.6g} m above the datum, got "
                            "{:.6g} m",
                            record.place(i), -c.datum(), c.channel.depth, record.z[i]));
        }
        points.y.push_back(y);
        points.z.push_back(z);
    }
    const auto values = [&](ProfileQuantity quantity) {
        const ProfileColumn* const found = record.find(quantity);
        return found == nullptr ? std::vector<double>{} : found->values;
    };
    points.velocity = values(ProfileQuantity::velocity);
    if (const ProfileColumn* const u = record.find(ProfileQuantity::velocity)) {
        points.uncertainty = u->uncertainty;
    }
    points.spanwise_velocity = values(ProfileQuantity::spanwise_velocity);
    points.vertical_velocity = values(ProfileQuantity::vertical_velocity);
    points.reynolds_stress = values(ProfileQuantity::reynolds_stress);
    return points;
}

}  // namespace riffle::inline column
