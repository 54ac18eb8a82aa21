#include "case/solid_motion.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "case/solid_mesh.hpp"
#include "case/solid_volume.hpp"

namespace riffle::inline case_file {

namespace {

constexpr double degree = std::numbers::pi / 180.0;

double angular_frequency(const Solid& solid) { return 2.0 * std::numbers::pi * solid.frequency; }

/// A value of a table, with its first and second derivative.
struct TableValue {
    double value = 0.0;
    double rate = 0.0;
    double second = 0.0;
};

/// Slope of a table at a row: of the parabola through it and its neighbours; none at its ends, before and
/// behind which it rests.
double slope_at(const std::vector<double>& times, const std::vector<double>& values, std::size_t i) {
    if (i == 0 || i + 1 == times.size()) return 0.0;
    const double before = times[i] - times[i - 1];
    const double after = times[i + 1] - times[i];
    const double rise_before = (values[i] - values[i - 1]) / before;
    const double rise_after = (values[i + 1] - values[i]) / after;
    return (rise_before * after + rise_after * before) / (before + after);
}

/// Cubic Hermite pieces through the rows of a table.
TableValue in_table(const std::vector<double>& times, const std::vector<double>& values, double time) {
    if (values.empty() || times.size() != values.size() || time <= times.front()) {
        return {values.empty() ? 0.0 : values.front(), 0.0, 0.0};
    }
    if (time >= times.back()) {
        return {values.back(), 0.0, 0.0};
    }
    const auto above = std::upper_bound(times.begin(), times.end(), time);
    const auto j = static_cast<std::size_t>(above - times.begin());
    const std::size_t i = j - 1;
    const double width = times[j] - times[i];
    const double s = (time - times[i]) / width;
    const double from = values[i];
    const double rise = values[j] - values[i];
    const double first = width * slope_at(times, values, i);
    const double last = width * slope_at(times, values, j);
    const double square = 3.0 * rise - 2.0 * first - last;
    const double cube = first + last - 2.0 * rise;
    return {from + s * (first + s * (square + s * cube)),
            (first + s * (2.0 * square + s * 3.0 * cube)) / width,
            (2.0 * square + s * 6.0 * cube) / (width * width)};
}

void move_at_constant_velocity(const Solid& solid, double moving, SolidMotionState& state) {
    state.velocity = {solid.velocity_x, solid.velocity_y, solid.velocity_z};
    for (std::size_t k = 0; k < 3; ++k) state.displacement[k] = moving * state.velocity[k];
    state.angular_velocity = solid.angular_velocity;
    state.angle = moving * state.angular_velocity;
}

void swing(const Solid& solid, double moving, SolidMotionState& state) {
    const double omega = angular_frequency(solid);
    const double sine = std::sin(omega * moving);
    const double cosine = std::cos(omega * moving);
    const std::array<double, 3> amplitude{solid.amplitude_x, solid.amplitude_y, solid.amplitude_z};
    for (std::size_t k = 0; k < 3; ++k) {
        state.displacement[k] = amplitude[k] * sine;
        state.velocity[k] = amplitude[k] * omega * cosine;
        state.acceleration[k] = -amplitude[k] * omega * omega * sine;
    }
    const double turn = degree * solid.amplitude_angle;
    state.angle = turn * sine;
    state.angular_velocity = turn * omega * cosine;
    state.angular_acceleration = -turn * omega * omega * sine;
}

void follow_table(const Solid& solid, double moving, SolidMotionState& state) {
    const std::array<const std::vector<double>*, 3> shifts{&solid.shifts_x, &solid.shifts_y, &solid.shifts_z};
    for (std::size_t k = 0; k < 3; ++k) {
        const TableValue shift = in_table(solid.times, *shifts[k], moving);
        state.displacement[k] = shift.value;
        state.velocity[k] = shift.rate;
        state.acceleration[k] = shift.second;
    }
    const TableValue angle = in_table(solid.times, solid.angles, moving);
    state.angle = degree * angle.value;
    state.angular_velocity = degree * angle.rate;
    state.angular_acceleration = degree * angle.second;
}

std::array<double, 3> point_of(const std::vector<double>& values) {
    return {values[0], values.size() == 3 ? values[1] : 0.0, values.back()};
}

/// Largest speeds of a table: by its Hermite pieces, looked at often enough.
double largest_table_speed(const Solid& solid, double reach) {
    if (solid.times.size() < 2) return 0.0;
    constexpr int parts = 16;
    double largest = 0.0;
    for (std::size_t i = 0; i + 1 < solid.times.size(); ++i) {
        for (int part = 0; part < parts; ++part) {
            SolidMotionState state;
            const double share = (part + 0.5) / parts;
            follow_table(solid, solid.times[i] + share * (solid.times[i + 1] - solid.times[i]), state);
            largest = std::max(largest, std::hypot(state.velocity[0], state.velocity[1], state.velocity[2]) +
                                            reach * std::abs(state.angular_velocity));
        }
    }
    return largest;
}

}  // namespace

SolidMotionState solid_motion(const Solid& solid, double time) {
    SolidMotionState state;
    const bool stopped = solid.stop && time >= *solid.stop;
    const double moving = (stopped ? *solid.stop : time) - solid.start;
    if (solid.motion == SolidMotion::table) {
        follow_table(solid, moving, state);
        return state;
    }
    if (moving <= 0.0) return state;
    if (solid.motion == SolidMotion::constant) {
        move_at_constant_velocity(solid, moving, state);
    } else if (solid.motion == SolidMotion::oscillating) {
        swing(solid, moving, state);
    }
    if (stopped) {
        state.velocity = {};
        state.acceleration = {};
        state.angular_velocity = 0.0;
        state.angular_acceleration = 0.0;
    }
    return state;
}

bool turns(const Case& c, const Solid& solid) {
    const bool in_space = c.channel.dimensions == 3;
    switch (solid.motion) {
        case SolidMotion::fixed:
            return false;
        case SolidMotion::constant:
            return solid.angular_velocity != 0.0;
        case SolidMotion::oscillating:
            return solid.amplitude_angle != 0.0;
        case SolidMotion::table:
            return std::any_of(solid.angles.begin(), solid.angles.end(), [](double a) { return a != 0.0; });
        case SolidMotion::free:
            return solid.turns_y || (in_space && (solid.turns_x || solid.turns_z));
    }
    return false;
}

std::array<double, 3> rotation_axis(const Solid& solid) {
    if (solid.rotation_axis.size() != 3) {
        return {0.0, 1.0, 0.0};
    }
    const auto& axis = solid.rotation_axis;
    const double length = std::hypot(axis[0], axis[1], axis[2]);
    return {axis[0] / length, axis[1] / length, axis[2] / length};
}

std::vector<std::array<double, 3>> corners_of(const Case& c, const Solid& solid) {
    std::vector<std::array<double, 3>> corners;
    if (const SolidMesh* const mesh = c.channel.dimensions == 3 ? mesh_of(c, solid) : nullptr) {
        for (const Triangle& t : mesh->tree().triangles()) corners.insert(corners.end(), t.begin(), t.end());
        return corners;
    }
    for (std::size_t i = 0; i < solid.x.size(); ++i) {
        corners.push_back({solid.x[i], 0.0, solid.z[i]});
    }
    return corners;
}

std::array<double, 3> rotation_point(const Case& c, const Solid& solid) {
    const std::vector<double>& given = solid.is_free() ? solid.centre_of_mass : solid.rotation_about;
    return given.empty() ? solid_volume(c, solid).centroid : point_of(given);
}

SolidTurning solid_turning(const Case& c, const Solid& solid) {
    return turns(c, solid) ? SolidTurning{true, rotation_axis(solid), rotation_point(c, solid)}
                           : SolidTurning{};
}

BodyState body_state(const SolidMotionState& state, const SolidTurning& turning) {
    BodyState body{
        .displacement = state.displacement, .velocity = state.velocity, .acceleration = state.acceleration};
    if (turning.turns) {
        body.turns = true;
        body.centre = turning.centre;
        body.rotation = rotation_about(turning.axis, state.angle);
        for (std::size_t axis = 0; axis < 3; ++axis) {
            body.angular_velocity[axis] = state.angular_velocity * turning.axis[axis];
            body.angular_acceleration[axis] = state.angular_acceleration * turning.axis[axis];
        }
    }
    return body;
}

double largest_speed(const Case& c, const Solid& solid) {
    if (solid.rests()) return 0.0;
    const double reach = turns(c, solid) ? reach_from(c, solid, rotation_point(c, solid)) : 0.0;
    switch (solid.motion) {
        case SolidMotion::fixed:
            break;
        case SolidMotion::constant:
        case SolidMotion::free:
            return std::hypot(solid.velocity_x, solid.velocity_y, solid.velocity_z) +
                   reach * std::abs(solid.angular_velocity);
        case SolidMotion::oscillating:
            return angular_frequency(solid) *
                   (std::hypot(solid.amplitude_x, solid.amplitude_y, solid.amplitude_z) +
                    reach * degree * std::abs(solid.amplitude_angle));
        case SolidMotion::table:
            return largest_table_speed(solid, reach);
    }
    return 0.0;
}

}  // namespace riffle::inline case_file
