#pragma once

#include <Eigen/Core>
#include <functional>
#include <optional>
#include <vector>

#include "statistics/linear_fit.hpp"

namespace riffle::inline statistics {

/// Least-squares fit of a model with one nonlinear parameter p and linear coefficients c,
/// values = basis(p) c + noise, by elimination of the coefficients (Golub & Pereyra 1973, SIAM J. Numer.
/// Anal. 10:413): the sum of squares, minimised over c, is a function of p alone. It is scanned over the
/// whole range, so that a second minimum is not missed, and refined.
///
/// The 95 % interval of each number is the profile of the sum of squares: the values for which the sum,
/// minimised over all other unknowns, stays below its minimum times 1 + t^2/freedom. It holds 95 % also where
/// the linear propagation does not, and is infinite on a side where the range scanned ends first.
class SeparableFit {
  public:
    using Basis = std::function<Eigen::MatrixXd(double parameter)>;

    /// `uncertainty` as for fit_linear; the parameter is looked for from `first` to `last` at `steps` + 1
    /// evenly spaced values and between them. Throws InputError unless first < last and steps >= 2.
    SeparableFit(Basis basis, Eigen::VectorXd values, Eigen::VectorXd uncertainty, double first, double last,
                 int steps = 120);

    /// Whether there is a fit at all, with its best parameter inside of the range scanned.
    [[nodiscard]] bool determined() const { return best_.has_value() && !at_the_edge_; }

    /// Whether the least sum of squares lies at an end of the range.
    [[nodiscard]] bool at_the_edge() const { return at_the_edge_; }

    /// The coefficients at the best parameter; `freedom` counts the parameter. Call only if determined().
    [[nodiscard]] const LinearFit& linear() const { return *best_; }

    /// The nonlinear parameter, coefficient `i`, and the ratio of two coefficients. Only if determined().
    [[nodiscard]] FittedValue parameter() const;
    [[nodiscard]] FittedValue coefficient(Eigen::Index i) const;
    [[nodiscard]] FittedValue coefficient_ratio(Eigen::Index numerator, Eigen::Index denominator) const;

  private:
    struct Candidate {
        double parameter = 0;
        double sum_of_squares = 0;
    };
    using Range = std::function<Interval(const LinearFit& fit, double excess)>;

    [[nodiscard]] std::optional<LinearFit> fit_at(double parameter) const;
    [[nodiscard]] double sum_at(double parameter) const;
    void refine(std::size_t lowest);
    void bound_parameter();
    void propagate();
    [[nodiscard]] double crossing(double inside, double outside) const;
    [[nodiscard]] Interval extremes(const Range& range) const;
    [[nodiscard]] double half_width(const Eigen::VectorXd& gradient) const;

    Basis basis_;
    Eigen::VectorXd values_, uncertainty_;
    double step_;
    std::vector<Candidate> scan_;
    bool at_the_edge_ = false;
    double best_parameter_ = 0;
    std::optional<LinearFit> best_;
    double limit_ = 0;                 ///< of the sum of squares, for 95 %
    Interval parameter_interval_;      ///< with infinite ends where the scan ended
    Interval searched_;                ///< the same with finite ends
    Eigen::MatrixXd full_covariance_;  ///< of coefficients and parameter (last), for unit variance
};

}  // namespace riffle::inline statistics
