#include "statistics/separable_fit.hpp"

#include <Eigen/Dense>
#include <algorithm>
#include <boost/math/tools/minima.hpp>
#include <cmath>
#include <cstddef>
#include <limits>
#include <utility>

#include "base/error.hpp"
#include "statistics/root.hpp"

namespace riffle::inline statistics {

namespace {
constexpr double infinite = std::numeric_limits<double>::infinity();
}  // namespace

SeparableFit::SeparableFit(Basis basis, Eigen::VectorXd values, Eigen::VectorXd uncertainty, double first,
                           double last, int steps)
    : basis_(std::move(basis)),
      values_(std::move(values)),
      uncertainty_(std::move(uncertainty)),
      step_((last - first) / steps) {
    if (!(first < last) || steps < 2) throw InputError("separable fit: the range of the parameter is empty");
    std::size_t lowest = 0;
    for (int i = 0; i <= steps; ++i) {
        const double p = i == steps ? last : first + i * step_;
        scan_.push_back({p, sum_at(p)});
        if (scan_.back().sum_of_squares < scan_[lowest].sum_of_squares) lowest = scan_.size() - 1;
    }
    if (!std::isfinite(scan_[lowest].sum_of_squares)) return;
    at_the_edge_ = lowest == 0 || lowest + 1 == scan_.size();
    if (at_the_edge_) return;
    refine(lowest);
    if (!best_) return;
    bound_parameter();
    propagate();
}

std::optional<LinearFit> SeparableFit::fit_at(double parameter) const {
    auto fit = fit_linear(basis_(parameter), values_, uncertainty_);
    if (!fit || fit->freedom < 2) return std::nullopt;
    --fit->freedom;
    return fit;
}

double SeparableFit::sum_at(double parameter) const {
    const auto fit = fit_at(parameter);
    if (!fit) return infinite;
    return fit->sum_of_squares;
}

void SeparableFit::refine(std::size_t lowest) {
    constexpr int bits = 40;
    const auto minimum =
        boost::math::tools::brent_find_minima([this](double p) { return sum_at(p); },
                                              scan_[lowest - 1].parameter, scan_[lowest + 1].parameter, bits);
    best_parameter_ = minimum.first;
    best_ = fit_at(best_parameter_);
    if (best_ && best_->sum_of_squares > scan_[lowest].sum_of_squares) {
        best_parameter_ = scan_[lowest].parameter;
        best_ = fit_at(best_parameter_);
    }
}

double SeparableFit::crossing(double inside, double outside) const {
    const auto excess = [this](double p) {
        const double sum = sum_at(p);
        return std::isfinite(sum) ? sum - limit_ : std::numeric_limits<double>::max();
    };
    if (!(excess(outside) > 0.0)) return outside;
    if (!(excess(inside) < 0.0)) return inside;
    constexpr unsigned bits = 30;
    return root_between(excess, inside, outside, bits);
}

void SeparableFit::bound_parameter() {
    const double t = student_quantile(best_->freedom);
    limit_ = best_->sum_of_squares * (1.0 + t * t / static_cast<double>(best_->freedom));
    // The outermost scanned values within the limit, so that a second valley belongs to the interval.
    const auto within = [this](const Candidate& c) { return c.sum_of_squares <= limit_; };
    const auto first = std::find_if(scan_.begin(), scan_.end(), within);
    const auto last = std::find_if(scan_.rbegin(), scan_.rend(), within);
    const double lowest =
        first == scan_.end() ? best_parameter_ : std::min(first->parameter, best_parameter_);
    const double highest =
        last == scan_.rend() ? best_parameter_ : std::max(last->parameter, best_parameter_);
    const double begin = scan_.front().parameter;
    const double end = scan_.back().parameter;
    searched_.lower = lowest > begin ? crossing(lowest, std::max(begin, lowest - step_)) : begin;
    searched_.upper = highest < end ? crossing(highest, std::min(end, highest + step_)) : end;
    parameter_interval_ = {};  // open on both sides
    if (lowest > begin) parameter_interval_.lower = searched_.lower;
    if (highest < end) parameter_interval_.upper = searched_.upper;
}

void SeparableFit::propagate() {
    const double h = 1e-3 * step_;
    const Eigen::MatrixXd basis = basis_(best_parameter_);
    const Eigen::Index n = basis.cols();
    Eigen::MatrixXd jacobian(basis.rows(), n + 1);
    jacobian.leftCols(n) = basis;
    jacobian.col(n) =
        (basis_(best_parameter_ + h) - basis_(best_parameter_ - h)) * best_->coefficients / (2.0 * h);
    // The covariance does not depend on the values that are fitted.
    const auto all = fit_linear(jacobian, values_, uncertainty_);
    full_covariance_ = all ? all->covariance : Eigen::MatrixXd::Constant(n + 1, n + 1, infinite);
}

double SeparableFit::half_width(const Eigen::VectorXd& gradient) const {
    if (!full_covariance_.allFinite()) return infinite;
    const double variance = best_->sum_of_squares / static_cast<double>(best_->freedom);
    return student_quantile(best_->freedom) * std::sqrt(variance * gradient.dot(full_covariance_ * gradient));
}

Interval SeparableFit::extremes(const Range& range) const {
    // For each parameter the coefficients may leave the best ones by what the limit has left over.
    const auto at = [&](double p) -> Interval {
        const auto fit = fit_at(p);
        if (!fit || fit->sum_of_squares > limit_) return {infinite, -infinite};
        return range(*fit, limit_ - fit->sum_of_squares);
    };
    constexpr int steps = 40;
    const double first = searched_.lower;
    const double step = (searched_.upper - first) / steps;
    Interval result = at(best_parameter_);
    double lower_at = best_parameter_;
    double upper_at = best_parameter_;
    for (int i = 0; i <= steps; ++i) {
        const double p = i == steps ? searched_.upper : first + i * step;
        const Interval here = at(p);
        if (here.lower < result.lower) {
            result.lower = here.lower;
            lower_at = p;
        }
        if (here.upper > result.upper) {
            result.upper = here.upper;
            upper_at = p;
        }
    }
    constexpr int bits = 20;
    const auto refined = [&](double centre, auto value) {
        const double from = std::max(first, centre - step);
        const double to = std::min(searched_.upper, centre + step);
        return boost::math::tools::brent_find_minima(value, from, to, bits).second;
    };
    if (step > 0.0 && std::isfinite(result.lower)) {
        result.lower = std::min(result.lower, refined(lower_at, [&](double p) { return at(p).lower; }));
    }
    if (step > 0.0 && std::isfinite(result.upper)) {
        result.upper = std::max(result.upper, -refined(upper_at, [&](double p) { return -at(p).upper; }));
    }
    // An extreme where the scan ended, and not the limit: beyond may be more.
    const auto open = [this](double p) {
        return (p == searched_.lower && std::isinf(parameter_interval_.lower)) ||
               (p == searched_.upper && std::isinf(parameter_interval_.upper));
    };
    if (open(lower_at)) result.lower = -infinite;
    if (open(upper_at)) result.upper = infinite;
    return result;
}

FittedValue SeparableFit::parameter() const {
    const Eigen::Index n = best_->coefficients.size();
    return {best_parameter_, half_width(Eigen::VectorXd::Unit(n + 1, n)), parameter_interval_};
}

FittedValue SeparableFit::coefficient(Eigen::Index i) const {
    return {best_->coefficients(i), half_width(Eigen::VectorXd::Unit(best_->coefficients.size() + 1, i)),
            extremes([i](const LinearFit& fit, double excess) { return coefficient_range(fit, i, excess); })};
}

FittedValue SeparableFit::coefficient_ratio(Eigen::Index numerator, Eigen::Index denominator) const {
    const double value = best_->coefficients(numerator) / best_->coefficients(denominator);
    Eigen::VectorXd gradient = Eigen::VectorXd::Zero(best_->coefficients.size() + 1);
    gradient(numerator) = 1.0 / best_->coefficients(denominator);
    gradient(denominator) = -value / best_->coefficients(denominator);
    return {value, half_width(gradient), extremes([=](const LinearFit& fit, double excess) {
                return ratio_range(fit, numerator, denominator, excess);
            })};
}

}  // namespace riffle::inline statistics
