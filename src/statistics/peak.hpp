#pragma once

namespace riffle::inline statistics {

/// Extreme of the parabola through three equally spaced values of which the middle one is the largest or
/// smallest.
struct ParabolaExtreme {
    double offset = 0;  ///< from the middle, in spacings, within [-1/2, 1/2]
    double value = 0;
};

/// Of values on a straight line, the middle one.
[[nodiscard]] inline ParabolaExtreme parabola_extreme(double before, double middle, double after) {
    const double curvature = before - 2.0 * middle + after;
    if (curvature == 0.0) return {0.0, middle};
    const double offset = 0.5 * (before - after) / curvature;
    return {offset, middle - 0.25 * (before - after) * offset};
}

}  // namespace riffle::inline statistics
