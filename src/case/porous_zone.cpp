#include "case/porous_zone.hpp"

#include <algorithm>
#include <cmath>
#include <memory>

#include "case/outline_check.hpp"
#include "case/patch_range.hpp"
#include "case/solid_mesh.hpp"

namespace riffle::inline case_file {

namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();

/// A range of the keys; an end at the bound of the channel or beyond it is none.
SoftRange range_of(std::optional<double> from, std::optional<double> to, double extent, bool periodic) {
    const double rounding = 1e-9 * extent;
    SoftRange range;
    const bool all = from.value_or(0.0) <= rounding && to.value_or(extent) >= extent - rounding;
    if (all) return range;
    if (periodic) {
        range.from = from.value_or(0.0);
        range.to = to.value_or(extent);
        range.period = extent;
        return range;
    }
    if (from && *from > rounding) range.from = *from;
    if (to && *to < extent - rounding) range.to = *to;
    return range;
}

/// Whether solids lie behind all of some places.
class SolidsBehind {
  public:
    explicit SolidsBehind(const Case& c) : c_(c), space_(c.channel.dimensions == 3) {
        if (space_ && !c.solids.empty()) meshes_ = c.meshes;
    }
    [[nodiscard]] bool holds(double x, double y, double z) const {
        if (space_) {
            return meshes_ && std::any_of(meshes_->begin(), meshes_->end(), [&](const SolidMesh& mesh) {
                       return mesh.contains({x, y, z});
                   });
        }
        return std::any_of(c_.solids.begin(), c_.solids.end(), [&](const Solid& solid) {
            return is_simple({solid.x, solid.z}) && contains({solid.x, solid.z}, x, z);
        });
    }
    /// Whether holds(place) for places evenly over two stretches, of those that count.
    template <class MakePlace>
    [[nodiscard]] bool all(const SoftRange& first, const SoftRange& second, const MakePlace& place) const {
        return all(first, second, place, [](const auto&) { return true; });
    }
    template <class MakePlace, class Counts>
    [[nodiscard]] bool all(const SoftRange& first, const SoftRange& second, const MakePlace& place,
                           const Counts& counts) const {
        constexpr int most = 9;
        const int across = space_ ? most : 1;
        for (int i = 0; i < most; ++i) {
            for (int j = 0; j < across; ++j) {
                const auto p = place(first.from + (i + 0.5) / most * (first.to - first.from),
                                     second.from + (j + 0.5) / across * (second.to - second.from));
                if (counts(p) && !holds(p[0], p[1], p[2])) return false;
            }
        }
        return true;
    }

  private:
    const Case& c_;
    bool space_;
    std::shared_ptr<const std::vector<SolidMesh>> meshes_;
};

/// How far beyond an edge solids are looked for, m.
double a_little_beyond(const Case& c) { return 0.1 * c.numerics.spacing; }

}  // namespace

double porous_edge(const Case& c, const Porous& porous) {
    // sigma = 0.527 h along an axis of Wendland's C2 kernel; that of a smooth step is its thickness/sqrt(20).
    constexpr double smoothing_lengths = 2.4;
    return porous.edge.value_or(smoothing_lengths * c.numerics.smoothing_ratio * c.numerics.spacing);
}

