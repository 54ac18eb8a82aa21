#include "boundary/solid_fill.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include "boundary/wall_particle.hpp"
#include "case/end_buffers.hpp"
#include "case/end_floor.hpp"

namespace riffle::inline boundary {

namespace {

/// Whether a place lies beyond all that stands behind an open end.
bool is_beyond_walls(const Case& c, double x) {
    return x <= -walls_beyond_end(c) || x >= c.channel.length + walls_beyond_end(c);
}

struct Interval {
    double begin = 0.0;
    double end = 0.0;
};

/// The parts of [begin, end] where f holds; nothing shorter than `step` is seen.
template <class F>
std::vector<Interval> intervals_where(double begin, double end, double step, const F& f) {
    std::vector<Interval> found;
    const auto edge = [&](double no, double yes) {
        for (int i = 0; i < 40; ++i) {
            const double middle = 0.5 * (no + yes);
            (f(middle) ? yes : no) = middle;
        }
        return yes;
    };
    const int steps = std::max(1, static_cast<int>(std::ceil((end - begin) / step)));
    double before = begin;
    bool inside = false;
    for (int i = 0; i < steps; ++i) {
        // The middles of the steps: a corner of the outline is never looked at itself.
        const double t = begin + (i + 0.5) * (end - begin) / steps;
        const bool now = f(t);
        if (now && !inside) {
            found.push_back({i == 0 && f(begin + 1e-9 * step) ? begin : edge(before, t), t});
        } else if (!now && inside) {
            found.back().end = edge(t, before);
        }
        inside = now;
        before = t;
    }
    if (inside) found.back().end = f(end - 1e-9 * step) ? end : edge(end, before);
    return found;
}

class Fill {
  public:
    Fill(const Case& c, const Solid& solid, std::int32_t body, WallParticles<2>& walls)
        : c_(c), body_(body), walls_(walls), outline_(outline_of(solid)), spacing_(c.numerics.spacing) {
        for (std::size_t i = 0; i < outline_.size(); ++i) {
            wetted_.push_back(is_wetted(c, solid, outline_, i));
            const std::size_t j = outline_.next(i);
            const double dx = outline_.x[j] - outline_.x[i];
            const double dz = outline_.z[j] - outline_.z[i];
            length_.push_back(std::hypot(dx, dz));
            along_.push_back({dx / length_.back(), dz / length_.back()});
        }
        moves_ = !solid.rests();
        passes_ = passes_through(c, solid);
        for (std::size_t k = 0; !moves_ && first_solid + static_cast<std::int32_t>(k) < body; ++k) {
            if (c.solids[k].rests()) earlier_.push_back(outline_of(c.solids[k]));
        }
    }

    void run() {
        for (int layer = 0; layer < c_.numerics.wall_layers; ++layer) {
            const double depth = (layer + 0.5) * spacing_;
            for (std::size_t i = 0; i < outline_.size(); ++i) {
                if (wetted_[i]) add_edge(i, depth);
                // The corner at the beginning of edge i.
                if (wetted_[i] || wetted_[before(i)]) add_corner(i, depth);
            }
        }
    }

  private:
    [[nodiscard]] Vec<2> normal(std::size_t i) const { return {along_[i][1], -along_[i][0]}; }

    struct Nearest {
        std::size_t edge = 0;
        double distance = std::numeric_limits<double>::infinity();
    };

    /// The nearest wetted edge.
    [[nodiscard]] Nearest nearest(const Vec<2>& p) const {
        Nearest found;
        for (std::size_t i = 0; i < outline_.size(); ++i) {
            const double distance = distance_from_edge(outline_, i, p[0], p[1]);
            if (wetted_[i] && distance < found.distance - 1e-6 * spacing_) {
                found = {i, distance};
            }
        }
        return found;
    }

    [[nodiscard]] std::size_t before(std::size_t i) const {
        return (i + outline_.size() - 1) % outline_.size();
    }

