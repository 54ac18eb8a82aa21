#include "solver/convergence.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <vector>

namespace riffle::inline solver {

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

/// A mean that must be known, over the window.
struct Tested {
    const char* name;
    const char* unit;
    MeanEstimate mean;
    double scale = 0.0;            ///< size of the mean, above 0
    double remaining_drift = 0.0;  ///< bound of the drift still to come, over it
};

/// `samples_of_relaxation`: the relaxation time in samples of the record.
Tested tested(const char* name, const char* unit, std::span<const double> window,
              double samples_of_relaxation) {
    Tested found{.name = name, .unit = unit, .mean = mean_with_confidence(window)};
    found.scale = std::max(std::abs(found.mean.mean), 1e-300);
    const TrendEstimate trend = trend_with_confidence(window);
    found.remaining_drift = (std::abs(trend.slope) + trend.half_width) * samples_of_relaxation / found.scale;
    return found;
}

/// Why the mean of a quantity does not do, in words; empty where it does.
std::string objection(const Tested& found, double tolerance) {
    if (!(found.remaining_drift <= tolerance)) {
        return fmt::format("{} may still drift by {:.2f} % (tolerance {:.2f} %)", found.name,
                           100.0 * found.remaining_drift, 100.0 * tolerance);
    }
    if (found.mean.effective_samples < fewest_effective_samples) {
        return fmt::format("{} rests on {:.1f} independent samples ({:.0f} make an interval)", found.name,
                           found.mean.effective_samples, fewest_effective_samples);
    }
    if (!(found.mean.half_width <= tolerance * found.scale)) {
        return fmt::format("{} is known to {:.2f} % (tolerance {:.2f} %)", found.name,
                           100.0 * found.mean.half_width / found.scale, 100.0 * tolerance);
    }
    return {};
}

/// Why what leaves is not what enters, by the account of the particles; empty where it is.
std::string imbalance(std::span<const double> entered, std::span<const double> left, double tolerance) {
    const double in = entered.back() - entered.front();
    const double out = left.back() - left.front();
    if (std::abs(out - in) <= tolerance * std::abs(in)) {
        return {};
    }
    return fmt::format("{:.2f} % {} water leaves than enters (tolerance {:.2f} %)",
                       100.0 * std::abs(out - in) / std::max(std::abs(in), 1e-300),
                       out > in ? "more" : "less", 100.0 * tolerance);
}

/// Why the fluctuation does not do, in words; empty where it does.
std::string growth_objection(const Convergence& found) {
    const double least = found.fluctuation_growth - found.fluctuation_growth_half_width;
    if (least > std::log1p(largest_fluctuation_growth)) {
        return fmt::format(
            "the velocity fluctuation has grown {:.2g}-fold over the window: the particles are leaving the "
            "order they started in",
            std::exp(found.fluctuation_growth));
    }
    return {};
}

/// What is known, the mean velocity first.
std::string success_text(const std::vector<Tested>& all, double remaining_drift) {
    const Tested& velocity = all.front();
    std::string text = fmt::format("mean velocity {:.5g} m/s +- {:.2f} % from {:.0f} independent samples",
                                   velocity.mean.mean, 100.0 * velocity.mean.half_width / velocity.scale,
                                   velocity.mean.effective_samples);
    for (auto one = std::next(all.begin()); one != all.end(); ++one) {
        text += fmt::format(", {} {:.5g} {} +- {:.2f} % from {:.0f}", one->name, one->mean.mean, one->unit,
                            100.0 * one->mean.half_width / one->scale, one->mean.effective_samples);
    }
    return text + fmt::format(", drift still to come below {:.2f} %", 100.0 * remaining_drift);
}

Convergence test_window(const SteadinessRecord& record, double start, double relaxation_time,
                        double tolerance) {
    Convergence result;
    result.window_start = start;
    const auto time = record.time;
    const auto first =
        static_cast<std::size_t>(std::lower_bound(time.begin(), time.end(), start) - time.begin());
    const auto window_of = [&](std::span<const double> values) {
        return values.subspan(std::min(first, values.size()));
    };
    const auto window = window_of(record.depth_mean_velocity);
    constexpr std::size_t fewest = 50;
    if (window.size() < fewest || time.back() - start < relaxation_time) {
        result.reason =
            fmt::format("the record after t = {:.3g} s is shorter than one relaxation time ({:.3g} s)", start,
                        relaxation_time);
        return result;
    }
    const double interval = (time.back() - time[first]) / static_cast<double>(window.size() - 1);
    const double of_relaxation = relaxation_time / interval;  // samples
    std::vector<Tested> all{tested("the mean velocity", "m/s", window, of_relaxation)};
    result.mean = all.front().mean;
    if (record.ends) {
        if (!record.ends->mean_level.empty()) {
            all.push_back(tested("the mean level", "m", window_of(record.ends->mean_level), of_relaxation));
        }
        all.push_back(tested("the discharge at the outflow", record.ends->discharge_unit,
                             window_of(record.ends->outflow_discharge), of_relaxation));
        result.reason =
            imbalance(window_of(record.ends->mass_entered), window_of(record.ends->mass_left), tolerance);
    }
    const Tested* worst = &all.front();
    for (const Tested& one : all) {
        result.remaining_drift = std::max(result.remaining_drift, one.remaining_drift);
        if (one.mean.half_width / one.scale > worst->mean.half_width / worst->scale) worst = &one;
    }
    result.least_known = worst->mean;
    find_growth(window_of(record.velocity_fluctuation), result);
    for (const Tested& one : all) {
        const std::string why = objection(one, tolerance);
        if (!why.empty()) {
            result.reason = why;
            break;
        }
    }
    if (result.reason.empty()) result.reason = growth_objection(result);
    if (result.reason.empty()) {
        result.converged = true;
        result.reason = success_text(all, result.remaining_drift);
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
    if (fixed_start >= 0.0) return test_window(record, fixed_start, relaxation_time, tolerance);
    Convergence last;
    for (int multiple = 3;
         multiple == 3 || multiple * relaxation_time <= record.time.back() - relaxation_time; ++multiple) {
        last = test_window(record, multiple * relaxation_time, relaxation_time, tolerance);
        if (last.converged) break;
    }
    return last;
}

double expected_end(const Convergence& test, double time, double relaxation_time, double tolerance,
                    double latest) {
    if (test.converged) return std::min(time, latest);
    double end = std::max(time, std::max(test.window_start, 3.0 * relaxation_time) + relaxation_time);
    const double mean = std::abs(test.least_known.mean);
    const double window = time - test.window_start;
    if (mean > 0.0 && window > 0.0) {
        if (test.remaining_drift > tolerance) {
            end = std::max(end, time + relaxation_time * std::log(test.remaining_drift / tolerance));
        }
        // Not by the half-width, in which Student's t of few samples makes much of what a little more of the
        // record will tell.
        const double samples = std::max(1.0, test.least_known.effective_samples);
        const double width = normal_95 * test.least_known.standard_deviation / (mean * std::sqrt(samples));
        const double longer =
            std::max((width / tolerance) * (width / tolerance), fewest_effective_samples / samples);
        if (longer > 1.0) end = std::max(end, test.window_start + window * longer);
    } else {
        end = std::max(end, usual_relaxation_times * relaxation_time);
    }
    return std::min(end, latest);
}

}  // namespace riffle::inline solver
