#pragma once

#include <array>
#include <cmath>
#include <memory>
#include <vector>

#include "case/case.hpp"
#include "roughness/patch_area.hpp"
#include "roughness/stem_drag.hpp"
#include "roughness/stem_ground.hpp"
#include "turbulence/closure.hpp"

namespace riffle::inline roughness {

/// Stems that stand in a part of the channel: where, and how they hold the water back.
class VegetationPatch {
  public:
    VegetationPatch(const Case& c, const Vegetation& stems);

    [[nodiscard]] const StemDrag& drag() const { return drag_; }
    [[nodiscard]] double top() const { return top_; }  ///< of the stems above their feet, m
    /// Height of their feet above the bed level at a place in plan, m.
    [[nodiscard]] double foot(double x, double y) const { return ground_.at(x, y); }
    /// Share of a row of a height (m) around z, from the feet of the stems, that stands below the tops.
    [[nodiscard]] double share_below_top(double z, double row_height) const;
    /// Share of a particle of a width (m) around a place in plan that stands in the patch.
    [[nodiscard]] double share_in_plan(double x, double y, double width) const {
        return area_.share(x, y, width);
    }
    [[nodiscard]] const PatchStretch& across() const { return area_.across(); }

  private:
    StemDrag drag_;
    double top_;
    PatchArea area_;
    StemGround ground_;
};

[[nodiscard]] std::vector<VegetationPatch> vegetation_patches(const Case& c);

/// Displacement height of a canopy over its height by its frontal area index a k, with the canopy area index
/// 2 a k: d/k = 1 - (1 - exp(-s))/s, s = sqrt(7.5 * 2 a k) (Raupach 1994).
[[nodiscard]] inline double raupach_displacement(double frontal_area_index) {
    const double s = std::sqrt(15.0 * frontal_area_index);
    return s > 0.0 ? 1.0 + std::expm1(-s) / s : 0.0;
}

/// Of a patch, m above the bed level.
[[nodiscard]] inline double displacement_height(const Vegetation& stems) {
    return stems.height * raupach_displacement(stems.frontal_area() * stems.height);
}

/// The drag coefficient of a patch at a speed that it is likely to meet.
struct ReferenceDrag {
    double speed = 0.0;             ///< m/s
    double drag_coefficient = 0.0;  ///< C_D
};

/// At the speed of a uniform flow between the stems that the weight along the bed drives; on a bed without
/// slope at that of the discharge at the inflow over the depth, else at a tenth of sqrt(g H).
[[nodiscard]] ReferenceDrag reference_drag(const Case& c, const Vegetation& stems);

/// The mixing length in and above stems (docs/theory.md, section 7, canopies) from the closure of the bed
/// without them: above the tops that of a flow over a bed at the displacement height, below them what it is
/// at the tops or that of the stems' wakes, their diameter, as far as the bed allows. The closure itself
/// where it is no mixing length.
[[nodiscard]] std::unique_ptr<const Closure> make_canopy_closure(const Case& c, const Vegetation& stems,
                                                                 std::unique_ptr<const Closure> of_bed);

/// The closure of make_closure(), in a channel with vegetation everywhere that of its canopy.
[[nodiscard]] std::unique_ptr<const Closure> make_channel_closure(const Case& c);

}  // namespace riffle::inline roughness
