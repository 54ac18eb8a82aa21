#include "statistics/damped_oscillation.hpp"

#include <Eigen/QR>
#include <cmath>
#include <limits>
#include <numbers>

#include "base/error.hpp"
#include "statistics/least_squares.hpp"

namespace riffle::inline statistics {

namespace {

/// Columns 1, exp(-decay t) cos(frequency t), exp(-decay t) sin(frequency t).
Eigen::MatrixXd basis_of(std::span<const double> time, double frequency, double decay) {
    Eigen::MatrixXd basis(static_cast<Eigen::Index>(time.size()), 3);
    for (std::size_t i = 0; i < time.size(); ++i) {
        const double t = time[i] - time.front();
        const double size = std::exp(-decay * t);
        basis.row(static_cast<Eigen::Index>(i)) << 1.0, size * std::cos(frequency * t),
            size * std::sin(frequency * t);
    }
    return basis;
}

}  // namespace

double DampedOscillation::at(double time) const {
    return offset + std::exp(-decay.value * time) *
                        (cosine * std::cos(frequency.value * time) + sine * std::sin(frequency.value * time));
}

std::optional<DampedOscillation> fit_damped_oscillation(std::span<const double> time,
                                                        std::span<const double> values, double frequency,
                                                        double decay) {
    if (time.size() != values.size()) throw InputError("a damped oscillation needs a time for each value");
    constexpr std::size_t fewest = 12;
    if (time.size() < fewest || !(frequency > 0.0)) return std::nullopt;
    const double length = time.back() - time.front();
    if (length * frequency < 2.0 * std::numbers::pi) return std::nullopt;
    const Eigen::Map<const Eigen::VectorXd> data(values.data(), static_cast<Eigen::Index>(values.size()));
    // Parameters of order 1: the frequency over its guess, and the decay over the record plus one.
    const auto frequency_of = [&](const Eigen::VectorXd& p) { return p[0] * frequency; };
    const auto decay_of = [&](const Eigen::VectorXd& p) { return (p[1] - 1.0) / length; };
    const auto residuals = [&](const Eigen::VectorXd& p) -> std::optional<Eigen::VectorXd> {
        const Eigen::MatrixXd basis = basis_of(time, frequency_of(p), decay_of(p));
        if (!basis.allFinite()) return std::nullopt;
        return data - basis * basis.colPivHouseholderQr().solve(data);
    };
    constexpr double factor = 1.5;
    constexpr double most_folds = 60.0;
    // Scanned first: the sum of squares has a minimum for each whole period more or less.
    Eigen::VectorXd best(2);
    double least = std::numeric_limits<double>::infinity();
    const int steps = static_cast<int>(std::ceil(4.0 * length * frequency * (factor - 1.0 / factor)));
    for (int i = 0; i <= steps; ++i) {
        Eigen::VectorXd p(2);
        p << 1.0 / factor + (factor - 1.0 / factor) * i / steps, 1.0 + decay * length;
        const auto r = residuals(p);
        if (r && r->squaredNorm() < least) {
            least = r->squaredNorm();
            best = p;
        }
    }
    if (!std::isfinite(least)) return std::nullopt;
    const Eigen::Vector2d lower(1.0 / factor, 1.0 - most_folds);
    const Eigen::Vector2d upper(factor, 1.0 + most_folds);
    best = best.cwiseMax(lower).cwiseMin(upper);
    const auto fit = minimise_least_squares(residuals, best, lower, upper);
    if (!fit) return std::nullopt;
    const auto covariance = parameter_covariance(fit->jacobian);
    if (!covariance) return std::nullopt;
    DampedOscillation result;
    constexpr Eigen::Index unknowns = 5;
    const Eigen::Index freedom = data.size() - unknowns;
    const double variance = fit->residuals.squaredNorm() / static_cast<double>(freedom);
    const double quantile = student_quantile(freedom);
    const auto fitted = [&](Eigen::Index i, double value, double scale) {
        const double half = quantile * scale * std::sqrt(variance * (*covariance)(i, i));
        return FittedValue{value, half, {value - half, value + half}};
    };
    result.frequency = fitted(0, frequency_of(fit->parameters), frequency);
    result.decay = fitted(1, decay_of(fit->parameters), 1.0 / length);
    const Eigen::MatrixXd basis = basis_of(time, result.frequency.value, result.decay.value);
    const Eigen::VectorXd amplitudes = basis.colPivHouseholderQr().solve(data);
    result.offset = amplitudes[0];
    // The fit counts time from the first sample: turn and scale the amplitudes to t = 0.
    const double size = std::exp(result.decay.value * time.front());
    const double turn = result.frequency.value * time.front();
    result.cosine = size * (amplitudes[1] * std::cos(turn) - amplitudes[2] * std::sin(turn));
    result.sine = size * (amplitudes[1] * std::sin(turn) + amplitudes[2] * std::cos(turn));
    result.residual_rms = std::sqrt(fit->residuals.squaredNorm() / static_cast<double>(data.size()));
    return result;
}

}  // namespace riffle::inline statistics
