#include "case/porous_zone.hpp"

#include <algorithm>
#include <cmath>
#include <memory>

#include "case/outline_check.hpp"
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

}  // namespace

double share_within(double distance, double edge) {
    const double t = std::clamp(distance / edge + 0.5, 0.0, 1.0);
    return t * t * (3.0 - 2.0 * t);
}

double SoftRange::share(double place, double edge) const {
    const auto passed = [&](double end, bool hard) {
        if (hard || std::isinf(end)) return place >= end ? 1.0 : 0.0;
        return share_within(place - end, edge);
    };
    const auto once = [&](double shift) {
        return passed(from + shift, hard_from) - passed(to + shift, hard_to);
    };
    return period > 0.0 ? once(0.0) + once(-period) + once(period) : once(0.0);
}

bool SoftRange::holds(double place) const {
    const double inside = period > 0.0 ? place - period * std::floor(place / period) : place;
    return inside >= from && inside <= to;
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
    /// Whether holds(place) for places evenly over two stretches.
    template <class MakePlace>
    [[nodiscard]] bool all(const SoftRange& first, const SoftRange& second, const MakePlace& place) const {
        constexpr int most = 9;
        const int across = space_ ? most : 1;
        for (int i = 0; i < most; ++i) {
            for (int j = 0; j < across; ++j) {
                const auto p = place(first.from + (i + 0.5) / most * (first.to - first.from),
                                     second.from + (j + 0.5) / across * (second.to - second.from));
                if (!holds(p[0], p[1], p[2])) return false;
            }
        }
        return true;
    }

  private:
    const Case& c_;
    bool space_;
    std::shared_ptr<const std::vector<SolidMesh>> meshes_;
};

double porous_edge(const Case& c, const Porous& porous) {
    // sigma = 0.527 h along an axis of Wendland's C2 kernel; that of a smooth step is its thickness/sqrt(20).
    constexpr double smoothing_lengths = 2.4;
    return porous.edge.value_or(smoothing_lengths * c.numerics.smoothing_ratio * c.numerics.spacing);
}

PorousZone::PorousZone(const Case& c, const Porous& porous)
    : edge_(porous_edge(c, porous)),
      along_(range_of(porous.x_from, porous.x_to, c.channel.length, c.channel.ends == Ends::periodic)),
      across_(range_of(porous.y_from, porous.y_to, c.channel.simulated_width(),
                       c.channel.dimensions == 3 && c.channel.sides == Sides::periodic)),
      outline_{porous.x, porous.z},
      top_x_(porous.top_x),
      top_z_(porous.top_z),
      length_(c.channel.ends == Ends::periodic ? c.channel.length : 0.0) {
    const double rounding = 1e-9 * c.channel.length;
    const bool box = c.channel.top == Top::periodic;
    if (porous.z_from && (*porous.z_from > rounding || box)) upright_.from = *porous.z_from;
    const bool below_lid = c.channel.top != Top::free_surface && !box;
    if (porous.z_to && !(below_lid && *porous.z_to >= c.total_depth() - rounding)) upright_.to = *porous.z_to;
    end_at_solids(c);
    const SolidsBehind solids(c);
    const double turn = outline_.size() > 0 && signed_area(outline_) < 0.0 ? -1.0 : 1.0;
    for (std::size_t i = 0; i < outline_.size(); ++i) {
        const std::size_t j = outline_.next(i);
        const auto both = [&](const std::vector<double>& values, auto beyond) {
            return beyond(values[i]) && beyond(values[j]);
        };
        const bool at_bound = both(outline_.x, [&](double x) { return x <= rounding; }) ||
                              both(outline_.x, [&](double x) { return x >= c.channel.length - rounding; }) ||
                              both(outline_.z, [&](double z) { return z <= rounding; });
        // A little beyond the edge, to the right of one that goes against the clock.
        const double along_x = outline_.x[j] - outline_.x[i];
        const double along_z = outline_.z[j] - outline_.z[i];
        const double out = turn * 0.1 * c.numerics.spacing / std::hypot(along_x, along_z);
        const SoftRange edge{0.0, 1.0};
        const bool at_solid =
            !c.solids.empty() && c.channel.dimensions == 2 && solids.all(edge, edge, [&](double t, double) {
                return std::array{outline_.x[i] + t * along_x + out * along_z, 0.0,
                                  outline_.z[i] + t * along_z - out * along_x};
            });
        inner_edge_.push_back(!at_bound && !at_solid);
    }
}

