#pragma once

#include "analysis/flow_record.hpp"
#include "record/run_results.hpp"

namespace riffle::inline analysis {

/// The profiles of the run's averaging window, `/profiles`. Bins without particles are left out, as are
/// columns that the file lacks (their vectors are empty). Empty without profiles.
[[nodiscard]] Profiles read_profiles_group(const RunResults& results);

/// The profiles averaged anew from `/profile_blocks` over the blocks that lie within the window. Empty if the
/// file has no blocks there. Throws FileError if the blocks are not those of the case.
[[nodiscard]] Profiles average_profile_blocks(const RunResults& results, const Case& c,
                                              const ColumnResult* column, const TimeWindow& window);

}  // namespace riffle::inline analysis
