#pragma once

#include <map>
#include <vector>

#include "case/case.hpp"

namespace riffle::inline column {

/// Depth of uniform flow for any discharge: the rating of a channel far from its ends, by the twins of its
/// bed. The twins are solved at depths 15 % apart, each when it is first needed, and interpolated between
/// them in the logarithms (third degree, to 1e-5 of the depth); below the least depth for which the friction
/// of the bed is known the power law of the two lowest goes on, down to no depth without discharge. Of a
/// canal at depths half a percent apart with straight lines between them; where its discharge falls as water
/// spills onto floodplains, whose bed makes the hydraulic radius of the whole section smaller, the depth is
/// the one at which it rises again.
class UniformRating {
  public:
    /// The channel falls, and something resists the flow.
    explicit UniformRating(Case c);

    /// Depth over the datum, m, of a discharge of a unit of the width, m2/s; 0 for none.
    [[nodiscard]] double depth(double unit_discharge);

  private:
    /// The logarithm of the discharge at the k-th depth.
    [[nodiscard]] double log_discharge(int k);

    [[nodiscard]] double depth_of_canal(double unit_discharge) const;

    Case case_;
    int lowest_;
    std::vector<double> canal_depths_;      ///< m; empty of other channels
    std::vector<double> canal_discharges_;  ///< that do not fall, m2/s
    std::map<int, double> log_discharges_;
};

}  // namespace riffle::inline column
