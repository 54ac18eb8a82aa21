#pragma once

#include <vector>

#include "check_run.hpp"

namespace riffle::verification {

/// Velocities on the centre lines of a lid-driven cavity, positions over the edge and velocities over the
/// lid's.
struct CentreLines {
    std::vector<double> z;  ///< on x = 1/2
    std::vector<double> u;
    std::vector<double> x;  ///< on z = 1/2
    std::vector<double> w;
};

/// Tables I and II of Ghia, Ghia & Shin (1982).
[[nodiscard]] CentreLines ghia_reynolds_100();
[[nodiscard]] CentreLines ghia_reynolds_1000();

/// Run a cavity to `time` and compare its velocities, averaged over the last `span` seconds, with tabulated
/// ones: the largest difference over both lines, over the lid's velocity. At each point a linear fit to the
/// particles within two smoothing lengths, weighted by the kernel.
[[nodiscard]] double cavity_error(CheckRun& run, const CentreLines& lines, double time, double span);

}  // namespace riffle::verification
