#pragma once

#include <optional>
#include <string>
#include <vector>

#include "hydraulics/surface_curve.hpp"

namespace riffle::inline hydraulics {

/// Class of a bed slope for a discharge: by which of normal and critical depth is the larger.
enum class SlopeClass { mild, critical, steep, horizontal, adverse };

/// What is given at the ends of a channel, m. At the upstream end a depth counts only where the flow is
/// supercritical there, at the downstream end only where it is subcritical.
struct ChannelControls {
    double length = 0.0;                     ///< along the bed
    std::optional<double> upstream_depth;    ///< unset: the normal depth of a steep bed, else none
    std::optional<double> downstream_depth;  ///< unset: the normal depth of a mild bed, else none
};

/// A part of the channel with one curve of the surface.
struct SurfaceProfile {
    std::string name;   ///< M1 to S3, C, H, A alike, or "uniform"
    double from = 0.0;  ///< m from the upstream end
    double to = 0.0;
    double depth_from = 0.0;
    double depth_to = 0.0;
    SurfaceCurve curve;
    double origin = 0.0;  ///< what the places of the curve count from, m from the upstream end

    /// Depth at a place of the channel, m.
    [[nodiscard]] double depth_at(double x) const { return curve.depth_at(x - origin); }
};

/// A stretch of the channel with one bed.
struct VariedReach {
    std::string name;   ///< of a patch of the bed; empty for the bed of the channel
    double from = 0.0;  ///< m from the upstream end
    double to = 0.0;
    SlopeClass slope = SlopeClass::mild;
    double critical_depth = 0.0;
    std::optional<double> normal_depth;
};

/// A hydraulic jump, where the momentum functions of both curves meet; it has no length in this theory.
struct HydraulicJump {
    double place = 0.0;  ///< m from the upstream end
    double depth_before = 0.0;
    double depth_after = 0.0;
    double froude_before = 0.0;
    double head_loss = 0.0;  ///< of the energy grade line, m
};

/// Steady gradually varied flow in a channel of one slope.
struct VariedFlow {
    SlopeClass slope = SlopeClass::mild;  ///< of the last reach, as the depths
    double critical_depth = 0.0;
    std::optional<double> normal_depth;
    std::vector<VariedReach> reaches;      ///< from upstream to downstream, where the bed changes
    std::vector<SurfaceProfile> profiles;  ///< from upstream to downstream
    std::optional<HydraulicJump> jump;
    std::vector<std::string> events;  ///< sentences: a jump that is drowned or swept out

    /// Depth at a place of the channel, m; at a jump that behind it.
    [[nodiscard]] double depth_at(double x) const;
    [[nodiscard]] const SurfaceProfile& profile_at(double x) const;
};

/// The name of the curve on which a depth lies: M1 to A3, "uniform" at the normal depth.
[[nodiscard]] std::string profile_name(double depth, double critical_depth,
                                       std::optional<double> normal_depth, SlopeClass slope);

/// Steady flow between the controls: a subcritical curve from the downstream end, a supercritical one from
/// the upstream end, and where both are there a jump at the place where their momentum functions are equal
/// (Henderson 1966, chapters 4 and 5). Throws InputError for a control that cannot hold: a downstream depth
/// below the critical one on a bed that is not steep, an upstream one above it, none where one is needed.
[[nodiscard]] VariedFlow solve_varied_flow(const SteadyChannel& channel, const ChannelControls& controls);

/// The length in which the flow from the controls comes within a share of its far depth, m; for a channel
/// whose length is not given. None where it does not approach one.
[[nodiscard]] std::optional<double> approach_length(const SteadyChannel& channel,
                                                    const ChannelControls& controls, double share);

}  // namespace riffle::inline hydraulics
