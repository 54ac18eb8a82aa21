#pragma once

#include <optional>
#include <vector>

#include "analysis/figure.hpp"
#include "analysis/flow_record.hpp"
#include "analysis/mean_flow.hpp"

namespace riffle::inline analysis {

// The parts of the chapter on the bed and the side walls.

/// Values over the width, averaged over a period of the bed's elements, with their intervals.
struct Distribution {
    std::vector<double> y, value, period_mean, half_width;
    bool of_elements = false;  ///< the bed has elements, over whose period the means are
    Estimate mean;
};

[[nodiscard]] Distribution distribution_of(const MeanFlow& field, const Case& c,
                                           const SectionEstimator& estimator);

/// The curves of a distribution over a scale.
void add_distribution(const Distribution& d, double scale, Figure& figure);

/// A finding: largest departure of the periods' means from a uniform value, and where.
void add_departure(const Distribution& d, double uniform, const char* key, const char* what,
                   const std::optional<double>& thesis, Analysis& analysis);

/// What the partition of Yang & Lim is called beside a case: it knows walls as rough as the bed alone.
[[nodiscard]] const char* partition_name(const Case& c);

/// The curve of Yang & Lim's stress on the bed; nothing without side walls.
void add_yang_lim(const Case& c, Figure& figure);

/// The stress near the bed across the channel: of a run, or measured points alone.
void add_bed_stress(const FlowRecord& record, Analysis& analysis);

}  // namespace riffle::inline analysis
