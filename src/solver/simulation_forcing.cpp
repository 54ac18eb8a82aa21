// Forces that are not sums over neighbours: the stirring, and the coefficients of the drags.

#include <algorithm>
#include <bit>
#include <cmath>

#include "base/parallel.hpp"
#include "solver/simulation_of.hpp"

namespace riffle {

// The mean of the stirring over the particles: taken off it, so that it adds no momentum along or across the
// channel even where the particles' spacing correlates with its pattern.
template <int D, class Real>
void SimulationOf<D, Real>::measure_stirring() {
    if (!stirring_.active()) {
        return;
    }
    using Sums = std::array<double, axes>;  // of the horizontal components, then of the mass
    const Sums sums = reduce_blocks(
        particles_.size(), std::size_t{1024}, Sums{},
        [&](std::size_t begin, std::size_t end) {
            Sums part{};
            for (std::size_t i = begin; i < end; ++i) {
                const Vec<D> a = stirring_at(i);
                for (std::size_t k = 0; k < vertical; ++k) {
                    part[k] += particles_.mass[i] * a[k];
                }
                part[vertical] += particles_.mass[i];
            }
            return part;
        },
        [](const Sums& a, const Sums& b) {
            Sums sum{};
            for (std::size_t k = 0; k < axes; ++k) {
                sum[k] = a[k] + b[k];
            }
            return sum;
        });
    for (std::size_t k = 0; k < vertical; ++k) {
        stirring_mean_[k] = sums[k] / sums[vertical];
    }
}

template <int D, class Real>
Vec<D> SimulationOf<D, Real>::stirring_at(std::size_t particle) const {
    Vec<D> x{};
    for (std::size_t k = 0; k < axes; ++k) {
        x[k] = particles_.position[k][particle];
    }
    Vec<D> a{};
    stirring_.add(x, clock_.time, a);
    return a;
}

template <int D, class Real>
void SimulationOf<D, Real>::add_stirring(Task& task, std::size_t begin, std::size_t end) const {
    for_clusters(begin, end, [&](std::size_t first, std::size_t last, std::size_t first_lane) {
        for (std::size_t i = first; i < last; ++i) {
            const Vec<D> a = stirring_at(i);
            for (std::size_t k = 0; k < axes; ++k) {
                task.particles.acceleration[k][first_lane + (i - first)] = a[k] - stirring_mean_[k];
            }
        }
    });
}

template <int D, class Real>
void SimulationOf<D, Real>::add_repulsion(Task& task, std::size_t begin, std::size_t end) const {
    for_clusters(begin, end, [&](std::size_t first, std::size_t last, std::size_t first_lane) {
        for (std::size_t i = first; i < last; ++i) {
            Vec<D> x{};
            Vec<D> u{};
            for (std::size_t k = 0; k < axes; ++k) {
                x[k] = particles_.position[k][i];
                u[k] = particles_.velocity[k][i];
            }
            const Vec<D> a = repulsion_.acceleration(x, u);
            const std::size_t lane = first_lane + (i - first);
            for (std::size_t k = 0; k < axes; ++k) {
                task.repulsion[k][lane] = a[k];
                task.particles.acceleration[k][lane] += a[k];
            }
        }
    });
}

template <int D, class Real>
void SimulationOf<D, Real>::find_drag(Task& task, std::size_t begin, std::size_t end) const {
    // Few clusters reach into the roughness.
    const std::uint32_t reaching = particle_loops_.standing_below(particle_data_, drag_->top(), begin, end);
    task.particles.drag_clusters = reaching;
    const std::vector<double>& height = particles_.position[vertical];
    const auto block_first = static_cast<std::size_t>(clusters_.begin[begin]);
    const bool in_plan = D == 3 && drag_->varies_in_plan();
    for (std::uint32_t left = reaching; left != 0; left &= left - 1) {
        const std::size_t cluster = begin + static_cast<std::size_t>(std::countr_zero(left));
        const auto first = static_cast<std::size_t>(clusters_.begin[cluster]);
        const auto count = static_cast<std::size_t>(clusters_.count(cluster));
        double* const drag = &task.particles.drag[first - block_first];
        if (in_plan) {
            for (std::size_t n = 0; n < count; ++n) {
                drag[n] = bed_drag_at(first + n);
            }
        } else {
            drag_->coefficients({&height[first], count}, {drag, count});
        }
    }
}

template <int D, class Real>
double SimulationOf<D, Real>::bed_drag_at(std::size_t particle) const {
    return drag_->coefficient_at(particles_.position[0][particle], particles_.position[1][particle],
                                 particles_.position[vertical][particle]);
}

// Each side wall takes wall_over_bed times the drag of the bed of the whole width: of all that is simulated
// between two walls, of twice that where one half is simulated. Either way the coefficient of its layer is
// 2 wall_over_bed sum(m beta u|u|) / sum over all layers (m u|u|).
template <int D, class Real>
void SimulationOf<D, Real>::set_side_drag(double bed_drag, double side_layer) {
    // Of water at rest nothing follows; the last coefficient stays.
    if (bed_drag >= 0.0 && side_layer > 0.0) {
        clock_.side_wall_drag_coefficient = 2.0 * wall_over_bed_ * bed_drag / side_layer;
    }
}

template <int D, class Real>
void SimulationOf<D, Real>::measure_side_drag() {
    using Sums = std::array<double, 2>;
    const Sums sums = reduce_blocks(
        particles_.size(), std::size_t{1024}, Sums{},
        [&](std::size_t begin, std::size_t end) {
            Sums part{};
            for (std::size_t i = begin; i < end; ++i) {
                const double u = particles_.velocity[0][i];
                const double square = particles_.mass[i] * u * std::abs(u);
                const double y = particles_.position[1][i];
                part[0] += bed_drag_at(i) * square;
                part[1] += y < particle_data_.layer_below || y > particle_data_.layer_above ? square : 0.0;
            }
            return part;
        },
        [](const Sums& a, const Sums& b) {
            return Sums{a[0] + b[0], a[1] + b[1]};
        });
    set_side_drag(sums[0], sums[1]);
}

template <int D, class Real>
void SimulationOf<D, Real>::add_drags(Task& task, std::size_t lane, std::size_t particle, double bed,
                                      Vec<D>& a) const {
    const auto drag = [&](double beta, std::size_t k) {
        const double u = particles_.velocity[k][particle];
        const double acceleration = -beta * u * std::abs(u);
        a[k] += acceleration;
        return acceleration;
    };
    task.particles.drag_force[lane] = drag(bed, 0);
    if constexpr (D == 3) {
        task.particles.drag_force_across[lane] = drag(bed, 1);
        const double y = particles_.position[1][particle];
        const bool inside = y < particle_data_.layer_below || y > particle_data_.layer_above;
        const double side = inside ? clock_.side_wall_drag_coefficient : 0.0;
        task.particles.side_force[lane] = drag(side, 0);
        task.particles.side_force_vertical[lane] = drag(side, 2);
    }
}

template class SimulationOf<2, float>;
template class SimulationOf<2, double>;
template class SimulationOf<3, float>;
template class SimulationOf<3, double>;

}  // namespace riffle
