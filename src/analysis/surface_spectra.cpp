#include "analysis/surface_spectra.hpp"

#include <fmt/format.h>

#include <cmath>
#include <numbers>
#include <numeric>
#include <span>

#include "base/error.hpp"
#include "base/parallel.hpp"
#include "statistics/fourier.hpp"
#include "statistics/jackknife.hpp"
#include "statistics/welch.hpp"

namespace riffle::inline analysis {

namespace {

using std::numbers::pi;

std::vector<double> line_window(const SpaceTime& data) {
    return data.periodic ? std::vector<double>(data.columns, 1.0) : hann_window(data.columns);
}

/// How often the value k of 0 ... n/2 stands in the whole transform of a real record.
double multiplicity(std::size_t k, std::size_t n) { return k == 0 || 2 * k == n ? 1.0 : 2.0; }

/// Add |transform|^2 of one segment, frequencies >= 0 only, columns in the order of the transform.
void add_periodogram(const SpaceTime& data, std::size_t first, const std::vector<double>& time_window,
                     const std::vector<double>& x_window, std::vector<double>& sum) {
    const std::size_t rows = time_window.size();
    const std::size_t columns = data.columns;
    std::vector<Complex> plane(rows * columns);
    for (std::size_t j = 0; j < rows; ++j) {
        for (std::size_t i = 0; i < columns; ++i) {
            plane[j * columns + i] = data.at(first + j, i) * time_window[j] * x_window[i];
        }
    }
    fourier_transform_2d(plane, rows, columns);
    for (std::size_t n = 0; n < sum.size(); ++n) sum[n] += std::norm(plane[n]);
}

}  // namespace

std::vector<double> hann_window(std::size_t n) {
    std::vector<double> window(n);
    for (std::size_t j = 0; j < n; ++j) {
        const double s = std::sin(pi * (static_cast<double>(j) + 0.5) / static_cast<double>(n));
        window[j] = s * s * std::sqrt(8.0 / 3.0);
    }
    return window;
}

WavenumberSpectrum wavenumber_spectrum(const SpaceTime& fluctuation) {
    require_wet(fluctuation, "spectrum in wavenumber");
    const std::size_t n = fluctuation.columns;
    const std::vector<double> window = line_window(fluctuation);
    const FourierTransform transform(n);
    WavenumberSpectrum result;
    result.step = 2.0 * pi / fluctuation.length();
    const std::size_t count = n / 2 + 1;
    const std::size_t rows = fluctuation.rows();
    std::vector<double> record(count * rows);  // of each component
    std::vector<double> line(n);
    const double scale = 1.0 / (static_cast<double>(n) * static_cast<double>(n) * result.step);
    for (std::size_t j = 0; j < rows; ++j) {
        for (std::size_t i = 0; i < n; ++i) line[i] = fluctuation.at(j, i) * window[i];
        const std::vector<Complex> values = transform.forward_real(line);
        for (std::size_t k = 0; k < count; ++k) {
            record[k * rows + j] = multiplicity(k, n) * scale * std::norm(values[k]);
        }
    }
    for (std::size_t k = 0; k < count; ++k) {
        const MeanEstimate mean = mean_with_confidence(std::span(record).subspan(k * rows, rows));
        result.wavenumber.push_back(static_cast<double>(k) * result.step);
        result.density.push_back(mean.mean);
        result.half_width.push_back(mean.half_width);
    }
    return result;
}

FrequencySpectrum frequency_spectrum(const SpaceTime& fluctuation, std::size_t blocks) {
    constexpr const char* purpose = "spectrum in frequency";
    require_wet(fluctuation, purpose);
    require_even_times(fluctuation, purpose);
    const std::size_t rows = fluctuation.rows();
    if (blocks < 2 || rows / blocks < 8) {
        throw InputError(fmt::format("{}: {} times in {} blocks; at least two blocks of 8 are needed",
                                     purpose, rows, blocks));
    }
    const std::size_t length = rows / blocks;
    const double rate =
        static_cast<double>(rows - 1) / (fluctuation.times.back() - fluctuation.times.front());
    const WelchSegments segment(length, {.segment_length = length});
    FrequencySpectrum result;
    result.blocks = blocks;
    result.resolution = rate / static_cast<double>(length);
    result.frequency = one_sided_frequencies(length, 1.0 / rate);
    const std::size_t width = result.frequency.size();
    std::vector<double> densities(blocks * width, 0.0);
    for (std::size_t i = 0; i < fluctuation.columns; ++i) {
        const std::vector<double> record = fluctuation.record(i);
        for (std::size_t b = 0; b < blocks; ++b) {
            const std::size_t first = b * (rows - length) / (blocks - 1);
            const std::vector<Complex> values = segment.spectrum(std::span(record).subspan(first, length), 0);
            for (std::size_t m = 0; m < width; ++m) {
                densities[b * width + m] +=
                    std::norm(values[m]) / rate / static_cast<double>(fluctuation.columns);
            }
        }
    }
    result.density = mean_without(densities, width, blocks);
    std::vector<std::vector<double>> logarithms(width);
    for (std::size_t b = 0; b < blocks; ++b) {
        const std::vector<double> rest = mean_without(densities, width, b);
        for (std::size_t m = 0; m < width; ++m) logarithms[m].push_back(std::log(rest[m]));
    }
    for (const std::vector<double>& values : logarithms) {
        result.factor.push_back(std::exp(jackknife_half_width(values)));
    }
    return result;
}

double WaveSpectrum::variance() const {
    return std::accumulate(density.begin(), density.end(), 0.0) * wavenumber_step * frequency_step;
}

WaveSpectrum wave_spectrum(const SpaceTime& fluctuation, std::size_t segment_rows) {
    constexpr const char* purpose = "spectrum in wavenumber and frequency";
    require_wet(fluctuation, purpose);
    require_even_times(fluctuation, purpose);
    const std::size_t rows = fluctuation.rows();
    if (segment_rows < 4 || segment_rows > rows) {
        throw InputError(fmt::format("{}: segments of {} times in a record of {}; from 4 to {} are possible",
                                     purpose, segment_rows, rows, rows));
    }
    const std::size_t columns = fluctuation.columns;
    const double interval =
        (fluctuation.times.back() - fluctuation.times.front()) / static_cast<double>(rows - 1);
    const std::vector<double> time_window = hann_window(segment_rows);
    const std::vector<double> x_window = line_window(fluctuation);
    const std::size_t hop = segment_rows / 2;
    const std::size_t frequencies = segment_rows / 2 + 1;

    WaveSpectrum result;
    result.segments = (rows - segment_rows) / hop + 1;
    result.wavenumber_step = 2.0 * pi / fluctuation.length();
    result.frequency_step = 2.0 * pi / (static_cast<double>(segment_rows) * interval);
    // The segments share the rows evenly, so that the end of the record is not left out.
    const std::vector<double> sum = reduce_blocks(
        result.segments, 1, std::vector<double>(frequencies * columns, 0.0),
        [&](std::size_t begin, std::size_t) {
            std::vector<double> part(frequencies * columns, 0.0);
            const std::size_t spare = rows - segment_rows;
            const std::size_t first = result.segments == 1 ? 0 : begin * spare / (result.segments - 1);
            add_periodogram(fluctuation, first, time_window, x_window, part);
            return part;
        },
        [](std::vector<double> a, const std::vector<double>& b) {
            for (std::size_t n = 0; n < a.size(); ++n) a[n] += b[n];
            return a;
        });

    // exp(i (k x - omega t)) stands at the transform's spatial frequency k and temporal one -omega, and, the
    // record being real, at -k and omega: so the column of wavenumber k is that of the spatial frequency -k.
    const std::vector<double> spatial = two_sided_frequencies(columns, fluctuation.spacing);
    const auto points = static_cast<double>(segment_rows * columns);
    const double scale = 1.0 / (points * points * result.wavenumber_step * result.frequency_step *
                                static_cast<double>(result.segments));
    result.density.resize(sum.size());
    for (std::size_t i = 0; i < columns; ++i) {
        // Descending from the last non-negative frequency to 0, then those below zero from -1 on: -k ascends.
        const std::size_t last = (columns + 1) / 2 - 1;
        const std::size_t source = i <= last ? last - i : columns + last - i;
        result.wavenumber.push_back(-2.0 * pi * spatial[source]);
        for (std::size_t m = 0; m < frequencies; ++m) {
            result.density[m * columns + i] =
                multiplicity(m, segment_rows) * scale * sum[m * columns + source];
        }
    }
    for (double& k : result.wavenumber) k += 0.0;  // no negative zero
    for (std::size_t m = 0; m < frequencies; ++m) {
        result.frequency.push_back(static_cast<double>(m) * result.frequency_step);
    }
    return result;
}

}  // namespace riffle::inline analysis
