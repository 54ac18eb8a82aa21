#pragma once

#include "analysis/figure.hpp"
#include "analysis/flow_record.hpp"
#include "analysis/section_parts.hpp"

namespace riffle::inline analysis {

/// Form-induced stress -rho <u~ w~> of the mean field of a run in three dimensions at its heights
/// (`mean_field().z`), Pa, with the half-widths of its 95 % intervals: of the departures of the time means
/// from their mean over the plan, from products of different stretches of time. Of fewer than two stretches
/// it holds what is left of the fluctuation as well, of fewer than three the half-widths are infinite; not a
/// number where there is no water. Empty without a mean field.
[[nodiscard]] FieldEstimates form_induced_stress(const FlowRecord& record);

/// The part of the profiles that needs time means in cells, of a grid in two dimensions or of the mean field
/// in three: dispersive stress (time mean, then mean over the bed plane). Nothing without them. `form`:
/// form_induced_stress().
void add_double_averages(const FlowRecord& record, const FieldEstimates& form, Analysis& analysis);

}  // namespace riffle::inline analysis
