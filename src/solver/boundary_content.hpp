#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "boundary/wall_motion.hpp"
#include "case/case.hpp"
#include "output/dataset.hpp"

namespace riffle::inline solver {

/// What bounds the water of a case, for the results file: the particles of walls and solids, the surfaces of
/// the solids, the spheres of the bed (docs/results-format.md).
class BoundaryContent {
  public:
    explicit BoundaryContent(const Case& c);

    /// The group /boundaries: what there is, where it stands at t = 0.
    void add(Content& content) const;

    /// Where walls and solids stand at a time, into the group of a snapshot; nothing where no solid moves.
    /// `free`: the free bodies then. Gives the bytes added.
    std::size_t add_moved(Content& content, const std::string& snapshot, double time,
                          std::span<const FreeBodyState> free = {}) const;

    [[nodiscard]] bool moves() const { return motion_.displaces(); }
    [[nodiscard]] std::size_t walls() const { return wall_.size() / 3; }
    [[nodiscard]] std::size_t vertices() const { return vertex_.size() / 3; }
    /// Corners of the outline of each solid in two dimensions, one after the other in `vertices`.
    [[nodiscard]] const std::vector<std::size_t>& corners() const { return corners_; }
    [[nodiscard]] std::size_t triangles() const { return triangle_.size() / 3; }
    [[nodiscard]] std::size_t spheres() const { return sphere_.size() / 3; }

  private:
    /// Points displaced by the bodies they belong to.
    [[nodiscard]] std::vector<float> displaced(const std::vector<float>& points,
                                               const std::vector<std::int32_t>& bodies,
                                               const std::vector<BodyState>& states) const;

    WallMotion motion_;
    double period_ = 0.0;                                ///< of periodic ends, m; 0: none
    double width_ = 0.0;                                 ///< of periodic sides, m; 0: none
    std::vector<float> wall_, vertex_, sphere_;          ///< x, y, z of each point, m
    std::vector<std::int32_t> wall_body_, vertex_body_;  ///< by point (boundary/wall_motion.hpp)
    std::vector<std::int32_t> triangle_;                 ///< vertices of each, three dimensions
    std::vector<std::size_t> corners_;
    std::string names_;  ///< of the solids, a line each
    double sphere_diameter_ = 0.0;
};

}  // namespace riffle::inline solver
