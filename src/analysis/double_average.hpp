#pragma once

#include "analysis/flow_record.hpp"
#include "analysis/section_parts.hpp"

namespace riffle {

/// Form-induced stress -rho <u~ w~> of the mean field of a run in three dimensions at its heights
/// (`mean_field().z`), Pa, with the half-widths of its 95 % intervals: of the departures of the time means
/// from their mean over the plan, from products of different stretches of time. Of fewer than two stretches
/// it holds what is left of the fluctuation as well, of fewer than three the half-widths are infinite; not a
/// number where there is no water.
[[nodiscard]] FieldEstimates form_induced_stress(const FlowRecord& record);

}  // namespace riffle
