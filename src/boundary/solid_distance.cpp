#include "boundary/solid_distance.hpp"

#include <algorithm>
#include <cmath>

#include "case/outline.hpp"
#include "case/solid_mesh.hpp"

namespace riffle {

namespace {

/// Bounds of a solid, and the distance of a place from its surface, 0 inside.
template <int D, class Distance>
void measure(const Vec<D>& lower, const std::array<std::size_t, static_cast<std::size_t>(D)>& count,
             double step, std::vector<double>& values, const Distance& distance) {
    std::size_t points = 1;
    for (const std::size_t n : count) {
        points *= n;
    }
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

}  // namespace

template <int D>
SolidDistance<D>::SolidDistance(const Case& c, double limit) : limit_(limit), step_(c.numerics.spacing) {
    if (c.channel.ends == Ends::periodic) {
        period_[0] = c.channel.length;
    }
    if (D == 3 && c.channel.sides == Sides::periodic) {
        period_[1] = c.channel.width;
    }
    const auto meshes = D == 3 && !c.solids.empty() ? meshes_of(c) : nullptr;
    for (std::size_t k = 0; k < c.solids.size(); ++k) {
        const Solid& solid = c.solids[k];
        Vec<D> high{};
        Grid grid;
        if constexpr (D == 2) {
            grid.lower = {*std::min_element(solid.x.begin(), solid.x.end()),
                          *std::min_element(solid.z.begin(), solid.z.end())};
            high = {*std::max_element(solid.x.begin(), solid.x.end()),
                    *std::max_element(solid.z.begin(), solid.z.end())};
        } else {
            grid.lower = (*meshes)[k].lower();
            high = (*meshes)[k].upper();
        }
        for (std::size_t axis = 0; axis < D; ++axis) {
            grid.lower[axis] -= limit;
            grid.count[axis] = 2 + static_cast<std::size_t>((high[axis] + limit - grid.lower[axis]) / step_);
        }
        measure<D>(grid.lower, grid.count, step_, grid.distance, [&](const Vec<D>& place) {
            if constexpr (D == 2) {
                const Outline outline{solid.x, solid.z};
                return contains(outline, place[0], place[1])
                           ? 0.0
                           : distance_from_outline(outline, place[0], place[1]);
            } else {
                const SolidMesh& mesh = (*meshes)[k];
                const auto foot = mesh.nearest(place, limit);
                return mesh.contains(place) ? 0.0 : (foot ? foot->distance : limit);
            }
        });
        grids_.push_back(std::move(grid));
    }
}

template <int D>
double SolidDistance<D>::at(const std::vector<BodyState>& now, const Vec<D>& position) const {
    double nearest = limit_;
    for (std::size_t k = 0; k < grids_.size(); ++k) {
        nearest = std::min(nearest, from(k, now, position));
    }
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
        if (!(steps >= 0.0 && steps < static_cast<double>(grid.count[k] - 1))) {
            return limit_;
        }
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

}  // namespace riffle
