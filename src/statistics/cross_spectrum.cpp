#include "statistics/cross_spectrum.hpp"

#include <algorithm>
#include <cmath>
#include <complex>
#include <numbers>

#include "base/error.hpp"
#include "statistics/record.hpp"

namespace riffle::inline statistics {

CrossSpectrum cross_spectrum(std::span<const double> a, std::span<const double> b, double interval,
                             const WelchOptions& options) {
    require_same_length(a, b, "cross spectrum");
    require_no_gaps(a, "cross spectrum");
    require_no_gaps(b, "cross spectrum");
    if (!(interval > 0.0)) throw InputError("cross spectrum: the sampling interval must be positive");
    const WelchSegments segments(a.size(), options);
    if (segments.count() < 2) {
        throw InputError(
            "cross spectrum: the record holds one segment; coherence needs the mean over several: "
            "choose shorter segments");
    }
    CrossSpectrum result;
    result.segments = segments.count();
    result.degrees_of_freedom = segments.degrees_of_freedom();
    result.frequency = one_sided_frequencies(segments.length(), interval);
    const std::size_t bins = result.frequency.size();
    result.density_a.assign(bins, 0.0);
    result.density_b.assign(bins, 0.0);
    std::vector<Complex> cross(bins);
    for (std::size_t s = 0; s < segments.count(); ++s) {
        const std::vector<Complex> x = segments.spectrum(a, s);
        const std::vector<Complex> y = segments.spectrum(b, s);
        for (std::size_t k = 0; k < bins; ++k) {
            result.density_a[k] += std::norm(x[k]);
            result.density_b[k] += std::norm(y[k]);
            cross[k] += std::conj(x[k]) * y[k];
        }
    }
    const double independent = 0.5 * result.degrees_of_freedom;
    result.coherence_significance = 1.0 - std::pow(0.05, 1.0 / (independent - 1.0));
    const double scale = interval / static_cast<double>(segments.count());
    result.coherence.resize(bins);
    result.phase.resize(bins);
    result.phase_half_width.resize(bins);
    for (std::size_t k = 0; k < bins; ++k) {
        const double powers = result.density_a[k] * result.density_b[k];
        const double coherence = powers > 0.0 ? std::min(std::norm(cross[k]) / powers, 1.0) : 0.0;
        result.coherence[k] = coherence;
        result.phase[k] = std::arg(std::conj(cross[k]));
        result.phase_half_width[k] = std::numbers::pi;
        if (coherence > result.coherence_significance) {
            constexpr double normal_factor = 1.959963984540054;  // 97.5 % point of the Gaussian distribution
            const double deviation = std::sqrt((1.0 - coherence) / (2.0 * independent * coherence));
            result.phase_half_width[k] = std::min(normal_factor * deviation, std::numbers::pi);
        }
        result.density_a[k] *= scale;
        result.density_b[k] *= scale;
    }
    return result;
}

}  // namespace riffle::inline statistics
