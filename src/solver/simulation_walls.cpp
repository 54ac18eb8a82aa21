// Wall particles: their records, and the motion of the lid and of solids.

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "base/error.hpp"
#include "solver/pair_setup.hpp"
#include "solver/simulation_of.hpp"

namespace riffle {

template <int D, class Real>
void SimulationOf<D, Real>::make_walls() {
    if (walls_.size() == 0) {
        return;
    }
    if (motion_.displaces()) {
        reference_walls_ = walls_;
        wall_order_.resize(walls_.size());
        for (std::size_t i = 0; i < wall_order_.size(); ++i) {
            wall_order_[i] = static_cast<std::int32_t>(i);
        }
        place_walls(clock_.time);
        return;
    }
    sort_walls();
    pack_wall_records<D, Real>(case_, scheme_, walls_, wall_clusters_, data_);
}

template <int D, class Real>
std::vector<std::int32_t> SimulationOf<D, Real>::sort_walls() {
    const PositionView<D> unsorted = position_view<D>(walls_.position);
    std::vector<std::int32_t> order =
        spatial_order<D>(domain_, unsorted, column_width_, 0.5 * case_.numerics.spacing);
    walls_.permute(order);
    wall_clusters_ =
        build_clusters<D>(domain_, fixed_point_, position_view<D>(walls_.position), column_width_);
    return order;
}

// Always sorted from the same order, so that where the walls stand follows from the time alone, in a resumed
// run too.
template <int D, class Real>
void SimulationOf<D, Real>::place_walls(double time) {
    std::vector<double> by_reference(walls_.size());
    for (std::size_t i = 0; i < walls_.size(); ++i) {
        by_reference[static_cast<std::size_t>(wall_order_[i])] = wall_deviation_[i];
    }
    walls_ = reference_walls_;
    const std::vector<BodyState> bodies = motion_.at(time);
    for (std::size_t i = 0; i < walls_.size(); ++i) {
        const BodyState& body = bodies[static_cast<std::size_t>(walls_.body[i])];
        walls_.position[0][i] = displaced(walls_.position[0][i], body, 0);
        walls_.position[vertical][i] = displaced(walls_.position[vertical][i], body, 1);
    }
    wall_order_ = sort_walls();
    for (std::size_t i = 0; i < walls_.size(); ++i) {
        wall_deviation_[i] = by_reference[static_cast<std::size_t>(wall_order_[i])];
    }
    pack_wall_records<D, Real>(case_, scheme_, walls_, wall_clusters_, data_);
    wet_walls();
}

template <int D, class Real>
double SimulationOf<D, Real>::displaced(double x, const BodyState& body, std::size_t axis) const {
    const std::size_t k = axis == 0 ? 0 : vertical;
    x += body.displacement[axis];
    if (domain_.periodic[k]) {
        const double extent = domain_.upper[k] - domain_.lower[k];
        x -= extent * std::floor((x - domain_.lower[k]) / extent);
        return x < domain_.upper[k] ? x : domain_.lower[k];
    }
    // Far from all water: where exactly does not matter any more.
    return std::clamp(x, domain_.lower[k], domain_.upper[k] - 4.0 * fixed_point_.unit(k));
}

template <int D, class Real>
void SimulationOf<D, Real>::move_walls() {
    if constexpr (D == 2) {
        if (!motion_.any()) {
            return;
        }
        bodies_ = motion_.at(clock_.time);
        if (!motion_.displaces()) {
            return;
        }
        data_.wall_drift.assign(data_.wall_force.size(), {});
        for (std::size_t slot = 0; slot < wall_clusters_.slots(); ++slot) {
            const std::int32_t particle = wall_clusters_.particle_of(slot);
            if (particle < 0 || !is_solid(walls_, static_cast<std::size_t>(particle))) {
                continue;
            }
            const auto i = static_cast<std::size_t>(particle);
            const auto b = static_cast<std::size_t>(walls_.body[i]);
            const auto reference = static_cast<std::size_t>(wall_order_[i]);
            auto& gradient = data_.wall_gradient[slot];
            for (std::size_t k = 0; k < axes; ++k) {
                walls_.position[k][i] = displaced(reference_walls_.position[k][reference], bodies_[b], k);
                gradient.x[k] = fixed_point_.encode(walls_.position[k][i], k);
                double drift = 0.0;
                for (std::size_t l = 0; l < axes; ++l) {
                    drift += walls_.projector[k * axes + l][i] * bodies_[b].velocity[l];
                }
                data_.wall_drift[slot][k] = static_cast<Real>(drift);
            }
            data_.wall_force[slot].x = gradient.x;
        }
    }
}

template <int D, class Real>
void SimulationOf<D, Real>::add_wall_motion(double step, Vec<D>& slowest, Vec<D>& fastest) const {
    if constexpr (D == 2) {
        if (!motion_.displaces() || step <= 0.0) {
            return;
        }
        for (std::size_t b = first_solid; b < bodies_after_.size(); ++b) {
            for (std::size_t k = 0; k < axes; ++k) {
                const double speed = (bodies_after_[b].displacement[k] - bodies_[b].displacement[k]) / step;
                slowest[k] = std::min(slowest[k], speed);
                fastest[k] = std::max(fastest[k], speed);
            }
        }
    }
}

template <int D, class Real>
void SimulationOf<D, Real>::keep_out_of_walls(std::size_t begin, std::size_t end, double step) {
    double deepest = 0.0;
    for (std::size_t cluster = begin; cluster < end; ++cluster) {
        if (fluid_wall_.run_begin[cluster] == fluid_wall_.run_begin[cluster + 1]) {
            continue;
        }
        for_clusters(cluster, cluster + 1, [&](std::size_t first, std::size_t last, std::size_t) {
            for (std::size_t i = first; i < last; ++i) {
                Vec<D> x{};
                Vec<D> u{};
                for (std::size_t k = 0; k < axes; ++k) {
                    x[k] = particles_.position[k][i];
                    u[k] = particles_.velocity[k][i];
                }
                const Vec<D> before = u;
                double depth = planes_.resolve(x, u);
                if (!contact_.empty()) {
                    depth = std::max(depth, contact_.resolve(bodies_after_, x, u));
                }
                if (depth > 0.0 && keep_fields_) {
                    // What the wall takes from the velocity is a force of the wall.
                    auto& along = fields_.wall_acceleration_x;
                    auto& upright = fields_.wall_acceleration_z;
                    along.set(i, along[i] + (u[0] - before[0]) / step);
                    upright.set(i, upright[i] + (u[vertical] - before[vertical]) / step);
                }
                for (std::size_t k = 0; k < axes && depth > 0.0; ++k) {
                    particles_.position[k][i] = x[k];
                    particles_.velocity[k][i] = u[k];
                }
                deepest = std::max(deepest, depth);
            }
        });
    }
    contact_depth_[begin / block_clusters] = deepest;
}

template <int D, class Real>
void SimulationOf<D, Real>::check_solids() const {
    const double spacing = case_.numerics.spacing;
    const std::vector<BodyState> bodies = motion_.at(clock_.time);
    for (std::size_t k = 0; k < case_.solids.size(); ++k) {
        for (std::size_t i = 0; i < particles_.size(); ++i) {
            Vec<D> place{};
            for (std::size_t axis = 0; axis < axes; ++axis) {
                place[axis] = particles_.position[axis][i];
            }
            if (contact_.depth(k, bodies, place) > spacing) {
                const Solid& solid = case_.solids[k];
                throw ParticleFault(
                    i, fmt::format(
                           "water has entered the solid \"{}\": particle {} at x = {:.6g} m, z = {:.6g} m, "
                           "velocity ({:.4g}, {:.4g}) m/s, at t = {:.6g} s; take a smaller step ([numerics] "
                           "courant_number){}",
                           solid.name, particles_.id[i], place[0], place[vertical], particles_.velocity[0][i],
                           particles_.velocity[vertical][i], clock_.time,
                           solid.motion == SolidMotion::fixed
                               ? " or spacing"
                               : ", a smaller spacing, or let the solid move more slowly"));
            }
        }
    }
}

template <int D, class Real>
void SimulationOf<D, Real>::wet_walls() {
    for (std::size_t slot = 0; slot < wall_clusters_.slots() && !wall_law_.dynamic; ++slot) {
        const std::int32_t particle = wall_clusters_.particle_of(slot);
        if (particle >= 0) {
            const auto i = static_cast<std::size_t>(particle);
            wet_wall(slot, i, scheme_.state.pressure(wall_deviation_[i]));
        }
    }
}

// To the symmetric form (thesis 2.42) a wall particle with a density of its own is a particle like any other:
// its term is p_w/rho_w^2.
template <int D, class Real>
double SimulationOf<D, Real>::pair_pressure(double deviation) const {
    const double ratio = weighs_by_volume(case_) ? 1.0 : 1.0 + deviation;
    return scheme_.state.pressure(deviation) / (ratio * ratio);
}

template <int D, class Real>
void SimulationOf<D, Real>::update_wall(std::size_t slot, std::size_t i, const WallResult<D, Real>& sums,
                                        std::size_t lane, double step) {
    auto& record = data_.wall_force[slot];
    double pressure = 0.0;
    const auto weight = static_cast<double>(sums.weight[lane]);
    const BodyState* const body =
        bodies_.empty() ? nullptr : &bodies_[static_cast<std::size_t>(walls_.body[i])];
    if (wall_law_.dynamic) {
        double& s = wall_deviation_[i];
        s += step * (1.0 + s) * static_cast<double>(sums.density_rate[lane]);
        pressure = pair_pressure(s);
    } else if (weight > 0.0) {
        // Adami et al. (2012), eq. 27: p_w = [sum p_f W + (g - a_w) . sum rho r_wf W] / sum W.
        pressure = static_cast<double>(sums.pressure[lane]) -
                   scheme_.normal_gravity * static_cast<double>(sums.offset[vertical][lane]);
        if (body != nullptr) {
            pressure -= body->acceleration[0] * static_cast<double>(sums.offset[0][lane]) +
                        body->acceleration[1] * static_cast<double>(sums.offset[vertical][lane]);
        }
        pressure /= weight;
        // Suction at a solid in the water is no sign of a surface: its particles fade only where the water
        // lies below them, and else the state that says how wet they are is that of one under water.
        const bool below =
            static_cast<double>(sums.offset[vertical][lane]) > 0.25 * weight * case_.numerics.spacing;
        const double wetting = is_solid(walls_, i) && !below
                                   ? std::max(pressure, scheme_.normal_gravity * case_.numerics.spacing)
                                   : pressure;
        wall_deviation_[i] = scheme_.state.deviation(wetting);
        // Of the saved deviation, so that a resumed run finds the same.
        wet_wall(slot, i, scheme_.state.pressure(wall_deviation_[i]));
    }
    record.pressure = static_cast<Real>(pressure);
    record.u = {};
    if (wall_law_.rests_at(walls_, i) && !wall_law_.dynamic && weight > 0.0) {
        // No slip at the wall's surface: u is extrapolated along the line through the velocity of the surface
        // that fits the fluid's momentum near by, so that a linear profile is met exactly.
        Vec<D> surface{};
        if (body != nullptr) {
            surface[0] = body->velocity[0];
            surface[vertical] = body->velocity[1];
        }
        double height = -walls_.depth[i] * weight;
        for (std::size_t k = 0; k < axes; ++k) {
            height -= walls_.normal[k][i] * static_cast<double>(sums.offset[k][lane]);
        }
        if (height > 0.0) {
            // Behind the corner of a solid the water may lie beside the face, and all that a wall particle
            // sees may be a drop on the surface: the mean height is nearly 0 there.
            height = std::max(height, 0.25 * case_.numerics.spacing * weight);
        }
        for (std::size_t k = 0; k < axes; ++k) {
            double u = surface[k];
            if (height > 0.0) {
                u -= walls_.depth[i] / height *
                     (static_cast<double>(sums.velocity[k][lane]) - weight * surface[k]);
            }
            record.u[k] = static_cast<Real>(u);
        }
    }
}

// An end wall stands higher than the water, and so may a solid. Their particles above the surface, where the
// extrapolated pressure is negative, must be as empty as the space over the rest of the surface, or they pull
// at the water below: their volume fades out over one spacing.
template <int D, class Real>
void SimulationOf<D, Real>::wet_wall(std::size_t slot, std::size_t particle, double pressure) {
    if ((walls_.normal[vertical][particle] != 0.0 && !is_solid(walls_, particle)) ||
        scheme_.normal_gravity <= 0.0) {
        return;
    }
    const double wetness =
        std::clamp(0.5 + pressure / (scheme_.normal_gravity * case_.numerics.spacing), 0.0, 1.0);
    const auto volume = static_cast<Real>(wetness * walls_.volume[particle]);
    data_.wall_gradient[slot].volume = volume;
    data_.wall_force[slot].weight = volume;
    data_.wall_force[slot].viscous_weight = wall_law_.rests_at(walls_, particle) ? volume : Real(0);
}

template class SimulationOf<2, float>;
template class SimulationOf<2, double>;
template class SimulationOf<3, float>;
template class SimulationOf<3, double>;

}  // namespace riffle
