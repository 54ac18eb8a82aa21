#include "column/twin_channel.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <map>
#include <memory>
#include <utility>

#include "base/error.hpp"
#include "case/bed_patch.hpp"
#include "case/cross_section.hpp"
#include "case/flow_kind.hpp"
#include "case/patch_range.hpp"
#include "case/porous_zone.hpp"
#include "column/canal_channel.hpp"
#include "column/column.hpp"
#include "turbulence/wall_law.hpp"

namespace riffle::inline column {

namespace {

constexpr double small_slope = 1e-3;

/// Means over the depth of a column's profile. In porous layers the discharge is that of the water, and the
/// coefficients belong to the mean of the discharge over the whole depth: the momentum of the water over the
/// share of it, on which the pressure acts as well.
struct ProfileMeans {
    double unit_discharge = 0.0;  ///< m2/s
    double momentum_coefficient = 1.0;
    double energy_coefficient = 1.0;
};

ProfileMeans means_of(const ColumnProfile& profile) {
    double discharge = 0.0;
    double square = 0.0;
    double cube = 0.0;
    double water = 0.0;
    double face = 0.0;
    for (std::size_t i = 0; i < profile.z.size(); ++i) {
        const double next = 2.0 * profile.z[i] - face;
        const double u = profile.velocity[i];
        const double thickness = (next - face) * (profile.porosity.empty() ? 1.0 : profile.porosity[i]);
        water += thickness;
        discharge += thickness * u;
        square += thickness * u * u;
        cube += thickness * u * u * u;
        face = next;
    }
    return {discharge, face * (face / water) * square / (discharge * discharge),
            face * face * cube / (discharge * discharge * discharge)};
}

/// What the twin says at some depths of one discharge; found when first asked for.
class TwinStates {
  public:
    TwinStates(Case c, double unit_discharge, double least_depth)
        : case_(with_fixed_roughness(std::move(c))),
          has_section_(has_section_reach(case_)),
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

    [[nodiscard]] SectionState solve(double depth) const {
        if (has_section_) {
            const CarryingSection carrying = carrying_section(case_, depth, unit_discharge_);
            return {carrying.weight / case_.fluid.gravity, carrying.section.depth_mean_velocity,
                    carrying.section.momentum_coefficient, carrying.section.energy_coefficient};
        }
        const CarryingColumn carrying = carrying_column(case_, depth, unit_discharge_);
        const ProfileMeans means = means_of(carrying.column.profile);
        return {carrying.weight / case_.fluid.gravity, carrying.column.depth_mean_velocity,
                means.momentum_coefficient, means.energy_coefficient};
    }

