#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <random>
#include <vector>

namespace riffle::synthetic {

/// First-order autoregressive record of mean zero and standard deviation 1, started in its steady state.
/// Autocorrelation phi^lag, integral scale 1/2 + sum phi^k = (1 + phi)/(2 (1 - phi)).
inline std::vector<double> autoregressive(std::size_t n, double phi, std::mt19937_64& generator) {
    std::normal_distribution<double> normal;
    std::vector<double> x(n);
    double state = normal(generator);
    for (double& v : x) {
        v = state;
        state = phi * state + std::sqrt(1 - phi * phi) * normal(generator);
    }
    return x;
}

inline double integral_scale(double phi) { return 0.5 * (1 + phi) / (1 - phi); }

/// Share of `trials` with different fixed seeds for which `covered` holds.
template <class Trial>
double share(int trials, const Trial& covered) {
    int count = 0;
    for (int i = 0; i < trials; ++i) {
        std::mt19937_64 generator(static_cast<std::uint64_t>(1000 + i));
        count += covered(generator) ? 1 : 0;
    }
    return static_cast<double>(count) / trials;
}

/// Standard deviation of the share of events of a probability: three of them are the binomial band that the
/// tests of coverage allow.
inline double share_deviation(double probability, int trials) {
    return std::sqrt(probability * (1 - probability) / trials);
}

/// Puts gaps of about `length` samples into a record until about `part` of it is missing.
inline void cut_gaps(std::vector<double>& x, double part, std::size_t length, std::mt19937_64& generator) {
    std::size_t missing = 0;
    while (static_cast<double>(missing) < part * static_cast<double>(x.size())) {
        const std::size_t start = generator() % x.size();
        for (std::size_t i = start; i < std::min(x.size(), start + length); ++i) {
            if (!std::isnan(x[i])) ++missing;
            x[i] = std::numeric_limits<double>::quiet_NaN();
        }
    }
}

}  // namespace riffle::synthetic
