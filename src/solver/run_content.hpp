#pragma once

#include "case/case.hpp"
#include "output/dataset.hpp"
#include "solver/convergence.hpp"
#include "solver/recorder.hpp"
#include "solver/run.hpp"
#include "solver/summary.hpp"
#include "solver/twins.hpp"

namespace riffle::inline solver {

// What a run writes into its results file beside the recorded rows (docs/results-format.md).

/// The complete case, as the results and the checkpoints hold it.
[[nodiscard]] Dataset case_dataset(const Case& c);

/// Head of a new results file: case, versions, the twins.
[[nodiscard]] Content run_head(const Case& c, const Twins& twins);

/// Summary of what is recorded so far.
[[nodiscard]] Numbers current_summary(const Case& c, const Twins& twins, const Recorder& recorder,
                                      const Convergence& convergence);

/// Time-averaged profiles over the window so far; nothing when no block is complete yet.
void add_profiles_content(Content& content, const Twins& twins, const Recorder& recorder,
                          const Convergence& convergence);

/// The XDMF indexes of the snapshots and of the mean field, as far as there are any.
void write_indexes(const RunFiles& files, const Recorder& recorder);

}  // namespace riffle::inline solver
