#pragma once

#include <array>
#include <span>
#include <vector>

#include "case/body_state.hpp"
#include "case/case.hpp"

namespace riffle::inline boundary {

/// A turn as a quaternion of length 1: cos(angle/2), then sin(angle/2) along the axis.
using Quaternion = std::array<double, 4>;

/// What moves of a free body. SI, in two dimensions per width; in two dimensions nothing but the motion along
/// x and z and the turn about y.
struct FreeBodyState {
    Point3 displacement{};  ///< of its centre of mass
    Point3 velocity{};      ///< so, m/s
    Quaternion orientation{1.0, 0.0, 0.0, 0.0};
    Point3 angular_momentum{};  ///< about its centre of mass, kg m2/s
    Point3 angular_velocity{};  ///< what follows from it, rad/s
    /// Accelerations that the water beside it feels: smoothed in time (FreeBody::advance).
    Point3 acceleration{};
    Point3 angular_acceleration{};
    /// How far the body has turned about x, y and z in all: the sum of its steps, rad.
    Point3 angle{};
    double released = 0.0;  ///< 1: it has its velocity of the start and moves freely

    void put_into(BodyState& body) const;

    /// So many numbers, for the checkpoint.
    static constexpr std::size_t count = 26;
    [[nodiscard]] std::array<double, count> numbers() const;
    [[nodiscard]] static FreeBodyState from(const std::array<double, count>& numbers);
};

/// So many states, one after the other, from as many times FreeBodyState::count numbers.
[[nodiscard]] std::vector<FreeBodyState> free_body_states(std::span<const double> numbers, std::size_t count);

/// A force and its moment about the centre of mass of a body.
struct BodyLoad {
    Point3 force{};
    Point3 moment{};
};

inline BodyLoad& operator+=(BodyLoad& sum, const BodyLoad& other) {
    for (std::size_t k = 0; k < 3; ++k) {
        sum.force[k] += other.force[k];
        sum.moment[k] += other.moment[k];
    }
    return sum;
}

/// A free rigid body of a case: what it weighs, and which ways it is free to go.
class FreeBody {
  public:
    /// Of solid `number`, which is free and of known shape.
    FreeBody(const Case& c, std::size_t number);

    [[nodiscard]] std::size_t solid() const { return solid_; }
    [[nodiscard]] double mass() const { return mass_; }
    [[nodiscard]] const Point3& centre_of_mass() const { return centre_; }
    [[nodiscard]] double restitution() const { return restitution_; }
    [[nodiscard]] double friction() const { return friction_; }
    /// Largest distance of a place of it from its centre of mass, m.
    [[nodiscard]] double reach() const { return reach_; }
    [[nodiscard]] double start() const { return start_; }

    /// As it is held until it is released.
    [[nodiscard]] FreeBodyState at_rest() const { return {}; }
    /// Give it the velocities of its start.
    void release(FreeBodyState& state) const;

    /// What a load changes per second: accelerations, none where it is not free.
    struct Rates {
        Point3 acceleration{};
        Point3 angular_acceleration{};
    };
    [[nodiscard]] Rates rates(const FreeBodyState& state, const BodyLoad& load) const;
    /// Velocity of its point at an arm from the centre of mass, per impulse of 1 along `direction` there,
    /// along that direction: the inverse of the mass that an impact there feels, 1/kg.
    [[nodiscard]] double mobility(const FreeBodyState& state, const Point3& arm,
                                  const Point3& direction) const;
    /// Force of its springs, N.
    [[nodiscard]] Point3 spring_force(const FreeBodyState& state) const;
    /// Its kinetic energy, J.
    [[nodiscard]] double kinetic_energy(const FreeBodyState& state) const;

    /// One step: velocities by `kick`, places by `motion`, s, as the water's particles; symplectic. The turn
    /// is by the angular velocity of the middle of the step, which the angular momentum has there: what no
    /// moment acts on keeps it. The accelerations that the water feels follow the true ones within
    /// `smoothing`, s: they push water that pushes the body, at once, and a light one would answer with more
    /// each time.
    void advance(FreeBodyState& state, const BodyLoad& load, double kick, double motion,
                 double smoothing) const;
    /// The same by the smoothed accelerations, before the load is known: where it will about be.
    void predict(FreeBodyState& state, double kick, double motion) const;

  private:
    /// Angular velocity of an angular momentum about the axes that are free.
    [[nodiscard]] Point3 angular_velocity_of(const Point3& angular_momentum,
                                             const Quaternion& orientation) const;
    /// Moments of inertia about axes along x, y and z as it is turned.
    [[nodiscard]] std::array<double, 9> inertia_at(const Quaternion& orientation) const;

    std::size_t solid_ = 0;
    double mass_ = 0.0;
    Point3 centre_{};
    std::array<double, 9> inertia_{};  ///< at t = 0, kg m2
    std::array<bool, 3> moves_{};
    std::array<bool, 3> turns_{};
    Point3 spring_{};
    Point3 first_velocity_{};
    Point3 first_angular_velocity_{};
    double restitution_ = 0.0;
    double friction_ = 0.0;
    double reach_ = 0.0;
    double start_ = 0.0;
};

/// The free bodies of a case, in its order.
[[nodiscard]] std::vector<FreeBody> free_bodies(const Case& c);

}  // namespace riffle::inline boundary
