#include "statistics/grid_convergence.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

#include "base/error.hpp"
#include "statistics/linear_fit.hpp"

namespace riffle::inline statistics {

namespace {

using Triple = std::array<RefinedValue, 3>;  // finest first

constexpr double safety_factor = 1.25;
constexpr double largest_order = 60.0;

double known(double half_width) { return std::isfinite(half_width) ? half_width : 0.0; }

/// ln of r21^p (r32^p - s)/(r21^p - s), which grows with p; a = ln r21, b = ln r32.
double logarithm_of_ratio(double p, double a, double b, bool oscillating) {
    if (oscillating) return p * a + std::log1p(std::exp(p * b)) - std::log1p(std::exp(p * a));
    return p * a + std::log(std::expm1(p * b) / std::expm1(p * a));
}

/// The order of these three values; nothing where the differences do not diminish or one of them is zero.
std::optional<double> order_of(const Triple& v) {
    const double fine = v[1].value - v[0].value;
    const double coarse = v[2].value - v[1].value;
    if (fine == 0.0 || coarse == 0.0) return std::nullopt;
    const double a = std::log(v[1].size / v[0].size);
    const double b = std::log(v[2].size / v[1].size);
    const bool oscillating = fine * coarse < 0.0;
    const double wanted = std::log(std::abs(coarse / fine));
    // The ratio at vanishing order: what is not above it does not converge.
    if (wanted <= (oscillating ? 0.0 : std::log(b / a))) return std::nullopt;
    double low = 0.0;
    double high = 1.0;
    while (logarithm_of_ratio(high, a, b, oscillating) < wanted) {
        low = high;
        high *= 2.0;
        if (high > largest_order) {
            return std::nullopt;  // the finer difference is nothing but rounding
        }
    }
    for (int i = 0; i < 200 && high - low > 1e-14 * high; ++i) {
        const double middle = 0.5 * (low + high);
        (logarithm_of_ratio(middle, a, b, oscillating) < wanted ? low : high) = middle;
    }
    return 0.5 * (low + high);
}

double limit_of(const Triple& v, double order) {
    return v[0].value + (v[0].value - v[1].value) / std::expm1(order * std::log(v[1].size / v[0].size));
}

/// 95 % half-width of a number that follows from the three values, by linear propagation of their sampling
/// errors; nothing where none of these is known or the number cannot be made near the values.
template <class F>
std::optional<double> propagated(const Triple& v, const F& number) {
    const double scale = std::min(std::abs(v[1].value - v[0].value), std::abs(v[2].value - v[1].value));
    double sum = 0.0;
    bool any = false;
    for (std::size_t i = 0; i < v.size(); ++i) {
        if (!std::isfinite(v[i].half_width)) continue;
        any = true;
        constexpr double small = 1e-4;
        Triple up = v;
        Triple down = v;
        up[i].value += small * scale;
        down[i].value -= small * scale;
        const std::optional<double> above = number(up);
        const std::optional<double> below = number(down);
        if (!above || !below) return std::nullopt;
        const double slope = (*above - *below) / (up[i].value - down[i].value);
        sum += slope * slope * v[i].half_width * v[i].half_width;
    }
    return any ? std::optional(std::sqrt(sum)) : std::nullopt;
}

Triple finest_three(std::span<const RefinedValue> values) {
    std::vector<RefinedValue> sorted(values.begin(), values.end());
    std::sort(sorted.begin(), sorted.end(),
              [](const RefinedValue& a, const RefinedValue& b) { return a.size < b.size; });
    if (sorted.size() < 3) {
        throw InputError(fmt::format("an order of convergence needs three resolutions, but there {} {}",
                                     sorted.size() == 1 ? "is" : "are", sorted.size()));
    }
    for (std::size_t i = 0; i < sorted.size(); ++i) {
        const bool distinct = i == 0 || sorted[i].size > sorted[i - 1].size;
        if (!(sorted[i].size > 0.0) || !std::isfinite(sorted[i].value) || !distinct) {
            throw InputError(fmt::format(
                "an order of convergence needs finite values at different sizes greater than zero, but there "
                "is {:.6g} at the size {:.6g}",
                sorted[i].value, sorted[i].size));
        }
    }
    return {sorted[0], sorted[1], sorted[2]};
}

std::string with_half_width(double value, const std::optional<double>& half_width, const char* format) {
    return fmt::format(fmt::runtime(format), value) +
           (half_width ? fmt::format(" +- {:.2g}", *half_width) : std::string());
}

/// Which of the two differences is within its sampling error, in words; empty where none is.
std::string noise_of(const Triple& v) {
    const auto within = [&](std::size_t i) {
        const double error = std::hypot(known(v[i].half_width), known(v[i + 1].half_width));
        return error > 0.0 && std::abs(v[i + 1].value - v[i].value) <= error;
    };
    const bool fine = within(0);
    const bool coarse = within(1);
    return fine && coarse ? "both differences of the three finest values are"
           : fine         ? "the finer difference of the three finest values is"
           : coarse       ? "the coarser difference of the three finest values is"
                          : "";
}

}  // namespace

GridConvergence grid_convergence(std::span<const RefinedValue> values, const RefinementBounds& bounds) {
    const Triple v = finest_three(values);
    const double fine = v[1].value - v[0].value;
    const double coarse = v[2].value - v[1].value;
    GridConvergence result;
    if (const std::string noise = noise_of(v); !noise.empty()) {
        result.refinement = Refinement::within_noise;
        result.finding = noise + " within the sampling error: no order can be told";
        return result;
    }
    if (fine == 0.0) {
        result.refinement = Refinement::unchanged;
        result.finding = "the two finest values are equal: no order can be told";
        return result;
    }
    result.order = order_of(v);
    if (!result.order) {
        result.refinement = Refinement::diverging;
        result.finding = "not converging: the differences do not diminish";
        return result;
    }
    const auto refuse = [&](const std::string& why) {
        result = {};
        result.refinement = Refinement::not_asymptotic;
        result.finding = "not in the asymptotic range: " + why;
        return result;
    };
    if (*result.order < bounds.lowest_order || *result.order > bounds.highest_order) {
        return refuse(fmt::format(
            "the differences would have an order of {:.2g}, which the method does not have", *result.order));
    }
    if (bounds.magnitude && fine * coarse > 0.0 && limit_of(v, *result.order) < 0.0) {
        return refuse("the limit of a magnitude would be negative");
    }
    result.order_half_width = propagated(v, order_of);
    const std::string order = "order " + with_half_width(*result.order, result.order_half_width, "{:.2f}");
    const double uncertainty =
        safety_factor * std::abs(fine) / std::expm1(*result.order * std::log(v[1].size / v[0].size));
    result.finest_uncertainty = uncertainty;
    if (v[0].value != 0.0) result.fine_grid_index = uncertainty / std::abs(v[0].value);
    if (fine * coarse < 0.0) {
        result.refinement = Refinement::oscillating;
        result.finding = "oscillating, not monotone: no limit is extrapolated (" + order + " by magnitude)";
        return result;
    }
    result.refinement = Refinement::monotone;
    result.limit = limit_of(v, *result.order);
    result.limit_half_width = propagated(v, [](const Triple& w) -> std::optional<double> {
        const std::optional<double> p = order_of(w);
        return p ? std::optional(limit_of(w, *p)) : std::nullopt;
    });
    result.finding = "monotone, " + order;
    return result;
}

std::optional<PowerLaw> fit_power_law(std::span<const RefinedValue> values) {
    const auto count = static_cast<Eigen::Index>(values.size());
    if (count < 2) return std::nullopt;
    Eigen::MatrixXd basis(count, 2);
    Eigen::VectorXd logarithms(count);
    for (Eigen::Index i = 0; i < count; ++i) {
        const RefinedValue& v = values[static_cast<std::size_t>(i)];
        if (!(v.size > 0.0) || v.value == 0.0 || !std::isfinite(v.value)) return std::nullopt;
        basis(i, 0) = 1.0;
        basis(i, 1) = std::log(v.size);
        logarithms(i) = std::log(std::abs(v.value));
    }
    if (count == 2) {
        const double span = basis(1, 1) - basis(0, 1);
        if (span == 0.0) return std::nullopt;
        const double exponent = (logarithms(1) - logarithms(0)) / span;
        return PowerLaw{exponent, std::exp(logarithms(0) - exponent * basis(0, 1)), std::nullopt};
    }
    const std::optional<LinearFit> fit = fit_linear(basis, logarithms);
    if (!fit) return std::nullopt;
    const FittedValue exponent = coefficient(*fit, 1);
    return PowerLaw{exponent.value, std::exp(fit->coefficients(0)), exponent.half_width};
}

const char* word(Refinement refinement) {
    switch (refinement) {
        case Refinement::monotone:
            return "monotone";
        case Refinement::oscillating:
            return "oscillating";
        case Refinement::diverging:
            return "diverging";
        case Refinement::not_asymptotic:
            return "not-asymptotic";
        case Refinement::within_noise:
            return "within-noise";
        case Refinement::unchanged:
            break;
    }
    return "unchanged";
}

}  // namespace riffle::inline statistics
