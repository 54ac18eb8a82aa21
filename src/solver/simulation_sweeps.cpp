// The sweeps over the clusters that make up a force evaluation.

#include <algorithm>
#include <cmath>
#include <limits>
#include <span>

#include "base/parallel.hpp"
#include "solver/pair_setup.hpp"
#include "solver/simulation_of.hpp"

namespace riffle {

namespace {

/// Ask for values [begin, end) that will be read and written.
template <class Values>
void fetch(const Values& values, std::size_t begin, std::size_t end) {
    constexpr std::size_t line = 64;  // of the caches, bytes; some records are longer
    constexpr std::size_t step = std::max<std::size_t>(line / sizeof(values[0]), 1);
    for (std::size_t i = begin; i < end; i += step) {
        __builtin_prefetch(&values[i], 1);
    }
    // Else GCC takes the function for one without effects and drops its calls.
    asm volatile("");
}

}  // namespace

template <int D, class Real>
void SimulationOf<D, Real>::evaluate(const StageSteps& steps) {
    move_walls();
    if (!contact_.empty()) {
        bodies_after_ = motion_.at(clock_.time + steps.motion);
    }
    contact_depth_.assign(block_advance_.size(), 0.0);
    measure_stirring();
    for (const auto& sweep : sweeps_) {
        sweep->begin(data_, clusters_);
    }
    Displacement<D>* const moved = displacements_due() ? &moved_ : nullptr;
    if (order_.sections() == 1) {
        for (std::size_t wave = 0; wave < order_.waves; ++wave) {
            evaluate_wave(wave, steps, moved, false);
        }
    } else {
        parallel_blocks(order_.sections(), 1, [&](std::size_t section, std::size_t) {
            for (auto wave = order_.section_begin[section]; wave < order_.section_begin[section + 1];
                 ++wave) {
                evaluate_wave(wave, steps, moved, true);
            }
        });
        evaluate_wave(order_.waves - 1, steps, moved, false);
    }
    moved_known_ = moved != nullptr;
    gather_motion(steps.motion);
    fill_last_records();
}

template <int D, class Real>
void SimulationOf<D, Real>::evaluate_wave(std::size_t wave, const StageSteps& steps, Displacement<D>* moved,
                                          bool alone) {
    for_blocks(
        clusters_.size(), order_.gradients.blocks(wave),
        [&](Task& task, std::size_t begin, std::size_t end) { evaluate_gradients(task, begin, end, steps); },
        alone);
    if (ghosts_) {  // all in one wave (build_lists)
        timed(profile_.walls, [&] { ghosts_->interpolate(data_, clusters_, particles_.density_deviation); });
    }
    for_blocks(
        wall_clusters_.size(), order_.walls.blocks(wave),
        [&](Task& task, std::size_t begin, std::size_t end) {
            timed(wall_seconds_[begin / block_clusters],
                  [&] { evaluate_walls(task, begin, end, steps.wall); });
        },
        alone);
    for_blocks(
        clusters_.size(), order_.forces.blocks(wave),
        [&](Task& task, std::size_t begin, std::size_t end) { evaluate_forces(task, begin, end, steps); },
        alone);
    for_blocks(
        clusters_.size(), order_.packing.blocks(wave),
        [&](Task&, std::size_t begin, std::size_t end) {
            // A faulty position may have no integer code; it is reported below.
            if (!block_advance_[begin / block_clusters].fault || can_be_packed(begin, end)) {
                particle_loops_.pack(particle_data_, data_, moved, begin, end);
            }
        },
        alone);
}

template <int D, class Real>
void SimulationOf<D, Real>::fetch_for_stress(std::size_t begin, std::size_t end) {
    if (!asks_ahead_) {
        return;
    }
    // The sums of the blocks that follow begin with the positions of particles that none has read yet: those
    // some columns ahead.
    constexpr std::size_t ahead = 3 * block_clusters;
    fetch(data_.motion, std::min((begin + ahead) * cluster_size, data_.motion.size()),
          std::min((end + ahead) * cluster_size, data_.motion.size()));
    const auto first = static_cast<std::size_t>(clusters_.begin[begin]);
    const auto last = static_cast<std::size_t>(clusters_.begin[end]);
    fetch(particles_.density_deviation, first, last);
    if (particle_data_.uniform_mass == 0.0) {
        fetch(particles_.mass, first, last);
    }
    if (closure_) {
        fetch(particles_.position[vertical], first, last);
    }
    if (!data_.stress.empty()) {
        fetch(data_.stress, begin * cluster_size, end * cluster_size);
    } else {
        fetch(data_.pressure, begin * cluster_size, end * cluster_size);
    }
}

template <int D, class Real>
void SimulationOf<D, Real>::fetch_for_motion(std::size_t begin, std::size_t end) {
    if (!asks_ahead_) {
        return;
    }
    const auto first = static_cast<std::size_t>(clusters_.begin[begin]);
    const auto last = static_cast<std::size_t>(clusters_.begin[end]);
    for (std::size_t k = 0; k < axes; ++k) {
        fetch(particles_.position[k], first, last);
        fetch(particles_.velocity[k], first, last);
    }
}

template <int D, class Real>
void SimulationOf<D, Real>::evaluate_gradients(Task& task, std::size_t begin, std::size_t end,
                                               const StageSteps& steps) {
    fetch_for_stress(begin, end);
    timed(block_seconds_[begin / block_clusters].gradients,
          [&] { (steps.midway ? loops_.gradient_midway : loops_.gradient)(data_, begin, end, task.sums); });
    for (const auto& sweep : sweeps_) {
        sweep->complete(data_, clusters_, begin, end, task.sums.gradient);
    }
    if (closure_) {
        find_mixing_lengths(task, begin, end);
    }
    particle_loops_.stress(particle_data_, data_, task.sums, task.particles, steps.density, begin, end);
    if (stepper_) {
        for_clusters(begin, end, [&](std::size_t first, std::size_t last, std::size_t lane) {
            std::copy_n(&task.particles.density_rate[lane], last - first, &density_rate_[first]);
        });
    }
    if (keep_fields_) {
        keep_stress_fields(task, begin, end);
    }
}

template <int D, class Real>
void SimulationOf<D, Real>::find_mixing_lengths(Task& task, std::size_t begin, std::size_t end) const {
    const auto first = static_cast<std::size_t>(clusters_.begin[begin]);
    const auto count = static_cast<std::size_t>(clusters_.begin[end]) - first;
    double* const lengths = task.particles.mixing_length.data();
    closure_->mixing_lengths({&particles_.position[vertical][first], count}, {lengths, count});
    if constexpr (D == 3) {
        for (std::size_t i = 0; closure_->varies_across() && i < count; ++i) {
            lengths[i] *= closure_->side_factor(particles_.position[1][first + i]);
        }
    }
}

template <int D, class Real>
void SimulationOf<D, Real>::keep_stress_fields(const Task& task, std::size_t begin, std::size_t end) {
    const bool gradients = !data_.stress.empty();
    const auto& gradient = task.sums.gradient;
    for_clusters(begin, end, [&](std::size_t first, std::size_t last, std::size_t first_lane) {
        for (std::size_t i = first; i < last; ++i) {
            const std::size_t lane = first_lane + (i - first);
            fields_.pressure.set(i, task.particles.pressure[lane]);
            fields_.eddy_viscosity.set(i, task.particles.eddy_viscosity[lane]);
            fields_.shear.set(i, gradients ? gradient.velocity_gradient[vertical][lane] : Real(0));
            if constexpr (D == 2) {
                fields_.regularity.set(i, gradients ? gradient.regularity[lane] : Real(1));
            }
            const auto twice_strain = [&](std::size_t k, std::size_t l) {
                return gradients ? static_cast<double>(gradient.velocity_gradient[k * axes + l][lane]) +
                                       static_cast<double>(gradient.velocity_gradient[l * axes + k][lane])
                                 : 0.0;
            };
            const double density = scheme_.density * (1.0 + particles_.density_deviation[i]);
            const double nu_t = fields_.eddy_viscosity[i];
            fields_.shear_stress[i] = density * (scheme_.viscosity + nu_t) * twice_strain(0, vertical);
            if constexpr (D == 3) {
                fields_.lateral_shear_stress[i] =
                    density * (scheme_.viscosity + particle_data_.shear_weight_across * nu_t) *
                    twice_strain(0, 1);
            }
        }
    });
}

template <int D, class Real>
void SimulationOf<D, Real>::evaluate_walls(Task& task, std::size_t begin, std::size_t end, double step) {
    if (ghosts_) {
        update_walls_by_ghosts(begin, end);
        return;
    }
    loops_.wall(data_, begin, end, task.sums);
    for (std::size_t slot = begin * cluster_size; slot < end * cluster_size; ++slot) {
        const std::int32_t particle = wall_clusters_.particle_of(slot);
        if (particle >= 0) {
            update_wall(slot, static_cast<std::size_t>(particle), task.sums.wall, slot - begin * cluster_size,
                        step);
        }
    }
}

template <int D, class Real>
void SimulationOf<D, Real>::evaluate_forces(Task& task, std::size_t begin, std::size_t end,
                                            const StageSteps& steps) {
    const std::size_t block = begin / block_clusters;
    fetch_for_motion(begin, end);
    timed(block_seconds_[block].forces, [&] { loops_.force(data_, begin, end, task.sums); });
    if (keep_fields_ && !solid_lists_.empty()) {
        sum_solid_forces(task, begin, end);
    }
    ++block_seconds_[block].measurements;
    if (drag_) {
        find_drag(task, begin, end);
    }
    if (has_accelerations()) {
        for (auto& component : task.particles.acceleration) {
            component.fill(0.0);
        }
    }
    if (stirring_.active()) {
        add_stirring(task, begin, end);
    }
    if (repulsion_.active()) {
        add_repulsion(task, begin, end);
    }
    const bool smoothed = case_.numerics.xsph != 0.0;
    if (smoothed) {
        for (std::size_t k = 0; k < axes; ++k) {
            for_clusters(begin, end, [&](std::size_t first, std::size_t last, std::size_t lane) {
                std::fill_n(&task.particles.transport[k][lane], cluster_size, 0.0);
                std::copy_n(&smoothed_velocity_[k][first], last - first, &task.particles.transport[k][lane]);
            });
        }
    }
    if (stepper_) {
        advance_by_rates(task, begin, end);
    } else {
        block_advance_[block] = particle_loops_.advance(particle_data_, task.sums, task.particles,
                                                        {.step = steps.motion,
                                                         .kick = steps.kick,
                                                         .drag = drag_ != nullptr,
                                                         .acceleration = has_accelerations(),
                                                         .transport = smoothed,
                                                         .side_drag = clock_.side_wall_drag_coefficient,
                                                         .sum_of_drags = wall_over_bed_ > 0.0},
                                                        begin, end);
    }
    if (keep_fields_) {
        keep_force_fields(task, begin, end);
    }
    if (!contact_.empty() || !planes_.empty()) {
        keep_out_of_walls(begin, end, steps.motion);
    }
}

// What the blocks say of the motion: faults, the largest acceleration, and a bound of how far any two
// particles, or a particle and a wall, can have moved against each other.
template <int D, class Real>
void SimulationOf<D, Real>::gather_motion(double step) {
    double largest = 0.0;
    bool fault = false;
    Vec<D> slowest{};  // zero: the walls at rest
    Vec<D> fastest{};
    double bed_drag = 0.0;
    double side_layer = 0.0;
    for (const AdvanceResult<D>& block : block_advance_) {
        bed_drag += block.bed_drag;
        side_layer += block.side_layer;
        largest = std::max(largest, block.largest);
        fault = fault || block.fault;
        for (std::size_t k = 0; k < axes; ++k) {
            slowest[k] = std::min(slowest[k], block.slowest[k]);
            fastest[k] = std::max(fastest[k], block.fastest[k]);
        }
    }
    if (fault) {
        check_state();
        leaving_ = true;
    }
    add_wall_motion(step, slowest, fastest);
    if (wall_over_bed_ > 0.0) {
        if (stepper_) {
            measure_side_drag();
        } else {
            set_side_drag(bed_drag, side_layer);
        }
    }
    clock_.largest_acceleration = std::sqrt(largest);
    double squared = 0.0;
    for (std::size_t k = 0; k < axes; ++k) {
        squared += (fastest[k] - slowest[k]) * (fastest[k] - slowest[k]);
    }
    // A hair more than the rounding of the moved positions.
    last_motion_ =
        stepper_ ? std::numeric_limits<double>::infinity() : (1.0 + 1e-6) * step * std::sqrt(squared);
    clock_.displacement_bound += last_motion_;
    if (!contact_depth_.empty()) {
        clock_.displacement_bound += 2.0 * *std::max_element(contact_depth_.begin(), contact_depth_.end());
    }
}

template <int D, class Real>
void SimulationOf<D, Real>::keep_force_fields(const Task& task, std::size_t begin, std::size_t end) {
    const bool corrected = weighs_by_volume(case_);
    for_clusters(begin, end, [&](std::size_t first, std::size_t last, std::size_t first_lane) {
        for (std::size_t i = first; i < last; ++i) {
            const std::size_t lane = first_lane + (i - first);
            const double factor = corrected ? 1.0 / (1.0 + particles_.density_deviation[i]) : 1.0;
            fields_.pair_acceleration_x[i] = factor * static_cast<double>(task.sums.force.tensor[0][lane]);
            fields_.viscous_acceleration_x[i] =
                factor * static_cast<double>(task.sums.force.viscous[0][lane]);
            double wall_x = factor * static_cast<double>(task.sums.force.wall[0][lane]);
            double wall_z = factor * static_cast<double>(task.sums.force.wall[vertical][lane]);
            if (repulsion_.active()) {
                wall_x += task.repulsion[0][lane];
                wall_z += task.repulsion[vertical][lane];
            }
            fields_.wall_acceleration_x.set(i, wall_x);
            fields_.wall_acceleration_z.set(i, wall_z);
            fields_.drag_acceleration_x.set(i, drag_ ? task.particles.drag_force[lane] : 0.0);
            if constexpr (D == 3) {
                fields_.drag_acceleration_y.set(i, drag_ ? task.particles.drag_force_across[lane] : 0.0);
                fields_.side_wall_acceleration_x.set(i, side_drag_ ? task.particles.side_force[lane] : 0.0);
                fields_.side_wall_acceleration_z.set(
                    i, side_drag_ ? task.particles.side_force_vertical[lane] : 0.0);
            }
        }
    });
}

template <int D, class Real>
void SimulationOf<D, Real>::advance_by_rates(Task& task, std::size_t begin, std::size_t end) {
    const bool corrected = weighs_by_volume(case_);
    const bool smoothed = case_.numerics.xsph != 0.0;
    const auto block_first = static_cast<std::size_t>(clusters_.begin[begin]);
    double largest = 0.0;
    bool fault = false;
    for_clusters(begin, end, [&](std::size_t first, std::size_t last, std::size_t first_lane) {
        const bool dragged = drag_ && (task.particles.drag_clusters >> first_lane / cluster_size & 1U) != 0;
        for (std::size_t i = first; i < last; ++i) {
            const std::size_t lane = first_lane + (i - first);
            const double factor = corrected ? 1.0 / (1.0 + particles_.density_deviation[i]) : 1.0;
            double squared = 0.0;
            Vec<D> drags{};
            add_drags(task, lane, i, dragged ? task.particles.drag[i - block_first] : 0.0, drags);
            ParticleRates<D> rates{.density = density_rate_[i]};
            for (std::size_t k = 0; k < axes; ++k) {
                double a = factor * (static_cast<double>(task.sums.force.tensor[k][lane]) +
                                     static_cast<double>(task.sums.force.viscous[k][lane])) +
                           particle_data_.gravity[k];
                a += has_accelerations() ? task.particles.acceleration[k][lane] : 0.0;
                squared += a * a;
                rates.acceleration[k] = a + drags[k];
                rates.drift[k] = smoothed ? task.particles.transport[k][lane] : 0.0;
            }
            largest = std::max(largest, squared);
            stepper_->advance(evaluation_, i, rates, particles_);
            fault = fault || !std::isfinite(particles_.density_deviation[i]);
            for (std::size_t k = 0; k < axes; ++k) {
                double& x = particles_.position[k][i];
                if (domain_.periodic[k]) {
                    x += x < domain_.lower[k] ? domain_.extent(static_cast<int>(k)) : 0.0;
                    x -= x >= domain_.upper[k] ? domain_.extent(static_cast<int>(k)) : 0.0;
                }
                fault = fault || !std::isfinite(particles_.velocity[k][i]);
            }
            fault = fault || !stays(i);
        }
    });
    block_advance_[begin / block_clusters] = {.largest = largest, .fault = fault};
}

template class SimulationOf<2, float>;
template class SimulationOf<2, double>;
template class SimulationOf<3, float>;
template class SimulationOf<3, double>;

}  // namespace riffle