namespace {

/// Which edges of an outline have solids behind them all along, and over a stretch of the third axis.
/// `point`: of a place on the outline's two axes and the third the point in space.
template <class MakePoint>
std::vector<bool> edges_at_solids(const Case& c, const Outline& outline, const SoftRange& third,
                                  const MakePoint& point) {
    const SolidsBehind solids(c);
    const double turn = signed_area(outline) < 0.0 ? -1.0 : 1.0;
    std::vector<bool> result;
    for (std::size_t i = 0; i < outline.size(); ++i) {
        const std::size_t j = outline.next(i);
        const double first = outline.x[j] - outline.x[i];
        const double second = outline.z[j] - outline.z[i];
        // To the right of an edge that goes against the clock.
        const double out = turn * a_little_beyond(c) / std::hypot(first, second);
        result.push_back(solids.all({0.0, 1.0}, third, [&](double t, double other) {
            return point(outline.x[i] + t * first + out * second, outline.z[i] + t * second - out * first,
                         other);
        }));
    }
    return result;
}

/// Where the water of a channel ends along it; the second axis has no bounds yet.
WaterBounds bounds_along(const Case& c) {
    WaterBounds bounds;
    if (c.channel.ends == Ends::periodic) {
        bounds.periods[0] = c.channel.length;
    } else {
        bounds.from[0] = 0.0;
        bounds.to[0] = c.channel.length;
    }
    return bounds;
}

/// An outline in plan of a zone that stands over a stretch of heights.
SoftOutline shape_in_plan(const Case& c, const Outline& outline, const SoftRange& height, double edge) {
    WaterBounds bounds = bounds_along(c);
    if (c.channel.sides == Sides::periodic) {
        bounds.periods[1] = c.channel.simulated_width();
    } else {
        bounds.from[1] = 0.0;
        bounds.to[1] = c.channel.simulated_width();
    }
    return {outline,
            edges_at_solids(c, outline, height,
                            [](double x, double y, double z) {
                                return std::array{x, y, z};
                            }),
            bounds, edge, c.numerics.spacing};
}

/// An outline seen from the side.
SoftOutline shape_from_the_side(const Case& c, const Outline& outline, double edge) {
    WaterBounds bounds = bounds_along(c);
    if (c.channel.top != Top::periodic) bounds.from[1] = 0.0;
    if (c.channel.top == Top::wall) bounds.to[1] = c.total_depth();
    std::vector<bool> at_solids;
    if (c.channel.dimensions == 2) {
        at_solids = edges_at_solids(c, outline, {0.0, 1.0}, [](double x, double z, double) {
            return std::array{x, 0.0, z};
        });
    }
    return {outline, std::move(at_solids), bounds, edge, c.numerics.spacing};
}

}  // namespace

PorousZone::PorousZone(const Case& c, const Porous& porous)
    : edge_(porous_edge(c, porous)),
      along_(range_of(porous.x_from, porous.x_to, c.channel.length, c.channel.ends == Ends::periodic)),
      across_(range_of(porous.y_from, porous.y_to, c.channel.simulated_width(),
                       c.channel.dimensions == 3 && c.channel.sides == Sides::periodic)),
      top_x_(porous.top_x),
      top_z_(porous.top_z) {
    const double rounding = 1e-9 * c.channel.length;
    const bool box = c.channel.top == Top::periodic;
    if (porous.z_from && (*porous.z_from > rounding || box)) upright_.from = *porous.z_from;
    const bool below_lid = c.channel.top != Top::free_surface && !box;
    if (porous.z_to && !(below_lid && *porous.z_to >= c.total_depth() - rounding)) upright_.to = *porous.z_to;
    // Outlines that are none are refused elsewhere.
    if (const Outline outline = outline_of(porous); outline.size() > 2) {
        in_plan_ = shape_in_plan(c, outline, upright_within(c), edge_);
    } else if (is_seen_from_the_side(porous) && porous.x.size() == porous.z.size() && porous.x.size() > 2) {
        from_the_side_ = shape_from_the_side(c, {porous.x, porous.z}, edge_);
    }
    end_at_solids(c);
}

SoftRange PorousZone::upright_within(const Case& c) const {
    double height = c.total_depth();
    for (const double z : c.start.water_z) height = std::max(height, z);
    const double top = top_z_.empty() ? height : *std::min_element(top_z_.begin(), top_z_.end());
    return {std::max(upright_.from, 0.0), std::min(upright_.to, top)};
}

