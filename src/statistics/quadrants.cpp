#include "statistics/quadrants.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <string>
#include <vector>

#include "base/error.hpp"
#include "statistics/confidence.hpp"
#include "statistics/record.hpp"

namespace riffle::inline statistics {

namespace {

/// Of the events: quadrants 1 to 4, then the hole.
constexpr std::size_t hole_index = 4;

std::size_t event_of(double u, double w, double threshold) {
    if (!(std::abs(u * w) > threshold)) return hole_index;
    if (w > 0.0) return u > 0.0 ? 0 : 1;
    return u > 0.0 ? 3 : 2;
}

/// Share of the samples and part of the mean product, by event.
struct Shares {
    std::array<double, 5> time{}, stress{};
};

/// What the shares are counted from: departures from the means, moved by `shift` each.
struct Frame {
    double shift_u = 0, shift_w = 0, threshold = 0;
};

Shares shares_of(const Fluctuations& u, const Fluctuations& w, const Frame& frame) {
    Shares shares;
    const double one = 1.0 / static_cast<double>(u.count);
    for (std::size_t i = 0; i < u.values.size(); ++i) {
        if (!u.present[i]) continue;
        const double a = u.values[i] - frame.shift_u;
        const double b = w.values[i] - frame.shift_w;
        const std::size_t event = event_of(a, b, frame.threshold);
        shares.time[event] += one;
        shares.stress[event] += one * a * b;
    }
    return shares;
}

/// Central difference of the shares in one number of the frame.
Shares derivative(const Fluctuations& u, const Fluctuations& w, Frame frame, double Frame::*number,
                  double step) {
    const double middle = frame.*number;
    frame.*number = middle + step;
    const Shares above = shares_of(u, w, frame);
    frame.*number = middle - step;
    const Shares below = shares_of(u, w, frame);
    Shares result;
    for (std::size_t e = 0; e < 5; ++e) {
        result.time[e] = (above.time[e] - below.time[e]) / (2.0 * step);
        result.stress[e] = (above.stress[e] - below.stress[e]) / (2.0 * step);
    }
    return result;
}

double mean_square(const Fluctuations& x) {
    double sum = 0.0;
    for (const double v : x.values) sum += v * v;
    return sum / static_cast<double>(x.count);
}

/// Influence of each sample on the threshold.
std::vector<double> influence_on_threshold(const Fluctuations& u, const Fluctuations& w, double mean_product,
                                           double hole, HoleScale scale) {
    std::vector<double> influence(u.values.size(), 0.0);
    const double uu = mean_square(u);
    const double ww = mean_square(w);
    for (std::size_t i = 0; i < influence.size(); ++i) {
        const double a = u.values[i];
        const double b = w.values[i];
        influence[i] = scale == HoleScale::mean_product
                           ? hole * std::copysign(1.0, mean_product) * (a * b - mean_product)
                           : hole * std::sqrt(uu * ww) * 0.5 * (a * a / uu + b * b / ww - 2.0);
    }
    return influence;
}

/// Width of the differences over the deviation: a few per cent of the samples lie within.
constexpr double difference_step = 0.15;

}  // namespace

Quadrants quadrant_analysis(std::span<const double> u, std::span<const double> w, double hole,
                            HoleScale scale) {
    if (!(hole >= 0.0)) {
        throw InputError("quadrant analysis: a hole size of " + std::to_string(hole) +
                         "; it must not be negative");
    }
    const PairOfFluctuations pair = fluctuations_of(u, w, "quadrant analysis");
    const Fluctuations& x = pair.first;
    const Fluctuations& y = pair.second;
    const std::size_t n = x.values.size();
    std::vector<double> record(n, std::numeric_limits<double>::quiet_NaN());
    for (std::size_t i = 0; i < n; ++i) {
        if (x.present[i]) record[i] = x.values[i] * y.values[i];
    }
    Quadrants result;
    result.samples = x.count;
    const MeanEstimate product = mean_with_confidence(record);
    result.mean_product = {product.mean, product.half_width};
    const double deviation_u = std::sqrt(mean_square(x));
    const double deviation_w = std::sqrt(mean_square(y));
    result.threshold =
        hole * (scale == HoleScale::mean_product ? std::abs(product.mean) : deviation_u * deviation_w);

    const Frame frame{0.0, 0.0, result.threshold};
    const Shares shares = shares_of(x, y, frame);
    Shares by_u;
    Shares by_w;
    Shares by_threshold;
    if (deviation_u > 0.0 && deviation_w > 0.0) {
        by_u = derivative(x, y, frame, &Frame::shift_u, difference_step * deviation_u);
        by_w = derivative(x, y, frame, &Frame::shift_w, difference_step * deviation_w);
        const double step = std::min(difference_step * deviation_u * deviation_w, 0.5 * result.threshold);
        if (step > 0.0) by_threshold = derivative(x, y, frame, &Frame::threshold, step);
    }
    const std::vector<double> on_threshold = influence_on_threshold(x, y, product.mean, hole, scale);
    const auto estimate = [&](std::size_t event, std::array<double, 5> Shares::*kind) {
        for (std::size_t i = 0; i < n; ++i) {
            if (!x.present[i]) continue;
            const double a = x.values[i];
            const double b = y.values[i];
            const double counted = kind == &Shares::time ? 1.0 : a * b;
            record[i] = (event_of(a, b, result.threshold) == event ? counted : 0.0) +
                        (by_u.*kind)[event] * a + (by_w.*kind)[event] * b +
                        (by_threshold.*kind)[event] * on_threshold[i];
        }
        return Estimate{(shares.*kind)[event], mean_with_confidence(record).half_width};
    };
    for (std::size_t q = 0; q < 4; ++q) {
        Quadrant& quadrant = result.quadrant[q];
        quadrant.time = estimate(q, &Shares::time);
        quadrant.stress = estimate(q, &Shares::stress);
        quadrant.stress_share = product.mean == 0.0 ? std::numeric_limits<double>::quiet_NaN()
                                                    : quadrant.stress.value / product.mean;
    }
    result.time_in_hole = estimate(hole_index, &Shares::time);
    return result;
}

}  // namespace riffle::inline statistics
