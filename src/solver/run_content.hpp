#pragma once

#include <optional>

#include "case/case.hpp"
#include "column/column.hpp"
#include "output/dataset.hpp"
#include "solver/convergence.hpp"
#include "solver/recorder.hpp"
#include "solver/run.hpp"
#include "solver/summary.hpp"

namespace riffle {

// What a run writes into its results file beside the recorded rows (docs/results-format.md).

/// The complete case, as the results and the checkpoints hold it.
[[nodiscard]] Dataset case_dataset(const Case& c);

/// Head of a new results file: case, versions, column twin.
[[nodiscard]] Content run_head(const Case& c, const std::optional<ColumnResult>& column);

/// Summary of what is recorded so far.
[[nodiscard]] RunSummary current_summary(const Case& c, const std::optional<ColumnResult>& column,
                                         const Recorder& recorder, const Convergence& convergence);

/// Time-averaged profiles over the window so far; nothing when no block is complete yet.
void add_profiles_content(Content& content, const std::optional<ColumnResult>& column,
                          const Recorder& recorder, const Convergence& convergence);

/// The XDMF indexes of the snapshots and of the mean field, as far as there are any.
void write_indexes(const RunFiles& files, const Recorder& recorder);

}  // namespace riffle
