#pragma once

#include <array>
#include <cstddef>
#include <vector>

#include "case/case.hpp"

namespace riffle::inline roughness {

/// Heights at which the stems of a patch stand (case/stem_feet.hpp), looked up once at places a spacing apart
/// over the patch, linear between them.
class StemGround {
  public:
    StemGround(const Case& c, const Vegetation& stems);

    /// Height at a place in plan, m; 0 everywhere where the stems stand on the bed. Outside of the patch that
    /// of its edge.
    [[nodiscard]] double at(double x, double y) const {
        if (height_.empty()) return 0.0;
        const Place along = place(x, 0);
        const Place across = place(y, 1);
        const auto on_line = [&](std::size_t line) {
            const double* const values = &height_[line * axes_[0].count];
            return values[along.cell] + along.share * (values[along.next] - values[along.cell]);
        };
        const double here = on_line(across.cell);
        return here + across.share * (on_line(across.next) - here);
    }

  private:
    struct Axis {
        double from = 0.0;
        double step = 1.0;
        std::size_t count = 1;
    };
    struct Place {
        std::size_t cell = 0;
        std::size_t next = 0;
        double share = 0.0;
    };
    [[nodiscard]] Place place(double at, std::size_t axis) const;

    std::array<Axis, 2> axes_{};
    std::vector<double> height_;  ///< [across, along], m
};

}  // namespace riffle::inline roughness