void PorousZone::end_at_solids(const Case& c) {
    if (c.solids.empty() || !from_the_side_.empty()) return;
    const SolidsBehind solids(c);
    const double beyond = a_little_beyond(c);
    const auto within = [](const SoftRange& range, double extent) {
        return SoftRange{std::max(range.from, 0.0), std::min(range.to, extent)};
    };
    const auto all_of = [](const std::vector<double>& corners) {
        const Extent extent(corners);
        return SoftRange{extent.low, extent.high};
    };
    const Outline& outline = in_plan_.outline();
    const SoftRange x = in_plan_.empty() ? within(along_, c.channel.length) : all_of(outline.x);
    const SoftRange y = in_plan_.empty() ? within(across_, c.channel.simulated_width()) : all_of(outline.z);
    const SoftRange z = upright_within(c);
    using Point = std::array<double, 3>;
    const auto end = [&](double& at, bool& hard, double outward, const auto& is_behind) {
        if (std::isfinite(at) && is_behind(at + outward * beyond)) {
            // A particle may touch the face.
            at += outward * c.numerics.spacing;
            hard = true;
        }
    };
    const auto end_both = [&](SoftRange& range, const auto& is_behind) {
        end(range.from, range.hard_from, -1.0, is_behind);
        end(range.to, range.hard_to, 1.0, is_behind);
    };
    end_both(along_, [&](double at) {
        return solids.all(z, y, [&](double up, double across) { return Point{at, across, up}; });
    });
    end_both(upright_, [&](double at) {
        return solids.all(
            x, y,
            [&](double along, double across) {
                return Point{along, across, at};
            },
            [&](const Point& place) { return in_plan_.empty() || in_plan_.holds(place[0], place[1]); });
    });
    if (c.channel.dimensions == 3) {
        end_both(across_, [&](double at) {
            return solids.all(x, z, [&](double along, double up) { return Point{along, at, up}; });
        });
    }
}

double PorousZone::top(double x) const {
    const auto above = std::upper_bound(top_x_.begin(), top_x_.end(), x);
    if (above == top_x_.begin()) return top_z_.front();
    if (above == top_x_.end()) return top_z_.back();
    const auto i = static_cast<std::size_t>(above - top_x_.begin());
    const double part = (x - top_x_[i - 1]) / (top_x_[i] - top_x_[i - 1]);
    return top_z_[i - 1] + part * (top_z_[i] - top_z_[i - 1]);
}

double PorousZone::top_at(double x) const {
    if (!from_the_side_.empty()) {
        const Outline& outline = from_the_side_.outline();
        double highest = -infinity;
        for (std::size_t i = 0; i < outline.size(); ++i) {
            const std::size_t j = outline.next(i);
            const double low = std::min(outline.x[i], outline.x[j]);
            const double high = std::max(outline.x[i], outline.x[j]);
            if (x >= low && x <= high) {
                const double part = high > low ? (x - outline.x[i]) / (outline.x[j] - outline.x[i]) : 0.0;
                highest = std::max(highest, outline.z[i] + part * (outline.z[j] - outline.z[i]));
            }
        }
        return highest;
    }
    if (in_plan_.empty() && !along_.holds(x)) return -infinity;
    return top_x_.empty() ? upright_.to : top(x);
}

double PorousZone::share(double x, double y, double z) const {
    double in_plan = 1.0;
    if (!in_plan_.empty()) {
        in_plan = in_plan_.share(x, y);
    } else {
        in_plan = across_.share(y, edge_);
        if (in_plan <= 0.0) return 0.0;
        if (!from_the_side_.empty()) return in_plan * from_the_side_.share(x, z);
        in_plan *= along_.share(x, edge_);
    }
    if (in_plan <= 0.0) return 0.0;
    SoftRange upright = upright_;
    double edge = edge_;
    if (!top_x_.empty()) {
        upright.to = top(x);
        // The edge is as thick at right angles to an inclined top.
        constexpr double little = 1e-6;
        edge *= std::hypot(1.0, (top(x + little) - top(x - little)) / (2.0 * little));
    }
    return in_plan * upright.share(z, edge);
}

