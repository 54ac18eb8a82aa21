#pragma once

#include <cmath>

namespace riffle::inline base {

// Due times are whole multiples of an interval (s), found anew each time, without accumulated rounding. A
// time within a billionth of an interval of a multiple counts as it.

/// Whole intervals, given as a number that need not be whole, that have passed.
[[nodiscard]] inline double whole_intervals(double intervals) { return std::floor(intervals + 1e-9); }

/// The first multiple of the interval after `time`.
[[nodiscard]] inline double due_after(double time, double interval) {
    return (whole_intervals(time / interval) + 1.0) * interval;
}

/// The first time after `time` of something that happens at a frequency (Hz).
[[nodiscard]] inline double due_after_at_frequency(double time, double frequency) {
    return (whole_intervals(time * frequency) + 1.0) / frequency;
}

}  // namespace riffle::inline base
