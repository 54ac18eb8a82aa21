#include "column/twin_channel.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <map>
#include <memory>
#include <utility>

#include "base/error.hpp"
#include "case/flow_kind.hpp"
#include "case/porous_zone.hpp"
#include "column/column.hpp"
#include "turbulence/wall_law.hpp"

namespace riffle {

namespace {

/// Means over the depth of a column's profile.
struct ProfileMeans {
    double unit_discharge = 0.0;  ///< m2/s
    double momentum_coefficient = 1.0;
    double energy_coefficient = 1.0;
};

ProfileMeans means_of(const ColumnProfile& profile) {
    double discharge = 0.0;
    double square = 0.0;
    double cube = 0.0;
    double face = 0.0;
    for (std::size_t i = 0; i < profile.z.size(); ++i) {
        const double next = 2.0 * profile.z[i] - face;
        const double u = profile.velocity[i];
        const double thickness = next - face;
        discharge += thickness * u;
        square += thickness * u * u;
        cube += thickness * u * u * u;
        face = next;
    }
    return {discharge, face * square / (discharge * discharge),
            face * face * cube / (discharge * discharge * discharge)};
}

/// What the twin says at some depths of one discharge; found when first asked for.
class TwinStates {
  public:
    TwinStates(Case c, double unit_discharge, double least_depth)
        : case_(with_fixed_roughness(std::move(c))),
          unit_discharge_(unit_discharge),
          least_depth_(least_depth) {}

    [[nodiscard]] SectionState at(double depth) {
        const double place = std::log(std::max(depth, least_depth_) / least_depth_) / step;
        const double first = std::max(0.0, std::floor(place) - 2.0);  // no node among the crests
        SectionState state{0.0, 0.0, 0.0, 0.0};
        double log_slope = 0.0;
        for (int k = 0; k < points; ++k) {
            double weight = 1.0;
            for (int other = 0; other < points; ++other) {
                if (other != k) weight *= (place - first - other) / static_cast<double>(k - other);
            }
            const SectionState& node = node_at(static_cast<int>(first) + k);
            log_slope += weight * std::log(node.friction_slope);
            state.mean_velocity += weight * node.mean_velocity;
            state.momentum_coefficient += weight * node.momentum_coefficient;
            state.energy_coefficient += weight * node.energy_coefficient;
        }
        state.friction_slope = std::exp(log_slope);
        return state;
    }

  private:
    static constexpr double step = 0.1;  // in ln h
    static constexpr int points = 6;

    [[nodiscard]] const SectionState& node_at(int i) {
        const auto found = nodes_.find(i);
        return found != nodes_.end()
                   ? found->second
                   : nodes_.emplace(i, solve(least_depth_ * std::exp(step * i))).first->second;
    }

    [[nodiscard]] SectionState solve(double depth) {
        const CarryingColumn carrying = carrying_column(case_, depth, unit_discharge_);
        const ProfileMeans means = means_of(carrying.column.profile);
        return {carrying.weight / case_.fluid.gravity, carrying.column.depth_mean_velocity,
                means.momentum_coefficient, means.energy_coefficient};
    }

    Case case_;
    double unit_discharge_;
    double least_depth_;
    std::map<int, SectionState> nodes_;
};

}  // namespace

Case uniform_reach(const Case& c) {
    Case reach = c;
    if (c.channel.ends != Ends::open) {
        return reach;
    }
    reach.channel.ends = Ends::periodic;
    reach.inflow = {};
    reach.outflow = {};
    reach.solids.clear();
    reach.probes.clear();
    std::erase_if(reach.porous, [&c](const Porous& zone) { return !covers_length(c, zone); });
    std::erase_if(reach.vegetation, [&c](const Vegetation& patch) { return !covers_length(c, patch); });
    return reach;
}

// By secants between the logarithms: over rough beds the discharge goes with the root of the weight, in
// laminar flow with the weight. It may be more than g, where the water is braked faster than it would fall;
// the column knows of gravity and slope only their product, so that the slope stays small and gravity is
// changed.
CarryingColumn carrying_column(const Case& of, double depth, double unit_discharge) {
    Case c = uniform_reach(of);
    c.channel.depth = depth;
    c.channel.slope = 1e-3;
    const double sine = std::sin(std::atan(c.channel.slope));
    const double water = c.total_depth();
    const double wanted = std::log(unit_discharge);
    // From a friction factor of 0.1.
    double log_weight = std::log(0.0125 * unit_discharge * unit_discharge / (water * water * water));
    double exponent = 0.5;
    double last_weight = 0.0;
    double last_excess = 0.0;
    constexpr int most_iterations = 50;
    constexpr double close = 1e-9;
    for (int i = 0; i < most_iterations; ++i) {
        c.fluid.gravity = std::exp(log_weight) / sine;
        ColumnResult column = solve_column(c);
        const double excess = std::log(means_of(column.profile).unit_discharge) - wanted;
        if (std::abs(excess) < close) {
            return {std::exp(log_weight), std::move(column)};
        }
        if (i > 0) {
            constexpr double least = 0.3;
            constexpr double most = 1.5;
            exponent = std::clamp((excess - last_excess) / (log_weight - last_weight), least, most);
        }
        last_weight = log_weight;
        last_excess = excess;
        log_weight -= excess / exponent;
    }
    throw InputError(
        fmt::format("the column twin of a depth of {:.4g} m was not found for a discharge of {:.4g} m2/s",
                    depth, unit_discharge));
}

double uniform_unit_discharge(const Case& c) {
    return means_of(solve_column(uniform_reach(c)).profile).unit_discharge;
}

SteadyChannel twin_channel(const Case& c, double unit_discharge) {
    constexpr double least_share = 1e-3;  // of the case's depth, over a smooth bed
    // A log law holds in water of twice its roughness and more.
    const double least_depth = std::max({c.crest() - c.datum(), least_share * c.channel.depth,
                                         has_wall_law(c) ? 2.0 * equivalent_roughness(c) : 0.0});
    SteadyChannel channel{.slope = c.channel.slope,
                          .gravity = c.fluid.gravity,
                          .unit_discharge = unit_discharge,
                          .depth_below_datum = c.datum(),
                          .least_depth = least_depth,
                          .state = {}};
    const auto states = std::make_shared<TwinStates>(c, unit_discharge, least_depth);
    channel.state = [states](double depth) { return states->at(depth); };
    return channel;
}

}  // namespace riffle
