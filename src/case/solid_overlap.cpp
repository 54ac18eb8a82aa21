#include "case/solid_overlap.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <memory>
#include <vector>

#include "case/body_state.hpp"
#include "case/outline.hpp"
#include "case/solid_mesh.hpp"
#include "case/solid_motion.hpp"

namespace riffle::inline case_file {

namespace {

/// An outline at another place, turned with its body.
Outline moved(Outline outline, const BodyState& body, const Point3& shift) {
    for (std::size_t i = 0; i < outline.size(); ++i) {
        const Point3 corner = body.placed({outline.x[i], 0.0, outline.z[i]});
        outline.x[i] = corner[0] + shift[0];
        outline.z[i] = corner[2] + shift[2];
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
        if (cross == 0.0) continue;
        const double rx = b.x[j] - a.x[i];
        const double rz = b.z[j] - a.z[i];
        const double along = (rx * ez - rz * ex) / cross;
        const double along_other = (rx * dz - rz * dx) / cross;
        if (along > 0.0 && along < 1.0 && along_other >= 0.0 && along_other <= 1.0) at.push_back(along);
    }
    std::sort(at.begin(), at.end());
    return at;
}

/// A place of the outline of `a` that is deeper in `b` than `tolerance`: the middle of a stretch between two
/// crossings.
std::optional<Point3> place_inside(const Outline& a, const Outline& b, double tolerance) {
    for (std::size_t i = 0; i < a.size(); ++i) {
        const std::vector<double> at = crossings(a, i, b);
        for (std::size_t k = 0; k + 1 < at.size(); ++k) {
            const double middle = 0.5 * (at[k] + at[k + 1]);
            const double x = a.x[i] + middle * (a.x[a.next(i)] - a.x[i]);
            const double z = a.z[i] + middle * (a.z[a.next(i)] - a.z[i]);
            if (contains(b, x, z) && distance_from_outline(b, x, z) > tolerance) {
                return Point3{x, 0.0, z};
            }
        }
    }
    return std::nullopt;
}

/// How two solids stand to each other.
struct Meeting {
    std::optional<Point3> place;  ///< where one is deeper in the other than the tolerance
    double distance =
        std::numeric_limits<double>::infinity();  ///< so far apart at least, where they do not meet, m
};

/// Two solids in two dimensions, by their outlines.
class Outlines {
  public:
    Outlines(const Case& c, std::size_t first, std::size_t second)
        : first_{c.solids[first].x, c.solids[first].z}, second_{c.solids[second].x, c.solids[second].z} {}

    /// `shift`: of the second one to an image of it next door.
    [[nodiscard]] Meeting meeting(const BodyState& a, const BodyState& b, const Point3& shift,
                                  double tolerance) const {
        const Outline first = moved(first_, a, {});
        const Outline second = moved(second_, b, shift);
        auto place = place_inside(second, first, tolerance);
        if (!place) place = place_inside(first, second, tolerance);
        return {place, gap(first, second)};
    }

  private:
    Outline first_;
    Outline second_;
};

/// Two solids in space, by places on their surfaces that are at most a spacing apart: solids are thicker than
/// that.
class Surfaces {
  public:
    Surfaces(const Case& c, std::size_t first, std::size_t second)
        : meshes_(meshes_of(c)),
          first_((*meshes_)[first]),
          second_((*meshes_)[second]),
          between_(c.numerics.spacing),
          on_first_(places_on(first_, between_)),
          on_second_(places_on(second_, between_)) {}

    [[nodiscard]] Meeting meeting(const BodyState& a, const BodyState& b, const Point3& shift,
                                  double tolerance) const {
        const double apart = ball_distance(a, b, shift);
        if (apart > 0.0) {
            return {std::nullopt, apart};
        }
        const Point3 back{-shift[0], -shift[1], -shift[2]};
        Meeting found = look(on_second_, b, shift, first_, a, tolerance);
        if (!found.place) {
            const Meeting other = look(on_first_, a, back, second_, b, tolerance);
            found.distance = std::min(found.distance, other.distance);
            if (other.place) found.place = plus(*other.place, shift);
        }
        // Between two places the surface may be nearer.
        found.distance = std::max(0.0, found.distance - between_);
        return found;
    }

  private:
    static Point3 plus(const Point3& a, const Point3& b) { return {a[0] + b[0], a[1] + b[1], a[2] + b[2]}; }

    static std::vector<Point3> places_on(const SolidMesh& mesh, double apart) {
        std::vector<Point3> places;
        for (const Triangle& t : mesh.tree().triangles()) {
            const Point3 a = minus(t[1], t[0]);
            const Point3 b = minus(t[2], t[0]);
            const int parts = parts_of_edges(t, apart);
            // The middles of the upright ones of its parts; those of the others are as near.
            for (int i = 0; i < parts; ++i) {
                for (int j = 0; i + j < parts; ++j) {
                    const double u = (i + 1.0 / 3.0) / parts;
                    const double v = (j + 1.0 / 3.0) / parts;
                    places.push_back({t[0][0] + u * a[0] + v * b[0], t[0][1] + u * a[1] + v * b[1],
                                      t[0][2] + u * a[2] + v * b[2]});
                }
            }
        }
        return places;
    }

