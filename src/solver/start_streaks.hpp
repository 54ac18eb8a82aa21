#pragma once

#include <array>

#include "case/case.hpp"

namespace riffle::inline solver {

/// Whether the start of a case gets streaks: one in space whose water flows from the start and whose eddies
/// are resolved.
[[nodiscard]] bool starts_with_streaks(const Case& c);

/// Rolls along the flow, some depth wide each, and the streaks that they make: where a roll brings fast water
/// down the water is faster, where it lifts slow water up it is slower, so the pair carries a Reynolds stress
/// at once. The streaks meander along the flow, which is what streaks break up by into eddies (Schoppa and
/// Hussain, Coherent structure generation in near-wall turbulence, J. Fluid Mech. 453, 2002). Random modes
/// alone carry no stress: they may have died before the shear has made eddies of them.
class StartStreaks {
  public:
    /// \param depth, width extents of the water over the floor and across the flow, m. Where they lie along
    /// and across the flow follows from the seed of the start.
    StartStreaks(const Case& c, double depth, double width);

    /// The velocity, in any unit: the curl of a vector potential under an envelope.
    /// \param x place along, across and over the floor, m; \param slope gradient of the envelope, 1/m
    [[nodiscard]] std::array<double, 3> curl(const std::array<double, 3>& x, double envelope,
                                             const std::array<double, 3>& slope) const;

  private:
    double across_ = 0.0;   ///< Wave number across the flow, 1/m.
    double along_ = 0.0;    ///< Wave number of the meanders, 1/m.
    double meander_ = 0.0;  ///< Amplitude of the meanders, m.
    double phase_across_ = 0.0;
    double phase_along_ = 0.0;
};

}  // namespace riffle::inline solver
