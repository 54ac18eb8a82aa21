#pragma once

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <memory>
#include <vector>

#include "base/error.hpp"
#include "boundary/body_contact.hpp"
#include "case/solid_volume.hpp"
#include "engine/component.hpp"

namespace riffle::inline components {

/// Moves the free bodies of a case: by the forces that the water exerts on them in an evaluation, their
/// weight, their springs and what they touch, in step with the water. What the pairs give to the water they
/// take from the bodies, so that both together keep their momentum.
template <int D, class Real>
class FreeBodies final : public Component<D, Real> {
  public:
    using typename Component<D, Real>::Flow;

    explicit FreeBodies(Flow& flow)
        : contact_(flow.c, flow.free, steps_of_an_impact * longest_step(flow)),
          smoothing_(smoothing_lengths * flow.scheme.smoothing_length / flow.scheme.state.sound_speed) {
        for (const FreeBody& body : flow.free) {
            const Solid& solid = flow.c.solids[body.solid()];
            points_.push_back(moment_point(flow.c, solid));
            if (flow.c.channel.top == Top::wall) volumes_.push_back(solid_volume(flow.c, solid));
        }
        flow.clock.contact_springs.resize(contact_.springs());
    }

    void begin_step(Flow& flow, double /*dt*/) override {
        for (std::size_t n = 0; n < flow.free.size(); ++n) {
            FreeBodyState& state = flow.clock.free_bodies[n];
            if (state.released == 0.0 && flow.clock.time >= flow.free[n].start()) flow.free[n].release(state);
        }
    }

    void begin_evaluation(Flow& /*flow*/, const Stage& stage) override { stage_ = stage; }

    void end_evaluation(Flow& flow) override {
        const double kick = stage_.velocity_step();
        std::vector<FreeBodyState>& states = flow.clock.free_bodies;
        const std::vector<BodyLoad> touching =
            contact_.loads(flow.free, states, flow.bodies, stage_.motion, flow.clock.contact_springs);
        for (std::size_t n = 0; n < states.size(); ++n) {
            if (states[n].released == 0.0) continue;
            const FreeBody& body = flow.free[n];
            const std::size_t solid = body.solid();
            BodyLoad load = water_load(flow, n);
            const Point3 spring = body.spring_force(states[n]);
            const Point3 weight = in_space_of<D>(flow.particle_data.gravity);
            for (std::size_t k = 0; k < 3; ++k) {
                load.force[k] += body.mass() * weight[k] + spring[k] + touching[n].force[k];
                load.moment[k] += touching[n].moment[k];
            }
            if (!volumes_.empty()) add_weight_in_water(flow, n, load);
            body.advance(states[n], load, kick, stage_.motion, smoothing_);
            watch(flow, states[n], body);
            widen_bound(flow, states[n], flow.bodies_after[first_solid + solid], body.reach());
        }
    }

  private:
    /// An impact on a wall takes so many steps: it is resolved, and no body sinks in by more than its speed
    /// times as much.
    static constexpr double steps_of_an_impact = 30.0;
    /// Sound runs so many smoothing lengths while the water learns of an acceleration of a body.
    static constexpr double smoothing_lengths = 2.0;

    static double longest_step(const Flow& flow) {
        return flow.c.numerics.time_step.value_or(flow.scheme.acoustic_step);
    }

    /// Below a wall at the top the gravity across the bed only adds a hydrostatic pressure, and the particles
    /// feel none of it: the body has its weight, and its buoyancy at the middle of its volume.
    void add_weight_in_water(const Flow& flow, std::size_t n, BodyLoad& load) const {
        const double gravity = flow.c.normal_gravity();
        const double buoyancy = flow.scheme.density * volumes_[n].volume * gravity;
        load.force[2] += buoyancy - flow.free[n].mass() * gravity;
        const Point3 arm = flow.bodies[first_solid + flow.free[n].solid()].turned(
            minus(volumes_[n].centroid, flow.free[n].centre_of_mass()));
        const Point3 moment = cross(arm, Point3{0.0, 0.0, buoyancy});
        for (std::size_t k = 0; k < 3; ++k) load.moment[k] += moment[k];
    }