    /// Distance of what surely holds both, 0 where they meet: the boxes around solids that do not turn, else
    /// the balls around these.
    [[nodiscard]] double ball_distance(const BodyState& a, const BodyState& b, const Point3& shift) const {
        double squared = 0.0;
        const bool turn = a.turns || b.turns;
        double radii = 0.0;
        for (const SolidMesh* const mesh : {&first_, &second_}) {
            const Point3 size = minus(mesh->upper(), mesh->lower());
            radii += 0.5 * std::sqrt(dot(size, size));
        }
        for (std::size_t k = 0; k < 3; ++k) {
            const double way = shift[k] + b.displacement[k] - a.displacement[k];
            const double between = std::max({second_.lower()[k] + way - first_.upper()[k],
                                             first_.lower()[k] - second_.upper()[k] - way, 0.0});
            squared += between * between;
        }
        if (!turn) return std::sqrt(squared);
        const auto middle = [](const SolidMesh& mesh, const BodyState& body) {
            Point3 m{};
            for (std::size_t k = 0; k < 3; ++k) m[k] = 0.5 * (mesh.lower()[k] + mesh.upper()[k]);
            return body.placed(m);
        };
        const Point3 between = minus(plus(middle(second_, b), shift), middle(first_, a));
        return std::max(0.0, std::sqrt(dot(between, between)) - radii);
    }

    /// Places of one surface with its body, moved by a shift, against the other solid.
    static Meeting look(const std::vector<Point3>& places, const BodyState& body, const Point3& shift,
                        const SolidMesh& solid, const BodyState& other, double tolerance) {
        Meeting found;
        for (const Point3& place : places) {
            const Point3 now = plus(body.placed(place), shift);
            const Point3 p = other.place_at_start(now);
            if (solid.contains(p)) {
                if (!solid.nearest(p, tolerance)) {
                    return {now, 0.0};
                }
                found.distance = 0.0;
            } else if (found.distance > 0.0) {
                const auto near = solid.nearest(p, found.distance);
                found.distance = near ? near->distance : found.distance;
            }
        }
        return found;
    }

    std::shared_ptr<const std::vector<SolidMesh>> meshes_;
    const SolidMesh& first_;
    const SolidMesh& second_;
    double between_;
    std::vector<Point3> on_first_;
    std::vector<Point3> on_second_;
};

double last_motion(const Solid& solid, double end) {
    switch (solid.motion) {
        case SolidMotion::fixed:
        case SolidMotion::free:  // nobody knows its way
            return 0.0;
        case SolidMotion::table:
            return solid.times.empty() ? 0.0 : std::min(end, solid.start + solid.times.back());
        case SolidMotion::constant:
        case SolidMotion::oscillating:
            break;
    }
    return std::min(end, solid.stop.value_or(end));
}

/// Shifts to the images in the neighbouring periods of what stands so far from another solid, m.
std::vector<Point3> images_of(const Case& c, const Point3& apart) {
    std::vector<Point3> images = {Point3{}};
    const auto repeat = [&](bool periodic, std::size_t axis, double extent) {
        std::vector<Point3> repeated;
        for (Point3 image : images) {
            image[axis] -= periodic ? extent * std::floor(apart[axis] / extent) : 0.0;
            for (const double beside :
                 periodic ? std::vector<double>{-extent, 0.0, extent} : std::vector<double>{0.0}) {
                repeated.push_back(image);
                repeated.back()[axis] += beside;
            }
        }
        images = std::move(repeated);
    };
    repeat(c.channel.ends == Ends::periodic, 0, c.channel.length);
    repeat(c.channel.dimensions == 3 && c.channel.sides == Sides::periodic, 1, c.channel.simulated_width());
    return images;
}

/// The first overlap of two solids, by steps as long as their distance allows.
template <class Shapes>
std::optional<SolidOverlap> overlap_of(const Case& c, std::size_t i, std::size_t j) {
    const Shapes shapes(c, i, j);
    const Solid& a = c.solids[i];
    const Solid& b = c.solids[j];
    const double tolerance = 0.1 * c.numerics.spacing;
    const double speed = largest_speed(c, a) + largest_speed(c, b);
    const bool free = a.is_free() || b.is_free();
    const double end = free ? 0.0 : std::max(last_motion(a, c.run.time), last_motion(b, c.run.time));
    const SolidTurning turning_a = solid_turning(c, a);
    const SolidTurning turning_b = solid_turning(c, b);
    for (double time = 0.0;;) {
        const BodyState now_a = body_state(solid_motion(a, time), turning_a);
        const BodyState now_b = body_state(solid_motion(b, time), turning_b);
        double distance = std::numeric_limits<double>::infinity();
        for (const Point3& image : images_of(c, minus(now_b.displacement, now_a.displacement))) {
            const Meeting meeting = shapes.meeting(now_a, now_b, image, tolerance);
            if (meeting.place) {
                return SolidOverlap{i, j, time, *meeting.place};
            }
            distance = std::min(distance, meeting.distance);
        }
        if (time >= end) return std::nullopt;
        time = std::min(end, time + std::max(distance, tolerance) / speed);
    }
}

}  // namespace

std::optional<SolidOverlap> first_overlap(const Case& c) {
    std::optional<SolidOverlap> first;
    for (std::size_t i = 0; i < c.solids.size(); ++i) {
        for (std::size_t j = i + 1; j < c.solids.size(); ++j) {
            if (c.solids[i].rests() && c.solids[j].rests()) {
                continue;  // both at rest
            }
            const auto overlap =
                c.channel.dimensions == 3 ? overlap_of<Surfaces>(c, i, j) : overlap_of<Outlines>(c, i, j);
            if (overlap && (!first || overlap->time < first->time)) first = overlap;
        }
    }
    return first;
}

}  // namespace riffle::inline case_file
