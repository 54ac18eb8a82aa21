#include "damped_wave.hpp"

#include <cmath>
#include <complex>

#include <Eigen/Dense>

namespace riffle::verification {

DampedWave fit_damped_wave(const std::vector<double>& time, const std::vector<double>& value,
                           DampedWave guess) {
    const auto n = static_cast<Eigen::Index>(time.size());
    const Eigen::Map<const Eigen::VectorXd> x(value.data(), n);
    DampedWave wave = guess;
    Eigen::Vector2d amplitude = Eigen::Vector2d::Zero();
    for (int iteration = 0; iteration < 50; ++iteration) {
        Eigen::MatrixXd basis(n, 2);
        for (Eigen::Index i = 0; i < n; ++i) {
            const double t = time[static_cast<std::size_t>(i)];
            basis(i, 0) = std::exp(-wave.decay * t) * std::cos(wave.frequency * t);
            basis(i, 1) = std::exp(-wave.decay * t) * std::sin(wave.frequency * t);
        }
        amplitude = basis.colPivHouseholderQr().solve(x);
        Eigen::MatrixXd jacobian(n, 4);
        jacobian.leftCols(2) = basis;
        for (Eigen::Index i = 0; i < n; ++i) {
            const double t = time[static_cast<std::size_t>(i)];
            jacobian(i, 2) = -t * (basis.row(i) * amplitude).value();
            jacobian(i, 3) = t * (amplitude[1] * basis(i, 0) - amplitude[0] * basis(i, 1));
        }
        const Eigen::VectorXd residual = x - basis * amplitude;
        const Eigen::VectorXd step = jacobian.colPivHouseholderQr().solve(residual);
        wave.decay += step[2];
        wave.frequency += step[3];
    }
    return wave;
}

DampedWave viscous_wave(double gravity, double k, double depth, double nu, SurfaceCondition condition) {
    using Complex = std::complex<double>;
    const double n = condition == SurfaceCondition::zero_traction ? 2.0 : 1.0;
    const double square = gravity * k * std::tanh(k * depth);
    const auto residual = [&](Complex s) {
        const Complex m = std::sqrt(k * k + s / nu);
        const Complex sum = s + n * nu * k * k;
        return sum * sum + square -
               n * n * nu * nu * k * k * k * m * std::tanh(k * depth) / std::tanh(m * depth);
    };
    // Secant steps from the inviscid root.
    Complex before(-0.9 * n * nu * k * k, std::sqrt(square));
    Complex s(-n * nu * k * k, std::sqrt(square));
    for (int iteration = 0; iteration < 50 && std::abs(s - before) > 1e-13 * std::abs(s); ++iteration) {
        const Complex value = residual(s);
        const Complex next = s - value * (s - before) / (value - residual(before));
        before = s;
        s = next;
    }
    return {.frequency = s.imag(), .decay = -s.real()};
}

}  // namespace riffle::verification
