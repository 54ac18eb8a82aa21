#pragma once

#include <cmath>
#include <numeric>
#include <vector>

#include "boundary/wall_motion.hpp"
#include "case/end_buffers.hpp"
#include "case/solid_volume.hpp"
#include "engine/component.hpp"
#include "engine/pair_setup.hpp"
#include "engine/pass_order.hpp"
#include "particles/working_values.hpp"

namespace riffle::inline components {

/// What each part of the scheme does to the energy of the water, in steps that keep the fields
/// (docs/theory.md, "Energy"). Forces work on the mean of a particle's velocity before and after them, so
/// that with a method of one evaluation their powers add up to the change of the kinetic energy to rounding.
template <int D, class Real>
class EnergyBudget final : public Component<D, Real> {
  public:
    using typename Component<D, Real>::Flow;
    using typename Component<D, Real>::Task;

    explicit EnergyBudget(const Flow& flow)
        : corrected_(weighs_by_volume(flow.c)),
          two_point_(flow.particle_data.closure && flow.particle_data.two_point),
          tensor_(flow.particle_data.closure && !flow.particle_data.two_point),
          open_(flow.c.channel.ends == Ends::open) {
        LoopOptions options = loop_options(flow.c);
        options.gradients = false;
        options.directional = false;  // a weight of the eddies alone
        molecular_loops_ = pair_loops<D, Real>(options);
        for (const Solid& solid : flow.c.solids) points_.push_back(moment_point(flow.c, solid));
    }

    void begin_evaluation(Flow& flow, const Stage& stage) override {
        if (!flow.keep_fields) return;
        stage_ = stage;
        blocks_.assign(flow.block_advance.size(), EnergyRates{});
        if (two_point_) {
            flow.data.pressure.assign(flow.data.motion.size(), PressureRecord<Real>{});
        }
        if (tensor_) strain_work_.template reset<Real>(flow.particles.size());
    }

    void complete_gradients(Flow& flow, Task& task, std::size_t begin, std::size_t end) override {
        if (!flow.keep_fields) return;
        add_compression(flow, task.sums.gradient, begin, end);
        if (two_point_) put_molecular_records(flow, task.sums.gradient, begin, end);
        if (tensor_ || corrects(flow)) {
            Own& own = own_of(task);
            own.sums.uncorrected_gradient = true;
            flow.loops.gradient(flow.data, begin, end, own.sums);
        }
        if (tensor_) keep_strain_work(flow, task, begin, end);
        if (corrects(flow)) add_correction_work(flow, task, begin, end);
    }

    void add_forces(Flow& flow, Task& task, std::size_t begin, std::size_t end) override {
        if (!flow.keep_fields) return;
        Own& own = own_of(task);
        if (two_point_) molecular_loops_.force(flow.data, begin, end, own.sums);
        flow.for_particles(begin, end, [&](std::size_t i, std::size_t lane) {
            for (std::size_t k = 0; k < Flow::axes; ++k) {
                own.velocity[k][lane] = flow.particles.velocity[k][i];
            }
        });
    }

    void after_motion(Flow& flow, Task& task, const Stage& /*stage*/, std::size_t begin,
                      std::size_t end) override {
        if (!flow.keep_fields) return;
        const Own& own = own_of(task);
        EnergyRates& sum = blocks_[begin / block_clusters];
        for_water(flow, begin, end, [&](std::size_t i, std::size_t lane) {
            Vec<D> u{};
            for (std::size_t k = 0; k < Flow::axes; ++k) {
                const double before = own.velocity[k][lane];
                u[k] = flow.motion_summed ? 0.5 * (before + flow.particles.velocity[k][i]) : before;
            }
            add_powers(flow, task, own, i, lane, u, sum);
        });
    }

    void end_evaluation(Flow& flow) override {
        if (!flow.keep_fields) return;
        flow.energy_rates = std::accumulate(blocks_.begin(), blocks_.end(), EnergyRates{});
        if (!open_) flow.energy_rates.pressure += flow.energy_rates.compression;
    }

