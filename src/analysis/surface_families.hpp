#pragma once

#include <array>
#include <cstddef>
#include <vector>

#include "analysis/gravity_capillary_waves.hpp"

namespace riffle::inline analysis {

/// Elevation of the free surface in plan at even times, about its mean over the plan at each time.
struct SurfacePlan {
    std::size_t columns = 0;        ///< along the channel
    std::size_t rows = 0;           ///< across it
    double spacing_x = 0.0;         ///< m
    double spacing_y = 0.0;         ///< m
    double interval = 0.0;          ///< s
    bool periodic_x = true;         ///< whether the plan repeats itself along the channel
    bool periodic_y = true;         ///< and across it
    std::vector<double> elevation;  ///< m, [time][row][column]

    [[nodiscard]] std::size_t times() const {
        return rows * columns > 0 ? elevation.size() / (rows * columns) : 0;
    }
};

/// What the pattern of a surface can be, by the way it moves (Dolcetti et al. 2016).
enum class SurfaceFamily {
    bed_locked,        ///< it stands over the bed
    advected,          ///< the water carries it along
    waves_downstream,  ///< gravity-capillary waves that travel downstream through the water
    waves_upstream,    ///< and upstream through it
    waves_across,      ///< waves that travel straight across the channel
    other
};
inline constexpr std::size_t surface_families = 6;

/// The variance of a surface by families.
struct SurfaceMakeup {
    std::array<double, surface_families> variance{};  ///< m2, by SurfaceFamily
    /// What it would be, m2, if the variance of each wavenumber were spread evenly over the frequencies, as
    /// noise is that has no memory.
    std::array<double, surface_families> variance_of_noise{};
    std::vector<double> wavenumber;                             ///< middles of bands of |k|, rad/m
    std::array<std::vector<double>, surface_families> density;  ///< of the variance over |k|, m3/rad
    double frequency_step = 0.0;                                ///< rad/s
    std::size_t segments = 0;                                   ///< averaged

    [[nodiscard]] double whole() const;
    [[nodiscard]] double share(SurfaceFamily family) const;
    [[nodiscard]] double share_of_noise(SurfaceFamily family) const;
};

/// Each component (k_x, k_y, omega) of the spectrum counts for the family whose frequency is nearest: 0 for
/// what stands; from k_x `slowest` to k_x `fastest` for what the water carries; k_x U_s +- sqrt(g |k|
/// tanh(|k| H)) for waves (`waves.velocity` is U_s), which of k_x = 0 go neither up nor down; for none where
/// it is further off than two steps of frequency, or, of what moves, a tenth of k_x U_s (eddies carry the
/// pattern at velocities that vary). Frequencies are compared as sampling folds them, so patterns that pass
/// faster than the sampling resolves are told apart as well.
///
/// Means over segments of `segment_times` that overlap by half, under a Hann window in time, and along and
/// across the plan where it does not repeat itself. Throws InputError for fewer than 8 times in a segment, a
/// record shorter than that, or an elevation that is not a number.
[[nodiscard]] SurfaceMakeup surface_makeup(const SurfacePlan& plan, const GravityCapillaryWaves& waves,
                                           double slowest, double fastest, std::size_t segment_times);

}  // namespace riffle::inline analysis
