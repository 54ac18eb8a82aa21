#pragma once

#include <Eigen/Core>
#include <cstddef>
#include <limits>
#include <optional>
#include <span>
#include <string>

#include "statistics/linear_fit.hpp"

namespace riffle::inline hydraulics {

/// Points of a measured or computed velocity profile. Points whose height, velocity or uncertainty is not a
/// number are passed over by the fits.
struct VelocityPoints {
    std::span<const double> z;         ///< m, over any level
    std::span<const double> velocity;  ///< m/s
    /// Standard uncertainties, m/s: weights of the points against each other (a common factor does not
    /// matter, see fit_linear); empty: all alike.
    std::span<const double> uncertainty = {};
    double zero_plane = 0;  ///< zero of the law's height, over the same level as z, m
};

/// Range of z that a fit uses, ends included, m.
struct FitRange {
    double from = -std::numeric_limits<double>::infinity();
    double to = std::numeric_limits<double>::infinity();
};

/// What every fit of a profile tells beside its parameters. Where it is not valid the parameters mean
/// nothing, and `why_not` says why.
struct FitQuality {
    double residual_rms = 0;  ///< m/s
    double from = 0;          ///< range of z asked for, m
    double to = 0;
    std::size_t points = 0;  ///< used
    bool valid = false;
    std::string why_not = "not fitted";
};

/// The points of a fit: those within the range, and the tests that all fits share.
class FitPoints {
  public:
    /// Throws InputError if the numbers of heights, velocities and uncertainties differ or an uncertainty is
    /// not greater than zero.
    FitPoints(const VelocityPoints& points, FitRange range);

    /// Heights over the zero plane, velocities, uncertainties (empty: not given).
    Eigen::VectorXd height, velocity, uncertainty;

    /// The quality of a fit that has not been made yet, with range and number of points.
    [[nodiscard]] const FitQuality& quality() const { return quality_; }

    /// Why these points cannot be fitted: fewer than `fewest`, not all above the zero plane, or, where a
    /// depth is given, not all below the surface. Empty: they can.
    [[nodiscard]] std::string obstacle(Eigen::Index fewest, std::optional<double> depth = {}) const;

  private:
    FitQuality quality_;
};

/// Quality of a fit with these residuals that has succeeded.
[[nodiscard]] FitQuality succeeded(FitQuality quality, const Eigen::VectorXd& residuals);

/// Quality of a fit that has not, with the reason.
[[nodiscard]] FitQuality failed(FitQuality quality, std::string why_not);

/// offset + factor * fitted.
[[nodiscard]] FittedValue linear_of(const FittedValue& fitted, double factor, double offset = 0);

/// exp(fitted).
[[nodiscard]] FittedValue exponential_of(const FittedValue& fitted);

/// 1/fitted, for a fitted value > 0; no upper bound where the interval reaches zero.
[[nodiscard]] FittedValue inverse_of(const FittedValue& fitted);

/// A number that is known.
[[nodiscard]] FittedValue known_value(double value);

}  // namespace riffle::inline hydraulics
