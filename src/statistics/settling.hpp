#pragma once

#include <cstddef>
#include <span>
#include <vector>

namespace riffle::inline statistics {

/// How the mean of a record settles as the record grows (the thesis' Figs 4.4-4.5, 5.10): the mean of the
/// first `samples` samples and its 95 % interval, correlation taken into account.
struct SettlingCurve {
    std::vector<std::size_t> samples;  ///< including gaps
    std::vector<double> mean;
    std::vector<double> half_width;
};

/// At `points` numbers of samples, evenly spaced, the last being the whole record; at all where there are
/// fewer. Gaps (not-a-number) are left out. Throws InputError for an empty record or no points.
[[nodiscard]] SettlingCurve settling_curve(std::span<const double> record, std::size_t points = 100);

/// Number of samples after which the running mean stays within `band` of the mean of the whole record. The
/// running mean ends at that mean, so the answer says something only where it is small against the record's
/// length: two times the answer is a sensible shortest record. Throws InputError for a band that is not
/// positive, or a record without samples.
[[nodiscard]] std::size_t settled_after(std::span<const double> record, double band);

}  // namespace riffle::inline statistics
