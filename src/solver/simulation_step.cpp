// Construction and time stepping.

#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <cmath>

#include "base/error.hpp"
#include "base/parallel.hpp"
#include "particles/lattice.hpp"
#include "solver/simulation_of.hpp"

namespace riffle {

std::array<std::vector<double>*, 8> ParticleFields::all() {
    return {&pressure,
            &eddy_viscosity,
            &shear,
            &regularity,
            &pair_acceleration_x,
            &viscous_acceleration_x,
            &wall_acceleration_x,
            &drag_acceleration_x};
}

std::array<const std::vector<double>*, 8> ParticleFields::all() const {
    return {&pressure,
            &eddy_viscosity,
            &shear,
            &regularity,
            &pair_acceleration_x,
            &viscous_acceleration_x,
            &wall_acceleration_x,
            &drag_acceleration_x};
}

void ParticleFields::resize(std::size_t n) {
    for (auto* values : all()) {
        values->resize(n, 0.0);
    }
}

namespace {

/// Whether the velocity gradient and the correction matrix enter the equations.
bool needs_gradients(const Case& c) {
    return c.turbulence.closure != ClosureKind::none || c.numerics.pressure_form == PressureForm::corrected;
}

using Clock = std::chrono::steady_clock;

double seconds_between(Clock::time_point a, Clock::time_point b) {
    return std::chrono::duration<double>(b - a).count();
}

}  // namespace

template <int D, class Real>
SimulationOf<D, Real>::SimulationOf(const Case& c, const ColumnResult* column, Particles<D> particles)
    : case_(c),
      wall_law_(wall_law(c)),
      closure_(make_closure(c)),
      drag_(make_bed_drag(c)),
      stirring_(c, c.stirring.celerity.value_or(column != nullptr ? column->total_mean_velocity : 0.0)),
      domain_(domain_of<D>(c)),
      fixed_point_(domain_),
      loops_(pair_loops<D, Real>(
          {.kernel = c.numerics.kernel, .viscosity = c.numerics.viscosity, .gradients = needs_gradients(c)})),
      particle_loops_(particle_loops<D, Real>()),
      column_width_(cluster_column_spacings(D) * c.numerics.spacing),
      predictor_corrector_(c.numerics.stepping == Stepping::predictor_corrector) {
    particles_ = std::move(particles);
    scheme_ = make_scheme(c, column);
    walls_ = wall_particles<D>(c);
    wall_deviation_.resize(walls_.size());
    for (std::size_t i = 0; i < walls_.size(); ++i) {
        wall_deviation_[i] = scheme_.hydrostatic_deviation(walls_.position[vertical][i]);
    }
    const double h = scheme_.smoothing_length;
    skin_ = c.numerics.skin_in(D) * h;
    auto& constants = data_.constants;
    for (std::size_t k = 0; k < axes; ++k) {
        constants.unit[k] = static_cast<Real>(fixed_point_.unit(k) / h);
    }
    constants.h = static_cast<Real>(h);
    constants.gradient_scale = static_cast<Real>(std::pow(h, -(D + 2)));
    const double c0 = scheme_.state.sound_speed;
    const bool diffusion = c.numerics.density_diffusion == DensityDiffusion::fourtakas;
    constants.diffusion =
        static_cast<Real>(diffusion ? c.numerics.density_diffusion_coefficient * h * c0 : 0.0);
    constants.hydrostatic_gradient = static_cast<Real>(scheme_.normal_gravity / (c0 * c0));
    constants.correct_pressure = c.numerics.pressure_form == PressureForm::corrected;
    constants.correct_gradient = c.numerics.velocity_gradient == VelocityGradient::corrected;

    particle_data_.domain = domain_;
    particle_data_.fixed_point = fixed_point_;
    particle_data_.state = scheme_.state;
    particle_data_.density = scheme_.density;
    particle_data_.viscosity = scheme_.viscosity;
    particle_data_.gravity[0] = scheme_.streamwise_gravity;
    particle_data_.gravity[vertical] = -scheme_.normal_gravity;
    particle_data_.corrected = constants.correct_pressure;
    particle_data_.closure = closure_ != nullptr;
    particle_data_.two_point = closure_ == nullptr || c.numerics.eddy_stress == EddyStress::two_point;
    particle_data_.shear_only = c.turbulence.stress_terms == StressTerms::shear;
    refer_to_particles();

    check_state();
    make_walls();
    build_lists(true);
    fields_.resize(particles_.size());
}

template <int D, class Real>
int SimulationOf<D, Real>::evaluations_per_step() const {
    return predictor_corrector_ ? 2 : 1;
}

template <int D, class Real>
double SimulationOf<D, Real>::choose_step() const {
    if (case_.numerics.time_step) {
        return *case_.numerics.time_step;
    }
    return std::min(scheme_.acoustic_step, force_limited_step(scheme_, clock_.largest_acceleration));
}

template <int D, class Real>
void SimulationOf<D, Real>::check_state() const {
    for (std::size_t i = 0; i < particles_.size(); ++i) {
        bool finite = std::isfinite(particles_.density_deviation[i]);
        bool inside = true;
        std::array<double, 3> x{};  // x, y, z; y of a plane is 0
        std::array<double, 3> u{};
        for (std::size_t k = 0; k < axes; ++k) {
            const std::size_t axis = k == vertical ? 2 : k;
            x[axis] = particles_.position[k][i];
            u[axis] = particles_.velocity[k][i];
            finite = finite && std::isfinite(x[axis]) && std::isfinite(u[axis]);
            inside = inside && fixed_point_.in_range(x[axis], k);
        }
        if (finite && inside) {
            continue;
        }
        const std::string y = D == 3 ? fmt::format("y = {:.6g} m, ", x[1]) : "";
        const std::string v = D == 3 ? fmt::format("{:.4g}, ", u[1]) : "";
        throw RunError(fmt::format(
            "{}: particle {} at x = {:.6g} m, {}z = {:.6g} m, velocity ({:.4g}, {}{:.4g}) m/s, "
            "density deviation {:.4g}, at t = {:.6g} s (step {})",
            finite ? "a particle left the domain" : "the state is no longer finite", particles_.id[i], x[0],
            y, x[2], u[0], v, u[2], particles_.density_deviation[i], clock_.time, clock_.steps));
    }
}

template <int D, class Real>
void SimulationOf<D, Real>::step(double fields_due) {
    const auto start = Clock::now();
    if (!lists_valid(predictor_corrector_ ? 0.5 : 1.0)) {
        build_lists(true);
    }
    profile_.lists += seconds_between(start, Clock::now());
    const auto& numerics = case_.numerics;
    if (numerics.density_filter != DensityFilter::none && clock_.steps > 0 &&
        clock_.steps % numerics.density_filter_interval == 0) {
        filter_density();
        repack();
    }
    if (numerics.xsph != 0.0) {
        sweep_smoothed_velocity();
    }
    const double dt = choose_step();
    // As the recorder will see the time: the same sum.
    keep_fields_ = clock_.time + dt >= fields_due;
    if (keep_fields_) {
        fields_.resize(particles_.size());
    }
    const auto sweep = [&](double density_step, double wall_step, double motion_step) {
        sweep_gradients(density_step);
        const auto before = Clock::now();
        sweep_walls(wall_step);
        profile_.walls += seconds_between(before, Clock::now());
        sweep_forces(motion_step);
    };
    if (predictor_corrector_) {
        saved_ = particles_;
        const double begin = clock_.time;
        sweep(0.0, 0.5 * dt, 0.5 * dt);
        clock_.time = begin + 0.5 * dt;
        sweep(0.0, 0.5 * dt, dt);
        clock_.time = begin;
    } else {
        // Density, pressure, walls, forces, velocity, position, each with the newest of the others (numerics
        // of the default scheme, docs/theory.md). The drag is implicit: u1 + dt beta u1|u1| = u*.
        sweep(dt, dt, dt);
    }
    clock_.time_step = dt;
    clock_.time += dt;
    ++clock_.steps;
    profile_.total += seconds_between(start, Clock::now());
}

template <int D, class Real>
void SimulationOf<D, Real>::drop_fields() {
    for (auto* field : fields_.all()) {
        std::vector<double>().swap(*field);
    }
}

template <int D, class Real>
void SimulationOf<D, Real>::measure_profile(bool on) {
    profiling_ = on;
    profile_ = {};
    std::fill(block_seconds_.begin(), block_seconds_.end(), BlockSeconds{});
}

template <int D, class Real>
StepProfile SimulationOf<D, Real>::profile() const {
    StepProfile result = profile_;
    const double threads = thread_count();
    for (const BlockSeconds& block : block_seconds_) {
        result.gradients += block.gradients / threads;
        result.forces += block.forces / threads;
    }
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

}  // namespace riffle
