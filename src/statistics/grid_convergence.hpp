#pragma once

#include <limits>
#include <optional>
#include <span>
#include <string>

namespace riffle::inline statistics {

/// A result at one resolution.
struct RefinedValue {
    double size = 0.0;  ///< of the grid, the spacing or the step; finer is smaller
    double value = 0.0;
    /// Half-width of the 95 % interval of the value, its sampling error; not-a-number where it is not known.
    double half_width = std::numeric_limits<double>::quiet_NaN();
};

/// How a result changes from the coarsest to the finest of three resolutions.
enum class Refinement {
    monotone,        ///< the same way both times, the second time less: converging
    oscillating,     ///< one way, then less far back: no extrapolation
    diverging,       ///< the second change is not the smaller one: no order, no limit
    not_asymptotic,  ///< an order, or a limit, that the method cannot have: the sizes are not fine enough to
                     ///< tell
    within_noise,    ///< a change is within the sampling error: nothing can be told
    unchanged,       ///< the two finest values agree exactly: no order
};

/// What three resolutions tell about the limit of ever finer ones.
struct GridConvergence {
    Refinement refinement = Refinement::within_noise;
    std::optional<double> order;  ///< observed order of convergence p; nothing where not asymptotic
    std::optional<double> order_half_width;    ///< 95 %, from the sampling errors, where they are known
    std::optional<double> limit;               ///< Richardson's extrapolation to size zero; monotone only
    std::optional<double> limit_half_width;    ///< 95 %, from the sampling errors, where they are known
    std::optional<double> fine_grid_index;     ///< grid convergence index of the finest value, over it
    std::optional<double> finest_uncertainty;  ///< the same in the unit of the value
    std::string finding;                       ///< in words, for a table
};

/// What is known of a result before it is refined.
struct RefinementBounds {
    double lowest_order = 0.0;  ///< observed orders outside are not asymptotic: about half the formal order
    double highest_order = std::numeric_limits<double>::infinity();  ///< and about twice
    bool magnitude = false;  ///< the result cannot be negative, nor can its limit
};

/// Observed order, Richardson's extrapolation and grid convergence index of the three finest of the values,
/// for refinement ratios that need not be equal: I.B. Celik et al. 2008, Procedure for estimation and
/// reporting of uncertainty due to discretization in CFD applications, ASME J. Fluids Eng. 130(7), 078001,
/// with its safety factor of 1.25. With r21 = h2/h1, r32 = h3/h2 (1 the finest), p solves
///
///   |e32/e21| = r21^p (r32^p - s) / (r21^p - s),   s = sign(e32/e21),  e32 = v3 - v2,  e21 = v2 - v1.
///
/// The procedure takes the absolute value of a negative p; here differences that do not diminish are said to
/// diverge. Nothing is concluded from differences within their sampling error, nor from an order or a limit
/// outside of `bounds`: chance and cancelling errors make such, and Richardson's extrapolation then has no
/// ground (L. Eca & M. Hoekstra 2014, J. Comput. Phys. 262, 104-130, accept half to about once the formal
/// order). Throws InputError for less than three values, equal or negative sizes, values that are not finite.
[[nodiscard]] GridConvergence grid_convergence(std::span<const RefinedValue> values,
                                               const RefinementBounds& bounds = {});

/// Exponent p of |value| = C size^p by least squares of the logarithms: the order of a departure that should
/// vanish, the growth of a cost (then negative).
struct PowerLaw {
    double exponent = 0.0;
    double factor = 0.0;
    std::optional<double> half_width;  ///< of the exponent, 95 %, from the scatter about the line; from three
                                       ///< values on
};

/// Nothing for less than two sizes, or where a value is zero or not finite.
[[nodiscard]] std::optional<PowerLaw> fit_power_law(std::span<const RefinedValue> values);

/// The word of it for files: "monotone", "within-noise".
[[nodiscard]] const char* word(Refinement refinement);

}  // namespace riffle::inline statistics