    /// Whether the solid has a right angle at the corner at the beginning of edge i, water on its outside.
    [[nodiscard]] bool begins_at_right_angle(std::size_t i) const {
        const Vec<2>& a = along_[before(i)];
        const Vec<2>& b = along_[i];
        return a[0] * b[1] - a[1] * b[0] > 0.0 && std::abs(a[0] * b[0] + a[1] * b[1]) < 0.1;
    }

    /// The edge whose layers a place in the solid belongs to: the nearest, but at a right angle the layers of
    /// the longer edge go through, so that those of both form one lattice.
    [[nodiscard]] std::size_t owner(const Vec<2>& p) const {
        const std::size_t edge = nearest(p).edge;
        Nearest found{edge, c_.numerics.wall_layers * spacing_};
        const auto consider = [&](std::size_t other, bool right_angle) {
            const double distance = distance_from_edge(outline_, other, p[0], p[1]);
            const double longer = length_[other] - length_[edge];
            const bool first =
                longer > 1e-6 * spacing_ || (longer > -1e-6 * spacing_ && other == before(edge));
            const double slack = (other < found.edge ? 1e-6 : -1e-6) * spacing_;
            if (wetted_[other] && right_angle && first && distance < found.distance + slack) {
                found = {other, distance};
            }
        };
        consider(before(edge), begins_at_right_angle(edge));
        consider(outline_.next(edge), begins_at_right_angle(outline_.next(edge)));
        return found.edge;
    }

    [[nodiscard]] bool in_solid(const Vec<2>& p) const {
        return contains(outline_, p[0], p[1]) && in_channel(p) && !in_earlier(p);
    }

    /// Whether a solid at rest that the case names before this one has the place already.
    [[nodiscard]] bool in_earlier(const Vec<2>& p) const {
        const double period = c_.channel.ends == Ends::periodic ? c_.channel.length : 0.0;
        return std::any_of(earlier_.begin(), earlier_.end(), [&](const Outline& other) {
            return at_any_image(p[0], period, [&](double x) { return contains(other, x, p[1]); });
        });
    }

    /// The bed, the end walls and the lid have particles of their own.
    [[nodiscard]] bool in_channel(const Vec<2>& p) const {
        if (moves_ || c_.channel.top == Top::periodic) return true;
        const bool closed = c_.channel.ends == Ends::walls;
        if (c_.channel.ends == Ends::open && is_beyond_walls(c_, p[0])) return false;
        if (passes_ && (p[0] < 0.0 || p[0] >= c_.channel.length)) {
            return false;  // the other end of the channel has it
        }
        return p[1] > 0.0 && (!closed || (p[0] > 0.0 && p[0] < c_.channel.length)) &&
               (c_.channel.top != Top::wall || p[1] < c_.total_depth());
    }

    /// Whether an edge that faces the other way and was filled before has a layer there already.
    [[nodiscard]] bool filled_from_behind(std::size_t i, const Vec<2>& p, double depth) const {
        for (std::size_t j = 0; j < i; ++j) {
            const double cosine = along_[i][0] * along_[j][0] + along_[i][1] * along_[j][1];
            if (wetted_[j] && cosine < -0.9 &&
                distance_from_edge(outline_, j, p[0], p[1]) < depth + 0.25 * spacing_) {
                return true;
            }
        }
        return false;
    }

    void add_edge(std::size_t i, double depth) {
        const Vec<2> n = normal(i);
        const auto place = [&](double t) {
            return Vec<2>{outline_.x[i] + t * along_[i][0] - depth * n[0],
                          outline_.z[i] + t * along_[i][1] - depth * n[1]};
        };
        const auto mine = [&](double t) {
            const Vec<2> p = place(t);
            return in_solid(p) && owner(p) == i && !filled_from_behind(i, p, depth);
        };
        for (const Interval& part : intervals_where(0.0, length_[i], 0.02 * spacing_, mine)) {
            add_row(part, place, 1.0);
        }
    }

