#pragma once

#include <optional>
#include <span>

#include "statistics/linear_fit.hpp"

namespace riffle::inline statistics {

/// A fitted offset + exp(-decay t) (cosine cos(frequency t) + sine sin(frequency t)).
struct DampedOscillation {
    FittedValue frequency;  ///< rad/s
    FittedValue decay;      ///< 1/s
    double cosine = 0.0;
    double sine = 0.0;
    double offset = 0.0;
    double residual_rms = 0.0;

    [[nodiscard]] double at(double time) const;
};

/// Least-squares fit to samples at these times, with amplitudes and offset eliminated (variable projection).
/// `frequency` (rad/s) and `decay` (1/s) are guesses; the frequency is looked for within a factor of 1.5 of
/// its guess. The intervals take the residuals as independent. Nothing where the record is shorter than one
/// period of the guess, or does not determine the numbers. Throws InputError where the sizes differ.
[[nodiscard]] std::optional<DampedOscillation> fit_damped_oscillation(std::span<const double> time,
                                                                      std::span<const double> values,
                                                                      double frequency, double decay);

}  // namespace riffle::inline statistics
