#include "boundary/mesh_contact.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "boundary/wall.hpp"

namespace riffle {

MeshContact::MeshContact(const Case& c, const WallParticles<3>& walls)
    : meshes_(meshes_of(c)), layers_(meshes_->size()), spacing_(c.numerics.spacing) {
    for (std::size_t i = 0; i < walls.size(); ++i) {
        if (!is_solid(walls, i)) {
            continue;
        }
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
                if (found != layers_[solid].end()) {
                    first_layer = std::min(first_layer, found->second);
                }
            }
        }
    }
    const double half = 0.5 * spacing_;
    return std::isfinite(first_layer) ? std::clamp(first_layer - half, 0.0, half) : 0.0;
}

double MeshContact::depth(std::size_t solid, const std::vector<BodyState>& /*bodies*/,
                          const Vec<3>& position) const {
    const SolidMesh& mesh = (*meshes_)[solid];
    if (!mesh.contains(position)) {
        return 0.0;
    }
    const auto foot = mesh.nearest(position);
    return foot ? foot->distance : 0.0;
}

double MeshContact::resolve(const std::vector<BodyState>& /*bodies*/, Vec<3>& position,
                            Vec<3>& velocity) const {
    double furthest = 0.0;
    for (std::size_t solid = 0; meshes_ && solid < meshes_->size(); ++solid) {
        const SolidMesh& mesh = (*meshes_)[solid];
        if (!mesh.contains(position)) {
            continue;
        }
        const auto near = mesh.nearest(position, spacing_);
        if (!near) {
            continue;
        }
        const SolidMesh::Foot& foot = *near;
        Vec<3> place = position;
        for (std::size_t k = 0; k < 3; ++k) {
            place[k] += foot.distance * foot.direction[k];
        }
        const double way = foot.distance - room_at(solid, place);
        if (way <= 0.0) {
            continue;
        }
        double outward = 0.0;
        for (std::size_t k = 0; k < 3; ++k) {
            outward += velocity[k] * foot.direction[k];
        }
        for (std::size_t k = 0; k < 3; ++k) {
            position[k] += (way + 1e-6 * spacing_) * foot.direction[k];
            velocity[k] -= std::min(outward, 0.0) * foot.direction[k];
        }
        furthest = std::max(furthest, way);
    }
    return furthest;
}

}  // namespace riffle
