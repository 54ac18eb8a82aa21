#pragma once

#include <cstddef>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace riffle::inline laboratory {

/// What was wrong with a record, and what was done about it. Counts of samples unless said otherwise.
struct RecordQuality {
    std::size_t samples = 0;      ///< of the record, gaps included
    std::size_t missing = 0;      ///< without a value in the file
    std::size_t gaps = 0;         ///< runs of missing or refused samples
    std::size_t longest_gap = 0;  ///< samples
    std::size_t refused = 0;  ///< with a value that the instrument itself reports as poor (low correlation)
    std::size_t spikes = 0;   ///< found by find_spikes
    std::size_t interpolated = 0;  ///< missing, refused or spikes, replaced by interpolation
    std::size_t left = 0;          ///< still not a number, in gaps too long to be interpolated or at an end
};

/// One sentence about a record of this name; empty if nothing was wrong with it.
[[nodiscard]] std::string describe(const RecordQuality& quality, std::string_view name);

/// Replace runs of at most `longest` values that are not numbers by linear interpolation between their
/// neighbours; runs at an end of the record stay. Returns how many values were replaced.
std::size_t interpolate_gaps(std::span<double> values, std::size_t longest);

/// Runs of values that are not numbers: their number, and the length of the longest.
struct Gaps {
    std::size_t missing = 0;
    std::size_t runs = 0;
    std::size_t longest = 0;
};
[[nodiscard]] Gaps find_gaps(std::span<const double> values);

/// Indices of the spikes of an evenly sampled record, by the phase-space threshold of Goring & Nikora (2002,
/// J. Hydraul. Eng. 128:117): a sample is a spike where the value and its first two differences leave the
/// ellipsoid that the universal threshold sqrt(2 ln n) spans. Centre and axes are the median and 1.483 times
/// the median absolute deviation (Wahl 2003, ibid. 129:484), which spikes themselves do not widen. The tilt
/// of the ellipse of value and second difference is taken out by regression and its narrow axis bounded, so
/// that it does not degenerate in a smooth record. Of flagged samples next to each other, whose differences
/// share the spike, the one farthest from its neighbours goes first; it is replaced by interpolation and the
/// search repeated until none is found. In a record of n Gaussian samples without spikes two or three are
/// found by chance, whatever n is. Values that are not numbers are passed over; samples within two of them
/// are judged by their value alone. Records of fewer than 20 samples have no spikes that could be told.
[[nodiscard]] std::vector<std::size_t> find_spikes(std::span<const double> values);

/// How a record is repaired.
struct RepairOptions {
    bool despike = true;
    std::size_t longest_interpolated = 5;  ///< samples; longer gaps stay
};

/// Count gaps, remove spikes and interpolate short gaps, in place. `refused` values must have been made
/// not-a-number before; they count as such and not as missing.
[[nodiscard]] RecordQuality repair_record(std::span<double> values, const RepairOptions& options,
                                          std::size_t refused = 0);

}  // namespace riffle::inline laboratory
