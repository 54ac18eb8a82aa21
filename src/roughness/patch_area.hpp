#pragma once

#include <array>
#include <optional>
#include <vector>

#include "case/case.hpp"
#include "case/patch_range.hpp"

namespace riffle::inline roughness {

/// A stretch along an axis, m.
struct PatchStretch {
    double from = 0.0;
    double to = 0.0;
    double period = 0.0;  ///< of the axis; 0: none
    bool all = true;      ///< the whole axis, whatever the place

    /// Share of a width around a place that lies in the stretch.
    [[nodiscard]] double share(double place, double width) const;
};

/// An outline in plan, of which the particles' shares are asked for.
class OutlinedArea {
  public:
    /// `width`: of the particles, m; `periods`: length and width of a channel that goes round, 0 of one that
    /// does not.
    OutlinedArea(Outline outline, double width, const std::array<double, 2>& periods);

    /// The share of the square of the particles' width around a place that lies within.
    [[nodiscard]] double share(double x, double y) const;

  private:
    /// Of the outline alone, not of its images beyond periodic ends and sides.
    [[nodiscard]] double own_share(double x, double y) const;

    Outline outline_;
    double width_;
    std::array<double, 2> periods_;
    std::array<PatchRange, 2> range_{};  ///< that the squares may reach over, m
    std::array<int, 2> cells_{};
    enum class Cell { outside, within, cut };
    std::vector<Cell> kind_;  ///< [across, along], of squares of a width
};

/// Where a patch lies in plan.
class PatchArea {
  public:
    /// Of a patch of the bed or of vegetation.
    template <class Patch>
    PatchArea(const Case& c, const Patch& patch)
        : along_(stretch(covers_length(c, patch), patch.x_from, patch.x_to, c.channel.length,
                         c.channel.ends == Ends::periodic)),
          across_(stretch(covers_width(c, patch), patch.y_from, patch.y_to, c.channel.width,
                          c.channel.sides == Sides::periodic)) {
        if (is_outlined(patch)) {
            outlined_.emplace(plan_outline(c, patch), c.numerics.spacing,
                              std::array{c.channel.ends == Ends::periodic ? c.channel.length : 0.0,
                                         c.channel.sides == Sides::periodic ? c.channel.width : 0.0});
        }
    }

    /// Share of a particle of a width (m), the spacing, around a place that stands in the patch.
    [[nodiscard]] double share(double x, double y, double width) const {
        if (outlined_) return outlined_->share(x, y);
        return along_.share(x, width) * across_.share(y, width);
    }
    [[nodiscard]] const PatchStretch& across() const { return across_; }

  private:
    static PatchStretch stretch(bool all, std::optional<double> from, std::optional<double> to, double extent,
                                bool periodic) {
        return {from.value_or(0.0), to.value_or(extent), periodic ? extent : 0.0, all};
    }

    PatchStretch along_;
    PatchStretch across_;
    std::optional<OutlinedArea> outlined_;  ///< in place of both
};

}  // namespace riffle::inline roughness
