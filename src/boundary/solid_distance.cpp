#include "boundary/solid_distance.hpp"

#include <algorithm>
#include <cmath>
#include <memory>

#include "case/outline.hpp"
#include "case/solid_mesh.hpp"

namespace riffle::inline boundary {

namespace {

/// Bounds of a solid, and the distance of a place from its surface, 0 inside.
template <int D, class Distance>
void measure(const Vec<D>& lower, const std::array<std::size_t, static_cast<std::size_t>(D)>& count,
             double step, std::vector<double>& values, const Distance& distance) {
    std::size_t points = 1;
    for (const std::size_t n : count) points *= n;
    for (std::size_t i = 0; i < points; ++i) {
        Vec<D> place{};
        std::size_t rest = i;
        for (std::size_t k = 0; k < D; ++k) {
            place[k] = lower[k] + step * static_cast<double>(rest % count[k]);
            rest /= count[k];
        }
        values.push_back(distance(place));
    }
}

/// The solids of a case as shapes.
template <int D>
class Shapes {
  public:
    explicit Shapes(const Case& c) : c_(c), meshes_(D == 3 && !c.solids.empty() ? meshes_of(c) : nullptr) {
        for (const Solid& solid : c.solids) {
            outlines_.push_back({solid.x, solid.z});
        }
    }

    [[nodiscard]] Vec<D> lower(std::size_t k) const {
        if constexpr (D == 2) {
            const Outline& outline = outlines_[k];
            return {*std::min_element(outline.x.begin(), outline.x.end()),
                    *std::min_element(outline.z.begin(), outline.z.end())};
        } else {
            return (*meshes_)[k].lower();
        }
    }
    [[nodiscard]] Vec<D> upper(std::size_t k) const {
        if constexpr (D == 2) {
            const Outline& outline = outlines_[k];
            return {*std::max_element(outline.x.begin(), outline.x.end()),
                    *std::max_element(outline.z.begin(), outline.z.end())};
        } else {
            return (*meshes_)[k].upper();
        }
    }

    /// Distance of a place from the surface of solid k, 0 inside; `limit` at least beyond it, and where what
    /// is nearest stands in another solid: of solids at rest that overlap no water touches that.
    [[nodiscard]] double distance(std::size_t k, const Vec<D>& place, double limit) const {
        if (contains(k, place)) return 0.0;
        Vec<D> way{};
        double distance = limit;
        if constexpr (D == 2) {
            const OutlinePlace foot = nearest_on_outline(outlines_[k], place[0], place[1]);
            distance = foot.distance;
            way = {foot.x - place[0], foot.z - place[1]};
        } else if (const auto foot = (*meshes_)[k].nearest(place, limit)) {
            distance = foot->distance;
            way = foot->direction;
            for (double& component : way) component *= distance;
        }
        if (distance >= limit || !rests(k)) return distance;
        // Just before the surface, so that solids which only touch are beside each other.
        const double share = std::max(0.0, 1.0 - 1e-3 * c_.numerics.spacing / distance);
        Vec<D> before = place;
        for (std::size_t axis = 0; axis < D; ++axis) before[axis] += share * way[axis];
        for (std::size_t other = 0; other < outlines_.size(); ++other) {
            if (other != k && rests(other) && contains(other, before) && !contains(other, place)) {
                return limit;
            }
        }
        return distance;
    }

  private:
    [[nodiscard]] bool rests(std::size_t k) const { return c_.solids[k].rests(); }
    [[nodiscard]] bool contains(std::size_t k, const Vec<D>& place) const {
        if constexpr (D == 2) {
            return riffle::contains(outlines_[k], place[0], place[1]);
        } else {
            return (*meshes_)[k].contains(place);
        }
    }

