#include "boundary/body_contact.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "boundary/body_racks.hpp"
#include "boundary/solid_fill.hpp"
#include "boundary/wall_motion.hpp"

namespace riffle::inline boundary {

namespace {

constexpr double pi = std::numbers::pi;

/// Stiffness along a wall over that across it (Mindlin's ratio lies between 2/3 and 1).
constexpr double tangential_stiffness = 0.8;

void add_scaled(Point3& sum, double factor, const Point3& v) {
    for (std::size_t k = 0; k < 3; ++k) sum[k] += factor * v[k];
}

/// Corners of an outline, and places of its edges so far apart at most.
std::vector<Point3> points_on(const Outline& outline, double apart) {
    std::vector<Point3> points;
    for (std::size_t i = 0; i < outline.size(); ++i) {
        const std::size_t j = outline.next(i);
        const double dx = outline.x[j] - outline.x[i];
        const double dz = outline.z[j] - outline.z[i];
        const int parts = std::max(1, static_cast<int>(std::ceil(std::hypot(dx, dz) / apart)));
        for (int part = 0; part < parts; ++part) {
            const double share = static_cast<double>(part) / parts;
            points.push_back({outline.x[i] + share * dx, 0.0, outline.z[i] + share * dz});
        }
    }
    return points;
}

/// Corners of a mesh, and places of its triangles about so far apart.
std::vector<Point3> points_on(const SolidMesh& mesh, double apart) {
    std::vector<Point3> points;
    for (const Triangle& t : mesh.tree().triangles()) {
        const Point3 a = minus(t[1], t[0]);
        const Point3 b = minus(t[2], t[0]);
        const int parts = parts_of_edges(t, apart);
        for (int i = 0; i <= parts; ++i) {
            for (int j = 0; i + j <= parts; ++j) {
                Point3 place = t[0];
                add_scaled(place, static_cast<double>(i) / parts, a);
                add_scaled(place, static_cast<double>(j) / parts, b);
                points.push_back(place);
            }
        }
    }
    std::sort(points.begin(), points.end());
    points.erase(std::unique(points.begin(), points.end()), points.end());
    return points;
}

}  // namespace

// With the sine of the angle phi as the share of critical damping, the force of a damped spring is back at
// zero when the phase is pi - 2 phi, and the speed is then that of the impact times exp(-(pi - 2 phi) tan
// phi).
double damping_ratio(double restitution) {
    double low = 0.0;
    double high = 0.5 * pi;
    for (int i = 0; i < 60; ++i) {
        const double phi = 0.5 * (low + high);
        (std::exp(-(pi - 2.0 * phi) * std::tan(phi)) > restitution ? low : high) = phi;
    }
    return std::sin(low);
}

BodyContact::BodyContact(const Case& c, const std::vector<FreeBody>& bodies, double duration)
    : dimensions_(c.channel.dimensions), surfaces_(c), free_count_(bodies.size()), duration_(duration) {
    if (bodies.empty()) return;
    planes_ = dimensions_ == 2 ? boundary_planes<2>(c) : boundary_planes<3>(c);
    const std::vector<BoundaryPlane> racks = body_racks(c);
    planes_.insert(planes_.end(), racks.begin(), racks.end());
    const double apart = 0.5 * c.numerics.spacing;
    const auto meshes = dimensions_ == 3 ? meshes_of(c) : nullptr;
    for (std::size_t k = 0; k < c.solids.size(); ++k) {
        points_.push_back(meshes ? points_on((*meshes)[k], apart)
                                 : points_on(outline_of(c.solids[k]), apart));
        Point3 low = points_.back().front();
        Point3 high = low;
        for (const Point3& p : points_.back()) {
            for (std::size_t axis = 0; axis < 3; ++axis) {
                low[axis] = std::min(low[axis], p[axis]);
                high[axis] = std::max(high[axis], p[axis]);
            }
        }
        middle_.push_back({0.5 * (low[0] + high[0]), 0.5 * (low[1] + high[1]), 0.5 * (low[2] + high[2])});
        double squared = 0.0;
        for (const Point3& p : points_.back()) {
            const Point3 r = minus(p, middle_.back());
            squared = std::max(squared, dot(r, r));
        }
        radius_.push_back(std::sqrt(squared));
    }
}

void BodyContact::touch_plane(std::size_t solid, const BoundaryPlane& plane, const BodyState& body,
                              std::vector<Touch>& touches) const {
    const std::size_t axis = dimensions_ == 2 && plane.axis == 1 ? 2 : plane.axis;
    Point3 normal{};
    normal[axis] = plane.inward;
    const Point3 middle = body.placed(middle_[solid]);
    if (plane.inward * (middle[axis] - plane.place) > radius_[solid]) return;
    for (const Point3& start : points_[solid]) {
        const Point3 place = body.placed(start);
        const double depth = -plane.inward * (place[axis] - plane.place);
        if (depth > 0.0 && place[2] <= plane.top && place[0] <= plane.end) {
            touches.push_back({place, place, normal, depth});
        }
    }
}

bool BodyContact::may_touch(std::size_t first, std::size_t second,
                            const std::vector<BodyState>& bodies) const {
    const Point3 a = bodies[first_solid + first].placed(middle_[first]);
    const Point3 b = bodies[first_solid + second].placed(middle_[second]);
    const Point3 apart = minus(surfaces_.image_near(b, a), b);
    const double reach = radius_[first] + radius_[second];
    return dot(apart, apart) < reach * reach;
}

template <class Add>
void BodyContact::points_inside(std::size_t points_of, std::size_t in, const std::vector<BodyState>& bodies,
                                const Add& add) const {
    const BodyState& body = bodies[first_solid + points_of];
    const BodyState& other = bodies[first_solid + in];
    const Point3 middle = other.placed(middle_[in]);
    for (const Point3& start : points_[points_of]) {
        const Point3 place = body.placed(start);
        const Point3 beside = surfaces_.image_near(middle, place);
        const auto foot = surfaces_.inside(in, other.place_at_start(beside));
        if (foot) add(place, beside, other.turned(foot->normal), -foot->distance);
    }
}

void BodyContact::touch_solid(std::size_t first, std::size_t second, const std::vector<BodyState>& bodies,
                              std::vector<Touch>& touches) const {
    points_inside(first, second, bodies,
                  [&](const Point3& place, const Point3& beside, const Point3& normal, double depth) {
                      touches.push_back({place, beside, normal, depth});
                  });
    points_inside(second, first, bodies,
                  [&](const Point3& place, const Point3& beside, const Point3& normal, double depth) {
                      touches.push_back({beside, place, {-normal[0], -normal[1], -normal[2]}, depth});
                  });
}

void BodyContact::press(const std::vector<Touch>& touches, const Party& first, const Party& second,
                        double step, Point3& spring) const {
    if (touches.empty()) {
        spring = {};
        return;
    }
    double depths = 0.0;
    double deepest = 0.0;
    Touch middle;
    Point3& normal = middle.normal;
    for (const Touch& touch : touches) {
        depths += touch.depth;
        deepest = std::max(deepest, touch.depth);
        add_scaled(middle.place, touch.depth, touch.place);
        add_scaled(middle.other, touch.depth, touch.other);
        add_scaled(normal, touch.depth, touch.normal);
    }
    const double length = std::sqrt(dot(normal, normal));
    for (std::size_t k = 0; k < 3; ++k) {
        middle.place[k] /= depths;
        middle.other[k] /= depths;
        normal[k] /= length > 0.0 ? length : 1.0;
    }
    const auto place_of = [&](const Party& party, const Touch& touch) -> const Point3& {
        return &party == &first ? touch.place : touch.other;
    };
    const auto arm_of = [](const Party& party, const Point3& place) {
        return minus(minus(place, party.free->centre_of_mass()), party.state->displacement);
    };
    const auto velocity_of = [&](const Party& party, const Touch& touch) {
        return party.body != nullptr ? party.body->velocity_at(place_of(party, touch)) : Point3{};
    };
    const auto slip_at = [&](const Touch& touch) {
        return minus(velocity_of(first, touch), velocity_of(second, touch));
    };
    double mobility = 0.0;
    double restitution = 0.0;
    double friction = 0.0;
    double count = 0.0;
    for (const Party* const party : {&first, &second}) {
        if (party->free != nullptr) {
            mobility +=
                party->free->mobility(*party->state, arm_of(*party, place_of(*party, middle)), normal);
            restitution += party->free->restitution();
            friction += party->free->friction();
            count += 1.0;
        }
    }
    if (mobility <= 0.0) {
        return;  // not free along the normal
    }
    restitution /= count;
    friction /= count;
    const double mass = 1.0 / mobility;
    const double frequency = pi / duration_;
    const double stiffness = mass * frequency * frequency;
    const double damping = 2.0 * damping_ratio(restitution) * mass * frequency;
    const auto push = [&](const Touch& touch, const Point3& force) {
        const auto add = [&](const Party& party, double sign) {
            if (party.load != nullptr) {
                add_scaled(party.load->force, sign, force);
                add_scaled(party.load->moment, sign, cross(arm_of(party, place_of(party, touch)), force));
            }
        };
        add(first, 1.0);
        add(second, -1.0);
    };
    // So many points as deep as the deepest one.
    const double sharing = depths / deepest;
    double pressed = 0.0;
    for (const Touch& touch : touches) {
        const double out = dot(slip_at(touch), touch.normal);
        const double weight = touch.depth / deepest;
        const double size = std::max(0.0, stiffness * touch.depth - weight * damping * out) / sharing;
        Point3 force{};
        add_scaled(force, size, touch.normal);
        push(touch, force);
        pressed += size;
    }
    Point3 slip = slip_at(middle);
    add_scaled(slip, -dot(slip, normal), normal);
    add_scaled(spring, step, slip);
    add_scaled(spring, -dot(spring, normal), normal);
    const double along = tangential_stiffness * stiffness;
    Point3 force{};
    add_scaled(force, -along, spring);
    add_scaled(force, -std::sqrt(tangential_stiffness) * damping, slip);
    const double size = std::sqrt(dot(force, force));
    if (size > friction * pressed) {
        // It slides: the spring is as long as it can hold.
        const double share = size > 0.0 ? friction * pressed / size : 0.0;
        for (std::size_t k = 0; k < 3; ++k) {
            force[k] *= share;
            spring[k] = -force[k] / along;
        }
    }
    push(middle, force);
}

std::vector<BodyLoad> BodyContact::loads(const std::vector<FreeBody>& free,
                                         const std::vector<FreeBodyState>& states,
                                         const std::vector<BodyState>& bodies, double step,
                                         std::vector<Point3>& springs) const {
    std::vector<BodyLoad> loads(free.size());
    std::vector<Touch> touches;
    const std::size_t each = planes_.size() + points_.size();
    for (std::size_t n = 0; n < free.size(); ++n) {
        const std::size_t solid = free[n].solid();
        const BodyState& body = bodies[first_solid + solid];
        const Party party{&free[n], &states[n], &body, &loads[n]};
        for (std::size_t p = 0; p < planes_.size(); ++p) {
            touches.clear();
            touch_plane(solid, planes_[p], body, touches);
            press(touches, party, {}, step, springs[n * each + p]);
        }
        for (std::size_t other = 0; other < points_.size(); ++other) {
            const auto found =
                std::find_if(free.begin(), free.end(), [&](const FreeBody& f) { return f.solid() == other; });
            const auto m = static_cast<std::size_t>(found - free.begin());
            if (other == solid || (found != free.end() && m < n)) {
                continue;  // the pair has been looked at
            }
            touches.clear();
            if (may_touch(solid, other, bodies)) touch_solid(solid, other, bodies, touches);
            Party against{.body = &bodies[first_solid + other]};
            if (found != free.end()) {
                against = {&free[m], &states[m], &bodies[first_solid + other], &loads[m]};
            }
            press(touches, party, against, step, springs[n * each + planes_.size() + other]);
        }
    }
    return loads;
}

double BodyContact::deepest(const std::vector<FreeBody>& free, std::size_t n,
                            const std::vector<BodyState>& bodies) const {
    std::vector<Touch> touches;
    const std::size_t solid = free[n].solid();
    for (const BoundaryPlane& plane : planes_) {
        touch_plane(solid, plane, bodies[first_solid + solid], touches);
    }
    for (std::size_t other = 0; other < points_.size(); ++other) {
        if (other != solid && may_touch(solid, other, bodies)) touch_solid(solid, other, bodies, touches);
    }
    double depth = 0.0;
    for (const Touch& touch : touches) depth = std::max(depth, touch.depth);
    return depth;
}

}  // namespace riffle::inline boundary
