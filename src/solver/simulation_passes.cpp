// The passes over the clusters that make up a force evaluation.

#include <algorithm>
#include <cmath>
#include <limits>
#include <span>

#include "base/parallel.hpp"
#include "solver/simulation_of.hpp"

namespace riffle::inline solver {

namespace {

/// Ask for values [begin, end) that will be read and written.
template <class Values>
void fetch(const Values& values, std::size_t begin, std::size_t end) {
    constexpr std::size_t line = 64;  // of the caches, bytes; some records are longer
    constexpr std::size_t step = std::max<std::size_t>(line / sizeof(values[0]), 1);
    for (std::size_t i = begin; i < end; i += step) __builtin_prefetch(&values[i], 1);
    // Else GCC takes the function for one without effects and drops its calls.
    asm volatile("");
}

}  // namespace

// Fields: `state` are the arrays of a set, the others its records. `motion`: position, velocity and density
// at the start of the evaluation; `stress`: of the same particles, with pressure and the correction B;
// `volume` and `force`: what the gradient pass and the force pass need of a wall particle.
template <int D, class Real>
auto SimulationOf<D, Real>::make_passes() -> std::vector<Pass> {
    std::vector<Pass> passes;
    passes.push_back({.declaration = {.name = "gradients",
                                      .set = fluid_set,
                                      .reads = {"state", "motion"},
                                      .neighbours = {{fluid_set, {"motion"}}, {wall_set, {"volume"}}},
                                      .writes = {"state", "stress"}},
                      .run = [this](Task& task, const Stage& stage, std::size_t begin, std::size_t end) {
                          evaluate_gradients(task, stage, begin, end);
                      }});
    if (walls_.looks_at_all_water(flow_)) {
        passes.push_back({.declaration = {.name = "look at the water", .set = wall_set, .whole = true},
                          .run = [this](Task&, const Stage&, std::size_t, std::size_t) {
                              timed(profile_.walls, [this] { walls_.look_at_water(flow_); });
                          }});
    }
    passes.push_back({.declaration = {.name = "walls",
                                      .set = wall_set,
                                      .reads = {"state"},
                                      .neighbours = {{fluid_set, {"motion", "stress"}}},
                                      .writes = {"state", "volume", "force"}},
                      .run = [this](Task& task, const Stage& stage, std::size_t begin, std::size_t end) {
                          timed(wall_seconds_[begin / block_clusters],
                                [&] { walls_.update(flow_, task, stage, begin, end); });
                      }});
    passes.push_back(
        {.declaration = {.name = "forces and motion",
                         .set = fluid_set,
                         .reads = {"state", "motion", "stress"},
                         .neighbours = {{fluid_set, {"motion", "stress"}}, {wall_set, {"force"}}},
                         .writes = {"state"}},
         .run = [this](Task& task, const Stage& stage, std::size_t begin, std::size_t end) {
             evaluate_forces(task, stage, begin, end);
         }});
    passes.push_back(
        {.declaration = {.name = "packing",
                         .set = fluid_set,
                         .reads = {"state"},
                         .neighbours = {},
                         .writes = {"motion"}},
         .run = [this](Task&, const Stage&, std::size_t begin, std::size_t end) { pack(begin, end); }});
    return passes;
}

template <int D, class Real>
void SimulationOf<D, Real>::evaluate(const Stage& stage) {
    walls_.move(flow_, stage);
    for (const auto& component : components_) component->begin_evaluation(flow_, stage);
    finds_displacements_ = displacements_due();
    if (order_.strips() == 1) {
        for (std::size_t wave = 0; wave < order_.waves; ++wave) evaluate_wave(wave, stage, false);
    } else {
        parallel_blocks(order_.strips(), 1, [&](std::size_t strip, std::size_t) {
            for (auto wave = order_.strip_begin[strip]; wave < order_.strip_begin[strip + 1]; ++wave) {
                evaluate_wave(wave, stage, true);
            }
        });
        evaluate_wave(order_.waves - 1, stage, false);
    }
    flow_.moved_known = finds_displacements_;
    gather_motion(stage.motion);
    for (const auto& component : components_) component->end_evaluation(flow_);
    flow_.fill_last_records();
}

template <int D, class Real>
void SimulationOf<D, Real>::evaluate_wave(std::size_t wave, const Stage& stage, bool alone) {
    const std::array sizes{flow_.clusters.size(), flow_.wall_clusters.size()};
    for (std::size_t p = 0; p < passes_.size(); ++p) {
        const Pass& pass = passes_[p];
        if (pass.declaration.whole) {
            Task none;
            pass.run(none, stage, 0, sizes[pass.declaration.set]);
            continue;
        }
        flow_.for_blocks(
            sizes[pass.declaration.set], order_.passes[p].blocks(wave),
            [&](Task& task, std::size_t begin, std::size_t end) { pass.run(task, stage, begin, end); },
            alone);
    }
}

template <int D, class Real>
void SimulationOf<D, Real>::fetch_for_stress(std::size_t begin, std::size_t end) {
    if (!asks_ahead_) return;
    // The sums of the blocks that follow begin with the positions of particles that none has read yet: those
    // some columns ahead.
    constexpr std::size_t ahead = 3 * block_clusters;
    fetch(flow_.data.motion, std::min((begin + ahead) * cluster_size, flow_.data.motion.size()),
          std::min((end + ahead) * cluster_size, flow_.data.motion.size()));
    const auto first = static_cast<std::size_t>(flow_.clusters.begin[begin]);
    const auto last = static_cast<std::size_t>(flow_.clusters.begin[end]);
    fetch(flow_.particles.density_deviation, first, last);
    if (flow_.particle_data.uniform_mass == 0.0) fetch(flow_.particles.mass, first, last);
    if (flow_.particle_data.closure) fetch(flow_.particles.position[vertical], first, last);
    if (!flow_.data.stress.empty()) {
        fetch(flow_.data.stress, begin * cluster_size, end * cluster_size);
    } else {
        fetch(flow_.data.pressure, begin * cluster_size, end * cluster_size);
    }
}

template <int D, class Real>
void SimulationOf<D, Real>::fetch_for_motion(std::size_t begin, std::size_t end) {
    if (!asks_ahead_) return;
    const auto first = static_cast<std::size_t>(flow_.clusters.begin[begin]);
    const auto last = static_cast<std::size_t>(flow_.clusters.begin[end]);
    for (std::size_t k = 0; k < axes; ++k) {
        fetch(flow_.particles.position[k], first, last);
        fetch(flow_.particles.velocity[k], first, last);
    }
}

template <int D, class Real>
void SimulationOf<D, Real>::evaluate_gradients(Task& task, const Stage& stage, std::size_t begin,
                                               std::size_t end) {
    fetch_for_stress(begin, end);
    timed(block_seconds_[begin / block_clusters].gradients, [&] {
        (stage.midway ? flow_.loops.gradient_midway : flow_.loops.gradient)(flow_.data, begin, end,
                                                                            task.sums);
    });
    for (const auto& component : components_) component->complete_gradients(flow_, task, begin, end);
    flow_.particle_loops.stress(flow_.particle_data, flow_.data, task.sums, task.particles, stage.density,
                                begin, end);
    if (!flow_.porous.empty()) flow_.put_media_in_stress(begin, end);
    method_->keep_rates(flow_, task, begin, end);
    if (flow_.keep_fields) keep_stress_fields(task, begin, end);
}

template <int D, class Real>
void SimulationOf<D, Real>::keep_stress_fields(const Task& task, std::size_t begin, std::size_t end) {
    const bool gradients = !flow_.data.stress.empty();
    const auto& gradient = task.sums.gradient;
    flow_.for_particles(begin, end, [&](std::size_t i, std::size_t lane) {
        flow_.fields.pressure.set(i, task.particles.pressure[lane]);
        flow_.fields.eddy_viscosity.set(i, task.particles.eddy_viscosity[lane]);
        flow_.fields.shear.set(i, gradients ? gradient.velocity_gradient[vertical][lane] : Real(0));
        if constexpr (D == 2) flow_.fields.regularity.set(i, gradients ? gradient.regularity[lane] : Real(1));
        const auto twice_strain = [&](std::size_t k, std::size_t l) {
            return gradients ? static_cast<double>(gradient.velocity_gradient[k * axes + l][lane]) +
                                   static_cast<double>(gradient.velocity_gradient[l * axes + k][lane])
                             : 0.0;
        };
        const double density = flow_.scheme.density * (1.0 + flow_.particles.density_deviation[i]);
        const double nu_t = flow_.fields.eddy_viscosity[i];
        flow_.fields.shear_stress[i] = density * (flow_.scheme.viscosity + nu_t) * twice_strain(0, vertical);
        if constexpr (D == 3) {
            flow_.fields.lateral_shear_stress[i] =
                density * (flow_.scheme.viscosity + flow_.particle_data.shear_weight_across * nu_t) *
                twice_strain(0, 1);
        }
    });
}

template <int D, class Real>
void SimulationOf<D, Real>::evaluate_forces(Task& task, const Stage& stage, std::size_t begin,
                                            std::size_t end) {
    const std::size_t block = begin / block_clusters;
    fetch_for_motion(begin, end);
    timed(block_seconds_[block].forces, [&] { flow_.loops.force(flow_.data, begin, end, task.sums); });
    ++block_seconds_[block].measurements;
    if (flow_.inputs.acceleration) {
        for (std::size_t k = 0; k < axes; ++k) {
            task.particles.acceleration[k].fill(0.0);
            task.wall_acceleration[k].fill(0.0);
        }
    }
    if (flow_.with_vegetation) {
        for (auto& along_axis : task.vegetation_acceleration) along_axis.fill(0.0);
    }
    if (!flow_.porous.empty()) {
        for (auto& along_axis : task.porous_acceleration) along_axis.fill(0.0);
    }
    for (const auto& component : components_) component->add_forces(flow_, task, begin, end);
    flow_.block_advance[block] = method_->move(flow_, task, stage, begin, end);
    if (flow_.keep_fields) keep_force_fields(task, begin, end);
    for (const auto& component : components_) component->after_motion(flow_, task, stage, begin, end);
}

template <int D, class Real>
void SimulationOf<D, Real>::pack(std::size_t begin, std::size_t end) {
    // A faulty position may have no integer code; it is reported by gather_motion().
    if (!flow_.block_advance[begin / block_clusters].fault || can_be_packed(begin, end)) {
        flow_.pack(finds_displacements_ ? &flow_.moved : nullptr, begin, end);
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
    for (const AdvanceResult<D>& block : flow_.block_advance) {
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
    walls_.add_motion(flow_, step, slowest, fastest);
    flow_.clock.largest_acceleration = std::sqrt(largest);
    double squared = 0.0;
    for (std::size_t k = 0; k < axes; ++k) squared += (fastest[k] - slowest[k]) * (fastest[k] - slowest[k]);
    // A hair more than the rounding of the moved positions.
    last_motion_ = method_->sums_motion() ? (1.0 + 1e-6) * step * std::sqrt(squared)
                                          : std::numeric_limits<double>::infinity();
    flow_.clock.displacement_bound += last_motion_;
}

template <int D, class Real>
void SimulationOf<D, Real>::keep_force_fields(const Task& task, std::size_t begin, std::size_t end) {
    const AdvanceOptions& inputs = flow_.inputs;
    ParticleFields& fields = flow_.fields;
    const ForceResult<D, Real>& force = task.sums.force;
    const ParticleWork<D, Real>& work = task.particles;
    flow_.for_particles(begin, end, [&](std::size_t i, std::size_t lane) {
        const double factor = flow_.force_factor(i);
        // What walls do without pairs: repulsion, the friction of the log law.
        const auto further = [&](std::size_t k) {
            return inputs.acceleration ? task.wall_acceleration[k][lane] : 0.0;
        };
        const auto by_walls = [&](std::size_t k) {
            return factor * static_cast<double>(force.wall[k][lane]) + further(k);
        };
        // Under a reference pressure the bed bears through it what no pair of theirs carries.
        const double held =
            flow_.particle_data.reference_pressure.acts() ? task.reference_acceleration[lane] : 0.0;
        fields.pair_acceleration_x[i] = factor * static_cast<double>(force.tensor[0][lane]) + further(0);
        fields.viscous_acceleration_x[i] = factor * static_cast<double>(force.viscous[0][lane]);
        fields.wall_acceleration_x.set(i, by_walls(0));
        fields.wall_acceleration_z.set(i, by_walls(vertical) + held);
        fields.drag_acceleration_x.set(i, inputs.drag ? work.drag_force[lane] : 0.0);
        fields.vegetation_acceleration_x.set(
            i, flow_.with_vegetation ? task.vegetation_acceleration[0][lane] : 0.0);
        fields.porous_acceleration_x.set(i, flow_.porous.empty() ? 0.0 : task.porous_acceleration[0][lane]);
        if constexpr (D == 3) {
            const bool side = flow_.with_side_drag;
            fields.drag_acceleration_y.set(i, inputs.drag ? work.drag_force_across[lane] : 0.0);
            fields.side_wall_acceleration_x.set(i, side ? work.side_force[lane] : 0.0);
            fields.side_wall_acceleration_z.set(i, side ? work.side_force_vertical[lane] : 0.0);
        }
    });
}

template class SimulationOf<2, float>;
template class SimulationOf<2, double>;
template class SimulationOf<3, float>;
template class SimulationOf<3, double>;

}  // namespace riffle::inline solver
