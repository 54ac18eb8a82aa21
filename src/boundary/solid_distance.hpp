#pragma once

#include <array>
#include <cstddef>
#include <optional>
#include <vector>

#include "boundary/wall_motion.hpp"
#include "case/case.hpp"

namespace riffle::inline boundary {

/// Distance of water from the surfaces of the solids of a case, up to a limit: from grids that are laid
/// around each solid once, and move with it.
template <int D>
class SolidDistance {
  public:
    SolidDistance() = default;
    /// `limit`, m: up to where distances are known.
    SolidDistance(const Case& c, double limit);

    [[nodiscard]] bool empty() const { return grids_.empty(); }
    [[nodiscard]] std::size_t bytes() const {
        std::size_t sum = 0;
        for (const Grid& grid : grids_) sum += grid.distance.capacity() * sizeof(double);
        return sum;
    }
    /// Distance from the nearest surface, m; 0 inside of a solid, the limit or more beyond it. `now`: the
    /// bodies, WallMotion::at(); empty where none moves.
    [[nodiscard]] double at(const std::vector<BodyState>& now, const Vec<D>& position) const;
    /// So from the surface of one solid; the limit where what is nearest of it stands in another one.
    [[nodiscard]] double from(std::size_t solid, const std::vector<BodyState>& now,
                              const Vec<D>& position) const;

  private:
    struct Grid {
        Vec<D> lower{};
        std::array<std::size_t, static_cast<std::size_t>(D)> count{};  ///< of its points
        std::vector<double> distance;
    };
    /// The place at t = 0 of a point beside a solid that turns.
    [[nodiscard]] Vec<D> turned_back(const BodyState& body, Vec<D> position) const;
    [[nodiscard]] double in_grid(const Grid& grid, const Vec<D>& place) const;

    double limit_ = 0.0;
    double step_ = 0.0;
    std::array<double, static_cast<std::size_t>(D)> period_{};  ///< 0: none
    std::vector<Grid> grids_;
};

}  // namespace riffle::inline boundary
