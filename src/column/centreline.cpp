#include "column/centreline.hpp"

#include <cstddef>
#include <vector>

#include "case/bed_friction.hpp"
#include "column/section.hpp"
#include "hydraulics/channel_laws.hpp"

namespace riffle::inline column {

LogLawFit fit_column_profile(const Case& c, const ColumnResult& column) {
    constexpr int points = 200;
    const HeightRange range = log_law_range(c);
    std::vector<double> z;
    std::vector<double> u;
    for (int i = 0; i < points; ++i) {
        z.push_back(range.from + (range.to - range.from) * (i + 0.5) / points);
        u.push_back(column.velocity_at(z.back()));
    }
    return fit_log_law(z, u, log_law_kappa, c.datum(), range.from, range.to);
}

Centreline solve_centreline_and_section(const Case& c) {
    Centreline both{solve_column(c), std::nullopt};
    if (!has_section(c)) return both;
    ColumnResult& result = both.column;
    // The centreline does not see the fine structure beside the walls.
    constexpr SectionOptions options{.cells_across = 40, .cells_over_depth = 90};
    both.section = solve_section(c, options);
    const SectionResult& section = *both.section;
    const double middle = c.channel.centreline();
    for (std::size_t i = 0; i < result.profile.z.size(); ++i) {
        result.profile.velocity[i] = section.velocity_at(middle, result.profile.z[i]);
    }
    result.depth_mean_velocity = section.centreline_velocity;
    result.total_mean_velocity = section.depth_means(0.0, c.total_depth())[section.y.size() / 2];
    result.surface_velocity = result.profile.velocity.back();
    if (has_log_law(c)) result.log_law = fit_column_profile(c, result);
    return both;
}

}  // namespace riffle::inline column
