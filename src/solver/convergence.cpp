#include "solver/convergence.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace riffle {

namespace {

Convergence test_window(std::span<const double> time, std::span<const double> velocity, double start,
                        double relaxation_time, double tolerance) {
    Convergence result;
    result.window_start = start;
    const auto first =
        static_cast<std::size_t>(std::lower_bound(time.begin(), time.end(), start) - time.begin());
    const auto window = velocity.subspan(std::min(first, velocity.size()));
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
    const double width = result.mean.half_width / scale;
    if (result.remaining_drift > tolerance) {
        result.reason = fmt::format("the mean velocity may still drift by {:.2f} % (tolerance {:.2f} %)",
                                    100.0 * result.remaining_drift, 100.0 * tolerance);
    } else if (width > tolerance) {
        result.reason = fmt::format("the mean velocity is known to {:.2f} % (tolerance {:.2f} %)",
                                    100.0 * width, 100.0 * tolerance);
    } else {
        result.converged = true;
        result.reason =
            fmt::format("mean velocity {:.5g} m/s +- {:.2f} %, drift still to come below {:.2f} %",
                        result.mean.mean, 100.0 * width, 100.0 * result.remaining_drift);
    }
    return result;
}

}  // namespace

Convergence test_convergence(std::span<const double> time, std::span<const double> velocity,
                             double relaxation_time, double tolerance, double fixed_start) {
    if (time.empty()) {
        Convergence none;
        none.reason = "nothing recorded yet";
        return none;
    }
    if (fixed_start >= 0.0) {
        return test_window(time, velocity, fixed_start, relaxation_time, tolerance);
    }
    Convergence last;
    for (int multiple = 3; multiple == 3 || multiple * relaxation_time <= time.back() - relaxation_time;
         ++multiple) {
        last = test_window(time, velocity, multiple * relaxation_time, relaxation_time, tolerance);
        if (last.converged) {
            break;
        }
    }
    return last;
}

}  // namespace riffle
