#include "analysis/celerity_ridge.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "base/error.hpp"
#include "base/not_a_number.hpp"
#include "statistics/jackknife.hpp"

namespace riffle::inline analysis {

namespace {

constexpr double usable_share = 0.8;  // of the highest wavenumber and frequency
constexpr double smallest_contrast = 8.0;
constexpr std::size_t hann_lobe = 2;  // half width of its main lobe, steps

/// What of a spectrum is its ridge.
struct RidgeRules {
    std::size_t lobe = hann_lobe;   ///< steps of frequency to each side of the peak
    double smallest_energy = 0.01;  ///< of that of the largest
    /// Take in what the taper of an open line moved to wavenumber zero.
    bool with_zero = false;
};

/// Density at wavenumber k > 0 (column i, its negative at column `opposite`) over signed frequencies,
/// ascending.
std::vector<double> over_signed_frequency(const WaveSpectrum& s, std::size_t i, std::size_t opposite) {
    std::vector<double> result;
    for (std::size_t m = s.frequency.size(); m-- > 1;) result.push_back(s.at(m, opposite));
    // At zero frequency the two directions share one value.
    for (std::size_t m = 0; m < s.frequency.size(); ++m) {
        result.push_back(m == 0 ? s.at(0, i) + s.at(0, opposite) : s.at(m, i));
    }
    return result;
}

double median(std::vector<double> values) {
    const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
    std::nth_element(values.begin(), middle, values.end());
    return *middle;
}

/// Energy-weighted mean frequency over mean wavenumber. The taper of a line that is not periodic spreads each
/// wave over some wavenumbers about its own: a regression of frequency on wavenumber would lose slope by it,
/// the sums over all of them do not.
double ratio_of_means(const std::vector<RidgePoint>& ridge) {
    double frequency = 0.0;
    double wavenumber = 0.0;
    for (const RidgePoint& p : ridge) {
        frequency += p.energy * p.frequency;
        wavenumber += p.energy * p.wavenumber;
    }
    return wavenumber > 0.0 ? frequency / wavenumber : not_a_number;
}

/// The peak over frequencies that begin at step `first`; without one that stands out the energy is zero.
RidgePoint peak_of(const std::vector<double>& density, std::ptrdiff_t first, double k,
                   const WaveSpectrum& spectrum, std::size_t lobe) {
    const auto reach = static_cast<std::ptrdiff_t>(lobe);
    const auto n = static_cast<std::ptrdiff_t>(density.size());
    const std::ptrdiff_t peak = std::max_element(density.begin(), density.end()) - density.begin();
    const double floor = median(density);
    if (!(density[static_cast<std::size_t>(peak)] > smallest_contrast * floor)) return {k, 0.0, 0.0};
    double sum = 0.0;
    double moment = 0.0;
    for (std::ptrdiff_t m = std::max<std::ptrdiff_t>(0, peak - reach); m <= std::min(n - 1, peak + reach);
         ++m) {
        const double excess = std::max(0.0, density[static_cast<std::size_t>(m)] - floor);
        sum += excess;
        moment += excess * static_cast<double>(m + first) * spectrum.frequency_step;
    }
    return {k, moment / sum, sum * spectrum.wavenumber_step * spectrum.frequency_step};
}

std::vector<RidgePoint> spectral_ridge(const WaveSpectrum& spectrum, const RidgeRules& rules) {
    std::vector<RidgePoint> ridge;
    const double highest_frequency = spectrum.frequency.back();
    const double highest_wavenumber = spectrum.wavenumber.back();
    const auto zero = static_cast<std::size_t>(
        std::lower_bound(spectrum.wavenumber.begin(), spectrum.wavenumber.end(), -1e-9 * highest_wavenumber) -
        spectrum.wavenumber.begin());
    const auto frequencies = static_cast<std::ptrdiff_t>(spectrum.frequency.size());
    for (std::size_t order = 1; zero + order < spectrum.wavenumber.size() && order <= zero; ++order) {
        const double k = spectrum.wavenumber[zero + order];
        if (k > usable_share * highest_wavenumber) break;
        const RidgePoint point = peak_of(over_signed_frequency(spectrum, zero + order, zero - order),
                                         1 - frequencies, k, spectrum, rules.lobe);
        if (point.energy > 0.0) ridge.push_back(point);
    }
    double largest = 0.0;
    for (const RidgePoint& p : ridge) largest = std::max(largest, p.energy);
    const double smallest = rules.smallest_energy * largest;
    std::erase_if(ridge, [smallest](const RidgePoint& p) { return p.energy < smallest; });
    // Beyond half the sampling rate a branch comes back with the other sign.
    double direction = 0.0;
    for (const RidgePoint& p : ridge) direction += std::copysign(p.energy, p.frequency);
    std::erase_if(ridge, [direction](const RidgePoint& p) { return p.frequency * direction < 0.0; });
    const auto aliased = std::find_if(ridge.begin(), ridge.end(), [&](const RidgePoint& p) {
        return std::abs(p.frequency) > usable_share * highest_frequency;
    });
    ridge.erase(aliased, ridge.end());
    if (rules.with_zero && !ridge.empty()) {
        std::vector<double> density;
        for (std::size_t m = 0; m < spectrum.frequency.size(); ++m) density.push_back(spectrum.at(m, zero));
        RidgePoint point = peak_of(density, 0, 0.0, spectrum, rules.lobe);
        point.frequency = std::copysign(point.frequency, direction);
        if (point.energy >= smallest && point.energy > 0.0) ridge.insert(ridge.begin(), point);
    }
    return ridge;
}

}  // namespace

RidgeCelerity ridge_celerity(const SpaceTime& fluctuation, std::size_t blocks) {
    const std::size_t rows = fluctuation.rows();
    if (blocks < 2 || rows / blocks < 8) {
        throw InputError(
            fmt::format("celerity of the ridge: {} times in {} blocks; at least two blocks of 8 are needed",
                        rows, blocks));
    }
    const std::size_t segment = rows / blocks;
    std::vector<double> densities;
    RidgeCelerity result;
    for (std::size_t b = 0; b < blocks; ++b) {
        result.spectrum =
            wave_spectrum(block_of_rows(fluctuation, b * (rows - segment) / (blocks - 1), segment), segment);
        densities.insert(densities.end(), result.spectrum.density.begin(), result.spectrum.density.end());
    }
    const std::size_t width = result.spectrum.density.size();
    result.spectrum.density = mean_without(densities, width, blocks);
    result.spectrum.segments = blocks;
    RidgeRules rules;
    if (!fluctuation.periodic) {
        // The taper along the line spreads each wave over its lobe in wavenumber, and so over this in
        // frequency. What it moves beyond the points that count shifts their sums: nearly all are taken in.
        const double first = std::abs(ratio_of_means(spectral_ridge(result.spectrum, rules)));
        const double steps =
            hann_lobe * result.spectrum.wavenumber_step * first / result.spectrum.frequency_step;
        const auto most = static_cast<double>(result.spectrum.frequency.size());
        if (steps > hann_lobe) rules.lobe = static_cast<std::size_t>(std::ceil(std::min(steps, most)));
        rules.smallest_energy = 0.001;
        rules.with_zero = true;
    }
    result.ridge = spectral_ridge(result.spectrum, rules);
    std::vector<double> without;
    WaveSpectrum rest = result.spectrum;
    for (std::size_t b = 0; b < blocks; ++b) {
        rest.density = mean_without(densities, width, b);
        without.push_back(ratio_of_means(spectral_ridge(rest, rules)));
    }
    result.celerity = {ratio_of_means(result.ridge), jackknife_half_width(without)};
    if (!fluctuation.periodic) {
        // The blocks share what the taper does to them. A cut at ten times the energy says how much that is.
        rules.smallest_energy *= 10.0;
        const double cut = ratio_of_means(spectral_ridge(result.spectrum, rules));
        if (std::isfinite(cut)) {
            result.celerity.half_width = std::hypot(result.celerity.half_width, cut - result.celerity.value);
        }
        std::erase_if(result.ridge, [](const RidgePoint& p) { return !(p.wavenumber > 0.0); });
    }
    double energy = 0.0;
    double sum = 0.0;
    for (const RidgePoint& p : result.ridge) {
        const double off = p.frequency / p.wavenumber - result.celerity.value;
        sum += p.energy * off * off;
        energy += p.energy;
        result.largest_wavenumber = p.wavenumber;
    }
    result.deviation = energy > 0.0 ? std::sqrt(sum / energy) : not_a_number;
    return result;
}

}  // namespace riffle::inline analysis
