#pragma once

#include <span>

#include "hydraulics/channel_laws.hpp"
#include "hydraulics/profile_fit.hpp"

namespace riffle::inline hydraulics {

// Laws of uniform flow with cells of secondary flow beside each other, as over alternate rough and smooth
// strips along the channel (Wang & Cheng 2005; thesis 2.24, 2.27, 2.29). SI units; heights z over the zero
// plane, depth h between zero plane and surface. Where in a cell a profile stands is told by its phase,
// cos(pi y/lambda): 1 in the downflow (over the middle of a rough strip), -1 in the upflow (over the middle
// of a smooth one), 0 between them; lambda is the distance from downflow to upflow, a strip's width.
//
// The prints of (2.24) and (2.27) that these follow are damaged: their terms and constants are legible, their
// signs and brackets are not. As written here they meet all that is said of the measurements: at phase 0 the
// log law and the linear stress; at the surface no stress; near the bed the larger stress, and over the lower
// depth the steeper velocity, at phase 1; above a seventh of the depth the larger stress at phase -1; and an
// eddy viscosity that is positive but where the velocity has its maximum.

/// Constants of (2.24), fitted by Wang & Cheng to flow over strips as wide as the depth.
struct SecondaryFlowConstants {
    double logarithm = 0.3;  ///< alpha_1
    double offset = -0.8;    ///< alpha_2
    double wake = -1.7;      ///< D
};

/// Phase at the distance y from the middle of the downflow, m; `cell_width`: lambda, m.
[[nodiscard]] double secondary_flow_phase(double y, double cell_width);

/// Log law with secondary flow (thesis 2.24), m/s: kappa u/u_* = ln(z/z0) + [alpha_1 ln(z/z0) + alpha_2 +
/// D sin^2(pi z/(2 h))] phase. u_* and z0 are those between the cells.
[[nodiscard]] double secondary_flow_log_law(double z, double depth, double friction_velocity,
                                            double zero_velocity_height, double phase,
                                            double kappa = log_law_kappa,
                                            const SecondaryFlowConstants& constants = {});

/// -u'w'/u_*^2 with secondary flow (thesis 2.27): alpha_3 - alpha_4 z/h + (alpha_4 - alpha_3) (z/h)^2 with
/// alpha_3 = 1 + 0.18 phase, alpha_4 = 1 + 1.44 phase, which is (1 - z/h) (1 + 0.18 phase (1 - 7 z/h)).
[[nodiscard]] double secondary_flow_stress(double z, double depth, double phase);

/// Bed stress over its mean across the channel (thesis 2.29): 1 + 0.18 phase.
[[nodiscard]] double secondary_flow_bed_stress(double phase);

/// Amplitude of (2.29).
inline constexpr double secondary_flow_bed_amplitude = 0.18;

/// Fit of (2.27) to a stress profile.
struct SecondaryStressFit : FitQuality {
    FittedValue phase;
};

/// Fit the phase to stresses over rho u_*^2 (`relative_stress`, by height z over the zero plane), the
/// friction velocity being known. Values that are not numbers are left out; needs three in the range.
[[nodiscard]] SecondaryStressFit fit_secondary_flow_stress(std::span<const double> z,
                                                           std::span<const double> relative_stress,
                                                           double depth, FitRange range = {});

/// Fit of (2.29) to the bed stress across a channel.
struct BedStressFit : FitQuality {
    FittedValue mean;        ///< Pa
    FittedValue cell_width;  ///< lambda, m
    double amplitude = 0;    ///< of the undulation over the mean
    double downflow = 0;     ///< place of the first maximum, m

    /// The fitted stress at the place y, Pa.
    [[nodiscard]] double at(double y) const;
};

/// Fit mean, amplitude, place and width of the cells; the width is looked for between a twentieth and the
/// whole of the range of y. Needs six values; not valid where no width in between fits best.
[[nodiscard]] BedStressFit fit_bed_stress(std::span<const double> y, std::span<const double> stress);

}  // namespace riffle::inline hydraulics
