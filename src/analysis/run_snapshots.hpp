#pragma once

#include <array>
#include <cstddef>
#include <vector>

#include "analysis/eddies_and_noise.hpp"
#include "analysis/flow_record.hpp"
#include "case/case.hpp"
#include "record/run_results.hpp"

namespace riffle::inline analysis {

/// The three components of an (N, 3) dataset, each an array of its own.
[[nodiscard]] std::array<std::vector<double>, 3> components(const std::vector<double>& rows);

/// Of the snapshots of a run within a window, at most `most_particles` particles in all; empty where the
/// run has none that hold all of the water, or is no channel in space whose eddies move over a bed that is
/// alike all along it.
[[nodiscard]] EddiesAndNoise read_eddies_and_noise(const RunResults& results, const Case& c,
                                                   const TimeWindow& window,
                                                   std::size_t most_particles = 1'000'000);

}  // namespace riffle::inline analysis
