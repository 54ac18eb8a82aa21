#pragma once

#include <array>
#include <cstddef>
#include <span>

#include "statistics/moments.hpp"

namespace riffle::inline statistics {

/// What the hole size is measured in.
enum class HoleScale {
    deviations,   ///< |u' w'| > H u_rms w_rms (Lu & Willmarth 1973); defined whatever the mean stress
    mean_product  ///< |u' w'| > H |<u' w'>| (Nakagawa & Nezu 1977)
};

/// One quadrant of the plane of u' and w'.
struct Quadrant {
    Estimate time;            ///< share of the samples in it and outside of the hole
    Estimate stress;          ///< its part of <u' w'>, in the square of the velocity's unit
    double stress_share = 0;  ///< the same over <u' w'>; not-a-number where that is zero
};

/// Quadrant analysis of the Reynolds shear stress.
struct Quadrants {
    /// [0] outward interaction, u' > 0, w' > 0; [1] ejection, u' < 0, w' > 0; [2] inward interaction, both <
    /// 0; [3] sweep, u' > 0, w' < 0.
    std::array<Quadrant, 4> quadrant;
    Estimate time_in_hole;  ///< share of the samples with |u' w'| at or below the threshold
    double threshold = 0;   ///< of |u' w'|
    Estimate mean_product;  ///< <u' w'>: minus the kinematic Reynolds stress
    std::size_t samples = 0;
};

/// `hole` H >= 0; with H = 0 samples with u' w' = 0 are in the hole. Samples missing (not-a-number) in either
/// record are left out. Intervals are 95 %, correlation in time taken into account. Throws InputError for a
/// negative H or records of different lengths.
[[nodiscard]] Quadrants quadrant_analysis(std::span<const double> u, std::span<const double> w,
                                          double hole = 0, HoleScale scale = HoleScale::deviations);

}  // namespace riffle::inline statistics
