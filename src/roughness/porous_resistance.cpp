#include "roughness/porous_resistance.hpp"

#include <algorithm>
#include <limits>

namespace riffle::inline roughness {

namespace {

constexpr double ergun_laminar = 150.0;

double linear_of(const Porous& medium, double viscosity) {
    const double n = medium.porosity;
    if (medium.grain_size) {
        const double d = *medium.grain_size;
        return medium.laminar_coefficient * (1.0 - n) * (1.0 - n) * viscosity / (n * n * n * d * d);
    }
    return medium.permeability ? viscosity / *medium.permeability : 0.0;
}

double quadratic_of(const Porous& medium) {
    const double n = medium.porosity;
    if (medium.grain_size) return medium.inertial_coefficient * (1.0 - n) / (n * n * n * *medium.grain_size);
    return medium.permeability ? medium.forchheimer / std::sqrt(*medium.permeability) : 0.0;
}

}  // namespace

PorousResistance::PorousResistance(const Porous& medium, double viscosity)
    : linear_(linear_of(medium, viscosity)), quadratic_(quadratic_of(medium)) {}

double PorousResistance::discharge_at(double force) const {
    const double carried = linear_ + std::sqrt(linear_ * linear_ + 4.0 * quadratic_ * std::abs(force));
    return carried > 0.0 ? 2.0 * force / carried : std::numeric_limits<double>::infinity();
}

double permeability_of(const Porous& medium) {
    const double linear = linear_of(medium, 1.0);
    return linear > 0.0 ? 1.0 / linear : std::numeric_limits<double>::infinity();
}

double grain_size_of(const Porous& medium) {
    const double n = medium.porosity;
    return medium.grain_size.value_or(
        std::sqrt(ergun_laminar * medium.permeability.value_or(0.0) * (1.0 - n) * (1.0 - n) / (n * n * n)));
}

double pore_mixing_length(const Porous& medium) {
    // Eddies are not larger than pores, a mixing length is a part of their size.
    constexpr double grains = 0.1;
    constexpr double roots = 3.0;
    if (medium.mixing_length) return *medium.mixing_length;
    if (medium.grain_size) return grains * *medium.grain_size;
    return medium.permeability ? roots * std::sqrt(*medium.permeability)
                               : std::numeric_limits<double>::infinity();
}

PorousMedia::PorousMedia(const Case& c) : field_(c) {
    for (const Porous& medium : c.porous) {
        media_.push_back({PorousResistance(medium, c.fluid.kinematic_viscosity), medium.viscosity_ratio,
                          pore_mixing_length(medium)});
    }
    for (const PorousZone& zone : field_.zones()) {
        thinnest_edge_ = thinnest_edge_ > 0.0 ? std::min(thinnest_edge_, zone.edge()) : zone.edge();
    }
}

PorousMedia::At PorousMedia::at_with_normal(int dimensions, double x, double y, double z) const {
    At here = at(x, y, z);
    // Away from edges the two ways of the resistance are one.
    if (std::abs(here.porosity * here.linear - here.force_linear) <= 1e-9 * here.force_linear &&
        std::abs(here.porosity * here.quadratic - here.force_quadratic) <= 1e-9 * here.force_quadratic) {
        return here;
    }
    const double step = 0.02 * thinnest_edge_;
    double squared = 0.0;
    for (std::size_t k = 0; k < 3; ++k) {
        if (k == 1 && dimensions == 2) continue;
        std::array<double, 3> low{x, y, z};
        std::array<double, 3> high{x, y, z};
        low[k] -= step;
        high[k] += step;
        here.normal[k] = field_.porosity(high) - field_.porosity(low);
        squared += here.normal[k] * here.normal[k];
    }
    for (double& component : here.normal) component = squared > 0.0 ? component / std::sqrt(squared) : 0.0;
    return here;
}

PorousMedia::At PorousMedia::at(double x, double y, double z) const {
    At at;
    double solid = 0.0;
    for (std::size_t k = 0; k < media_.size(); ++k) {
        const Medium& medium = media_[k];
        const double share = field_.zones()[k].share(x, y, z);
        if (share > 0.0) {
            const double grains = field_.solid()[k];
            solid += share * grains;
            at.linear += share * medium.resistance.linear();
            at.quadratic += share * medium.resistance.quadratic();
            at.force_linear += share * (1.0 - grains) * medium.resistance.linear();
            at.force_quadratic += share * (1.0 - grains) * medium.resistance.quadratic();
            at.viscosity_ratio += share * (medium.viscosity_ratio - 1.0);
        }
    }
    at.porosity = 1.0 - solid;
    return at;
}

double PorousMedia::limited(double length, double x, double y, double z) const {
    double outside = 1.0;
    double inside = 0.0;
    for (std::size_t k = 0; k < media_.size(); ++k) {
        const double share = field_.zones()[k].share(x, y, z);
        if (share > 0.0) {
            outside -= share;
            inside += share * std::min(length, media_[k].mixing_length);
        }
    }
    return inside > 0.0 || outside < 1.0 ? std::max(0.0, outside) * length + inside : length;
}

}  // namespace riffle::inline roughness