    void add_corner(std::size_t i, double depth) {
        const auto place = [&](double angle) {
            return Vec<2>{outline_.x[i] + depth * std::cos(angle), outline_.z[i] + depth * std::sin(angle)};
        };
        // Where the corner itself is nearest the distance to the edges beside it is `depth` as well, but
        // their own rows end at right angles to their ends.
        const auto mine = [&](double angle) {
            const Vec<2> p = place(angle);
            return in_solid(p) && nearest(p).distance > depth - 1e-6 * spacing_ && !beside_edge(i, p) &&
                   !beside_edge(before(i), p);
        };
        const double full = 2.0 * std::numbers::pi;
        for (const Interval& part : intervals_where(0.0, full, 0.02 * spacing_ / depth, mine)) {
            add_row(part, place, depth);
        }
    }

    /// Whether the foot of the perpendicular from p to a wetted edge lies on it.
    [[nodiscard]] bool beside_edge(std::size_t i, const Vec<2>& p) const {
        const double t = (p[0] - outline_.x[i]) * along_[i][0] + (p[1] - outline_.z[i]) * along_[i][1];
        return wetted_[i] && t > 0.0 && t < length_[i];
    }

    /// Particles evenly over a part of a layer; `scale`: length per unit of the parameter.
    template <class Place>
    void add_row(const Interval& part, const Place& place, double scale) {
        const double length = (part.end - part.begin) * scale;
        if (length < 0.05 * spacing_) return;
        const int count = std::max(1, static_cast<int>(std::lround(length / spacing_)));
        for (int k = 0; k < count; ++k) {
            Vec<2> p = place(part.begin + (k + 0.5) / count * (part.end - part.begin));
            const Nearest face = nearest(p);
            const Vec<2> n = beside_edge(face.edge, p) ? normal(face.edge) : Vec<2>{};
            if (c_.channel.ends == Ends::periodic) {
                p[0] -= c_.channel.length * std::floor(p[0] / c_.channel.length);
            }
            add_wall_particle(walls_, {.position = p,
                                       .volume = length / count * spacing_,
                                       .normal = n,
                                       .depth = face.distance,
                                       .body = body_,
                                       .all_motion = true});
        }
    }

    const Case& c_;
    std::int32_t body_;
    WallParticles<2>& walls_;
    Outline outline_;
    double spacing_;
    std::vector<bool> wetted_;
    std::vector<double> length_;
    std::vector<Vec<2>> along_;
    bool moves_ = false;
    bool passes_ = false;           ///< through periodic ends
    std::vector<Outline> earlier_;  ///< of the solids at rest before this one, where it rests too
};

}  // namespace

Outline outline_of(const Solid& solid) {
    Outline outline{solid.x, solid.z};
    if (signed_area(outline) < 0.0) {
        std::reverse(outline.x.begin(), outline.x.end());
        std::reverse(outline.z.begin(), outline.z.end());
    }
    return outline;
}

bool is_wetted(const Case& c, const Solid& solid, const Outline& outline, std::size_t i) {
    if (!solid.rests() || c.channel.top == Top::periodic) return true;
    const double near = 1e-6 * c.numerics.spacing;
    const std::size_t j = outline.next(i);
    const auto [left, right] = std::minmax(outline.x[i], outline.x[j]);
    const auto [low, high] = std::minmax(outline.z[i], outline.z[j]);
    const bool behind_bed = high <= near;
    const bool behind_ends =
        c.channel.ends == Ends::walls && (right <= near || left >= c.channel.length - near);
    const bool beyond =
        left == right &&
        (c.channel.ends == Ends::open ? is_beyond_walls(c, left)
                                      : (left < 0.0 || left > c.channel.length) && passes_through(c, solid));
    const bool behind_lid = c.channel.top == Top::wall && low >= c.total_depth() - near;
    return !behind_bed && !behind_ends && !beyond && !behind_lid;
}

void add_solid(const Case& c, const Solid& solid, std::int32_t body, WallParticles<2>& walls) {
    Fill(c, solid, body, walls).run();
}

}  // namespace riffle::inline boundary
