#pragma once

#include <optional>
#include <string>

#include "record/series_table.hpp"

namespace riffle::inline analysis {

/// Thin a time series whose rows were written at other intervals in a part of it, as after a resume with
/// another output.series_interval, to the widest of them: the statistics take rows as evenly spaced. Single
/// gaps stay. What was done, in words; nothing where the rows are even.
std::optional<std::string> make_even(SeriesTable& series);

}  // namespace riffle::inline analysis
