// Free rigid bodies without water: their equations of motion, and what they touch.

#include "boundary/free_body.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "boundary/body_contact.hpp"
#include "boundary/wall_motion.hpp"

namespace riffle {
namespace {

Solid shaped(const char* name, SolidShape shape, std::vector<double> centre, std::vector<double> size) {
    Solid solid;
    solid.name = name;
    solid.shape = shape;
    solid.centre = std::move(centre);
    solid.size = std::move(size);
    solid.motion = SolidMotion::free;
    solid.density = 2000.0;
    return solid;
}

/// A rectangle in the plane with its outline, as the reader makes it.
Solid rectangle(const char* name, double x, double z, double width, double height) {
    Solid solid = shaped(name, SolidShape::rectangle, {x, z}, {width, height});
    solid.x = {x - width / 2, x + width / 2, x + width / 2, x - width / 2};
    solid.z = {z - height / 2, z - height / 2, z + height / 2, z + height / 2};
    return solid;
}

Solid sphere(const char* name, const Point3& centre, double diameter) {
    Solid solid = shaped(name, SolidShape::sphere, {centre[0], centre[1], centre[2]}, {});
    solid.diameter = diameter;
    return solid;
}

Case dry_tank(int dimensions, std::vector<Solid> solids) {
    Case c;
    c.channel.dimensions = dimensions;
    c.channel.slope = 0.0;
    c.channel.depth = 0.3;
    c.channel.length = 1.0;
    c.channel.width = 0.4;
    c.channel.ends = Ends::walls;
    c.channel.sides = Sides::walls;
    c.bed.kind = BedKind::slip;
    c.numerics.spacing = 0.01;
    c.solids = std::move(solids);
    return c;
}

/// The free bodies of a case in a tank without water.
class Dry {
  public:
    explicit Dry(const Case& c, const Point3& gravity = {0.0, 0.0, -9.81})
        : free(free_bodies(c)),
          states(free.size()),
          motion_(c),
          gravity_(gravity),
          contact_(c, free, 30.0 * step),
          springs_(contact_.springs()) {
        for (std::size_t n = 0; n < free.size(); ++n) free[n].release(states[n]);
    }

    void advance(double time) {
        for (double t = 0.0; t < time - 0.5 * step; t += step) {
            const auto bodies = motion_.at(0.0, states);
            const auto touching = contact_.loads(free, states, bodies, step, springs_);
            for (std::size_t n = 0; n < free.size(); ++n) {
                BodyLoad load = touching[n];
                for (std::size_t k = 0; k < 3; ++k) load.force[k] += free[n].mass() * gravity_[k];
                free[n].advance(states[n], load, step, step, 0.0);
            }
        }
    }
    [[nodiscard]] double depth(std::size_t n) const {
        return contact_.deepest(free, n, motion_.at(0.0, states));
    }

    static constexpr double step = 1e-4;
    std::vector<FreeBody> free;
    std::vector<FreeBodyState> states;

