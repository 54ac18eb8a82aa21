#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <vector>

#include "statistics/confidence.hpp"

namespace riffle::inline analysis {

/// A quantity along a line over time, e.g. the surface elevation eta(x, t) of a run or of a row of wave
/// probes: evenly spaced along the line, at increasing times. SI.
struct SpaceTime {
    double first_x = 0.0;  ///< coordinate of the first column, m
    double spacing = 0.0;  ///< between columns, m
    std::size_t columns = 0;
    /// The line closes on itself after columns * spacing, as along a periodic channel.
    bool periodic = false;
    std::vector<double> times;   ///< s
    std::vector<double> values;  ///< values[j * columns + i] at times[j], x(i); not-a-number where dry

    [[nodiscard]] std::size_t rows() const { return times.size(); }
    [[nodiscard]] double x(std::size_t column) const {
        return first_x + static_cast<double>(column) * spacing;
    }
    /// Length of the line: the period, or that between the outer edges of the end columns' cells, m.
    [[nodiscard]] double length() const { return static_cast<double>(columns) * spacing; }
    [[nodiscard]] double at(std::size_t row, std::size_t column) const {
        return values[row * columns + column];
    }
    [[nodiscard]] std::span<const double> row(std::size_t j) const {
        return std::span(values).subspan(j * columns, columns);
    }
    [[nodiscard]] std::span<double> row(std::size_t j) {
        return std::span(values).subspan(j * columns, columns);
    }
    /// The record of one column.
    [[nodiscard]] std::vector<double> record(std::size_t column) const;
};

/// The record of one wave probe of a few at uneven places, mean removed or not. Not-a-number where nothing
/// was measured.
struct StationRecord {
    double x = 0.0;  ///< m
    std::vector<double> values;
};

/// Make a SpaceTime of coordinates `x`, `times` and values[j * x.size() + i]. With `period` (m) the line
/// closes on itself. Throws InputError, naming what is wrong, where sizes disagree, x is not evenly spaced
/// (to 1e-3 of the spacing), times do not increase, or the period is not that of the columns.
[[nodiscard]] SpaceTime make_space_time(std::span<const double> x, std::span<const double> times,
                                        std::span<const double> values,
                                        std::optional<double> period = std::nullopt);

/// Rows first ... first + count - 1. Throws InputError where there are not so many.
[[nodiscard]] SpaceTime block_of_rows(const SpaceTime& data, std::size_t first, std::size_t count);

/// The record at fewer places, at most `most` (>= 2): every n-th column. Along a periodic line n must divide
/// the columns; where no n leaves at least half of `most`, the record is interpolated linearly at `most` even
/// places around the period instead.
[[nodiscard]] SpaceTime fewer_columns(const SpaceTime& data, std::size_t most);

/// The mean over line and time. The 95 % interval is that of the record of the means along the line, so
/// correlation along the line needs no assumption. Dry points are left out.
[[nodiscard]] MeanEstimate mean_level(const SpaceTime& data);

/// Share of the points that are dry (not-a-number).
[[nodiscard]] double dry_share(const SpaceTime& data);

/// What fluctuation() takes away beside the time mean of each column.
struct FluctuationOptions {
    /// Also the linear trend in time of each column (a drift of the level during the run).
    bool remove_trend = false;
    /// Also the mean along the line at each time: the level as a whole, e.g. the slow sloshing of a channel
    /// whose length holds few patterns. It removes the true mean of the patterns on the line as well, so that
    /// the variance falls by about the integral scale over the length.
    bool remove_line_mean = false;
};

/// eta'(x, t): the values less the time mean of their column, which takes out what the bed imprints on the
/// level, and less what the options say. Dry points stay not-a-number.
[[nodiscard]] SpaceTime fluctuation(const SpaceTime& data, const FluctuationOptions& options = {});

/// A standard deviation with its uncertainty.
struct DeviationEstimate {
    double value = 0.0;
    double half_width = 0.0;  ///< of the 95 % interval; infinite from too few independent times
    /// Number of independent Gaussian samples that would know the variance as well: 2 variance^2 over the
    /// variance of the estimate.
    double effective_samples = 0.0;
    double integral_time = 0.0;  ///< of the mean square along the line, s
};

/// Standard deviation of a fluctuation (mean zero in time), over line and time. Its interval comes from the
/// record of the mean square along the line, whose scatter and correlation in time contain those along the
/// line. The mean removed from each column lowers the variance by the variance of that mean (integral time
/// over duration); this is not corrected for, so that the integral of the spectra is the same variance.
[[nodiscard]] DeviationEstimate standard_deviation(const SpaceTime& fluctuation);

/// Take the mean, or with `trend` the line through the values over their places or times, from the values of
/// a record that are numbers.
void remove_line(std::span<const double> places, std::vector<double>& record, bool trend);

/// The interval between even times: the mean of the intervals, but for those where samples are missing, s.
/// Needs two times (else InputError).
[[nodiscard]] double sampling_interval(const SpaceTime& data);

/// The record at even times, from the first to the last, at the mean interval, so that there are as many as
/// samples: by cubic interpolation in time (linear beside dry points). Records of a run are taken at the
/// first step after their due time, so that their times scatter by a fraction of the interval. With any other
/// interval the even times would drift through those of the samples, and cubics half-way between samples
/// damp what has few of them in a period.
/// Throws InputError, naming the place, where two times lie further apart than `largest_gap` intervals.
[[nodiscard]] SpaceTime resample_evenly(const SpaceTime& data, double largest_gap = 1.9);

/// Throws InputError, naming the first place, where a point is dry: spectra need them all. `purpose` begins
/// the message, e.g. "spectrum in frequency".
void require_wet(const SpaceTime& data, const char* purpose);

/// Throws InputError where the times are not even to `tolerance` intervals.
void require_even_times(const SpaceTime& data, const char* purpose, double tolerance = 0.01);

}  // namespace riffle::inline analysis
