#pragma once

#include <memory>

#include "case/case.hpp"
#include "ends/recorded_flow.hpp"

namespace riffle::inline ends {

/// The water that enters a case from the results of a run with periodic ends (inflow.results): its snapshots
/// from inflow.results_from on, on cells as large as its spacing, each cell with the kernel's mean at its
/// middle, exact for linear fields. A file that has been read is kept as long as another one is not asked
/// for. Throws InputError, naming the key and what to do, where that water does not fit the case: other
/// dimensions or sides, a width that does not repeat in that of the case, ends that are not periodic, no
/// snapshots of all the water with velocities; and FileError as RunResults.
[[nodiscard]] std::shared_ptr<const RecordedFlow> recorded_flow(const Case& c);

}  // namespace riffle::inline ends
