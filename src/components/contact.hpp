#pragma once

#include <fmt/format.h>

#include <type_traits>
#include <vector>

#include "boundary/mesh_contact.hpp"
#include "boundary/plane_contact.hpp"
#include "boundary/solid_contact.hpp"
#include "case/solid_volume.hpp"
#include "engine/component.hpp"
#include "engine/particle_fault.hpp"
#include "engine/pass_order.hpp"

namespace riffle::inline components {

/// Keeps water before walls and out of solids where their pressure does not: particles of a block that have
/// moved behind a face are put back onto it.
template <int D, class Real>
class Contact final : public Component<D, Real> {
  public:
    using typename Component<D, Real>::Flow;
    using typename Component<D, Real>::Task;

    explicit Contact(const Flow& flow) : planes_(flow.c) {
        for (const Solid& solid : flow.c.solids) points_.push_back(moment_point(flow.c, solid));
        if constexpr (D == 2) {
            solids_ = SolidContact(flow.c);
        } else {
            solids_ = MeshContact(flow.c, flow.walls);
        }
    }
    [[nodiscard]] bool empty() const { return solids_.empty() && planes_.empty(); }

    /// Error where water stands more than a spacing deep in a solid.
    void particles_sorted(const Flow& flow) override {
        const double spacing = flow.c.numerics.spacing;
        const std::vector<BodyState> bodies = flow.bodies_now();
        for (std::size_t k = 0; k < flow.c.solids.size(); ++k) {
            for (std::size_t i = 0; i < flow.particles.size(); ++i) {
                if (solids_.depth(k, bodies, vector_of(flow.particles.position, i)) > spacing) {
                    throw ParticleFault(i, entered(flow, flow.c.solids[k], i));
                }
            }
        }
    }

    void begin_evaluation(Flow& flow, const Stage& stage) override {
        velocity_step_ = stage.velocity_step();
        depth_.assign(flow.block_advance.size(), 0.0);
        impulses_.assign(flow.keeps_solid_forces() ? flow.block_advance.size() * points_.size() : 0,
                         BodyLoad{});
    }

    void after_motion(Flow& flow, Task& /*task*/, const Stage& /*stage*/, std::size_t begin,
                      std::size_t end) override {
        double deepest = 0.0;
        std::size_t particle = 0;
        const Push push = impulses_.empty() ? Push{} : impulse_on(flow, particle, begin / block_clusters);
        for (std::size_t cluster = begin; cluster < end; ++cluster) {
            if (flow.fluid_wall.run_begin[cluster] == flow.fluid_wall.run_begin[cluster + 1]) continue;
            flow.for_particles(cluster, cluster + 1, [&](std::size_t i, std::size_t) {
                particle = i;
                deepest = std::max(deepest, put_back(flow, i, push));
            });
        }
        depth_[begin / block_clusters] = deepest;
    }

    void end_evaluation(Flow& flow) override {
        if (!depth_.empty()) {
            flow.clock.displacement_bound += 2.0 * *std::max_element(depth_.begin(), depth_.end());
        }
        // What a solid takes from water that it puts back presses on it as its pressure does.
        for (std::size_t n = 0; n < impulses_.size(); ++n) {
            ForceOnSolid& load = flow.solid_forces[n % points_.size()];
            for (std::size_t k = 0; k < 3; ++k) {
                load.pressure[k] += impulses_[n].force[k] / velocity_step_;
                load.pressure_moment[k] += impulses_[n].moment[k] / velocity_step_;
            }
        }
    }
    [[nodiscard]] std::size_t bytes() const override { return impulses_.capacity() * sizeof(BodyLoad); }

  private:
    /// Returns how far a particle was put back, m.
    double put_back(Flow& flow, std::size_t i, const Push& push) const {
        constexpr std::size_t vertical = Flow::vertical;
        Particles<D>& particles = flow.particles;
        Vec<D> x = vector_of(particles.position, i);
        Vec<D> u = vector_of(particles.velocity, i);
        const Vec<D> before = u;
        double depth = planes_.resolve(x, u);
        if (!solids_.empty()) depth = std::max(depth, solids_.resolve(flow.bodies_after, x, u, push));
        if (depth > 0.0 && flow.keep_fields) {
            // What the wall takes from the velocity is a force of the wall, beside that of its pressure.
            auto& along = flow.fields.wall_acceleration_x;
            auto& upright = flow.fields.wall_acceleration_z;
            const double taken = (u[0] - before[0]) / velocity_step_;
            along.set(i, along[i] + taken);
            flow.fields.pair_acceleration_x[i] += taken;
            upright.set(i, upright[i] + (u[vertical] - before[vertical]) / velocity_step_);
        }
        for (std::size_t k = 0; k < Flow::axes && depth > 0.0; ++k) {
            particles.position[k][i] = x[k];
            particles.velocity[k][i] = u[k];
        }
        return depth;
    }

    /// Books what the velocity of a particle gains on the solid that put it back.
    Push impulse_on(const Flow& flow, const std::size_t& i, std::size_t block) {
        return [this, &flow, &i, block](std::size_t solid, const Vec<3>& place, const Vec<3>& gain) {
            const Point3 about = flow.bodies_after[first_solid + solid].placed(points_[solid]);
            const double mass = flow.particles.mass[i];
            const Point3 impulse{-mass * gain[0], -mass * gain[1], -mass * gain[2]};
            impulses_[block * points_.size() + solid] += {impulse, cross(minus(place, about), impulse)};
        };
    }

    static std::string entered(const Flow& flow, const Solid& solid, std::size_t i) {
        const Particles<D>& p = flow.particles;
        return fmt::format(
            "water has entered the solid \"{}\": particle {} at x = {:.6g} m, z = {:.6g} m, velocity ({:.4g}, {:.4g}) m/s, at t = {:.6g} s; take a smaller step ([numerics] courant_number){}",
            solid.name, p.id[i], p.position[0][i], p.position[Flow::vertical][i], p.velocity[0][i],
            p.velocity[Flow::vertical][i], flow.clock.time,
            solid.rests()     ? " or spacing"
            : solid.is_free() ? " or a smaller spacing"
                              : ", a smaller spacing, or let the solid move more slowly");
    }

    std::conditional_t<D == 2, SolidContact, MeshContact> solids_;
    PlaneContact<D> planes_;
    std::vector<double> depth_;       ///< by block, the largest of the evaluation, m
    double velocity_step_ = 0.0;      ///< of the evaluation in progress, s
    std::vector<Point3> points_;      ///< of each solid, that the moments on it are about, at t = 0
    std::vector<BodyLoad> impulses_;  ///< by block and solid, N s and N m s; empty where they are not kept
};

template <int D, class Real>
std::unique_ptr<Component<D, Real>> make_contact(FlowOf<D, Real>& flow) {
    auto contact = std::make_unique<Contact<D, Real>>(flow);
    return contact->empty() ? nullptr : std::move(contact);
}

}  // namespace riffle::inline components
