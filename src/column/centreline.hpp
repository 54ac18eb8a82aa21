#pragma once

#include <optional>

#include "case/case.hpp"
#include "column/column.hpp"
#include "column/section.hpp"

namespace riffle::inline column {

/// Fit of a profile to the rough log law at evenly spaced heights, as an instrument would sample it.
[[nodiscard]] LogLawFit fit_column_profile(const Case& c, const ColumnResult& column);

/// The column of a case; between side walls with the velocities of the section twin at the centreline
/// (profile, means, log-law fit), and that section.
struct Centreline {
    ColumnResult column;
    std::optional<SectionResult> section;
};

/// Both of them. Throws as solve_column().
[[nodiscard]] Centreline solve_centreline_and_section(const Case& c);

}  // namespace riffle::inline column
