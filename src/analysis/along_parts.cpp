#include "analysis/along_parts.hpp"

#include <cmath>
#include <limits>

#include "analysis/figure_tools.hpp"
#include "base/not_a_number.hpp"
#include "case/end_levels.hpp"
#include "record/probe_fields.hpp"
#include "statistics/confidence.hpp"

namespace riffle::inline analysis {

LongProfile long_profile(const SpaceTime& surface) {
    LongProfile profile;
    for (std::size_t i = 0; i < surface.columns; ++i) {
        const std::vector<double> record = surface.record(i);
        double low = std::numeric_limits<double>::infinity();
        double high = -low;
        for (const double value : record) {
            if (!std::isfinite(value)) continue;
            low = std::min(low, value);
            high = std::max(high, value);
        }
        const bool wet = low <= high;
        const MeanEstimate mean = wet ? mean_with_confidence(record) : MeanEstimate{};
        profile.x.push_back(surface.x(i));
        profile.level.push_back(wet ? mean.mean : not_a_number);
        profile.half_width.push_back(wet ? trusted_half_width(mean).value_or(not_a_number) : not_a_number);
        profile.lowest.push_back(wet ? low : not_a_number);
        profile.highest.push_back(wet ? high : not_a_number);
    }
    return profile;
}

std::vector<double> discharge_of(const FlowRecord& record) {
    const ScalarProbe* const entering = find_at_end(record, fields::flow_rate.flow_rate, 1);
    if (entering != nullptr && entering->value.size() > 1) return entering->value;
    for (const ScalarProbe& probe : record.scalar_probes()) {
        if (probe.kind == "flow_rate" && probe.quantity.rfind("flow_rate", 0) == 0 &&
            probe.value.size() > 1) {
            return probe.value;
        }
    }
    return {};
}

std::optional<UnitDischarge> unit_discharge(const FlowRecord& record) {
    const Case& c = *record.flow();
    const double width = c.channel.flow_width();
    const std::vector<double> samples = discharge_of(record);
    if (samples.empty()) return std::nullopt;
    MeanEstimate mean = mean_with_confidence(samples);
    mean.mean /= width;
    mean.half_width /= width;
    UnitDischarge discharge{.mean = mean.mean, .half_width = trusted_half_width(mean)};
    if (changes_at_ends(c) || mean.mean == 0.0) return discharge;
    const TrendEstimate trend = trend_with_confidence(samples);
    const double change = trend.slope * static_cast<double>(samples.size() - 1) / width;
    const bool stands_out = std::abs(change) > 2.0 * mean.half_width || !discharge.half_width;
    if (stands_out && std::abs(trend.slope) > trend.half_width) {
        const double share = change / mean.mean;
        if (std::abs(share) <= c.run.tolerance) {
            // As steady as the case asks for: the mean is known no better than what it changes by.
            if (discharge.half_width) {
                *discharge.half_width = std::max(*discharge.half_width, std::abs(change));
            }
        } else {
            discharge.half_width.reset();
            discharge.drift = share;
        }
    }
    return discharge;
}

}  // namespace riffle::inline analysis
