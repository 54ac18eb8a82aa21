#pragma once

#include "case/case.hpp"
#include "column/column.hpp"

namespace riffle {

/// Fit of a profile to the rough log law at evenly spaced heights, as an instrument would sample it.
[[nodiscard]] LogLawFit fit_column_profile(const Case& c, const ColumnResult& column);

/// What the measurements at the centreline are compared with: the column, and between side walls the column
/// with the velocities of the section twin at the centreline (profile, means, log-law fit). Throws as
/// solve_column().
[[nodiscard]] ColumnResult solve_centreline(const Case& c);

}  // namespace riffle
