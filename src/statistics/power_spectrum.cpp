#include "statistics/power_spectrum.hpp"

#include <algorithm>
#include <boost/math/distributions/chi_squared.hpp>
#include <boost/math/distributions/students_t.hpp>
#include <boost/math/special_functions/digamma.hpp>
#include <boost/math/special_functions/trigamma.hpp>
#include <cmath>
#include <complex>
#include <string>

#include "base/error.hpp"
#include "statistics/record.hpp"

namespace riffle::inline statistics {

namespace {

constexpr double normal_factor = 1.959963984540054;  // 97.5 % point of the Gaussian distribution

void append(PowerSpectrum& spectrum, double frequency, double density, double degrees_of_freedom) {
    spectrum.frequency.push_back(frequency);
    spectrum.density.push_back(density);
    spectrum.degrees_of_freedom.push_back(degrees_of_freedom);
    const boost::math::chi_squared distribution(degrees_of_freedom);
    spectrum.lower.push_back(degrees_of_freedom / quantile(complement(distribution, 0.025)));
    spectrum.upper.push_back(degrees_of_freedom / quantile(distribution, 0.025));
}

PowerSpectrum averaged(std::span<const double> record, double interval, const WelchSegments& segments) {
    require_no_gaps(record, "power spectrum");
    if (!(interval > 0.0)) throw InputError("power spectrum: the sampling interval must be positive");
    PowerSpectrum result;
    result.segments = segments.count();
    result.segment_length = segments.length();
    result.resolution = 1.0 / (static_cast<double>(segments.length()) * interval);
    result.frequency = one_sided_frequencies(segments.length(), interval);
    result.density.assign(result.frequency.size(), 0.0);
    for (std::size_t s = 0; s < segments.count(); ++s) {
        const std::vector<Complex> spectrum = segments.spectrum(record, s);
        for (std::size_t k = 0; k < spectrum.size(); ++k) result.density[k] += std::norm(spectrum[k]);
    }
    for (double& d : result.density) d *= interval / static_cast<double>(segments.count());

    PowerSpectrum one;
    append(one, 0.0, 0.0, segments.degrees_of_freedom());
    result.degrees_of_freedom.assign(result.frequency.size(), one.degrees_of_freedom[0]);
    result.lower.assign(result.frequency.size(), one.lower[0]);
    result.upper.assign(result.frequency.size(), one.upper[0]);
    result.correlation_with_next.assign(result.frequency.size(), segments.correlation_of_neighbours());
    result.correlation_with_next.back() = 0.0;
    return result;
}

/// A density of the band on logarithmic axes.
struct LogarithmicPoint {
    double x, y;
    double weight;  ///< one over the variance of y
    double correlation_with_next;
};

std::vector<LogarithmicPoint> points_of(const PowerSpectrum& spectrum, double from, double to) {
    std::vector<LogarithmicPoint> points;
    for (std::size_t k = 0; k < spectrum.frequency.size(); ++k) {
        const double f = spectrum.frequency[k];
        if (f < from || f > to || !(f > 0.0) || !(spectrum.density[k] > 0.0)) continue;
        const double half = 0.5 * spectrum.degrees_of_freedom[k];
        const double y = std::log(spectrum.density[k]) - boost::math::digamma(half) + std::log(half);
        points.push_back(
            {std::log(f), y, 1.0 / boost::math::trigamma(half), spectrum.correlation_with_next[k]});
    }
    if (points.size() < 3) {
        throw InputError("spectral slope: " + std::to_string(points.size()) + " densities lie between " +
                         std::to_string(from) + " and " + std::to_string(to) +
                         "; at least three are needed: choose a wider band or longer segments");
    }
    return points;
}

}  // namespace

PowerSpectrum power_spectrum(std::span<const double> record, double interval, const WelchOptions& options) {
    return averaged(record, interval, WelchSegments(record.size(), options));
}

double peak_frequency(const PowerSpectrum& spectrum) {
    if (spectrum.density.size() < 2) return 0.0;
    const auto peak = std::max_element(spectrum.density.begin() + 1, spectrum.density.end());
    return spectrum.frequency[static_cast<std::size_t>(peak - spectrum.density.begin())];
}

PowerSpectrum smoothed(const PowerSpectrum& spectrum, const WelchSegments& segments, int bins_per_decade) {
    if (bins_per_decade < 1) throw InputError("smoothed spectrum: at least one bin per decade is needed");
    PowerSpectrum result;
    result.resolution = spectrum.resolution;
    result.segments = spectrum.segments;
    result.segment_length = spectrum.segment_length;
    const std::size_t end = (spectrum.segment_length - 1) / 2 + 1;  // half the sampling rate is left out
    const auto bin_of = [&](std::size_t k) {
        return static_cast<long>(std::floor(std::log10(static_cast<double>(k)) * bins_per_decade + 0.5));
    };
    std::size_t count_before = 0;
    for (std::size_t first = 1; first < end;) {
        std::size_t last = first;
        double density = 0.0;
        double logarithm = 0.0;
        for (; last < end && bin_of(last) == bin_of(first); ++last) {
            density += spectrum.density[last];
            logarithm += std::log(spectrum.frequency[last]);
        }
        const auto count = static_cast<double>(last - first);
        if (count_before > 0) {
            result.correlation_with_next.push_back(
                segments.correlation_of_neighbours(count_before, last - first));
        }
        count_before = last - first;
        append(result, std::exp(logarithm / count), density / count,
               segments.degrees_of_freedom(last - first));
        first = last;
    }
    if (count_before > 0) result.correlation_with_next.push_back(0.0);
    return result;
}

SmoothedSpectrum smoothed_power_spectrum(std::span<const double> record, double interval,
                                         const WelchOptions& options, int bins_per_decade) {
    const WelchSegments segments(record.size(), options);
    SmoothedSpectrum result;
    result.fine = averaged(record, interval, segments);
    result.smooth = smoothed(result.fine, segments, bins_per_decade);
    return result;
}

SpectralSlope spectral_slope(const PowerSpectrum& spectrum, double from, double to) {
    const std::vector<LogarithmicPoint> points = points_of(spectrum, from, to);
    double sum = 0.0;
    double mean_x = 0.0;
    double mean_y = 0.0;
    for (const LogarithmicPoint& p : points) {
        sum += p.weight;
        mean_x += p.weight * p.x;
        mean_y += p.weight * p.y;
    }
    mean_x /= sum;
    mean_y /= sum;
    double spread = 0.0;
    double moment = 0.0;
    double shared = 0.0;
    double before = 0.0;  // of the error of the previous point
    for (const LogarithmicPoint& p : points) {
        const double dx = p.x - mean_x;
        spread += p.weight * dx * dx;
        moment += p.weight * dx * (p.y - mean_y);
        shared += 2.0 * before * std::sqrt(p.weight) * dx;
        before = p.correlation_with_next * std::sqrt(p.weight) * dx;
    }
    SpectralSlope result;
    result.points = points.size();
    result.slope.value = moment / spread;
    result.coefficient = std::exp(mean_y - result.slope.value * mean_x);
    double chi_square = 0.0;
    for (const LogarithmicPoint& p : points) {
        const double residual = p.y - mean_y - result.slope.value * (p.x - mean_x);
        chi_square += p.weight * residual * residual;
    }
    const auto degrees = static_cast<double>(points.size() - 2);
    result.reduced_chi_square = chi_square / degrees;
    const double variance = (spread + shared) / (spread * spread);
    // The scatter replaces the theory only where chance cannot explain it.
    const double beyond_chance = quantile(complement(boost::math::chi_squared(degrees), 0.05)) / degrees;
    if (result.reduced_chi_square > beyond_chance) {
        const double student = quantile(complement(boost::math::students_t(degrees), 0.025));
        result.slope.half_width = student * std::sqrt(result.reduced_chi_square * variance);
    } else {
        result.slope.half_width = normal_factor * std::sqrt(variance);
    }
    return result;
}

}  // namespace riffle::inline statistics
