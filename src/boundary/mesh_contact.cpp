#include "boundary/mesh_contact.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "boundary/wall.hpp"

namespace riffle::inline boundary {

MeshContact::MeshContact(const Case& c, const WallParticles<3>& walls)
    : meshes_(meshes_of(c)),
      layers_(meshes_->size()),
      spacing_(c.numerics.spacing),
      period_{c.channel.ends == Ends::periodic ? c.channel.length : 0.0,
              c.channel.sides == Sides::periodic ? c.channel.simulated_width() : 0.0, 0.0},
      planes_(boundary_planes<3>(c)) {
    for (const Solid& solid : c.solids) moves_.push_back(!solid.rests());
    if (walls_end_at_surface(c)) return;
    for (std::size_t i = 0; i < walls.size(); ++i) {
        if (!is_solid(walls, i)) continue;
        const Vec<3> place{walls.position[0][i], walls.position[1][i], walls.position[2][i]};
        auto& layer = layers_[static_cast<std::size_t>(walls.body[i] - first_solid)];
        const auto [cell, added] = layer.try_emplace(cell_of(place, {}), walls.depth[i]);
        cell->second = std::min(cell->second, walls.depth[i]);
    }
}

std::int64_t MeshContact::cell_of(const Vec<3>& place, const std::array<int, 3>& beside) const {
    constexpr std::int64_t most = std::int64_t{1} << 20U;  // cells on either side of the origin
    std::int64_t cell = 0;
    for (std::size_t k = 0; k < 3; ++k) {
        cell =
            2 * most * cell + static_cast<std::int64_t>(std::floor(place[k] / spacing_)) + beside[k] + most;
    }
    return cell;
}

double MeshContact::room_at(std::size_t solid, const Vec<3>& place) const {
    double first_layer = std::numeric_limits<double>::infinity();
    for (int i = -1; i <= 1; ++i) {
        for (int j = -1; j <= 1; ++j) {
            for (int k = -1; k <= 1; ++k) {
                const auto found = layers_[solid].find(cell_of(place, {i, j, k}));
                if (found != layers_[solid].end()) first_layer = std::min(first_layer, found->second);
            }
        }
    }
    const double half = 0.5 * spacing_;
    if (!std::isfinite(first_layer)) return 0.0;
    return std::clamp(first_layer - half, moves_[solid] ? -half : 0.0, half);
}

Vec<3> MeshContact::in_body(std::size_t solid, const BodyState& state, Vec<3> position) const {
    if (state.turns) {
        for (std::size_t k = 0; k < 3; ++k) {
            position[k] = image_near(state.centre[k] + state.displacement[k], position[k], period_[k]);
        }
        return state.place_at_start(position);
    }
    const Point3& lower = (*meshes_)[solid].lower();
    const Point3& upper = (*meshes_)[solid].upper();
    for (std::size_t k = 0; k < 3; ++k) {
        position[k] -= state.displacement[k];
        if (state.displacement[k] != 0.0) {
            position[k] = image_near(0.5 * (lower[k] + upper[k]), position[k], period_[k]);
        }
    }
    return position;
}

double MeshContact::depth(std::size_t solid, const std::vector<BodyState>& now,
                          const Vec<3>& position) const {
    const SolidMesh& mesh = (*meshes_)[solid];
    const Vec<3> place = in_body(solid, now[first_solid + solid], position);
    if (!mesh.contains(place)) return 0.0;
    const auto foot = mesh.nearest(place);
    return foot ? foot->distance : 0.0;
}

double MeshContact::resolve(const std::vector<BodyState>& now, Vec<3>& position, Vec<3>& velocity,
                            const Push& push) const {
    double furthest = 0.0;
    for (std::size_t solid = 0; meshes_ && solid < meshes_->size(); ++solid) {
        const SolidMesh& mesh = (*meshes_)[solid];
        const BodyState& state = now[first_solid + solid];
        // Water that has been pressed into a wall must not slip along it under a solid that stands there: it
        // leaves by the faces that water can touch alone.
        const double hair = 1e-3 * spacing_;
        Vec<3> before = position;
        for (const BoundaryPlane& plane : planes_) {
            before[plane.axis] += plane.inward * std::max(0.0, hair - plane.distance<3>(before));
        }
        Vec<3> place = in_body(solid, state, before);
        const bool inside = mesh.contains(place);
        if (!inside && !moves_[solid]) continue;
        const auto near = mesh.nearest(place, spacing_, [&](const Vec<3>& foot) {
            const Vec<3> from = state.turned(place);
            const Vec<3> to = state.turned(foot);
            Vec<3> now_at{};
            for (std::size_t k = 0; k < 3; ++k) now_at[k] = before[k] + to[k] - from[k];
            return std::all_of(planes_.begin(), planes_.end(), [&](const BoundaryPlane& plane) {
                return plane.distance<3>(now_at) > 0.5 * hair;
            });
        });
        if (!near) continue;
        SolidMesh::Foot foot = *near;
        for (std::size_t k = 0; k < 3; ++k) {
            place[k] += foot.distance * foot.direction[k];
            foot.direction[k] *= inside ? 1.0 : -1.0;
        }
        const double way = (inside ? foot.distance : -foot.distance) - room_at(solid, place);
        if (way <= 0.0) continue;
        foot.direction = state.turned(foot.direction);
        const Vec<3> at = state.placed(place);
        const Vec<3> solid_velocity = state.velocity_at(at);
        double outward = 0.0;
        for (std::size_t k = 0; k < 3; ++k) outward += (velocity[k] - solid_velocity[k]) * foot.direction[k];
        for (std::size_t k = 0; k < 3; ++k) {
            position[k] += (way + 1e-6 * spacing_) * foot.direction[k];
            velocity[k] -= std::min(outward, 0.0) * foot.direction[k];
        }
        if (push) {
            const double gain = -std::min(outward, 0.0);
            push(solid, at, {gain * foot.direction[0], gain * foot.direction[1], gain * foot.direction[2]});
        }
        furthest = std::max(furthest, way);
    }
    return furthest;
}

}  // namespace riffle::inline boundary
