// Construction and time stepping.

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "base/parallel.hpp"
#include "particles/lattice.hpp"
#include "roughness/side_wall_partition.hpp"
#include "solver/pair_setup.hpp"
#include "solver/simulation_of.hpp"
#include "sph/pair_approach.hpp"

namespace riffle {

std::span<SparseValues ParticleFields::*const> ParticleFields::near_walls(int dimensions) {
    static constexpr std::array<SparseValues ParticleFields::*, 6> all = {
        &ParticleFields::wall_acceleration_x,      &ParticleFields::wall_acceleration_z,
        &ParticleFields::drag_acceleration_x,      &ParticleFields::drag_acceleration_y,
        &ParticleFields::side_wall_acceleration_x, &ParticleFields::side_wall_acceleration_z};
    return std::span(all).first(dimensions == 3 ? all.size() : 3);
}

void ParticleFields::release(bool with_viscosity) {
    pressure.release();
    shear.release();
    regularity.release();
    for (std::vector<double>* const values :
         {&pair_acceleration_x, &viscous_acceleration_x, &shear_stress, &lateral_shear_stress}) {
        std::vector<double>().swap(*values);
    }
    for (SparseValues ParticleFields::*const force : near_walls(3)) {
        (this->*force).release();
    }
    if (with_viscosity) {
        eddy_viscosity.release();
    }
}

void ParticleFields::keep(const std::vector<std::int32_t>& particles) {
    pressure.keep(particles);
    eddy_viscosity.keep(particles);
    shear.keep(particles);
    regularity.keep(particles);
    for (std::vector<double>* const values :
         {&pair_acceleration_x, &viscous_acceleration_x, &shear_stress, &lateral_shear_stress}) {
        WorkingValues::keep_values(*values, particles);
    }
    for (SparseValues ParticleFields::*const force : near_walls(3)) {
        (this->*force).keep(particles);
    }
}

std::size_t ParticleFields::bytes() const {
    std::size_t total = pressure.bytes() + eddy_viscosity.bytes() + shear.bytes() + regularity.bytes();
    for (const SparseValues ParticleFields::*const force : near_walls(3)) {
        total += (this->*force).bytes();
    }
    for (const std::vector<double>* const values :
         {&pair_acceleration_x, &viscous_acceleration_x, &shear_stress, &lateral_shear_stress}) {
        total += values->capacity() * sizeof(double);
    }
    return total;
}

template <int D, class Real>
SimulationOf<D, Real>::SimulationOf(const Case& c, const ColumnResult* column, Particles<D> particles)
    : case_(c),
      wall_law_(wall_law(c)),
      motion_(c),
      closure_(make_closure(c)),
      drag_(make_bed_drag(c)),
      stirring_(c, c.stirring.celerity.value_or(column != nullptr ? column->total_mean_velocity : 0.0)),
      domain_(domain_of<D>(c)),
      fixed_point_(domain_),
      loops_(pair_loops<D, Real>(loop_options(c))),
      particle_loops_(particle_loops<D, Real>()),
      column_width_(cluster_column_spacings(D) * c.numerics.spacing),
      stepper_(make_stepper<D>(c.numerics.stepping)) {
    particles_ = std::move(particles);
    scheme_ = make_scheme(c, column);
    walls_ = wall_particles<D>(c);
    if constexpr (D == 2) {
        contact_ = SolidContact(c);
    } else {
        contact_ = MeshContact(c, walls_);
    }
    planes_ = PlaneContact<D>(c);
    wall_deviation_.resize(walls_.size());
    for (std::size_t i = 0; i < walls_.size(); ++i) {
        wall_deviation_[i] = scheme_.hydrostatic_deviation(walls_.position[vertical][i]);
    }
    data_.constants = pair_constants<D, Real>(c, scheme_, fixed_point_);
    repulsion_ = RepulsiveWalls<D>(c, scheme_.state.sound_speed);
    sweeps_ = make_pair_sweeps<D, Real>(c, scheme_, fixed_point_);
    particle_data_ = particle_constants<D>(c, scheme_, domain_);
    refer_to_particles();
    if (D == 3 && has_side_wall_drag(c)) {
        side_drag_ = true;
        if (c.side_walls.drag_form == SideDragForm::thesis) {
            clock_.side_wall_drag_coefficient = printed_side_wall_coefficient(c);
        } else if (drag_) {
            wall_over_bed_ = side_wall_partition(c).wall_over_bed;
            measure_side_drag();
        }
    }

    check_state();
    make_walls();
    if (D == 3 || starts_beside_dry_walls(c)) {
        // Again, as make_walls() has sorted them.
        for (std::size_t i = 0; i < walls_.size(); ++i) {
            wall_deviation_[i] = scheme_.hydrostatic_deviation(walls_.position[vertical][i]);
        }
        wet_walls();
    }
    if (c.numerics.wall == WallKind::modified_dynamic && walls_.size() > 0) {
        ghosts_ = std::make_unique<GhostNodes<D>>(c, scheme_, domain_, walls_, column_width_);
    }
    build_lists(true);
    fields_.template reset<Real>(particles_.size(), D, scheme_.density);
}

template <int D, class Real>
int SimulationOf<D, Real>::evaluations_per_step() const {
    return stepper_ ? stepper_->evaluations() : 1;
}

template <int D, class Real>
double SimulationOf<D, Real>::choose_step() const {
    if (case_.numerics.time_step) {
        return *case_.numerics.time_step;
    }
    if (case_.numerics.step_rule == StepRule::monaghan_kos) {
        const double approach =
            largest_pair_approach(data_, clusters_, fixed_point_, scheme_.smoothing_length);
        return std::min(scheme_.acoustic_step, monaghan_kos_step(scheme_, case_.numerics.courant_number,
                                                                 clock_.largest_acceleration, approach));
    }
    return std::min(scheme_.acoustic_step, force_limited_step(scheme_, clock_.largest_acceleration));
}

template <int D, class Real>
void SimulationOf<D, Real>::step(double fields_due) {
    timed(profile_.total, [&] { take_step(fields_due); });
}

template <int D, class Real>
void SimulationOf<D, Real>::take_step(double fields_due) {
    timed(profile_.lists, [&] {
        // A second evaluation of the step finds the particles moved by up to half of what the lists allow.
        if (!lists_valid(evaluations_per_step() == 1 ? 1.0 : 0.5)) {
            build_lists(true);
        }
    });
    const auto& numerics = case_.numerics;
    const bool filtered = numerics.density_filter != DensityFilter::none && clock_.steps > 0 &&
                          clock_.steps % numerics.density_filter_interval == 0;
    if (filtered) {
        filter_density();
        repack();
    }
    if (numerics.xsph != 0.0) {
        sweep_smoothed_velocity();
    }
    const double dt = choose_step();
    if (dissolves_crowds()) {
        dissolve_crowds(dt);
    }
    // As the recorder will see the time: the same sum.
    keep_fields_ = clock_.time + dt >= fields_due;
    if (keep_fields_) {
        fields_.template reset<Real>(particles_.size(), D, scheme_.density);
        list_solids();
    }
    if (stepper_) {
        take_step_by_rates(dt, filtered);
    } else if (numerics.stepping == Stepping::leapfrog) {
        // Velocities stand half a step before the positions: those that brought the particles here say how
        // the density has changed on the way, over the step that has been taken. What the middle of the way
        // adds to the sum at its end changes slowly in layers: every other step takes it there, twice.
        const int interval = midway_interval(case_);
        const double before = clock_.time_step;
        const bool midway = clock_.steps % interval == 0;
        data_.constants.half_way = static_cast<Real>(0.5 * interval * before / scheme_.smoothing_length);
        evaluate(
            {.density = before, .wall = before, .motion = dt, .kick = 0.5 * (before + dt), .midway = midway});
    } else {
        // Density, pressure, walls, forces, velocity, position, each with the newest of the others. The drag
        // is implicit: u1 + dt beta u1|u1| = u*.
        evaluate({.density = dt, .wall = dt, .motion = dt});
    }
    if (keep_fields_ && !solid_lists_.empty()) {
        gather_solid_forces();
    }
    clock_.time_step = dt;
    clock_.time += dt;
    ++clock_.steps;
    if (leaving_) {
        take_out_leaving();
    }
}

template <int D, class Real>
void SimulationOf<D, Real>::take_step_by_rates(double dt, bool filtered) {
    const double begin = clock_.time;
    stepper_->begin(particles_,
                    {.now = dt, .before = clock_.time_step, .steps = clock_.steps, .restart = filtered});
    const int evaluations = stepper_->evaluations();
    for (evaluation_ = 0; evaluation_ < evaluations; ++evaluation_) {
        clock_.time = begin + stepper_->evaluation_time(evaluation_) * dt;
        evaluate({.density = 0.0, .wall = dt / evaluations, .motion = dt});
    }
    clock_.time = begin;
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
    for (const double seconds : wall_seconds_) {
        result.walls += seconds / threads;
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
