#pragma once

#include "check_run.hpp"

namespace riffle::verification {

/// Flow between plates `width` apart, started from rest by the acceleration `force` (Morris, Fox & Zhu 1997,
/// eq. 22).
[[nodiscard]] double start_up_poiseuille(double force, double nu, double width, double z, double t);

/// Amplitude of the Taylor-Green vortices of a run, m/s: projection of the velocity on them.
[[nodiscard]] double vortex_amplitude(const CheckRun& run);

}  // namespace riffle::verification
