#include "solver/convergence.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <vector>

namespace riffle {

namespace {

/// Growth of ln(fluctuation) over the window by its linear trend, and its half-width; no growth where there
/// is no fluctuation.
void find_growth(std::span<const double> fluctuation, Convergence& result) {
    std::vector<double> logarithm;
    logarithm.reserve(fluctuation.size());
    for (const double value : fluctuation) {
        if (!(value > 0.0)) {
            return;  // particles that move exactly as one
        }
        logarithm.push_back(std::log(value));
    }
    const TrendEstimate trend = trend_with_confidence(logarithm);
    const auto length = static_cast<double>(logarithm.size() - 1);
    result.fluctuation_growth = trend.slope * length;
    result.fluctuation_growth_half_width = trend.half_width * length;
}

/// Why the window does not do, in words; empty where it does.
std::string objection(const Convergence& found, double tolerance) {
    const double scale = std::max(std::abs(found.mean.mean), 1e-300);
    if (found.remaining_drift > tolerance) {
        return fmt::format("the mean velocity may still drift by {:.2f} % (tolerance {:.2f} %)",
                           100.0 * found.remaining_drift, 100.0 * tolerance);
    }
    if (found.mean.effective_samples < fewest_effective_samples) {
        return fmt::format("the mean velocity rests on {:.1f} independent samples ({:.0f} make an interval)",
                           found.mean.effective_samples, fewest_effective_samples);
    }
    if (found.mean.half_width > tolerance * scale) {
        return fmt::format("the mean velocity is known to {:.2f} % (tolerance {:.2f} %)",
                           100.0 * found.mean.half_width / scale, 100.0 * tolerance);
    }
    const double least = found.fluctuation_growth - found.fluctuation_growth_half_width;
    if (least > std::log1p(largest_fluctuation_growth)) {
        return fmt::format(
            "the velocity fluctuation has grown {:.2g}-fold over the window: the particles are leaving the "
            "order they started in",
            std::exp(found.fluctuation_growth));
    }
    return {};
}

Convergence test_window(const SteadinessRecord& record, double start, double relaxation_time,
                        double tolerance) {
    Convergence result;
    result.window_start = start;
    const auto time = record.time;
    const auto first =
        static_cast<std::size_t>(std::lower_bound(time.begin(), time.end(), start) - time.begin());
    const auto window =
        record.depth_mean_velocity.subspan(std::min(first, record.depth_mean_velocity.size()));
    constexpr std::size_t fewest = 50;
    if (window.size() < fewest || time.back() - start < relaxation_time) {
        result.reason =
            fmt::format("the record after t = {:.3g} s is shorter than one relaxation time ({:.3g} s)", start,
                        relaxation_time);
        return result;
    }
    result.mean = mean_with_confidence(window);
    const TrendEstimate trend = trend_with_confidence(window);
    const double interval = (time.back() - time[first]) / static_cast<double>(window.size() - 1);
    const double scale = std::max(std::abs(result.mean.mean), 1e-300);
    result.remaining_drift = (std::abs(trend.slope) + trend.half_width) / interval * relaxation_time / scale;
    find_growth(record.velocity_fluctuation.subspan(std::min(first, record.velocity_fluctuation.size())),
                result);
    result.reason = objection(result, tolerance);
    if (result.reason.empty()) {
        result.converged = true;
        result.reason = fmt::format(
            "mean velocity {:.5g} m/s +- {:.2f} % from {:.0f} independent samples, drift still to come below "
            "{:.2f} %",
            result.mean.mean, 100.0 * result.mean.half_width / scale, result.mean.effective_samples,
            100.0 * result.remaining_drift);
    }
    return result;
}

}  // namespace

Convergence test_convergence(const SteadinessRecord& record, double relaxation_time, double tolerance,
                             double fixed_start) {
    if (record.time.empty()) {
        Convergence none;
        none.reason = "nothing recorded yet";
        return none;
    }
    if (fixed_start >= 0.0) {
        return test_window(record, fixed_start, relaxation_time, tolerance);
    }
    Convergence last;
    for (int multiple = 3;
         multiple == 3 || multiple * relaxation_time <= record.time.back() - relaxation_time; ++multiple) {
        last = test_window(record, multiple * relaxation_time, relaxation_time, tolerance);
        if (last.converged) {
            break;
        }
    }
    return last;
}

double expected_end(const Convergence& test, double time, double relaxation_time, double tolerance,
                    double latest) {
    if (test.converged) {
        return std::min(time, latest);
    }
    double end = std::max(time, std::max(test.window_start, 3.0 * relaxation_time) + relaxation_time);
    const double mean = std::abs(test.mean.mean);
    const double window = time - test.window_start;
    if (mean > 0.0 && window > 0.0) {
        if (test.remaining_drift > tolerance) {
            end = std::max(end, time + relaxation_time * std::log(test.remaining_drift / tolerance));
        }
        // Not by the half-width, in which Student's t of few samples makes much of what a little more of the
        // record will tell.
        const double samples = std::max(1.0, test.mean.effective_samples);
        const double width = normal_95 * test.mean.standard_deviation / (mean * std::sqrt(samples));
        const double longer =
            std::max((width / tolerance) * (width / tolerance), fewest_effective_samples / samples);
        if (longer > 1.0) {
            end = std::max(end, test.window_start + window * longer);
        }
    } else {
        end = std::max(end, usual_relaxation_times * relaxation_time);
    }
    return std::min(end, latest);
}

}  // namespace riffle
