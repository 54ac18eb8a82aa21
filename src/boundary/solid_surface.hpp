#pragma once

#include <cstddef>
#include <memory>
#include <optional>
#include <vector>

#include "case/case.hpp"
#include "case/outline.hpp"
#include "case/solid_mesh.hpp"
#include "particles/domain.hpp"

namespace riffle::inline boundary {

/// The surfaces of the solids of a case where they stand at t = 0, whatever the number of dimensions: places
/// are (x, y, z), y = 0 in two.
class SolidSurfaces {
  public:
    SolidSurfaces() = default;
    explicit SolidSurfaces(const Case& c);

    /// The nearest place of a surface.
    struct Foot {
        Vec<3> place{};
        Vec<3> normal{};        ///< away from the solid, of length 1
        double distance = 0.0;  ///< m; below zero inside
    };
    /// Of a place beside a solid; where the channel is periodic, of its image nearest to the solid, beside
    /// which the foot then is. Nothing where no surface is nearer than `limit`, m.
    [[nodiscard]] std::optional<Foot> nearest(std::size_t solid, const Vec<3>& place, double limit) const;

    /// The same of a place in a solid; nothing outside of it.
    [[nodiscard]] std::optional<Foot> inside(std::size_t solid, const Vec<3>& place) const;

    /// Whether a place lies in a solid.
    [[nodiscard]] bool contains(std::size_t solid, const Vec<3>& place) const;

    /// The image of a place that is nearest to another one.
    [[nodiscard]] Vec<3> image_near(const Vec<3>& other, Vec<3> place) const;

    [[nodiscard]] std::size_t size() const { return middle_.size(); }

  private:
    std::vector<Outline> outlines_;  ///< two dimensions
    std::shared_ptr<const std::vector<SolidMesh>> meshes_;
    std::vector<Vec<3>> middle_;  ///< of the box around each solid
    Vec<3> period_{};             ///< along x, y, z, m; 0: none
};

}  // namespace riffle::inline boundary
