#include "boundary/solid_surface.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "boundary/solid_fill.hpp"

namespace riffle {

namespace {

/// The place of edge i that is nearest to a point.
Vec<3> nearest_on_edge(const Outline& outline, std::size_t i, const Vec<3>& place) {
    const std::size_t j = outline.next(i);
    const double dx = outline.x[j] - outline.x[i];
    const double dz = outline.z[j] - outline.z[i];
    const double along = (place[0] - outline.x[i]) * dx + (place[2] - outline.z[i]) * dz;
    const double share = std::clamp(along / (dx * dx + dz * dz), 0.0, 1.0);
    return {outline.x[i] + share * dx, 0.0, outline.z[i] + share * dz};
}

SolidSurfaces::Foot foot_on_outline(const Outline& outline, const Vec<3>& place) {
    SolidSurfaces::Foot foot{.distance = std::numeric_limits<double>::infinity()};
    std::size_t edge = 0;
    for (std::size_t i = 0; i < outline.size(); ++i) {
        const Vec<3> on_edge = nearest_on_edge(outline, i, place);
        const double distance = std::hypot(place[0] - on_edge[0], place[2] - on_edge[2]);
        if (distance < foot.distance) {
            foot = {.place = on_edge, .distance = distance};
            edge = i;
        }
    }
    const double side = contains(outline, place[0], place[2]) ? -1.0 : 1.0;
    if (foot.distance > 0.0) {
        foot.normal = {side * (place[0] - foot.place[0]) / foot.distance, 0.0,
                       side * (place[2] - foot.place[2]) / foot.distance};
    } else {
        // outline_of() has the solid on the left of its edges.
        const std::size_t end = outline.next(edge);
        const double dx = outline.x[end] - outline.x[edge];
        const double dz = outline.z[end] - outline.z[edge];
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
            for (std::size_t k = 0; k < 3; ++k) {
                middle_.back()[k] = 0.5 * (mesh.lower()[k] + mesh.upper()[k]);
            }
        }
    }
}

Vec<3> SolidSurfaces::image_near(const Vec<3>& other, Vec<3> place) const {
    for (std::size_t k = 0; k < 3; ++k) {
        if (period_[k] > 0.0) {
            place[k] -= period_[k] * std::round((place[k] - other[k]) / period_[k]);
        }
    }
    return place;
}

std::optional<SolidSurfaces::Foot> SolidSurfaces::inside(std::size_t solid, const Vec<3>& place) const {
    const Vec<3> beside = image_near(middle_[solid], place);
    const bool contained = meshes_ == nullptr ? contains(outlines_[solid], beside[0], beside[2])
                                              : (*meshes_)[solid].contains(beside);
    return contained ? nearest(solid, beside, std::numeric_limits<double>::infinity()) : std::nullopt;
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
    if (!near) {
        return std::nullopt;
    }
    const bool inside = mesh.contains(beside);
    Foot foot{.distance = inside ? -near->distance : near->distance};
    for (std::size_t k = 0; k < 3; ++k) {
        foot.place[k] = beside[k] + near->distance * near->direction[k];
        // Of a place on the surface the direction is its normal.
        foot.normal[k] = inside || near->distance == 0.0 ? near->direction[k] : -near->direction[k];
    }
    return foot;
}

}  // namespace riffle
