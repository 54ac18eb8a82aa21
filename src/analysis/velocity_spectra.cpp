#include "analysis/velocity_spectra.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "base/error.hpp"

namespace riffle::inline analysis {

namespace {

constexpr std::size_t shortest_record = 64;

FrequencyBand default_band(const PowerSpectrum& spectrum, double interval) {
    double peak = 0.0;
    double largest = 0.0;
    for (std::size_t m = 0; m < spectrum.frequency.size(); ++m) {
        const double energy = spectrum.frequency[m] * spectrum.density[m];
        if (energy > largest) {
            largest = energy;
            peak = spectrum.frequency[m];
        }
    }
    return {3.0 * peak, 0.25 / interval};
}

bool usable(const PowerSpectrum& spectrum, const FrequencyBand& band) {
    std::size_t count = 0;
    for (std::size_t m = 0; m < spectrum.frequency.size(); ++m) {
        const double f = spectrum.frequency[m];
        if (f >= band.from && f <= band.to && spectrum.density[m] > 0.0) ++count;
    }
    return count >= 3;
}

/// Mean over the band of ln(S f^(5/3)), weighted by the degrees of freedom.
double five_thirds_level(const PowerSpectrum& spectrum, const FrequencyBand& band) {
    double sum = 0.0;
    double weight = 0.0;
    for (std::size_t m = 0; m < spectrum.frequency.size(); ++m) {
        const double f = spectrum.frequency[m];
        if (f < band.from || f > band.to || !(spectrum.density[m] > 0.0)) continue;
        const double w = spectrum.degrees_of_freedom[m];
        sum += w * (std::log(spectrum.density[m]) + 5.0 / 3.0 * std::log(f));
        weight += w;
    }
    return std::exp(sum / weight);
}

void require_whole(const HeightRecord& record) {
    if (record.values.size() < shortest_record) {
        throw InputError(fmt::format("velocity spectrum at z = {:.4g} m: {} samples; at least {} are needed",
                                     record.z, record.values.size(), shortest_record));
    }
    const auto gaps =
        std::count_if(record.values.begin(), record.values.end(), [](double v) { return std::isnan(v); });
    if (gaps > 0) {
        throw InputError(
            fmt::format("velocity spectrum at z = {:.4g} m: {} of {} samples are missing (no water there); "
                        "choose a lower height",
                        record.z, gaps, record.values.size()));
    }
}

}  // namespace

std::vector<VelocitySpectrum> velocity_spectra(std::span<const HeightRecord> records, double interval,
                                               std::optional<FrequencyBand> band,
                                               const WelchOptions& options) {
    std::vector<VelocitySpectrum> result;
    for (const HeightRecord& record : records) {
        require_whole(record);
        VelocitySpectrum v;
        v.z = record.z;
        v.spectrum = smoothed_power_spectrum(record.values, interval, options);
        const FrequencyBand chosen = band.value_or(default_band(v.spectrum.smooth, interval));
        if (usable(v.spectrum.smooth, chosen)) {
            v.band = chosen;
            v.slope = spectral_slope(v.spectrum.smooth, chosen.from, chosen.to);
            v.five_thirds_level = five_thirds_level(v.spectrum.smooth, chosen);
        }
        result.push_back(std::move(v));
    }
    return result;
}

}  // namespace riffle::inline analysis