void PorousZone::end_at_solids(const Case& c) {
    if (c.solids.empty() || outline_.size() > 0) return;
    const SolidsBehind solids(c);
    const double beyond = 0.1 * c.numerics.spacing;
    const auto within = [](const SoftRange& range, double extent) {
        return SoftRange{std::max(range.from, 0.0), std::min(range.to, extent)};
    };
    double height = c.total_depth();
    for (const double z : c.start.water_z) height = std::max(height, z);
    const SoftRange x = within(along_, c.channel.length);
    const SoftRange y = within(across_, c.channel.simulated_width());
    const SoftRange z =
        within(upright_, top_z_.empty() ? height : *std::min_element(top_z_.begin(), top_z_.end()));
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
        return solids.all(x, y, [&](double along, double across) { return Point{along, across, at}; });
    });
    if (c.channel.dimensions == 3) {
        end_both(across_, [&](double at) {
            return solids.all(x, z, [&](double along, double up) { return Point{along, at, up}; });
        });
    }
}

double PorousZone::within_outline(double x, double z) const {
    double distance = infinity;
    for (std::size_t i = 0; i < outline_.size(); ++i) {
        if (inner_edge_[i]) distance = std::min(distance, distance_from_edge(outline_, i, x, z));
    }
    return contains(outline_, x, z) ? distance : -distance;
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
    if (outline_.size() > 0) {
        double highest = -infinity;
        for (std::size_t i = 0; i < outline_.size(); ++i) {
            const std::size_t j = outline_.next(i);
            const double low = std::min(outline_.x[i], outline_.x[j]);
            const double high = std::max(outline_.x[i], outline_.x[j]);
            if (x >= low && x <= high) {
                const double part = high > low ? (x - outline_.x[i]) / (outline_.x[j] - outline_.x[i]) : 0.0;
                highest = std::max(highest, outline_.z[i] + part * (outline_.z[j] - outline_.z[i]));
            }
        }
        return highest;
    }
    if (!along_.holds(x)) return -infinity;
    return top_x_.empty() ? upright_.to : top(x);
}

double PorousZone::share(double x, double y, double z) const {
    const double beside = across_.share(y, edge_);
    if (beside <= 0.0) return 0.0;
    if (outline_.size() > 0) {
        double within = share_within(within_outline(x, z), edge_);
        if (length_ > 0.0) {
            within += share_within(within_outline(x - length_, z), edge_) +
                      share_within(within_outline(x + length_, z), edge_);
        }
        return beside * std::min(within, 1.0);
    }
    const double along = along_.share(x, edge_);
    if (along <= 0.0) return 0.0;
    SoftRange upright = upright_;
    double edge = edge_;
    if (!top_x_.empty()) {
        upright.to = top(x);
        // The edge is as thick at right angles to an inclined top.
        constexpr double little = 1e-6;
        edge *= std::hypot(1.0, (top(x + little) - top(x - little)) / (2.0 * little));
    }
    return beside * along * upright.share(z, edge);
}

bool PorousZone::holds(double x, double y, double z) const {
    if (!across_.holds(y)) return false;
    if (outline_.size() > 0) {
        return at_any_image(x, length_, [&](double at) { return contains(outline_, at, z); });
    }
    return along_.holds(x) && z >= upright_.from && z <= (top_x_.empty() ? upright_.to : top(x));
}

Outline porous_outline(const Case& c, const Porous& zone, double top) {
    if (!zone.x.empty()) {
        return {zone.x, zone.z};
    }
    const double begin = zone.x_from.value_or(0.0);
    const double end = zone.x_to.value_or(c.channel.length);
    const double bottom = std::max(zone.z_from.value_or(0.0), 0.0);
    if (zone.top_x.empty()) {
        const double level = std::min(zone.z_to.value_or(top), top);
        return {{begin, end, end, begin}, {bottom, bottom, level, level}};
    }
    const PorousZone shape(c, zone);
    Outline outline{{begin, end}, {bottom, bottom}};
    constexpr int pieces = 200;
    for (int i = pieces; i >= 0; --i) {
        outline.x.push_back(begin + (end - begin) * i / pieces);
        outline.z.push_back(std::min(shape.top_at(outline.x.back()), top));
    }
    return outline;
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

bool is_cut_at(const Case& c, const Porous& zone, double y) {
    return c.channel.dimensions == 2 || (y >= zone.y_from.value_or(y) && y <= zone.y_to.value_or(y));
}

bool covers_length(const Case& c, const Porous& porous) {
    const SoftRange range = range_of(porous.x_from, porous.x_to, c.channel.length, true);
    const bool level = std::all_of(porous.top_z.begin(), porous.top_z.end(),
                                   [&](double z) { return z == porous.top_z.front(); });
    return porous.x.empty() && level && range.period == 0.0;
}

bool covers_width(const Case& c, const Porous& porous) {
    return c.channel.dimensions == 2 ||
           range_of(porous.y_from, porous.y_to, c.channel.simulated_width(), true).period == 0.0;
}

bool porosity_varies_along(const Case& c) {
    return std::any_of(c.porous.begin(), c.porous.end(),
                       [&c](const Porous& porous) { return !covers_length(c, porous); });
}

}  // namespace riffle::inline case_file