bool PorousZone::holds(double x, double y, double z) const {
    if (!from_the_side_.empty()) return across_.holds(y) && from_the_side_.holds(x, z);
    const bool in_plan = in_plan_.empty() ? across_.holds(y) && along_.holds(x) : in_plan_.holds(x, y);
    return in_plan && z >= upright_.from && z <= (top_x_.empty() ? upright_.to : top(x));
}

std::vector<Outline> porous_cuts_along(const Case& c, const Porous& zone, double y, double top) {
    const double bottom = std::max(zone.z_from.value_or(0.0), 0.0);
    std::vector<Outline> cuts;
    for (const PatchRange& along : stretches_of(c, zone, 0, y)) {
        if (is_seen_from_the_side(zone)) {
            cuts.push_back({zone.x, zone.z});
            continue;
        }
        if (zone.top_x.empty()) {
            const double level = std::min(zone.z_to.value_or(top), top);
            cuts.push_back({{along.from, along.to, along.to, along.from}, {bottom, bottom, level, level}});
            continue;
        }
        const PorousZone shape(c, zone);
        Outline& outline = cuts.emplace_back(Outline{{along.from, along.to}, {bottom, bottom}});
        constexpr int pieces = 200;
        for (int i = pieces; i >= 0; --i) {
            outline.x.push_back(along.from + (along.to - along.from) * i / pieces);
            outline.z.push_back(std::min(shape.top_at(outline.x.back()), top));
        }
    }
    return cuts;
}

std::vector<PorousCut> porous_cuts_across(const Case& c, const Porous& zone, double x, double top) {
    std::vector<PorousCut> cuts;
    if (is_seen_from_the_side(zone)) {
        const PatchRange across = ranges_of(c, zone)[1];
        for (const PatchRange& upright : chords({zone.x, zone.z}, 1, x)) cuts.push_back({across, upright});
        return cuts;
    }
    const PatchRange upright{std::max(zone.z_from.value_or(0.0), 0.0),
                             std::min(PorousZone(c, zone).top_at(x), top)};
    if (upright.to <= upright.from) return cuts;
    for (const PatchRange& across : stretches_of(c, zone, 1, x)) cuts.push_back({across, upright});
    return cuts;
}

Outline plan_of(const Case& c, const Porous& zone) {
    if (!is_seen_from_the_side(zone)) return plan_outline(c, zone);
    const Extent along(zone.x);
    return rectangle_in_plan({along.low, along.high}, ranges_of(c, zone)[1]);
}

PorosityField::PorosityField(const Case& c) {
    for (const Porous& porous : c.porous) {
        zones_.emplace_back(c, porous);
        solid_.push_back(1.0 - porous.porosity);
    }
}

double PorosityField::porosity(double x, double y, double z) const {
    double solid = 0.0;
    for (std::size_t k = 0; k < zones_.size(); ++k) solid += zones_[k].share(x, y, z) * solid_[k];
    return 1.0 - solid;
}

bool covers_length(const Case& c, const Porous& porous) {
    if (is_outlined(porous)) return porous.top_z.empty() && outlines_all(c, porous);
    const SoftRange range = range_of(porous.x_from, porous.x_to, c.channel.length, true);
    const bool level = std::all_of(porous.top_z.begin(), porous.top_z.end(),
                                   [&](double z) { return z == porous.top_z.front(); });
    return porous.x.empty() && level && range.period == 0.0;
}

bool covers_width(const Case& c, const Porous& porous) {
    if (is_outlined(porous)) return outlines_all(c, porous);
    return c.channel.dimensions == 2 ||
           range_of(porous.y_from, porous.y_to, c.channel.simulated_width(), true).period == 0.0;
}

bool porosity_varies_along(const Case& c) {
    return std::any_of(c.porous.begin(), c.porous.end(),
                       [&c](const Porous& porous) { return !covers_length(c, porous); });
}

}  // namespace riffle::inline case_file
