#include "analysis/upwelling.hpp"

#include <fmt/format.h>

#include <cmath>
#include <span>
#include <vector>

#include "base/error.hpp"

namespace riffle::inline analysis {

namespace {

/// Stretches of one sign (+1, -1) that somewhere exceed the threshold.
int count_stretches(std::span<const double> w, bool periodic, double sign, double threshold) {
    const std::size_t n = w.size();
    // Around a closed line, start where no stretch is under way.
    std::size_t start = 0;
    if (periodic) {
        while (start < n && sign * w[start] > 0.0) ++start;
        if (start == n) start = 0;
    }
    int count = 0;
    bool counted = false;
    for (std::size_t i = 0; i < n; ++i) {
        const double value = sign * w[(start + i) % n];
        if (!(value > 0.0)) {
            counted = false;
        } else if (!counted && value > threshold) {
            ++count;
            counted = true;
        }
    }
    return count;
}

}  // namespace

UpwellingCounts count_upwellings(const SpaceTime& vertical_velocity, double depth, double threshold) {
    if (!(threshold >= 0.0) || !(depth > 0.0)) {
        throw InputError(
            fmt::format("upwellings: threshold {:.4g} and depth {:.4g} m; a threshold of at least 0 and a "
                        "depth above 0 are needed",
                        threshold, depth));
    }
    UpwellingCounts result;
    result.threshold = threshold * standard_deviation(vertical_velocity).value;
    std::vector<double> up, down;
    for (std::size_t j = 0; j < vertical_velocity.rows(); ++j) {
        const std::span<const double> w = vertical_velocity.row(j);
        up.push_back(count_stretches(w, vertical_velocity.periodic, 1.0, result.threshold));
        down.push_back(count_stretches(w, vertical_velocity.periodic, -1.0, result.threshold));
    }
    result.upwellings = mean_with_confidence(up);
    result.downwellings = mean_with_confidence(down);
    result.upwellings_per_depth = result.upwellings.mean * depth / vertical_velocity.length();
    result.downwellings_per_depth = result.downwellings.mean * depth / vertical_velocity.length();
    return result;
}

SpaceTime surface_vertical_velocity(const SpaceTime& elevation, double surface_velocity) {
    const std::size_t rows = elevation.rows();
    const std::size_t columns = elevation.columns;
    if (rows < 3 || columns < 3) {
        throw InputError(
            "vertical velocity of the surface: at least three times and three columns are needed");
    }
    SpaceTime result = elevation;
    for (std::size_t j = 0; j < rows; ++j) {
        const std::size_t before = j == 0 ? 0 : j - 1;
        const std::size_t after = j + 1 == rows ? j : j + 1;
        for (std::size_t i = 0; i < columns; ++i) {
            const bool first = i == 0 && !elevation.periodic;
            const bool last = i + 1 == columns && !elevation.periodic;
            const std::size_t left = first ? i : (i + columns - 1) % columns;
            const std::size_t right = last ? i : (i + 1) % columns;
            const double slope = (elevation.at(j, right) - elevation.at(j, left)) /
                                 ((first || last ? 1.0 : 2.0) * elevation.spacing);
            const double rate = (elevation.at(after, i) - elevation.at(before, i)) /
                                (elevation.times[after] - elevation.times[before]);
            result.row(j)[i] = rate + surface_velocity * slope;
        }
    }
    return result;
}

}  // namespace riffle::inline analysis
