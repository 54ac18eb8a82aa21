// Construction and time stepping.

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "base/parallel.hpp"
#include "solver/simulation_of.hpp"
#include "sph/pair_approach.hpp"

namespace riffle::inline solver {

template <int D, class Real>
SimulationOf<D, Real>::SimulationOf(const Case& c, const ColumnResult* column, Particles<D> particles)
    : flow_(c, column, std::move(particles)),
      walls_(flow_),
      components_(make_components(flow_, column != nullptr ? column->total_mean_velocity : 0.0)),
      method_(make_method(flow_)) {
    flow_.motion_summed = method_->sums_motion();
    check_state();
    walls_.place_at_start(flow_);
    passes_ = make_passes();
    build_lists(true);
    flow_.fields.template reset<Real>(flow_.particles.size(), D, flow_.scheme.density);
}

template <int D, class Real>
double SimulationOf<D, Real>::choose_step() const {
    const Numerics& numerics = flow_.c.numerics;
    if (numerics.time_step) return *numerics.time_step;
    const Scheme& scheme = flow_.scheme;
    const double largest_acceleration = flow_.clock.largest_acceleration;
    if (numerics.step_rule == StepRule::monaghan_kos) {
        const double approach =
            largest_pair_approach(flow_.data, flow_.clusters, flow_.fixed_point, scheme.smoothing_length);
        return std::min(scheme.acoustic_step,
                        monaghan_kos_step(scheme, numerics.courant_number, largest_acceleration, approach));
    }
    return std::min(scheme.acoustic_step, force_limited_step(scheme, largest_acceleration));
}

template <int D, class Real>
void SimulationOf<D, Real>::step(double fields_due) {
    timed(profile_.total, [&] { take_step(fields_due); });
}

template <int D, class Real>
void SimulationOf<D, Real>::take_step(double fields_due) {
    timed(profile_.lists, [&] {
        // A second evaluation of the step finds the particles moved by up to half of what the lists allow.
        if (!lists_valid(evaluations_per_step() == 1 ? 1.0 : 0.5)) build_lists(true);
    });
    for (const auto& component : components_) component->before_step(flow_);
    const double dt = choose_step();
    SimulationClock& clock = flow_.clock;
    // As the recorder will see the time: the same sum.
    flow_.keep_fields = clock.time + dt >= fields_due;
    if (flow_.keep_fields) flow_.fields.template reset<Real>(flow_.particles.size(), D, flow_.scheme.density);
    const auto looks_at_walls = [this](const auto& component) { return component->looks_at_walls(flow_); };
    if (std::any_of(components_.begin(), components_.end(), looks_at_walls)) walls_.bring_to_clock(flow_);
    for (const auto& component : components_) component->begin_step(flow_, dt);
    const double begin = clock.time;
    for (const Stage& stage : method_->begin(flow_, dt)) {
        clock.time = begin + stage.time;
        evaluate(stage);
    }
    for (const auto& component : components_) component->end_step(flow_);
    clock.time_step = dt;
    clock.time = begin + dt;
    ++clock.steps;
    if (leaving_) take_out_leaving();
}

template <int D, class Real>
void SimulationOf<D, Real>::measure_profile(bool on) {
    profiling_ = on;
    profile_ = {};
    std::fill(block_seconds_.begin(), block_seconds_.end(), BlockSeconds{});
    std::fill(wall_seconds_.begin(), wall_seconds_.end(), 0.0);
    // Two measurements a block cost up to 2 % of a step, which is none of its parts. The least of some
    // trials: the machine may interrupt one.
    constexpr int trials = 20;
    constexpr int each = 100;
    clock_seconds_ = std::numeric_limits<double>::infinity();
    for (int trial = 0; trial < trials; ++trial) {
        double inside = 0.0;
        double all = 0.0;
        timed(all, [&] {
            for (int n = 0; n < each; ++n) {
                timed(inside, [] {});
            }
        });
        if (all / each < clock_seconds_) {
            clock_seconds_ = all / each;
            clock_seconds_inside_ = inside / each;
        }
    }
}

template <int D, class Real>
StepProfile SimulationOf<D, Real>::profile() const {
    StepProfile result = profile_;
    const double threads = thread_count();
    for (const BlockSeconds& block : block_seconds_) {
        const auto measurements = static_cast<double>(block.measurements);
        result.gradients += (block.gradients - measurements * clock_seconds_inside_) / threads;
        result.forces += (block.forces - measurements * clock_seconds_inside_) / threads;
        result.total -= 2.0 * measurements * clock_seconds_ / threads;
    }
    for (const double seconds : wall_seconds_) result.walls += seconds / threads;
    result.particles = result.total - result.lists - result.walls - result.gradients - result.forces;
    return result;
}

template class SimulationOf<2, float>;
template class SimulationOf<2, double>;
template class SimulationOf<3, float>;
template class SimulationOf<3, double>;

template <int D>
std::unique_ptr<SimulationIn<D>> make_simulation(const Case& c, const ColumnResult* column,
                                                 Particles<D> particles) {
    if (c.numerics.precision == Precision::double_precision) {
        return std::make_unique<SimulationOf<D, double>>(c, column, std::move(particles));
    }
    return std::make_unique<SimulationOf<D, float>>(c, column, std::move(particles));
}

template std::unique_ptr<SimulationIn<2>> make_simulation<2>(const Case&, const ColumnResult*, Particles<2>);
template std::unique_ptr<SimulationIn<3>> make_simulation<3>(const Case&, const ColumnResult*, Particles<3>);

}  // namespace riffle::inline solver
