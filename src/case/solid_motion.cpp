#include "case/solid_motion.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <vector>

#include "case/outline.hpp"

namespace riffle {

namespace {

using Position = std::array<double, 2>;

double angular_frequency(const Solid& solid) { return 2.0 * std::numbers::pi * solid.frequency; }

/// A solid where it stands.
Outline moved(const Solid& solid, double x, double z) {
    Outline outline{solid.x, solid.z};
    for (double& corner : outline.x) {
        corner += x;
    }
    for (double& corner : outline.z) {
        corner += z;
    }
    return outline;
}

/// Least distance of the corners of either outline from the other one: of outlines that do not meet, their
/// distance.
double gap(const Outline& a, const Outline& b) {
    double least = std::numeric_limits<double>::infinity();
    for (std::size_t i = 0; i < a.size(); ++i) {
        least = std::min(least, distance_from_outline(b, a.x[i], a.z[i]));
    }
    for (std::size_t i = 0; i < b.size(); ++i) {
        least = std::min(least, distance_from_outline(a, b.x[i], b.z[i]));
    }
    return least;
}

/// Where along edge i of an outline, in units of its length, it crosses edges of the other one; with its
/// ends.
std::vector<double> crossings(const Outline& a, std::size_t i, const Outline& b) {
    std::vector<double> at = {0.0, 1.0};
    const double dx = a.x[a.next(i)] - a.x[i];
    const double dz = a.z[a.next(i)] - a.z[i];
    for (std::size_t j = 0; j < b.size(); ++j) {
        const double ex = b.x[b.next(j)] - b.x[j];
        const double ez = b.z[b.next(j)] - b.z[j];
        const double cross = dx * ez - dz * ex;
        if (cross == 0.0) {
            continue;
        }
        const double rx = b.x[j] - a.x[i];
        const double rz = b.z[j] - a.z[i];
        const double along = (rx * ez - rz * ex) / cross;
        const double along_other = (rx * dz - rz * dx) / cross;
        if (along > 0.0 && along < 1.0 && along_other >= 0.0 && along_other <= 1.0) {
            at.push_back(along);
        }
    }
    std::sort(at.begin(), at.end());
    return at;
}

/// A place of the outline of `a` that is deeper in `b` than `tolerance`: the middle of a stretch between two
/// crossings.
std::optional<Position> place_inside(const Outline& a, const Outline& b, double tolerance) {
    for (std::size_t i = 0; i < a.size(); ++i) {
        const std::vector<double> at = crossings(a, i, b);
        for (std::size_t k = 0; k + 1 < at.size(); ++k) {
            const double middle = 0.5 * (at[k] + at[k + 1]);
            const double x = a.x[i] + middle * (a.x[a.next(i)] - a.x[i]);
            const double z = a.z[i] + middle * (a.z[a.next(i)] - a.z[i]);
            if (contains(b, x, z) && distance_from_outline(b, x, z) > tolerance) {
                return Position{x, z};
            }
        }
    }
    return std::nullopt;
}

double last_motion(const Solid& solid, double end) {
    return solid.motion == SolidMotion::fixed ? 0.0 : std::min(end, solid.stop.value_or(end));
}

/// The first overlap of two solids, by steps as long as their distance allows.
std::optional<SolidOverlap> overlap_of(const Case& c, std::size_t i, std::size_t j) {
    const Solid& a = c.solids[i];
    const Solid& b = c.solids[j];
    const double tolerance = 0.1 * c.numerics.spacing;
    const double speed = largest_speed(a) + largest_speed(b);
    const double end = std::max(last_motion(a, c.run.time), last_motion(b, c.run.time));
    const double length = c.channel.length;
    for (double time = 0.0;;) {
        const Position at_a = solid_motion(a, time).displacement;
        const Position at_b = solid_motion(b, time).displacement;
        double x = at_b[0] - at_a[0];
        std::vector<double> images = {x};
        if (c.channel.ends == Ends::periodic) {
            x -= length * std::floor(x / length);
            images = {x - length, x, x + length};
        }
        const Outline first = moved(a, 0.0, 0.0);
        double distance = std::numeric_limits<double>::infinity();
        for (const double image : images) {
            const Outline second = moved(b, image, at_b[1] - at_a[1]);
            auto place = place_inside(second, first, tolerance);
            if (!place) {
                place = place_inside(first, second, tolerance);
            }
            if (place) {
                return SolidOverlap{i, j, time, {(*place)[0] + at_a[0], (*place)[1] + at_a[1]}};
            }
            distance = std::min(distance, gap(first, second));
        }
        if (time >= end) {
            return std::nullopt;
        }
        time = std::min(end, time + std::max(distance, tolerance) / speed);
    }
}

}  // namespace

SolidMotionState solid_motion(const Solid& solid, double time) {
    SolidMotionState state;
    const bool stopped = solid.stop && time >= *solid.stop;
    const double moving = (stopped ? *solid.stop : time) - solid.start;
    if (moving <= 0.0) {
        return state;
    }
    if (solid.motion == SolidMotion::constant) {
        state.velocity = {solid.velocity_x, solid.velocity_z};
        state.displacement = {moving * solid.velocity_x, moving * solid.velocity_z};
    } else if (solid.motion == SolidMotion::oscillating) {
        const double omega = angular_frequency(solid);
        const double sine = std::sin(omega * moving);
        const double cosine = std::cos(omega * moving);
        const std::array<double, 2> amplitude{solid.amplitude_x, solid.amplitude_z};
        for (std::size_t k = 0; k < 2; ++k) {
            state.displacement[k] = amplitude[k] * sine;
            state.velocity[k] = amplitude[k] * omega * cosine;
            state.acceleration[k] = -amplitude[k] * omega * omega * sine;
        }
    }
    if (stopped) {
        state.velocity = {};
        state.acceleration = {};
    }
    return state;
}

double largest_speed(const Solid& solid) {
    switch (solid.motion) {
        case SolidMotion::fixed:
            return 0.0;
        case SolidMotion::constant:
            return std::hypot(solid.velocity_x, solid.velocity_z);
        case SolidMotion::oscillating:
            return angular_frequency(solid) * std::hypot(solid.amplitude_x, solid.amplitude_z);
    }
    return 0.0;
}

std::optional<SolidOverlap> first_overlap(const Case& c) {
    std::optional<SolidOverlap> first;
    for (std::size_t i = 0; i < c.solids.size(); ++i) {
        for (std::size_t j = i + 1; j < c.solids.size(); ++j) {
            const bool rest = largest_speed(c.solids[i]) + largest_speed(c.solids[j]) == 0.0;
            const auto overlap = rest ? std::nullopt : overlap_of(c, i, j);
            if (overlap && (!first || overlap->time < first->time)) {
                first = overlap;
            }
        }
    }
    return first;
}

}  // namespace riffle