    void end_step(Flow& flow) override {
        if (!flow.keep_fields) return;
        add_solids(flow);
        if (two_point_) {
            flow.data.pressure = {};
        }
        strain_work_.release();
        std::vector<EnergyRates>().swap(blocks_);
    }

  private:
    /// What a thread keeps of a block from its forces to its motion.
    struct Own {
        BlockWork<D, Real> sums;
        std::array<LaneArray<double>, Flow::axes> velocity;  ///< before the motion
    };

    static Own& own_of(const Task& task) {
        thread_local Own own;
        if (own.sums.slots.size() < task.sums.slots.size()) own.sums.slots.resize(task.sums.slots.size());
        return own;
    }

    /// The energy of the compression at the middle of its change: exact to the third order of the change.
    void add_compression(const Flow& flow, const GradientResult<D, Real>& gradient, std::size_t begin,
                         std::size_t end) {
        EnergyRates& sum = blocks_[begin / block_clusters];
        for_water(flow, begin, end, [&](std::size_t i, std::size_t lane) {
            const double before = flow.particles.density_deviation[i];
            const double compression = (1.0 + before) * static_cast<double>(gradient.density_rate[lane]);
            const auto diffusion = static_cast<double>(gradient.diffusion[lane]);
            const double s = before + 0.5 * stage_.density * (compression + diffusion);
            const double slope =
                flow.particles.mass[i] * flow.scheme.state.pressure(s) / ((1.0 + s) * (1.0 + s));
            sum.compression += slope * compression;
            sum.density_diffusion += slope * diffusion;
            if (open_) {
                // What the diffusion takes under the reference pressure the motion gives back in the mean.
                sum.pressure -=
                    flow.particles.mass[i] * reference_at(flow, i) / ((1.0 + s) * (1.0 + s)) * diffusion;
            }
        });
    }

    /// Records of which the force pass makes the molecular viscosity alone.
    void put_molecular_records(Flow& flow, const GradientResult<D, Real>& gradient, std::size_t begin,
                               std::size_t end) const {
        flow.for_particles(begin, end, [&](std::size_t i, std::size_t lane) {
            const std::size_t slot = begin * cluster_size + lane;
            const double density_ratio = 1.0 + flow.particles.density_deviation[i];
            const double viscosity = flow.particle_data.viscosity *
                                     static_cast<double>(gradient.viscosity_factor[lane]) *
                                     (corrected_ ? density_ratio : 1.0 / density_ratio);
            const double mass = flow.particles.mass[i] / flow.scheme.density;
            flow.data.pressure[slot].viscosity_root = static_cast<Real>(viscosity_root(viscosity));
            flow.data.pressure[slot].weight = static_cast<Real>(corrected_ ? mass / density_ratio : mass);
            if (!flow.porous.empty()) {
                const PorousMedia::At& at = flow.porous_at[i];
                flow.data.pressure[slot].viscosity_root *= static_cast<Real>(std::sqrt(at.viscosity_ratio));
                flow.data.pressure[slot].weight /= static_cast<Real>(at.porosity);
            }
        });
    }

