#pragma once

#include <optional>

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

/// Where a patch lies in plan.
class PatchArea {
  public:
    /// Of a patch of the bed or of vegetation.
    template <class Patch>
    PatchArea(const Case& c, const Patch& patch)
        : along_(stretch(covers_length(c, patch), patch.x_from, patch.x_to, c.channel.length,
                         c.channel.ends == Ends::periodic)),
          across_(stretch(covers_width(c, patch), patch.y_from, patch.y_to, c.channel.width,
                          c.channel.sides == Sides::periodic)) {}

    /// Share of a particle of a width (m) around a place that stands in the patch.
    [[nodiscard]] double share(double x, double y, double width) const {
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
};

}  // namespace riffle::inline roughness
