#pragma once

#include <cmath>
#include <cstdint>
#include <functional>
#include <random>
#include <vector>

#include "statistics/linear_fit.hpp"

namespace riffle::testing {

/// Trials of a test of 95 % intervals, and the band of the number that may cover: 3.3 standard deviations of
/// the binomial distribution on either side (missed by chance once in 1000 tests; the seeds are fixed).
inline constexpr int coverage_trials = 600;
inline const double coverage_band = 3.3 * std::sqrt(0.95 * 0.05 * coverage_trials);
inline constexpr double expected_covered = 0.95 * coverage_trials;

/// How often the intervals and half-widths of one fitted number held the truth.
class Coverage {
  public:
    explicit Coverage(double truth) : truth_(truth) {}

    void add(const FittedValue& fitted) {
        ++trials_;
        intervals_ += fitted.interval.contains(truth_);
        half_widths_ += std::abs(fitted.value - truth_) <= fitted.half_width;
        bounded_ += std::isfinite(fitted.interval.lower) && std::isfinite(fitted.interval.upper);
    }

    [[nodiscard]] int trials() const { return trials_; }
    [[nodiscard]] int intervals() const { return intervals_; }
    [[nodiscard]] int half_widths() const { return half_widths_; }
    [[nodiscard]] int bounded() const { return bounded_; }

  private:
    double truth_;
    int trials_ = 0;
    int intervals_ = 0;
    int half_widths_ = 0;
    int bounded_ = 0;
};

/// Heights and noisy velocities of a law.
struct NoisyProfile {
    std::vector<double> z;
    std::vector<double> velocity;
};

/// `n` evenly spaced heights from `lowest` to `highest` with Gaussian noise of the given standard deviation.
inline NoisyProfile noisy_profile(const std::function<double(double)>& law, double lowest, double highest,
                                  int n, double noise, int seed) {
    std::mt19937_64 generator(static_cast<std::uint64_t>(seed));
    std::normal_distribution<double> normal;
    NoisyProfile p;
    for (int i = 0; i < n; ++i) {
        p.z.push_back(lowest + (highest - lowest) * i / (n - 1));
        p.velocity.push_back(law(p.z.back()) + noise * normal(generator));
    }
    return p;
}

}  // namespace riffle::testing