    const Case& c_;
    std::vector<Outline> outlines_;  ///< two dimensions
    std::shared_ptr<const std::vector<SolidMesh>> meshes_;
};

}  // namespace

template <int D>
SolidDistance<D>::SolidDistance(const Case& c, double limit) : limit_(limit), step_(c.numerics.spacing) {
    if (c.channel.ends == Ends::periodic) period_[0] = c.channel.length;
    if (D == 3 && c.channel.sides == Sides::periodic) period_[1] = c.channel.width;
    const Shapes<D> shapes(c);
    for (std::size_t k = 0; k < c.solids.size(); ++k) {
        const Vec<D> high = shapes.upper(k);
        Grid grid;
        grid.lower = shapes.lower(k);
        for (std::size_t axis = 0; axis < D; ++axis) {
            grid.lower[axis] -= limit;
            grid.count[axis] = 2 + static_cast<std::size_t>((high[axis] + limit - grid.lower[axis]) / step_);
        }
        measure<D>(grid.lower, grid.count, step_, grid.distance,
                   [&](const Vec<D>& place) { return shapes.distance(k, place, limit); });
        grids_.push_back(std::move(grid));
    }
}

template <int D>
double SolidDistance<D>::at(const std::vector<BodyState>& now, const Vec<D>& position) const {
    double nearest = limit_;
    for (std::size_t k = 0; k < grids_.size(); ++k) nearest = std::min(nearest, from(k, now, position));
    return nearest;
}

template <int D>
double SolidDistance<D>::from(std::size_t solid, const std::vector<BodyState>& now,
                              const Vec<D>& position) const {
    const Grid& grid = grids_[solid];
    const std::size_t body = static_cast<std::size_t>(first_solid) + solid;
    const bool turns = body < now.size() && now[body].turns;
    const Vec<D> moved = body < now.size() && !turns ? in_flow<D>(now[body].displacement) : Vec<D>{};
    Vec<D> place = turns ? turned_back(now[body], position) : position;
    for (std::size_t axis = 0; axis < D; ++axis) {
        place[axis] -= moved[axis];
        const double middle = grid.lower[axis] + 0.5 * step_ * static_cast<double>(grid.count[axis] - 1);
        place[axis] = image_near(middle, place[axis], period_[axis]);
    }
    return in_grid(grid, place);
}

template <int D>
Vec<D> SolidDistance<D>::turned_back(const BodyState& body, Vec<D> position) const {
    const Vec<D> centre = in_flow<D>(body.centre);
    const Vec<D> moved = in_flow<D>(body.displacement);
    for (std::size_t axis = 0; axis < D; ++axis) {
        position[axis] = image_near(centre[axis] + moved[axis], position[axis], period_[axis]);
    }
    return in_flow<D>(body.place_at_start(in_space_of<D>(position)));
}

template <int D>
double SolidDistance<D>::in_grid(const Grid& grid, const Vec<D>& place) const {
    std::size_t low = 0;
    std::array<double, static_cast<std::size_t>(D)> share{};
    std::array<std::size_t, static_cast<std::size_t>(D)> stride{};
    std::size_t points = 1;
    for (std::size_t k = 0; k < D; ++k) {
        const double steps = (place[k] - grid.lower[k]) / step_;
        if (!(steps >= 0.0 && steps < static_cast<double>(grid.count[k] - 1))) return limit_;
        const auto index = static_cast<std::size_t>(steps);
        share[k] = steps - static_cast<double>(index);
        stride[k] = points;
        low += points * index;
        points *= grid.count[k];
    }
    double sum = 0.0;
    for (std::size_t corner = 0; corner < (std::size_t{1} << D); ++corner) {
        double weight = 1.0;
        std::size_t index = low;
        for (std::size_t k = 0; k < D; ++k) {
            const bool upper = (corner >> k & 1U) != 0;
            weight *= upper ? share[k] : 1.0 - share[k];
            index += upper ? stride[k] : 0;
        }
        sum += weight * grid.distance[index];
    }
    return sum;
}

template class SolidDistance<2>;
template class SolidDistance<3>;

}  // namespace riffle::inline boundary
