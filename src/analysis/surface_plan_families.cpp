// What the moving surface of a run is made of: the bed's pattern, patterns that the water carries, waves.

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <string>
#include <utility>

#include "analysis/chapters.hpp"
#include "analysis/figure_tools.hpp"
#include "analysis/section_parts.hpp"
#include "analysis/surface_families.hpp"
#include "analysis/surface_parts.hpp"
#include "base/error.hpp"
#include "statistics/record.hpp"

namespace riffle::inline analysis {

namespace {

/// Names of the families, in their order.
struct FamilyName {
    SurfaceFamily family;
    const char* key;
    const char* name;
};
constexpr std::array<FamilyName, surface_families> family_names = {
    {{SurfaceFamily::bed_locked, "bed_locked", "locked to the bed"},
     {SurfaceFamily::advected, "advected", "carried along by the water"},
     {SurfaceFamily::waves_downstream, "waves_downstream", "waves that travel downstream through the water"},
     {SurfaceFamily::waves_upstream, "waves_upstream", "waves that travel upstream through the water"},
     {SurfaceFamily::waves_across, "waves_across", "waves that travel straight across the channel"},
     {SurfaceFamily::other, "other", "none of these"}}};

/// The line along the channel that fits the mean level, at each place along it, m: between open ends the
/// surface falls or rises, which is no pattern of it.
std::vector<double> fall_of(const SurfaceMaps& maps) {
    const std::size_t columns = maps.x.size();
    std::vector<double> level(columns, 0.0);
    for (std::size_t i = 0; i < maps.elevation.size(); ++i) level[i % columns] += maps.elevation[i];
    const double samples = static_cast<double>(maps.elevation.size()) / static_cast<double>(columns);
    for (double& value : level) value /= samples;
    std::vector<double> rest = level;
    remove_line(maps.x, rest, true);
    for (std::size_t i = 0; i < columns; ++i) level[i] -= rest[i];
    return level;
}

/// The maps at even times, about the mean over the plan at each and, where it does not repeat itself along
/// the channel, about the fall of the mean level.
SpaceTime even_maps(const SurfaceMaps& maps, bool periodic) {
    SpaceTime even = resample_evenly(plan_record(maps));
    if (!periodic) {
        const std::vector<double> fall = fall_of(maps);
        for (std::size_t i = 0; i < even.values.size(); ++i) even.values[i] -= fall[i % fall.size()];
    }
    for (std::size_t row = 0; row < even.rows(); ++row) {
        const double mean = mean_of(even.row(row));
        for (double& elevation : even.row(row)) elevation -= mean;
    }
    return even;
}

SurfacePlan plan_of(const Case& c, const SurfaceMaps& maps, SpaceTime even) {
    SurfacePlan plan;
    plan.columns = maps.x.size();
    plan.rows = maps.y.size();
    plan.spacing_x = c.channel.length / static_cast<double>(plan.columns);
    plan.spacing_y = c.channel.simulated_width() / static_cast<double>(plan.rows);
    plan.interval = sampling_interval(even);
    plan.periodic_x = c.channel.ends == Ends::periodic;
    plan.periodic_y = c.channel.sides == Sides::periodic;
    plan.elevation = std::move(even.values);
    return plan;
}

}  // namespace

void add_surface_families(const FlowRecord& record, Analysis& analysis) {
    const SurfaceMaps& maps = record.surface_maps();
    const double bulk = velocity_at_centreline(record);
    if (maps.time.size() < 2 || maps.x.size() < 4 || maps.y.size() < 4 || !(bulk > 0.0)) return;
    Figure figure = make_figure(
        chapters::surface, "surface_families", "What the surface is made of",
        "Variance of the elevation over the plan, by wavenumber and by the way its components move: what stands over the "
        "bed, what the water carries along (between the depth-mean velocity and that of the surface), gravity waves "
        "on a current of the surface's velocity that travel downstream, upstream and straight across through it, and what "
        "is none of these. Of noise that has no memory each family gets by chance what stands beside its share. "
        "Frequencies as sampling folds them.",
        "Dolcetti et al. 2016", make_axis("wavenumber |k|", "rad/m"),
        make_axis("variance per wavenumber", "m3/rad", true));
    attempt(record, analysis, std::move(figure), [&](Figure& f) {
        SpaceTime even = even_maps(maps, record.flow()->channel.ends == Ends::periodic);
        if (is_flat(record, even)) {
            throw InputError(
                "the surface is flat to a thousandth of the spacing: nothing moves it but rows of particles");
        }
        const SurfacePlan plan = plan_of(*record.flow(), maps, std::move(even));
        const GravityCapillaryWaves waves = waves_on(record);
        const auto [slowest, fastest] = std::minmax(bulk, waves.velocity);
        constexpr std::size_t longest = 512;
        const std::size_t segment = std::clamp<std::size_t>(plan.times() / 4, 8, longest);
        const SurfaceMakeup makeup = surface_makeup(plan, waves, slowest, fastest, segment);
        if (!(makeup.whole() > 0.0)) throw InputError("the surface does not move");
        int variant = 0;
        for (const FamilyName& each : family_names) {
            Finding finding = make_finding(chapters::surface, std::string("surface_share_") + each.key,
                                           std::string("share of the surface's variance, ") + each.name, "1",
                                           makeup.share(each.family));
            finding.remark =
                fmt::format("noise would have {:.3f} by chance", makeup.share_of_noise(each.family));
            if (each.family == SurfaceFamily::bed_locked) {
                finding.remark += fmt::format(
                    "; over the plan, by wavenumber and frequency, {} segments of {:.3g} s; to 2 steps of {:.3g} rad/s, or a "
                    "tenth of k U_s",
                    makeup.segments, plan.interval * static_cast<double>(segment), makeup.frequency_step);
            }
            analysis.findings.push_back(std::move(finding));
            f.curves.push_back(make_curve(each.name, Origin::simulated, Mark::line_and_points,
                                          makeup.wavenumber,
                                          makeup.density[static_cast<std::size_t>(each.family)], variant++));
        }
    });
}

}  // namespace riffle::inline analysis
