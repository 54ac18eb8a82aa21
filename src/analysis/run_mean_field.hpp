#pragma once

#include <string>
#include <vector>

#include "analysis/flow_record.hpp"
#include "analysis/mean_flow.hpp"
#include "record/run_results.hpp"

namespace riffle::inline analysis {

/// The mean field of a three-dimensional run over those of its windows that lie within the window, read
/// window by window; empty where the file has none. What is left out is added to `warnings`. Throws FileError
/// where arrays do not fit each other.
[[nodiscard]] MeanFlow read_mean_field(const RunResults& results, const Case& c, const TimeWindow& window,
                                       std::vector<std::string>& warnings);

/// The plan maps of the surface within the window, at most `most_values` of them; empty where there are
/// none.
[[nodiscard]] SurfaceMaps read_surface_maps(const RunResults& results, const TimeWindow& window,
                                            std::size_t most_values, std::vector<std::string>& warnings);

/// The section twin that the run stored, `/section`; empty where it has none.
[[nodiscard]] SectionTwin read_section_twin(const RunResults& results);

}  // namespace riffle::inline analysis
