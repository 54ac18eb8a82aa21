#pragma once

#include <vector>

namespace riffle::verification {

/// A damped oscillation exp(-decay t) (a cos(frequency t) + b sin(frequency t)).
struct DampedWave {
    double frequency = 0.0;  ///< rad/s
    double decay = 0.0;      ///< 1/s
};

/// Least-squares fit (Gauss-Newton) to samples (t, x), from a guess.
[[nodiscard]] DampedWave fit_damped_wave(const std::vector<double>& time, const std::vector<double>& value,
                                         DampedWave guess);

/// What the surface of the water is free of.
enum class SurfaceCondition {
    zero_traction,           ///< of the stress 2 nu S: the condition of nature
    zero_velocity_gradient,  ///< of nu grad u: the natural condition of a Laplacian viscosity
};

/// Exact linear standing wave of wavenumber k on viscous water of depth H over a slip bed: the root s =
/// -decay + i frequency of
///   (s + n nu k^2)^2 + g k tanh kH = n^2 nu^2 k^3 m tanh(kH)/tanh(mH),  m^2 = k^2 + s/nu,
/// with n = 2 for zero traction (Lamb 1932, art. 349, here of finite depth) and n = 1 for zero velocity
/// gradient. Both follow from a potential and a vortical part that meet the tangential, kinematic and normal
/// conditions; to first order in nu the decay is n nu k^2.
[[nodiscard]] DampedWave viscous_wave(double gravity, double wavenumber, double depth, double viscosity,
                                      SurfaceCondition condition);

}  // namespace riffle::verification
