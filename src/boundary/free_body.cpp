#include "boundary/free_body.hpp"

#include <algorithm>
#include <cmath>

#include "case/solid_motion.hpp"
#include "case/solid_volume.hpp"

namespace riffle::inline boundary {

namespace {

Quaternion product(const Quaternion& a, const Quaternion& b) {
    return {a[0] * b[0] - a[1] * b[1] - a[2] * b[2] - a[3] * b[3],
            a[0] * b[1] + a[1] * b[0] + a[2] * b[3] - a[3] * b[2],
            a[0] * b[2] - a[1] * b[3] + a[2] * b[0] + a[3] * b[1],
            a[0] * b[3] + a[1] * b[2] - a[2] * b[1] + a[3] * b[0]};
}

/// An orientation turned on at an angular velocity for a time, of length 1 again.
Quaternion turned_on(const Quaternion& orientation, const Point3& angular_velocity, double time) {
    const double rate = std::sqrt(dot(angular_velocity, angular_velocity));
    const double half = 0.5 * rate * time;
    const double share = rate > 0.0 ? std::sin(half) / rate : 0.0;
    Quaternion result = product({std::cos(half), share * angular_velocity[0], share * angular_velocity[1],
                                 share * angular_velocity[2]},
                                orientation);
    double squared = 0.0;
    for (const double q : result) squared += q * q;
    for (double& q : result) q /= std::sqrt(squared);
    return result;
}

Rotation matrix_of(const Quaternion& q) {
    const auto [w, x, y, z] = q;
    return {1.0 - 2.0 * (y * y + z * z), 2.0 * (x * y - w * z),       2.0 * (x * z + w * y),
            2.0 * (x * y + w * z),       1.0 - 2.0 * (x * x + z * z), 2.0 * (y * z - w * x),
            2.0 * (x * z - w * y),       2.0 * (y * z + w * x),       1.0 - 2.0 * (x * x + y * y)};
}

/// x of A x = b for a symmetric matrix and the chosen rows and columns alone; 0 elsewhere.
Point3 solved(const std::array<double, 9>& a, const Point3& b, const std::array<bool, 3>& chosen) {
    std::array<double, 9> m{};
    Point3 right{};
    for (std::size_t k = 0; k < 3; ++k) {
        right[k] = chosen[k] ? b[k] : 0.0;
        for (std::size_t l = 0; l < 3; ++l) {
            m[3 * k + l] = chosen[k] && chosen[l] ? a[3 * k + l] : (k == l ? 1.0 : 0.0);
        }
    }
    const Point3 row0{m[0], m[1], m[2]};
    const Point3 row1{m[3], m[4], m[5]};
    const Point3 row2{m[6], m[7], m[8]};
    const double determinant = dot(row0, cross(row1, row2));
    // Cramer's rule; the matrix is symmetric, so that its rows are its columns.
    return {dot(right, cross(row1, row2)) / determinant, dot(row0, cross(right, row2)) / determinant,
            dot(row0, cross(row1, right)) / determinant};
}

Point3 times(const std::array<double, 9>& m, const Point3& v) {
    return {m[0] * v[0] + m[1] * v[1] + m[2] * v[2], m[3] * v[0] + m[4] * v[1] + m[5] * v[2],
            m[6] * v[0] + m[7] * v[1] + m[8] * v[2]};
}

}  // namespace

void FreeBodyState::put_into(BodyState& body) const {
    body.displacement = displacement;
    body.velocity = velocity;
    body.acceleration = acceleration;
    if (body.turns) {
        body.rotation = matrix_of(orientation);
        body.angular_velocity = angular_velocity;
        body.angular_acceleration = angular_acceleration;
    }
}

std::array<double, FreeBodyState::count> FreeBodyState::numbers() const {
    std::array<double, count> all{};
    auto place = all.begin();
    for (const Point3* const part : {&displacement, &velocity, &angular_momentum, &angular_velocity,
                                     &acceleration, &angular_acceleration, &angle}) {
        place = std::copy(part->begin(), part->end(), place);
    }
    place = std::copy(orientation.begin(), orientation.end(), place);
    *place = released;
    return all;
}

FreeBodyState FreeBodyState::from(const std::array<double, count>& numbers) {
    FreeBodyState state;
    auto place = numbers.begin();
    for (Point3* const part :
         {&state.displacement, &state.velocity, &state.angular_momentum, &state.angular_velocity,
          &state.acceleration, &state.angular_acceleration, &state.angle}) {
        std::copy_n(place, 3, part->begin());
        place += 3;
    }
    std::copy_n(place, 4, state.orientation.begin());
    state.released = *(place + 4);
    return state;
}

FreeBody::FreeBody(const Case& c, std::size_t number) : solid_(number) {
    const Solid& solid = c.solids[number];
    const bool in_space = c.channel.dimensions == 3;
    const SolidVolume shape = solid_volume(c, solid);
    mass_ = solid.mass ? *solid.mass : solid.density.value_or(0.0) * shape.volume;
    centre_ = rotation_point(c, solid);
    if (solid.inertia.empty()) {
        inertia_ = shape.inertia();
        for (double& moment : inertia_) moment *= mass_ / shape.volume;
    } else {
        for (std::size_t k = 0; k < 3; ++k) {
            inertia_[4 * k] = solid.inertia.size() == 3 ? solid.inertia[k] : solid.inertia[0];
        }
    }
    moves_ = {solid.moves_x, in_space && solid.moves_y, solid.moves_z};
    turns_ = {in_space && solid.turns_x, solid.turns_y, in_space && solid.turns_z};
    spring_ = {solid.spring_x, solid.spring_y, solid.spring_z};
    const Point3 velocity{solid.velocity_x, solid.velocity_y, solid.velocity_z};
    const Point3 axis = rotation_axis(solid);
    for (std::size_t k = 0; k < 3; ++k) {
        first_velocity_[k] = moves_[k] ? velocity[k] : 0.0;
        first_angular_velocity_[k] = turns_[k] ? solid.angular_velocity * axis[k] : 0.0;
    }
    restitution_ = solid.restitution;
    friction_ = solid.friction;
    reach_ = reach_from(c, solid, centre_);
    start_ = solid.start;
}

void FreeBody::release(FreeBodyState& state) const {
    state.velocity = first_velocity_;
    state.angular_momentum = times(inertia_at(state.orientation), first_angular_velocity_);
    state.angular_velocity = first_angular_velocity_;
    state.released = 1.0;
}

std::array<double, 9> FreeBody::inertia_at(const Quaternion& orientation) const {
    const Rotation r = matrix_of(orientation);
    std::array<double, 9> turned{};
    for (std::size_t i = 0; i < 3; ++i) {
        for (std::size_t j = 0; j < 3; ++j) {
            for (std::size_t k = 0; k < 3; ++k) {
                for (std::size_t l = 0; l < 3; ++l) {
                    turned[3 * i + j] += r[3 * i + k] * inertia_[3 * k + l] * r[3 * j + l];
                }
            }
        }
    }
    return turned;
}

Point3 FreeBody::angular_velocity_of(const Point3& angular_momentum, const Quaternion& orientation) const {
    return solved(inertia_at(orientation), angular_momentum, turns_);
}

FreeBody::Rates FreeBody::rates(const FreeBodyState& state, const BodyLoad& load) const {
    Rates rates;
    for (std::size_t k = 0; k < 3; ++k) rates.acceleration[k] = moves_[k] ? load.force[k] / mass_ : 0.0;
    const Point3 gyration = cross(state.angular_velocity, state.angular_momentum);
    Point3 moment = load.moment;
    for (std::size_t k = 0; k < 3; ++k) moment[k] -= gyration[k];
    rates.angular_acceleration = angular_velocity_of(moment, state.orientation);
    return rates;
}

double FreeBody::mobility(const FreeBodyState& state, const Point3& arm, const Point3& direction) const {
    double result = 0.0;
    for (std::size_t k = 0; k < 3; ++k) result += moves_[k] ? direction[k] * direction[k] / mass_ : 0.0;
    const Point3 turn = cross(arm, direction);
    return result + dot(turn, angular_velocity_of(turn, state.orientation));
}

Point3 FreeBody::spring_force(const FreeBodyState& state) const {
    return {-spring_[0] * state.displacement[0], -spring_[1] * state.displacement[1],
            -spring_[2] * state.displacement[2]};
}

double FreeBody::kinetic_energy(const FreeBodyState& state) const {
    return 0.5 * mass_ * dot(state.velocity, state.velocity) +
           0.5 * dot(state.angular_velocity, times(inertia_at(state.orientation), state.angular_velocity));
}

void FreeBody::advance(FreeBodyState& state, const BodyLoad& load, double kick, double motion,
                       double smoothing) const {
    const Rates now = rates(state, load);
    const double share = smoothing > motion ? motion / smoothing : 1.0;
    for (std::size_t k = 0; k < 3; ++k) {
        state.acceleration[k] += share * (now.acceleration[k] - state.acceleration[k]);
        state.angular_acceleration[k] +=
            share * (now.angular_acceleration[k] - state.angular_acceleration[k]);
        state.velocity[k] += kick * now.acceleration[k];
        state.displacement[k] += motion * state.velocity[k];
        state.angular_momentum[k] += turns_[k] ? kick * load.moment[k] : 0.0;
    }
    const bool about_all = turns_[0] && turns_[1] && turns_[2];
    const auto kept = [&](const Point3& angular_velocity, const Quaternion& orientation) {
        // What holds the other axes takes all momentum about them.
        return about_all ? state.angular_momentum : times(inertia_at(orientation), angular_velocity);
    };
    const Point3 begin = angular_velocity_of(state.angular_momentum, state.orientation);
    const Quaternion middle = turned_on(state.orientation, begin, 0.5 * motion);
    const Point3 turning = angular_velocity_of(state.angular_momentum, middle);
    state.orientation = turned_on(state.orientation, turning, motion);
    for (std::size_t k = 0; k < 3; ++k) state.angle[k] += motion * turning[k];
    state.angular_velocity = angular_velocity_of(state.angular_momentum, state.orientation);
    state.angular_momentum = kept(state.angular_velocity, state.orientation);
}

void FreeBody::predict(FreeBodyState& state, double kick, double motion) const {
    if (state.released == 0.0) return;
    for (std::size_t k = 0; k < 3; ++k) {
        state.velocity[k] += kick * state.acceleration[k];
        state.displacement[k] += motion * state.velocity[k];
        state.angular_velocity[k] += kick * state.angular_acceleration[k];
    }
    state.orientation = turned_on(state.orientation, state.angular_velocity, motion);
}

std::vector<FreeBodyState> free_body_states(std::span<const double> numbers, std::size_t count) {
    std::vector<FreeBodyState> states;
    for (std::size_t n = 0; n < count; ++n) {
        std::array<double, FreeBodyState::count> own{};
        std::copy_n(numbers.begin() + static_cast<std::ptrdiff_t>(n * own.size()), own.size(), own.begin());
        states.push_back(FreeBodyState::from(own));
    }
    return states;
}

std::vector<FreeBody> free_bodies(const Case& c) {
    std::vector<FreeBody> bodies;
    for (std::size_t k = 0; k < c.solids.size(); ++k) {
        if (c.solids[k].is_free()) bodies.emplace_back(c, k);
    }
    return bodies;
}

}  // namespace riffle::inline boundary