    Case case_;
    bool has_section_;  ///< between side walls
    double unit_discharge_;
    double least_depth_;
    std::map<int, SectionState> nodes_;
};

}  // namespace

double least_known_depth(const Case& c) {
    if (canal_of(c) != nullptr) return canal_by_radius(c, 1.0).least_depth;
    constexpr double least_share = 1e-3;  // of the case's depth, over a smooth bed
    // A log law holds in water of twice its roughness and more.
    const auto of_law = [](const Case& bed) {
        return has_wall_law(bed) ? 2.0 * equivalent_roughness(bed) : 0.0;
    };
    double least = std::max({c.crest() - c.datum(), least_share * c.channel.depth, of_law(c)});
    for (const BedPatch& patch : c.bed_patches) {
        if (covers_length(c, patch)) least = std::max(least, of_law(with_bed_of(c, patch)));
    }
    return least;
}

Case uniform_reach(const Case& c) {
    Case reach = c;
    if (c.channel.ends != Ends::open) return reach;
    reach.channel.ends = Ends::periodic;
    reach.inflow = {};
    reach.outflow = {};
    // Strips along the channel have the twin of a cross-section.
    std::erase_if(reach.bed_patches, [&c](const BedPatch& patch) {
        return !c.has_side_walls() || !covers_length(c, patch) || covers_width(c, patch);
    });
    reach.solids.clear();
    reach.probes.clear();
    reach.start.water_x.clear();  // where the water stands when the run begins is not how it enters
    reach.start.water_z.clear();
    std::erase_if(reach.porous, [&c](const Porous& zone) { return !covers_length(c, zone); });
    std::erase_if(reach.vegetation, [&c](const Vegetation& patch) { return !covers_length(c, patch); });
    return reach;
}

namespace {

/// The twin that carries a discharge has a slope of its own.
Case sloping_reach(const Case& c) {
    Case reach = uniform_reach(c);
    reach.channel.slope = small_slope;
    return reach;
}

}  // namespace

bool has_section_reach(const Case& c) { return section_of(c) == nullptr && has_section(sloping_reach(c)); }

bool has_column_reach(const Case& c) {
    return section_of(c) != nullptr ? canal_of(c) != nullptr : has_column(sloping_reach(c));
}

namespace {

/// The grid of sections that are solved many times.
constexpr SectionOptions coarse{.cells_across = 40, .cells_over_depth = 30, .with_relaxation_time = false};

/// By secants between the logarithms: over rough beds the discharge goes with the root of the weight, in
/// laminar flow with the weight. It may be more than g, where the water is braked faster than it would fall;
/// the twins know of gravity and slope only their product, so that the slope stays small and gravity is
/// changed. `solve`: the twin of a case; `discharge_of`: its unit discharge; `close`: in the logarithm.
template <class Twin, class Solve, class Discharge>
std::pair<double, Twin> carry(const Case& of, double depth, double unit_discharge, double close,
                              const char* name, const Solve& solve, const Discharge& discharge_of) {
    Case c = uniform_reach(with_fixed_roughness(of));
    c.channel.depth = depth;
    c.channel.slope = small_slope;
    const double sine = std::sin(std::atan(c.channel.slope));
    const double water = c.total_depth();
    const double wanted = std::log(unit_discharge);
    // From a friction factor of 0.1.
    double log_weight = std::log(0.0125 * unit_discharge * unit_discharge / (water * water * water));
    double exponent = 0.5;
    double last_weight = 0.0;
    double last_excess = 0.0;
    constexpr int most_iterations = 50;
    for (int i = 0; i < most_iterations; ++i) {
        c.fluid.gravity = std::exp(log_weight) / sine;
        Twin twin = solve(c);
        const double excess = std::log(discharge_of(twin)) - wanted;
        if (std::abs(excess) < close) {
            return {std::exp(log_weight), std::move(twin)};
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
        fmt::format("the {} twin of a depth of {:.4g} m was not found for a discharge of {:.4g} m2/s", name,
                    depth, unit_discharge));
}

}  // namespace

CarryingColumn carrying_column(const Case& c, double depth, double unit_discharge) {
    auto [weight, column] = carry<ColumnResult>(
        c, depth, unit_discharge, 1e-9, "column", [](const Case& at) { return solve_column(at); },
        [](const ColumnResult& twin) { return means_of(twin.profile).unit_discharge; });
    return {weight, std::move(column)};
}

CarryingSection carrying_section(const Case& c, double depth, double unit_discharge) {
    auto [weight, section] = carry<SectionResult>(
        c, depth, unit_discharge, 1e-7, "cross-section",
        [](const Case& at) { return solve_section(at, coarse); },
        [&c](const SectionResult& twin) { return twin.discharge / c.channel.width; });
    return {weight, std::move(section)};
}

double uniform_discharge_at(const Case& c, double depth) {
    if (canal_of(c) != nullptr) return canal_uniform_discharge(c, depth);
    Case at = uniform_reach(with_fixed_roughness(c));
    at.channel.depth = depth;
    return has_section_reach(c) ? solve_section(at, coarse).discharge / at.channel.width
                                : means_of(solve_column(at).profile).unit_discharge;
}

std::optional<double> twin_normal_depth(const Case& c, double unit_discharge) {
    if (!has_section_reach(c)) return normal_depth(twin_channel(c, unit_discharge));
    double depth = c.channel.depth;
    const double least_depth = least_known_depth(c);
    double exponent = 1.5;
    double last_depth = 0.0;
    double last_discharge = 0.0;
    constexpr int most_iterations = 50;
    for (int i = 0; i < most_iterations; ++i) {
        const double discharge = uniform_discharge_at(c, depth);
        if (std::abs(discharge / unit_discharge - 1.0) < 1e-7) return depth;
        if (i > 0) {
            constexpr double least = 0.7;
            constexpr double most = 4.0;
            exponent =
                std::clamp(std::log(discharge / last_discharge) / std::log(depth / last_depth), least, most);
        }
        last_depth = depth;
        last_discharge = discharge;
        depth *= std::pow(unit_discharge / discharge, 1.0 / exponent);
        if (depth < least_depth) break;
    }
    throw InputError(fmt::format(
        "the normal depth of {:.4g} m2/s between the side walls was not found at or above {:.3g} m, below which the "
        "friction of the bed is not known: give a larger discharge, or [outflow] kind = \"depth\"",
        unit_discharge, least_depth));
}

double uniform_unit_discharge(const Case& c) {
    if (canal_of(c) != nullptr) return canal_uniform_discharge(c, c.channel.depth);
    const Case reach = uniform_reach(c);
    return has_section_reach(c) ? solve_section(reach).discharge / c.channel.width
                                : means_of(solve_column(reach).profile).unit_discharge;
}

SteadyChannel twin_channel(const Case& c, double unit_discharge) {
    if (canal_of(c) != nullptr) return canal_channel(c, unit_discharge);
    const double least_depth = least_known_depth(c);
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

}  // namespace riffle::inline column
