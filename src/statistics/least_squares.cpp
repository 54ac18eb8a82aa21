#include "statistics/least_squares.hpp"

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>
#include <vector>

#include "base/error.hpp"

namespace riffle::inline statistics {

namespace {

std::optional<Eigen::VectorXd> finite_residuals(const ResidualFunction& residuals,
                                                const Eigen::VectorXd& parameters) {
    std::optional<Eigen::VectorXd> r = residuals(parameters);
    if (r && !r->allFinite()) r.reset();
    return r;
}

/// Jacobian by central differences; none where a residual is not defined beside the point.
std::optional<Eigen::MatrixXd> central_differences(const ResidualFunction& residuals,
                                                   const Eigen::VectorXd& parameters, Eigen::Index rows,
                                                   double relative_step) {
    static const double smallest_step = std::sqrt(std::numeric_limits<double>::epsilon());
    Eigen::MatrixXd jacobian(rows, parameters.size());
    for (Eigen::Index j = 0; j < parameters.size(); ++j) {
        const double step = std::max(smallest_step, relative_step * std::abs(parameters(j)));
        Eigen::VectorXd beside = parameters;
        beside(j) = parameters(j) + step;
        const auto above = finite_residuals(residuals, beside);
        beside(j) = parameters(j) - step;
        const auto below = finite_residuals(residuals, beside);
        if (!above || !below) return std::nullopt;
        jacobian.col(j) = (*above - *below) / (2.0 * step);
    }
    return jacobian;
}

/// The damping of Nielsen: falls with the quality of accepted steps, rises ever faster with rejected ones.
class Damping {
  public:
    [[nodiscard]] double value() const { return value_; }

    void accept(double gain_ratio) {
        const double cube = std::pow(2.0 * gain_ratio - 1.0, 3);
        value_ = std::max(smallest, value_ * std::max(1.0 / 3.0, 1.0 - cube));
        growth_ = 2.0;
    }

    void reject() {
        value_ *= growth_;
        growth_ *= 2.0;
    }

