#include "boundary/solid_surface.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "boundary/solid_fill.hpp"

namespace riffle::inline boundary {

namespace {

SolidSurfaces::Foot foot_on_outline(const Outline& outline, const Vec<3>& place) {
    const OutlinePlace near = nearest_on_outline(outline, place[0], place[2]);
    SolidSurfaces::Foot foot{.place = {near.x, 0.0, near.z}, .distance = near.distance};
    const double side = contains(outline, place[0], place[2]) ? -1.0 : 1.0;
    if (foot.distance > 0.0) {
        foot.normal = {side * (place[0] - foot.place[0]) / foot.distance, 0.0,
                       side * (place[2] - foot.place[2]) / foot.distance};
    } else {
        // outline_of() has the solid on the left of its edges.
        const std::size_t end = outline.next(near.edge);
        const double dx = outline.x[end] - outline.x[near.edge];
        const double dz = outline.z[end] - outline.z[near.edge];
        foot.normal = {dz / std::hypot(dx, dz), 0.0, -dx / std::hypot(dx, dz)};
    }
    foot.distance *= side;
    return foot;
}

}  // namespace

SolidSurfaces::SolidSurfaces(const Case& c) {
    period_[0] = c.channel.ends == Ends::periodic ? c.channel.length : 0.0;
    if (c.channel.dimensions == 2) {
        for (const Solid& solid : c.solids) {
            outlines_.push_back(outline_of(solid));
            const auto [left, right] = std::minmax_element(solid.x.begin(), solid.x.end());
            const auto [low, high] = std::minmax_element(solid.z.begin(), solid.z.end());
            middle_.push_back({0.5 * (*left + *right), 0.0, 0.5 * (*low + *high)});
        }
    } else if (!c.solids.empty()) {
        period_[1] = c.channel.sides == Sides::periodic ? c.channel.simulated_width() : 0.0;
        meshes_ = meshes_of(c);
        for (const SolidMesh& mesh : *meshes_) {
            middle_.emplace_back();
            for (std::size_t k = 0; k < 3; ++k) middle_.back()[k] = 0.5 * (mesh.lower()[k] + mesh.upper()[k]);
        }
    }
}

Vec<3> SolidSurfaces::image_near(const Vec<3>& other, Vec<3> place) const {
    for (std::size_t k = 0; k < 3; ++k) place[k] = riffle::image_near(other[k], place[k], period_[k]);
    return place;
}

bool SolidSurfaces::contains(std::size_t solid, const Vec<3>& place) const {
    const Vec<3> beside = image_near(middle_[solid], place);
    return meshes_ == nullptr ? riffle::contains(outlines_[solid], beside[0], beside[2])
                              : (*meshes_)[solid].contains(beside);
}

std::optional<SolidSurfaces::Foot> SolidSurfaces::inside(std::size_t solid, const Vec<3>& place) const {
    return contains(solid, place) ? nearest(solid, place, std::numeric_limits<double>::infinity())
                                  : std::nullopt;
}

std::optional<SolidSurfaces::Foot> SolidSurfaces::nearest(std::size_t solid, const Vec<3>& place,
                                                          double limit) const {
    const Vec<3> beside = image_near(middle_[solid], place);
    if (meshes_ == nullptr) {
        const Foot foot = foot_on_outline(outlines_[solid], beside);
        return std::abs(foot.distance) <= limit ? std::optional(foot) : std::nullopt;
    }
    const SolidMesh& mesh = (*meshes_)[solid];
    const auto near = mesh.nearest(beside, limit);
    if (!near) return std::nullopt;
    const bool inside = mesh.contains(beside);
    Foot foot{.distance = inside ? -near->distance : near->distance};
    for (std::size_t k = 0; k < 3; ++k) {
        foot.place[k] = beside[k] + near->distance * near->direction[k];
        // Of a place on the surface the direction is its normal.
        foot.normal[k] = inside || near->distance == 0.0 ? near->direction[k] : -near->direction[k];
    }
    return foot;
}

}  // namespace riffle::inline boundary