    /// Force of the water and its moment about the centre of mass.
    BodyLoad water_load(const Flow& flow, std::size_t n) const {
        const std::size_t solid = flow.free[n].solid();
        const ForceOnSolid& water = flow.solid_forces[solid];
        const Point3 arm =
            flow.bodies[first_solid + solid].turned(minus(points_[n], flow.free[n].centre_of_mass()));
        BodyLoad load;
        for (std::size_t k = 0; k < 3; ++k) {
            load.force[k] = water.pressure[k] + water.friction[k];
            load.moment[k] = water.pressure_moment[k] + water.friction_moment[k];
        }
        const Point3 more = cross(arm, load.force);
        for (std::size_t k = 0; k < 3; ++k) load.moment[k] += more[k];
        return load;
    }

    /// Throws RunError where a body is no longer finite, faster than sound, or beyond the walls.
    static void watch(const Flow& flow, const FreeBodyState& state, const FreeBody& body) {
        Point3 place = body.centre_of_mass();
        bool finite = true;
        for (std::size_t k = 0; k < 3; ++k) {
            place[k] += state.displacement[k];
            finite = finite && std::isfinite(place[k]) && std::isfinite(state.velocity[k]) &&
                     std::isfinite(state.angular_velocity[k]);
        }
        const Channel& channel = flow.c.channel;
        const double reach = body.reach();
        const auto beyond = [&](std::size_t axis, double extent) {
            return place[axis] < -reach || place[axis] > extent + reach;
        };
        const double speed = std::sqrt(dot(state.velocity, state.velocity)) +
                             reach * std::sqrt(dot(state.angular_velocity, state.angular_velocity));
        const char* what = nullptr;
        if (!finite) {
            what = "is no longer finite";
        } else if (speed > flow.scheme.state.sound_speed) {
            what = "moves faster than the sound of the water";
        } else if (place[2] < -reach || (channel.ends != Ends::periodic && beyond(0, channel.length)) ||
                   (D == 3 && channel.sides == Sides::walls && beyond(1, channel.simulated_width()))) {
            what = "has left the channel";
        }
        if (what != nullptr) {
            throw RunError(fmt::format(
                "the free body \"{}\" {}: its centre of mass at x = {:.6g} m, z = {:.6g} m, velocity ({:.4g}, "
                "{:.4g}) m/s, at t = {:.6g} s. Its mass, moments of inertia or springs may be too extreme for "
                "the time step, or the walls too low for it",
                flow.c.solids[body.solid()].name, what, place[0], place[2], state.velocity[0],
                state.velocity[2], flow.clock.time));
        }
    }

    /// The lists were told how far a body would go; now it is known.
    static void widen_bound(Flow& flow, const FreeBodyState& state, const BodyState& foreseen, double reach) {
        BodyState now = foreseen;
        state.put_into(now);
        const Point3 apart = minus(now.displacement, foreseen.displacement);
        double turn = 0.0;
        for (std::size_t k = 0; foreseen.turns && k < 9; ++k) {
            turn += std::abs(now.rotation[k] - foreseen.rotation[k]);
        }
        flow.clock.displacement_bound += std::sqrt(dot(apart, apart)) + turn * reach;
    }

    BodyContact contact_;
    double smoothing_;                  ///< s
    std::vector<Point3> points_;        ///< of each body, that the moments on it are about, at t = 0
    std::vector<SolidVolume> volumes_;  ///< of each body below a wall at the top; else empty
    Stage stage_;
};

template <int D, class Real>
std::unique_ptr<Component<D, Real>> make_free_bodies(FlowOf<D, Real>& flow) {
    return flow.free.empty() ? nullptr : std::make_unique<FreeBodies<D, Real>>(flow);
}

}  // namespace riffle::inline components
