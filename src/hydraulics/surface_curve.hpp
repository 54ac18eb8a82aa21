#pragma once

#include <vector>

#include "hydraulics/steady_channel.hpp"

namespace riffle::inline hydraulics {

/// A curve of the water surface of gradually varied flow in a channel of one slope: from a control, where the
/// depth is given, towards the depth that it approaches (uniform flow, without end) or ends at (critical).
///
/// Where the channel is the same all along, the equation dh/dx = g H (sin(theta) - S_f)/(dM/dh) is
/// one of the depth alone, and x(h) an integral: no step along the channel is taken, and the curve is exact
/// to the Gaussian quadrature between its nodes, 1e-10 of the length. The depth at a place is found by
/// inversion.
class SurfaceCurve {
  public:
    /// From the depth `control` at `place` on, towards `direction` (1: downstream, -1: upstream), as far as
    /// the flow goes in this state or `reach` m. A control at the normal depth gives uniform flow. Throws
    /// InputError where the depth falls below the least depth of the channel.
    SurfaceCurve(SteadyChannel channel, double place, double control, int direction, double reach,
                 double critical_depth, std::optional<double> normal_depth);

    [[nodiscard]] double begin() const { return place_; }
    /// The far end, m: where the flow becomes critical, or `reach` m from the control.
    [[nodiscard]] double end() const { return place_ + static_cast<double>(direction_) * length_; }
    [[nodiscard]] bool covers(double x) const;
    /// Whether the curve ends within the reach, at the critical depth.
    [[nodiscard]] bool ends_critical() const { return ends_critical_; }
    /// Depth at a place that the curve covers, m.
    [[nodiscard]] double depth_at(double x) const;
    [[nodiscard]] const SteadyChannel& channel() const { return channel_; }
    /// Distance from the control to where the depth is within a share of its far depth, m.
    [[nodiscard]] double distance_within(double share) const;

  private:
    void check_depth(double depth) const;
    [[nodiscard]] double distance_between(double from, double to) const;

    SteadyChannel channel_;
    double place_;
    int direction_;
    double length_ = 0.0;
    double far_depth_ = 0.0;  ///< what the depth approaches; infinite upstream on beds without normal depth
    bool uniform_ = false;
    bool ends_critical_ = false;
    std::vector<double> depth_;     ///< at the nodes
    std::vector<double> distance_;  ///< from the control
};

}  // namespace riffle::inline hydraulics