    /// tau:G over rho nu_t of the eddy stresses in the tensor. With G, the velocity gradient without
    /// correction, its sum is that of the forces' work, pair by pair.
    void keep_strain_work(Flow& flow, Task& task, std::size_t begin, std::size_t end) {
        const Own& own = own_of(task);
        const ParticleData<D>& p = flow.particle_data;
        flow.for_particles(begin, end, [&](std::size_t i, std::size_t lane) {
            const auto strain = [&](std::size_t k, std::size_t l) {
                return static_cast<double>(task.sums.gradient.velocity_gradient[k * D + l][lane]);
            };
            const auto plain = [&](std::size_t k, std::size_t l) {
                return static_cast<double>(own.sums.gradient.velocity_gradient[k * D + l][lane]);
            };
            double work = 0.0;
            if (p.shear_only) {
                work = strain(0, D - 1) * (plain(0, D - 1) + plain(D - 1, 0));
            } else {
                for (std::size_t k = 0; k < D; ++k) {
                    for (std::size_t l = 0; l < D; ++l) {
                        const bool across_k = D == 3 && k == 1;
                        const bool across_l = D == 3 && l == 1;
                        const double weight = across_k && across_l   ? p.normal_weight_across
                                              : across_k || across_l ? p.shear_weight_across
                                                                     : 1.0;
                        work += weight * (strain(k, l) + strain(l, k)) * plain(k, l);
                    }
                }
            }
            strain_work_.set(i, static_cast<Real>(work));
        });
    }

    /// Whether the pressure's own part is found from the correction.
    [[nodiscard]] bool corrects(const Flow& flow) const {
        return open_ && flow.data.constants.correct_pressure;
    }

    /// The reference pressure at a particle, over rho0, m2/s2.
    [[nodiscard]] static double reference_at(const Flow& flow, std::size_t i) {
        const auto& reference = flow.particle_data.reference_pressure;
        return reference.acts() ? reference.value(flow.particles.position[Flow::vertical][i]) : 0.0;
    }

    /// The same sum over pairs, of the water alone, by particles: V p (B - I):G, p the pressure that the
    /// pairs carry (what the reference pressure gives comes back in the mean, being a function of the
    /// height). Between open ends pairs with the water beyond them do the work of the pressure on the
    /// sections, which is no part of the scheme's.
    void add_correction_work(const Flow& flow, const Task& task, std::size_t begin, std::size_t end) {
        const Own& own = own_of(task);
        EnergyRates& sum = blocks_[begin / block_clusters];
        for_water(flow, begin, end, [&](std::size_t i, std::size_t lane) {
            double work = 0.0;
            for (std::size_t k = 0; k < task.sums.gradient.correction.size(); ++k) {
                const double identity = k % (D + 1) == 0 ? 1.0 : 0.0;
                work += (static_cast<double>(task.sums.gradient.correction[k][lane]) - identity) *
                        static_cast<double>(own.sums.gradient.velocity_gradient[k][lane]);
            }
            const double s = flow.particles.density_deviation[i];
            const double pressure = flow.scheme.state.pressure(s) - reference_at(flow, i);
            sum.pressure += flow.particles.mass[i] / (1.0 + s) * pressure * work;
        });
    }

    /// f(particle, lane) for the water of a block; between open ends that which stands between them.
    template <class F>
    void for_water(const Flow& flow, std::size_t begin, std::size_t end, const F& f) const {
        flow.for_particles(begin, end, [&](std::size_t i, std::size_t lane) {
            if (in_channel(flow.c, flow.particles.position[0][i])) f(i, lane);
        });
    }