  private:
    static constexpr double smallest = 1e-16;
    double value_ = 1e-4;
    double growth_ = 2.0;
};

/// Parameters that may move: not at a bound with the descent pointing outwards, and with an effect that the
/// residuals leave something of.
std::vector<Eigen::Index> free_parameters(const LeastSquaresFit& at, const Eigen::VectorXd& lower,
                                          const Eigen::VectorXd& upper, double gradient_tolerance) {
    const Eigen::VectorXd gradient = at.jacobian.transpose() * at.residuals;
    std::vector<Eigen::Index> free;
    bool stationary = true;
    for (Eigen::Index j = 0; j < gradient.size(); ++j) {
        if (at.parameters(j) <= lower(j) && gradient(j) >= 0.0) continue;
        if (at.parameters(j) >= upper(j) && gradient(j) <= 0.0) continue;
        free.push_back(j);
        const double scale = at.jacobian.col(j).norm() * at.residuals.norm();
        if (std::abs(gradient(j)) > gradient_tolerance * scale) stationary = false;
    }
    if (stationary) free.clear();
    return free;
}

/// The point a step s of the free parameters away that minimises |J s + r|^2 + damping |D s|^2, D the norms
/// of J's columns; the step is cut at the bounds.
Eigen::VectorXd trial_point(const LeastSquaresFit& at, const std::vector<Eigen::Index>& free, double damping,
                            const Eigen::VectorXd& lower, const Eigen::VectorXd& upper) {
    const Eigen::Index rows = at.residuals.size();
    const auto unknowns = static_cast<Eigen::Index>(free.size());
    const double largest_norm = at.jacobian.colwise().norm().maxCoeff();
    constexpr double smallest_ratio = 1e-12;  // keeps a parameter without effect where it is
    Eigen::MatrixXd matrix = Eigen::MatrixXd::Zero(rows + unknowns, unknowns);
    Eigen::VectorXd right = Eigen::VectorXd::Zero(rows + unknowns);
    right.head(rows) = -at.residuals;
    for (Eigen::Index k = 0; k < unknowns; ++k) {
        const auto column = at.jacobian.col(free[static_cast<std::size_t>(k)]);
        matrix.col(k).head(rows) = column;
        matrix(rows + k, k) = std::sqrt(damping) * std::max(column.norm(), smallest_ratio * largest_norm);
    }
    const Eigen::VectorXd solution = matrix.colPivHouseholderQr().solve(right);
    Eigen::VectorXd trial = at.parameters;
    for (Eigen::Index k = 0; k < unknowns; ++k) trial(free[static_cast<std::size_t>(k)]) += solution(k);
    return trial.cwiseMax(lower).cwiseMin(upper);
}

void require_start_in_range(const Eigen::VectorXd& start, const Eigen::VectorXd& lower,
                            const Eigen::VectorXd& upper) {
    if (start.size() == 0 || start.size() != lower.size() || start.size() != upper.size()) {
        throw InputError("least squares: start and bounds must have one value for each parameter");
    }
    if (!(start.array() >= lower.array()).all() || !(start.array() <= upper.array()).all()) {
        throw InputError("least squares: the start lies outside of its bounds");
    }
}

enum class Outcome { moved, minimum, stuck };

/// One accepted step, or the reason why there is none. Fails to `stuck` where only undefined residuals stop
/// it.
Outcome advance(const ResidualFunction& residuals, const Eigen::VectorXd& lower, const Eigen::VectorXd& upper,
                const LeastSquaresOptions& options, Damping& damping, LeastSquaresFit& at) {
    const std::vector<Eigen::Index> free = free_parameters(at, lower, upper, options.gradient_tolerance);
    if (free.empty()) return Outcome::minimum;
    const double sum = at.residuals.squaredNorm();
    const double smallest_step =
        options.parameter_tolerance * (at.parameters.norm() + options.parameter_tolerance);
    bool defined = true;
    for (;;) {
        const Eigen::VectorXd point = trial_point(at, free, damping.value(), lower, upper);
        const Eigen::VectorXd step = point - at.parameters;
        if (!(step.norm() > smallest_step)) return defined ? Outcome::minimum : Outcome::stuck;
        const auto trial = finite_residuals(residuals, point);
        defined = trial.has_value();
        // A step cut at a bound may lead upwards in the linear model: then it is too long as well.
        const double predicted = sum - (at.residuals + at.jacobian * step).squaredNorm();
        const double change = defined ? sum - trial->squaredNorm() : 0.0;
        if (defined && predicted > 0.0 && change > 0.0) {
            at.parameters = point;
            at.residuals = *trial;
            damping.accept(change / predicted);
            return std::max(change, predicted) <= options.function_tolerance * sum ? Outcome::minimum
                                                                                   : Outcome::moved;
        }
        if (defined && std::max(std::abs(change), std::abs(predicted)) <= options.function_tolerance * sum) {
            return Outcome::minimum;
        }
        damping.reject();
    }
}

}  // namespace

std::optional<LeastSquaresFit> minimise_least_squares(const ResidualFunction& residuals,
                                                      const Eigen::VectorXd& start,
                                                      const Eigen::VectorXd& lower,
                                                      const Eigen::VectorXd& upper,
                                                      const LeastSquaresOptions& options) {
    require_start_in_range(start, lower, upper);
    const auto first = finite_residuals(residuals, start);
    if (!first) return std::nullopt;
    LeastSquaresFit at;
    at.parameters = start;
    at.residuals = *first;
    Damping damping;
    Outcome outcome = Outcome::moved;
    for (int iteration = 0;; ++iteration) {
        auto jacobian =
            central_differences(residuals, at.parameters, at.residuals.size(), options.difference_step);
        if (!jacobian) return std::nullopt;
        at.jacobian = std::move(*jacobian);
        if (outcome != Outcome::moved || iteration == options.max_iterations) break;
        outcome = advance(residuals, lower, upper, options, damping, at);
    }
    at.converged = outcome == Outcome::minimum;
    return at;
}

std::optional<Eigen::MatrixXd> parameter_covariance(const Eigen::MatrixXd& jacobian) {
    const Eigen::JacobiSVD<Eigen::MatrixXd> svd(jacobian, Eigen::ComputeThinU | Eigen::ComputeThinV);
    const Eigen::VectorXd& s = svd.singularValues();
    constexpr double smallest_ratio = 1e-6;
    if (!(s(s.size() - 1) > smallest_ratio * s(0))) return std::nullopt;
    const Eigen::MatrixXd& v = svd.matrixV();
    return v * s.array().square().inverse().matrix().asDiagonal() * v.transpose();
}

}  // namespace riffle::inline statistics
