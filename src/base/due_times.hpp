#pragma once

#include <algorithm>
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

/// By how much a time may fall short of a due one and count as it, s: steps add up to it to rounding alone.
[[nodiscard]] inline double due_tolerance(double due, double interval) {
    return std::max(1e-9 * interval, 2e-12 * std::abs(due));
}

/// The earliest time that counts as the due one of something with this interval.
[[nodiscard]] inline double earliest_of(double due, double interval) {
    return due - due_tolerance(due, interval);
}

/// Whether a due time of something with this interval has come.
[[nodiscard]] inline bool has_come(double time, double due, double interval) {
    return time >= earliest_of(due, interval);
}

/// The first multiple of the interval after a due time that has come, and after `time`.
[[nodiscard]] inline double due_next(double time, double due, double interval) {
    return due_after(std::max(time, due), interval);
}

}  // namespace riffle::inline base