  private:
    WallMotion motion_;
    Point3 gravity_;
    BodyContact contact_;
    std::vector<Point3> springs_;
};

TEST(FreeBody, HasMassAndInertiaOfItsShape) {
    const Case c = dry_tank(2, {rectangle("block", 0.5, 0.2, 0.1, 0.04)});
    const FreeBody body = free_bodies(c)[0];
    EXPECT_NEAR(body.mass(), 2000.0 * 0.004, 1e-9);
    EXPECT_NEAR(body.centre_of_mass()[0], 0.5, 1e-12);
    EXPECT_NEAR(body.centre_of_mass()[2], 0.2, 1e-12);
    // A moment about y alone: m (w^2 + h^2)/12.
    const auto rates = body.rates({}, {.force = {8.0, 5.0, 0.0}, .moment = {1.0, 1.0, 1.0}});
    EXPECT_NEAR(rates.acceleration[0], 1.0, 1e-9);
    EXPECT_EQ(rates.acceleration[1], 0.0);
    EXPECT_NEAR(rates.angular_acceleration[1], 12.0 / (8.0 * (0.01 + 0.0016)), 1e-6);
    EXPECT_EQ(rates.angular_acceleration[0], 0.0);
}

TEST(FreeBody, SpinsWithoutMomentsAsEulerSays) {
    Solid box = shaped("box", SolidShape::box, {0.5, 0.2, 0.15}, {0.1, 0.06, 0.02});
    box.rotation_axis = {0.1, 1.0, 0.05};  // about its middle axis: it tumbles
    box.angular_velocity = 12.0;
    const Case c = dry_tank(3, {box});
    const auto drift = [&](double dt) {
        const FreeBody body = free_bodies(c)[0];
        FreeBodyState state;
        body.release(state);
        const Point3 momentum = state.angular_momentum;
        const double energy = body.kinetic_energy(state);
        double worst = 0.0;
        for (int i = 0; i * dt < 2.0; ++i) {
            body.advance(state, {}, dt, dt, 0.0);
            worst = std::max(worst, std::abs(body.kinetic_energy(state) / energy - 1.0));
        }
        double length = 0.0;
        for (const double q : state.orientation) length += q * q;
        EXPECT_NEAR(length, 1.0, 1e-14);
        EXPECT_EQ(state.angular_momentum, momentum);
        EXPECT_GT(std::abs(state.angular_velocity[0] - box.angular_velocity * 0.1), 0.1);  // it does tumble
        return worst;
    };
    const double coarse = drift(2e-3);
    const double fine = drift(1e-3);
    EXPECT_LT(fine, 1e-3);
    EXPECT_NEAR(coarse / fine, 4.0, 1.5);  // second order
}

TEST(FreeBody, KeepsToTheDegreesOfFreedomThatItHas) {
    Solid box = shaped("box", SolidShape::box, {0.5, 0.2, 0.15}, {0.1, 0.06, 0.02});
    box.moves_x = false;
    box.turns_x = box.turns_z = false;
    const Case c = dry_tank(3, {box});
    const FreeBody body = free_bodies(c)[0];
    FreeBodyState state;
    body.release(state);
    for (int i = 0; i < 100; ++i) {
        body.advance(state, {.force = {1.0, 1.0, 1.0}, .moment = {1e-3, 1e-3, 1e-3}}, 1e-3, 1e-3, 0.0);
    }
    EXPECT_EQ(state.displacement[0], 0.0);
    EXPECT_GT(state.displacement[1], 0.0);
    EXPECT_EQ(state.angle[0], 0.0);
    EXPECT_GT(state.angle[1], 0.0);
    EXPECT_EQ(state.orientation[1], 0.0);
    const FreeBodyState copy = FreeBodyState::from(state.numbers());
    EXPECT_EQ(copy.numbers(), state.numbers());
}

TEST(BodyContact, DampingLeavesTheRestitution) {
    for (const double restitution : {0.2, 0.5, 0.8, 0.95}) {
        const double ratio = damping_ratio(restitution);
        double x = 0.0;
        double v = 1.0;
        for (double force = 0.0; force <= 0.0 || v > 0.0;) {
            force = -x - 2.0 * ratio * v;
            if (x > 0.0 && force > 0.0) break;
            v += 1e-5 * std::min(force, 0.0);
            x += 1e-5 * v;
        }
        EXPECT_NEAR(-v, restitution, 1e-3);
    }
}

// A bounce in a thousandth of the time that it takes: the speeds by the heights. 2 %: the last step before
// the impact, and the facets of the sphere.
TEST(BodyContact, ASphereBouncesWithItsRestitution) {
    for (const double restitution : {0.3, 0.7}) {
        Solid ball = sphere("ball", {0.5, 0.2, 0.2}, 0.1);
        ball.restitution = restitution;
        Dry dry(dry_tank(3, {ball}));
        const double fall = 0.15;
        double before = 0.0;
        double after = 0.0;
        for (int i = 0; i < 4000 && after <= 0.0; ++i) {
            before = std::min(before, dry.states[0].velocity[2]);
            dry.advance(Dry::step);
            if (before < -1.0 && dry.depth(0) == 0.0 && dry.states[0].velocity[2] > 0.0) {
                after = dry.states[0].velocity[2];
            }
        }
        EXPECT_NEAR(before, -std::sqrt(2.0 * 9.81 * fall), 0.02);
        EXPECT_NEAR(-after / before, restitution, 0.02);
    }
}

TEST(BodyContact, ABlockRestsBelowCoulombsLimitAndSlidesAboveIt) {
    const double friction = 0.4;
    for (const double steepness : {0.3, 0.5}) {
        Solid block = rectangle("block", 0.3, 0.02, 0.1, 0.04);
        block.friction = friction;
        const double angle = std::atan(steepness);
        const double g = 9.81;
        Dry dry(dry_tank(2, {block}), {g * std::sin(angle), 0.0, -g * std::cos(angle)});
        dry.advance(0.3);  // it settles
        const double from = dry.states[0].displacement[0];
        const double speed = dry.states[0].velocity[0];
        dry.advance(0.2);
        const double acceleration = (dry.states[0].velocity[0] - speed) / 0.2;
        if (steepness < friction) {
            EXPECT_NEAR(dry.states[0].displacement[0], from, 1e-6);
        } else {
            const double expected = g * (std::sin(angle) - friction * std::cos(angle));
            EXPECT_NEAR(acceleration, expected, 0.01 * expected);
        }
        EXPECT_NEAR(dry.states[0].angle[1], 0.0, 1e-3);
        EXPECT_LT(dry.depth(0), 1e-4);
    }
}

TEST(BodyContact, ADroppedBoxComesToRestOnTheBed) {
    Solid box = rectangle("box", 0.5, 0.1, 0.1, 0.06);
    // Turned by 20 degrees: it falls on a corner.
    const double c = std::cos(0.35);
    const double s = std::sin(0.35);
    for (std::size_t i = 0; i < 4; ++i) {
        const double dx = box.x[i] - 0.5;
        const double dz = box.z[i] - 0.1;
        box.x[i] = 0.5 + c * dx - s * dz;
        box.z[i] = 0.1 + s * dx + c * dz;
    }
    Dry dry(dry_tank(2, {box}));
    dry.advance(3.0);
    EXPECT_NEAR(dry.states[0].displacement[2], -0.07, 1e-4);
    EXPECT_NEAR(dry.states[0].angle[1], 0.35, 1e-3);
    EXPECT_NEAR(dry.states[0].velocity[2], 0.0, 1e-4);
    EXPECT_NEAR(dry.states[0].angular_velocity[1], 0.0, 1e-3);
    EXPECT_LT(dry.depth(0), 1e-4);
}

TEST(BodyContact, TwoBodiesShareTheirMomentum) {
    for (const int dimensions : {2, 3}) {
        std::vector<Solid> both = dimensions == 2 ? std::vector{rectangle("first", 0.3, 0.1, 0.08, 0.06),
                                                                rectangle("second", 0.5, 0.11, 0.1, 0.1)}
                                                  : std::vector{sphere("first", {0.3, 0.2, 0.1}, 0.08),
                                                                sphere("second", {0.5, 0.21, 0.11}, 0.1)};
        both[0].velocity_x = 1.0;
        for (Solid& solid : both) {
            solid.restitution = 0.6;
            solid.friction = 0.2;
        }
        Dry dry(dry_tank(dimensions, both), {});
        const auto momentum = [&](std::size_t k) {
            return dry.free[0].mass() * dry.states[0].velocity[k] +
                   dry.free[1].mass() * dry.states[1].velocity[k];
        };
        const auto angular = [&] {
            double sum = 0.0;
            for (std::size_t n = 0; n < 2; ++n) {
                const Point3 x{dry.free[n].centre_of_mass()[0] + dry.states[n].displacement[0], 0.0,
                               dry.free[n].centre_of_mass()[2] + dry.states[n].displacement[2]};
                sum += dry.states[n].angular_momentum[1] +
                       dry.free[n].mass() *
                           (x[2] * dry.states[n].velocity[0] - x[0] * dry.states[n].velocity[2]);
            }
            return sum;
        };
        const double along = momentum(0);
        const double turning = angular();
        dry.advance(0.2);
        EXPECT_GT(dry.states[1].velocity[0], 0.2);
        EXPECT_NEAR(momentum(0), along, 1e-12 * along);
        EXPECT_NEAR(momentum(2), 0.0, 1e-12 * along);
        EXPECT_NEAR(angular(), turning, 1e-9 * std::abs(turning));
    }
}

// A body that has gone once around a periodic channel meets others as it did the first time. They are not
// whole steps apart, so that rounding does not decide in which step they meet.
TEST(BodyContact, ImagesOfAPeriodicChannelAreTheBodiesThemselves) {
    for (const int dimensions : {2, 3}) {
        std::vector<Solid> both = dimensions == 2 ? std::vector{rectangle("first", 0.3, 0.1, 0.08, 0.06),
                                                                rectangle("second", 0.50004, 0.133, 0.1, 0.1)}
                                                  : std::vector{sphere("first", {0.3, 0.2, 0.1}, 0.08),
                                                                sphere("second", {0.50004, 0.21, 0.12}, 0.1)};
        both[0].velocity_x = 1.0;
        for (Solid& solid : both) solid.friction = 0.2;
        Case c = dry_tank(dimensions, both);
        c.channel.ends = Ends::periodic;
        Dry once(c, {});
        once.advance(0.2);
        for (const std::size_t gone : {std::size_t{0}, std::size_t{1}}) {
            Dry again(c, {});
            again.states[gone].displacement[0] += c.channel.length;
            again.advance(0.2);
            for (std::size_t n = 0; n < 2; ++n) {
                EXPECT_GT(std::abs(once.states[n].angular_velocity[1]), 0.05);
                EXPECT_NEAR(again.states[n].angular_velocity[1], once.states[n].angular_velocity[1], 1e-6);
                for (std::size_t k = 0; k < 3; ++k) {
                    EXPECT_NEAR(again.states[n].velocity[k], once.states[n].velocity[k], 1e-8);
                }
            }
        }
    }
}

}  // namespace
}  // namespace riffle