    void add_powers(const Flow& flow, const Task& task, const Own& own, std::size_t i, std::size_t lane,
                    const Vec<D>& u, EnergyRates& sum) const {
        const ForceResult<D, Real>& force = task.sums.force;
        const ParticleWork<D, Real>& work = task.particles;
        const double mass = flow.particles.mass[i];
        const double factor = corrected_ ? mass / (1.0 + flow.particles.density_deviation[i]) : mass;
        double tensor = 0.0;
        double viscous = 0.0;
        double molecular = 0.0;
        double weight = 0.0;
        double further = 0.0;
        double held = 0.0;  // by the reference pressure
        double stems = 0.0;
        double grains = 0.0;
        double friction = 0.0;  // of solids by the log law
        // As PorousForces has it of all viscous forces.
        const double molecular_factor = flow.porous.empty() ? factor : factor / flow.porous_at[i].porosity;
        for (std::size_t k = 0; k < Flow::axes; ++k) {
            tensor += factor * u[k] * static_cast<double>(force.tensor[k][lane]);
            viscous += factor * u[k] * static_cast<double>(force.viscous[k][lane]);
            weight += mass * u[k] * flow.particle_data.gravity[k];
            if (two_point_) {
                molecular += molecular_factor * u[k] * static_cast<double>(own.sums.force.viscous[k][lane]);
            }
            if (flow.inputs.acceleration) further += mass * u[k] * work.acceleration[k][lane];
            if (flow.with_vegetation) stems += mass * u[k] * task.vegetation_acceleration[k][lane];
            if (flow.with_solid_friction) friction += mass * u[k] * task.wall_acceleration[k][lane];
            if (!flow.porous.empty()) grains += mass * u[k] * task.porous_acceleration[k][lane];
        }
        if (flow.particle_data.reference_pressure.acts()) {
            held = mass * u[Flow::vertical] * task.reference_acceleration[lane];
        }
        double bed = flow.inputs.drag ? work.drag_force[lane] * u[0] : 0.0;
        double side = 0.0;
        if constexpr (D == 3) {
            bed += flow.inputs.drag ? work.drag_force_across[lane] * u[1] : 0.0;
            side = flow.with_side_drag
                       ? work.side_force[lane] * u[0] + work.side_force_vertical[lane] * u[Flow::vertical]
                       : 0.0;
        }
        const double closure = two_point_ ? viscous - molecular
                               : tensor_  ? -mass * flow.fields.eddy_viscosity[i] * strain_work_[i]
                                          : 0.0;
        sum.kinetic += tensor + viscous + weight + mass * (bed + side) + further;
        sum.closure += closure;
        sum.viscosity += (two_point_ ? molecular : viscous) + friction;
        if (!open_) sum.pressure += tensor + held - (tensor_ ? closure : 0.0);
        sum.bed_drag += mass * bed;
        sum.side_drag += mass * side;
        sum.vegetation += stems;
        sum.porous += grains;
        sum.further_forces += further - held - stems - grains - friction;
        if (flow.domain.periodic[0] || open_) sum.gravity += mass * u[0] * flow.particle_data.gravity[0];
    }

    /// Solids that move work on the water by pressure and friction, of which the sums above know no cause.
    void add_solids(Flow& flow) const {
        for (std::size_t n = 0; !flow.bodies.empty() && n < flow.solid_forces.size(); ++n) {
            const BodyState& body = flow.bodies[static_cast<std::size_t>(first_solid) + n];
            const auto velocity = body.turns ? body.velocity_at(body.placed(points_[n])) : body.velocity;
            const auto& force = flow.solid_forces[n];
            double pressure = 0.0;
            double friction = 0.0;
            for (std::size_t axis = 0; axis < 3; ++axis) {
                pressure -= force.pressure[axis] * velocity[axis];
                friction -= force.friction[axis] * velocity[axis];
            }
            for (std::size_t axis = 0; body.turns && axis < 3; ++axis) {
                pressure -= force.pressure_moment[axis] * body.angular_velocity[axis];
                friction -= force.friction_moment[axis] * body.angular_velocity[axis];
            }
            flow.energy_rates.solids += pressure + friction;
            if (!open_) flow.energy_rates.pressure -= pressure;
            flow.energy_rates.viscosity -= friction;
        }
    }

    bool corrected_;
    bool two_point_;  ///< an eddy viscosity acts between pairs
    bool tensor_;     ///< or in the stress tensor
    bool open_;       ///< between open ends
    PairLoops<D, Real> molecular_loops_;
    std::vector<Point3> points_;  ///< of each solid, that the moments on it are about, at t = 0
    Stage stage_;
    std::vector<EnergyRates> blocks_;
    WorkingValues strain_work_;  ///< 1/s2, by particle
};

template <int D, class Real>
std::unique_ptr<Component<D, Real>> make_energy_budget(FlowOf<D, Real>& flow) {
    return std::make_unique<EnergyBudget<D, Real>>(flow);
}

}  // namespace riffle::inline components
