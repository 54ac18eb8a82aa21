#include "analysis/pools.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <optional>

#include "analysis/chapter_names.hpp"
#include "analysis/figure_tools.hpp"
#include "base/error.hpp"
#include "case/solid_mesh.hpp"
#include "case/solid_places.hpp"

namespace riffle::inline analysis {

namespace {

/// Shares of the section under the level that bodies at rest take up, by columns of a profile; 1 where it is
/// dry. Errors as meshes_of().
std::vector<double> closed_shares(const Case& flow, const LongProfile& profile) {
    Case c = flow;
    if (c.channel.dimensions == 3) c.meshes = meshes_of(flow);
    const SolidPlaces solids(c);
    const auto is_open = [&](const Point3& place) {
        const auto solid = solids.resting_at(place);
        return !solid || c.solids[*solid].part_of_bed;
    };
    const auto points_over = [&c](double extent) {
        return std::max(1, static_cast<int>(std::lround(extent / c.numerics.spacing)));
    };
    const int files = c.channel.dimensions == 3 ? points_over(c.channel.simulated_width()) : 1;
    std::vector<double> shares;
    for (std::size_t i = 0; i < profile.x.size(); ++i) {
        const double level = profile.level[i];
        shares.push_back(
            level > 0.0 ? 1.0 - open_share(c, profile.x[i], level, points_over(level), files, is_open) : 1.0);
    }
    return shares;
}

/// Columns of a profile that follow each other without a barrier among them, [first, end); beyond the last
/// one they begin anew.
struct Reach {
    std::size_t first = 0;
    std::size_t end = 0;
};

/// The reaches between barriers, in order; of a periodic channel from the first barrier all around, of
/// another the ones before the first barrier and behind the last too.
std::vector<Reach> reaches_between(const std::vector<bool>& barrier, bool periodic) {
    const std::size_t columns = barrier.size();
    const auto first_barrier = static_cast<std::size_t>(
        std::distance(barrier.begin(), std::find(barrier.begin(), barrier.end(), true)));
    if (first_barrier == columns) return {};
    std::vector<Reach> reaches;
    const std::size_t start = periodic ? first_barrier : 0;
    for (std::size_t i = start; i < start + columns; ++i) {
        if (barrier[i % columns]) continue;
        if (!reaches.empty() && reaches.back().end == i) {
            ++reaches.back().end;
        } else {
            reaches.push_back({i, i + 1});
        }
    }
    return reaches;
}

/// The water of a reach, without its fall.
Pool water_of(const Case& c, const LongProfile& profile, const std::vector<double>& closed,
              const Reach& reach) {
    const std::size_t columns = profile.x.size();
    const double step = c.channel.length / static_cast<double>(columns);
    Pool pool;
    double place = 0.0;
    for (std::size_t i = reach.first; i < reach.end; ++i) {
        const std::size_t at = i % columns;
        pool.level += profile.level[at];
        pool.volume += (1.0 - closed[at]) * profile.level[at] * step;
        place += profile.x[at] + (i >= columns ? c.channel.length : 0.0);
    }
    const auto count = static_cast<double>(reach.end - reach.first);
    pool.level /= count;
    place /= count;
    pool.from = place - 0.5 * count * step;
    pool.to = place + 0.5 * count * step;
    pool.head = (c.normal_gravity() * pool.level - c.streamwise_gravity() * place) / c.fluid.gravity;
    return pool;
}

/// The end of a reach beside a barrier, no longer than a pool.
Reach end_beside(const Reach& reach, std::size_t longest, bool before_barrier) {
    const std::size_t length = std::min(reach.end - reach.first, longest);
    return before_barrier ? Reach{reach.end - length, reach.end} : Reach{reach.first, reach.first + length};
}

/// A quantity of each pool over their places in the channel.
Figure figure_of_pools(const char* key, const char* title, const char* caption, Axis axis, double length,
                       const std::vector<Pool>& pools, std::vector<double> values) {
    Figure figure = make_figure(chapters::along, key, title, caption, "",
                                make_axis("distance along the channel x", "m"), std::move(axis));
    std::vector<double> places(pools.size());
    std::transform(pools.begin(), pools.end(), places.begin(),
                   [length](const Pool& pool) { return std::fmod(pool.middle(), length); });
    figure.x.from = 0.0;
    figure.x.to = length;
    figure.y.from = 0.0;
    figure.curves.push_back(
        make_curve("simulated", Origin::simulated, Mark::points, std::move(places), std::move(values)));
    return figure;
}

/// "N pools, from A to B UNIT"; of one nothing.
std::string range_text(const std::vector<double>& values, double factor, const char* unit) {
    if (values.size() < 2) return "";
    const auto [least, most] = std::minmax_element(values.begin(), values.end());
    return fmt::format("{} pools, from {:.3g} to {:.3g} {}", values.size(), factor * *least, factor * *most,
                       unit);
}

}  // namespace

std::vector<Pool> pools_of(const Case& c, const LongProfile& profile) {
    const bool periodic = c.channel.ends == Ends::periodic;
    if (c.solids.empty() || profile.x.empty() || (!periodic && c.channel.ends != Ends::open)) return {};
    const std::vector<double> closed = closed_shares(c, profile);
    constexpr double most_of_section = 0.5;
    std::vector<bool> barrier(closed.size());
    std::transform(closed.begin(), closed.end(), barrier.begin(),
                   [](double share) { return share >= most_of_section; });
    std::vector<Reach> reaches = reaches_between(barrier, periodic);
    // What is too short for a pool lies in a barrier, as the notch between two beams of one weir does.
    constexpr double least_length = 0.5;
    std::erase_if(reaches, [&](const Reach& reach) {
        const Pool water = water_of(c, profile, closed, reach);
        return water.to - water.from < least_length * water.level;
    });
    std::vector<Pool> pools;
    const std::size_t ends = periodic ? 0 : 1;
    for (std::size_t i = ends; i + ends < reaches.size(); ++i) {
        Pool pool = water_of(c, profile, closed, reaches[i]);
        if (periodic) {
            // The pool before the first one is the last, a whole channel upstream and so much higher.
            const Pool before = water_of(c, profile, closed, reaches[i > 0 ? i - 1 : reaches.size() - 1]);
            const double raised = i > 0 ? 0.0 : c.streamwise_gravity() / c.fluid.gravity * c.channel.length;
            pool.fall = before.head + raised - pool.head;
        } else {
            const std::size_t length = reaches[i].end - reaches[i].first;
            pool.fall =
                water_of(c, profile, closed, end_beside(reaches[i - 1], length, true)).head - pool.head;
        }
        pools.push_back(pool);
    }
    return pools;
}

void add_pools(const FlowRecord& record, const LongProfile& profile, double unit_discharge,
               Analysis& analysis) {
    const Case& c = *record.flow();
    std::vector<Pool> pools;
    try {
        pools = pools_of(c, profile);
    } catch (const Error& error) {
        analysis.warnings.push_back(std::string("pools between bodies were not looked for: ") + error.what());
    }
    if (pools.empty()) return;
    std::vector<double> falls;
    std::vector<double> powers;
    double sum = 0.0;
    for (const Pool& pool : pools) {
        falls.push_back(pool.fall);
        powers.push_back(c.fluid.density * c.fluid.gravity * unit_discharge * pool.fall / pool.volume);
        sum += pool.fall;
    }
    const double largest_fall = *std::max_element(falls.begin(), falls.end());
    const double mean_fall = sum / static_cast<double>(pools.size());
    Finding fall = make_finding(chapters::along, "pool_fall", "fall from pool to pool", "m", mean_fall);
    fall.remark = range_text(falls, 1e3, "mm");
    analysis.findings.push_back(std::move(fall));
    if (largest_fall > 0.0) {
        Finding velocity = make_finding(chapters::along, "pool_jet_velocity",
                                        "velocity of a jet that falls from pool to pool", "m/s",
                                        std::sqrt(2.0 * c.fluid.gravity * largest_fall));
        velocity.remark = pools.size() > 1 ? "√(2gΔh) of the largest fall" : "√(2gΔh)";
        analysis.findings.push_back(std::move(velocity));
    }
    Finding power = make_finding(chapters::along, "pool_power", "power per volume of a pool, the largest",
                                 "W/m3", *std::max_element(powers.begin(), powers.end()));
    power.remark = "ρgqΔh over the volume of the water; guidelines allow 150 to 200 W/m3 (FAO/DVWK 2002)";
    if (const std::string range = range_text(powers, 1.0, "W/m3"); !range.empty()) {
        power.remark += "; " + range;
    }
    analysis.findings.push_back(std::move(power));
    if (pools.size() < 2) return;
    analysis.figures.push_back(figure_of_pools("pool_falls", "Fall from pool to pool",
                                               "Of the water that comes into each pool: its mean level below "
                                               "that of the water before.",
                                               make_axis("fall Δh", "m"), c.channel.length, pools, falls));
    analysis.figures.push_back(figure_of_pools(
        "pool_powers", "Power per volume of the pools",
        "What each pool takes from the water that falls into it, over the volume of its water.",
        make_axis("ρgqΔh/V", "W/m3"), c.channel.length, pools, powers));
    for (const double allowed : {150.0, 200.0}) {
        analysis.figures.back().guides.push_back(
            {fmt::format("{:.0f} W/m3 (FAO/DVWK 2002)", allowed), false, allowed, allowed});
    }
}

}  // namespace riffle::inline analysis
