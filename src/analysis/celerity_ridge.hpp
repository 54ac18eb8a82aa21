#pragma once

#include <cstddef>
#include <vector>

#include "analysis/space_time.hpp"
#include "analysis/surface_spectra.hpp"
#include "statistics/moments.hpp"

namespace riffle::inline analysis {

/// A point of the ridge of a spectrum in wavenumber and frequency.
struct RidgePoint {
    double wavenumber = 0.0;  ///< > 0, rad/m
    double frequency = 0.0;   ///< signed: negative where the strongest waves travel upstream, rad/s
    double energy = 0.0;      ///< variance under the peak, m2
};

/// Celerity of the ridge.
struct RidgeCelerity {
    /// Slope of the line omega = c k through the ridge, weighted by energy, with the interval of the
    /// jackknife over blocks of time; of a line that is not periodic its half-width contains what a cut of
    /// the ridge at ten times the energy changes. Not-a-number where no ridge stands out.
    Estimate celerity;
    std::vector<RidgePoint> ridge;
    double largest_wavenumber = 0.0;  ///< that was used, rad/m
    double deviation = 0.0;           ///< weighted rms of omega/k about the celerity: dispersion, m/s
    WaveSpectrum spectrum;            ///< mean over the blocks
};

/// Celerity from the ridge of wave_spectrum(), the record cut into `blocks` whose segments are the blocks. It
/// measures the phase speed of the components that carry the energy: the water's velocity near the surface
/// where turbulence shapes it, the celerity of waves where these are stronger; `deviation` is large where one
/// line does not describe it. A periodic channel has only the wavenumbers of whole periods in its length: a
/// short one few points.
///
/// The ridge: for each k > 0 the largest value over both directions, its frequency the centroid of the lobe
/// around above the floor, the median over frequencies. Wavenumbers count where the peak is at least 8 times
/// the floor and holds 1 % of the energy of the largest, from the lowest up to where the ridge comes near the
/// highest frequency or the highest wavenumber (80 % of each), beyond which its aliases begin; those against
/// the direction of most of the energy are left out, too. The taper of a line that is not periodic moves
/// energy to neighbouring wavenumbers: there 0.1 % count, and what came to k = 0 is in the sums. Throws
/// InputError for fewer than two blocks or less than 8 times in each.
[[nodiscard]] RidgeCelerity ridge_celerity(const SpaceTime& fluctuation, std::size_t blocks = 10);

}  // namespace riffle::inline analysis
