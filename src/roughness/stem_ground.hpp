#pragma once

#include "case/case.hpp"
#include "roughness/plan_table.hpp"

namespace riffle::inline roughness {

/// Heights at which the stems of a patch stand (case/stem_feet.hpp), looked up once at places a spacing apart
/// over the patch, linear between them.
class StemGround {
  public:
    StemGround(const Case& c, const Vegetation& stems);

    /// Height at a place in plan, m; 0 everywhere where the stems stand on the bed. Outside of the patch that
    /// of its edge.
    [[nodiscard]] double at(double x, double y) const { return height_.empty() ? 0.0 : height_.at(x, y); }

  private:
    PlanTable height_;  ///< m
};

}  // namespace riffle::inline roughness
