// Time stepping.

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "base/error.hpp"
#include "base/parallel.hpp"
#include "particles/lattice.hpp"
#include "solver/simulation_of.hpp"

namespace riffle {

void ParticleFields::resize(std::size_t n) {
    for (auto* values : {&pressure, &eddy_viscosity, &shear, &regularity, &pair_acceleration_x,
                         &viscous_acceleration_x, &wall_acceleration_x, &drag_acceleration_x}) {
        values->resize(n, 0.0);
    }
}

template <class Real>
SimulationOf<Real>::SimulationOf(const Case& c, const ColumnResult* column, Particles<2> particles)
    : case_(c),
      wall_law_(wall_law(c)),
      closure_(make_closure(c)),
      drag_(make_bed_drag(c)),
      stirring_(c, c.stirring.celerity.value_or(column != nullptr ? column->total_mean_velocity : 0.0)),
      domain_(domain_of(c)),
      fixed_point_(domain_),
      loops_(pair_loops<2, Real>(c.numerics.kernel, c.numerics.viscosity)),
      column_width_(2.67 * c.numerics.spacing) {
    particles_ = std::move(particles);
    scheme_ = make_scheme(c, column);
    walls_ = wall_particles(c);
    wall_deviation_.resize(walls_.size());
    for (std::size_t i = 0; i < walls_.size(); ++i) {
        wall_deviation_[i] = scheme_.hydrostatic_deviation(walls_.position[1][i]);
    }
    const double h = scheme_.smoothing_length;
    auto& constants = data_.constants;
    for (std::size_t k = 0; k < 2; ++k) {
        constants.unit[k] = static_cast<Real>(fixed_point_.unit(k));
    }
    constants.inverse_h = static_cast<Real>(1.0 / h);
    constants.gradient_scale = static_cast<Real>(1.0 / (h * h * h * h));
    const double c0 = scheme_.state.sound_speed;
    const bool diffusion = c.numerics.density_diffusion == DensityDiffusion::fourtakas;
    constants.diffusion =
        static_cast<Real>(diffusion ? c.numerics.density_diffusion_coefficient * h * c0 : 0.0);
    constants.hydrostatic_gradient = static_cast<Real>(scheme_.normal_gravity / (c0 * c0));
    constants.correct_pressure = c.numerics.pressure_form == PressureForm::corrected;
    constants.correct_gradient = c.numerics.velocity_gradient == VelocityGradient::corrected;

    check_state();
    if (walls_.size() > 0) {
        const PositionView<2> unsorted = {walls_.position[0], walls_.position[1]};
        const auto order = spatial_order<2>(domain_, unsorted, column_width_, 0.5 * c.numerics.spacing);
        walls_.permute(order);
        wall_clusters_ =
            build_clusters<2>(domain_, fixed_point_, {walls_.position[0], walls_.position[1]}, column_width_);
        pack_wall_records();
    }
    build_lists(true);
}

template <class Real>
void SimulationOf<Real>::restore(Particles<2> particles, const SimulationClock& clock,
                                 std::vector<double> wall_deviation) {
    particles_ = std::move(particles);
    clock_ = clock;
    wall_deviation_ = std::move(wall_deviation);
    check_state();
    build_lists(false);
}

template <class Real>
int SimulationOf<Real>::evaluations_per_step() const {
    return case_.numerics.stepping == Stepping::predictor_corrector ? 2 : 1;
}

template <class Real>
double SimulationOf<Real>::choose_step() const {
    if (case_.numerics.time_step) {
        return *case_.numerics.time_step;
    }
    return std::min(scheme_.acoustic_step, force_limited_step(scheme_, clock_.largest_acceleration));
}

template <class Real>
void SimulationOf<Real>::check_state() const {
    for (std::size_t i = 0; i < particles_.size(); ++i) {
        const double x = particles_.position[0][i];
        const double z = particles_.position[1][i];
        const bool finite =
            std::isfinite(particles_.velocity[0][i]) && std::isfinite(particles_.velocity[1][i]) &&
            std::isfinite(particles_.density_deviation[i]) && std::isfinite(x) && std::isfinite(z);
        if (finite && fixed_point_.in_range(x, 0) && fixed_point_.in_range(z, 1)) {
            continue;
        }
        throw RunError(
            fmt::format("{}: particle {} at x = {:.6g} m, z = {:.6g} m, velocity ({:.4g}, {:.4g}) m/s, "
                        "density deviation {:.4g}, "
                        "at t = {:.6g} s (step {})",
                        finite ? "a particle left the domain" : "the state is no longer finite",
                        particles_.id[i], x, z, particles_.velocity[0][i], particles_.velocity[1][i],
                        particles_.density_deviation[i], clock_.time, clock_.steps));
    }
}

// Velocity that moves a particle: its own, or with XSPH (thesis 2.46) drawn towards its neighbours'.
template <class Real>
double SimulationOf<Real>::transport_velocity(std::size_t i, std::size_t axis) const {
    double u = particles_.velocity[axis][i];
    if (case_.numerics.xsph != 0.0) {
        const auto slot = static_cast<std::size_t>(clusters_.slot_of_particle[i]);
        u += case_.numerics.xsph * static_cast<double>(data_.filter.velocity[axis][slot]);
    }
    return u;
}

template <class Real>
void SimulationOf<Real>::wrap_and_pack(std::size_t first, std::size_t last) {
    const auto cluster = static_cast<std::size_t>(clusters_.slot_of_particle[first]) / cluster_size;
    bool fault = false;
    for (std::size_t i = first; i < last; ++i) {
        for (std::size_t k = 0; k < 2; ++k) {
            double& x = particles_.position[k][i];
            if (domain_.periodic[k]) {
                const double extent = domain_.extent(static_cast<int>(k));
                if (x < domain_.lower[k]) {
                    x += extent;
                } else if (x >= domain_.upper[k]) {
                    x -= extent;
                }
            }
            // Written so that a NaN is a fault too.
            fault = fault || !fixed_point_.in_range(x, k) || !std::isfinite(particles_.velocity[k][i]);
        }
        fault = fault || !std::isfinite(particles_.density_deviation[i]);
    }
    cluster_fault_[cluster] = fault ? 1 : 0;
    if (fault) {
        return;
    }
    const std::size_t slot = cluster * cluster_size;
    for (std::size_t i = first; i < last; ++i) {
        pack_gradient(i, slot + (i - first));
    }
    for (std::size_t empty = slot + (last - first); empty < slot + cluster_size; ++empty) {
        data_.fluid_gradient[empty].x = data_.fluid_gradient[slot].x;
        data_.fluid_force[empty].x = data_.fluid_gradient[slot].x;
    }
    measure_displacement(cluster);
}

template <class Real>
void SimulationOf<Real>::step() {
    const bool two_stages = case_.numerics.stepping == Stepping::predictor_corrector;
    if (!lists_valid(two_stages ? 0.5 : 1.0)) {
        build_lists(true);
    }
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
    if (two_stages) {
        step_predictor_corrector(dt);
    } else {
        step_semi_implicit_euler(dt);
    }
    if (std::any_of(cluster_fault_.begin(), cluster_fault_.end(),
                    [](std::uint8_t fault) { return fault != 0; })) {
        check_state();
    }
    clock_.largest_acceleration =
        std::sqrt(*std::max_element(cluster_largest_.begin(), cluster_largest_.end()));
    clock_.time_step = dt;
    clock_.time += dt;
    ++clock_.steps;
}

// Density, pressure, walls, forces, velocity, position, each with the newest of the others (numerics of the
// default scheme, docs/theory.md). The drag is implicit: u1 + dt beta u1|u1| = u*.
template <class Real>
void SimulationOf<Real>::step_semi_implicit_euler(double dt) {
    sweep_gradients(dt);
    sweep_walls(dt);
    sweep_forces([&](std::size_t first, std::size_t last) {
        for (std::size_t i = first; i < last; ++i) {
            double u = particles_.velocity[0][i] + dt * acceleration_[0][i];
            const double w = particles_.velocity[1][i] + dt * acceleration_[1][i];
            const double beta = drag_coefficient_[i];
            const double free_velocity = u;
            u = 2.0 * u / (1.0 + std::sqrt(1.0 + 4.0 * dt * beta * std::abs(u)));
            fields_.drag_acceleration_x[i] = (u - free_velocity) / dt;
            particles_.velocity[0][i] = u;
            particles_.velocity[1][i] = w;
            particles_.position[0][i] += dt * transport_velocity(i, 0);
            particles_.position[1][i] += dt * transport_velocity(i, 1);
        }
        wrap_and_pack(first, last);
    });
}

// Predictor-corrector of SPHysics (thesis 2.50-2.52): q^(n+1/2) = q^n + dt/2 q'^n, again with the rates at
// n+1/2, then q^(n+1) = 2 q^(n+1/2) - q^n.
template <class Real>
void SimulationOf<Real>::step_predictor_corrector(double dt) {
    saved_ = particles_;
    const double start = clock_.time;
    for (int stage = 0; stage < 2; ++stage) {
        sweep_gradients(0.0);
        sweep_walls(0.5 * dt);
        sweep_forces([&](std::size_t first, std::size_t last) {
            for (std::size_t i = first; i < last; ++i) {
                const double drag =
                    -drag_coefficient_[i] * particles_.velocity[0][i] * std::abs(particles_.velocity[0][i]);
                fields_.drag_acceleration_x[i] = drag;
                const std::array<double, 2> rate = {acceleration_[0][i] + drag, acceleration_[1][i]};
                // With the second stage, 2 q^(n+1/2) - q^n is q^n plus a full step at the rates of the
                // middle.
                const double part = stage == 0 ? 0.5 * dt : dt;
                particles_.density_deviation[i] = saved_.density_deviation[i] + part * density_rate_[i];
                for (std::size_t k = 0; k < 2; ++k) {
                    // dr/dt = u: the velocity of the same stage moves the particle.
                    const double u_stage = transport_velocity(i, k);
                    particles_.position[k][i] = saved_.position[k][i] + part * u_stage;
                    particles_.velocity[k][i] = saved_.velocity[k][i] + part * rate[k];
                }
            }
            wrap_and_pack(first, last);
        });
        clock_.time = start + 0.5 * dt;
    }
    clock_.time = start;
}

template class SimulationOf<float>;
template class SimulationOf<double>;

std::unique_ptr<Simulation> make_simulation(const Case& c, const ColumnResult* column,
                                            Particles<2> particles) {
    if (c.numerics.precision == Precision::double_precision) {
        return std::make_unique<SimulationOf<double>>(c, column, std::move(particles));
    }
    return std::make_unique<SimulationOf<float>>(c, column, std::move(particles));
}

}  // namespace riffle
