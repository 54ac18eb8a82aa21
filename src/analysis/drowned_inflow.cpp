#include "analysis/drowned_inflow.hpp"

#include <fmt/format.h>

#include "analysis/chapter_names.hpp"
#include "analysis/figure_tools.hpp"
#include "case/end_floor.hpp"
#include "case/end_levels.hpp"
#include "case/flow_kind.hpp"
#include "ends/end_events.hpp"
#include "record/probe_fields.hpp"
#include "statistics/confidence.hpp"

namespace riffle::inline analysis {

namespace {

/// Depth that is to enter, over what it stands on, m.
double entering_depth(const Case& c) { return *c.inflow.depth + c.datum() - end_floors(c).upstream; }

}  // namespace

std::string drowned_inflow_text(const Case& c) {
    return fmt::format(
        "where {:.4g} mm enter faster than their waves: a jump stands at the inflow and drowns the jet; a lower depth at "
        "the outflow or a longer channel lets it stand off",
        1e3 * entering_depth(c));
}

bool add_drowned_inflow(const FlowRecord& record, Analysis& analysis) {
    const Case& c = *record.flow();
    const auto unit_discharge = c.inflow_unit_discharge();
    const ScalarProbe* const depth = find_at_end(record, fields::flow_rate.depth, 1);
    if (c.channel.ends != Ends::open || is_duct(c) || !unit_discharge || !c.inflow.depth ||
        depth == nullptr || depth->value.size() < 2) {
        return false;
    }
    const double entering = entering_depth(c);
    if (entering >= critical_depth_of(c.normal_gravity(), *unit_discharge)) return false;
    const MeanEstimate mean = mean_with_confidence(depth->value);
    if (!(mean.mean > drowned_share * entering)) return false;
    analysis.findings.push_back(make_finding(chapters::along, "drowned_inflow_depth", "depth at the inflow",
                                             "m", mean.mean, trusted_half_width(mean)));
    analysis.findings.back().remark = drowned_inflow_text(c);
    return true;
}

}  // namespace riffle::inline analysis
