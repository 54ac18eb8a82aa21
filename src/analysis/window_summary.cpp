#include "analysis/window_summary.hpp"

#include <algorithm>
#include <array>
#include <cstddef>
#include <limits>
#include <vector>

#include "record/flow_fields.hpp"
#include "record/run_fields.hpp"
#include "record/twin_fields.hpp"
#include "solver/summary.hpp"

namespace riffle::inline analysis {

namespace {

/// The rows of a record up to the end of its window.
TimeSeries series_up_to_window(const RunRecord& record) {
    const auto& time = record.series()[fields::time_series.time];
    const auto rows = static_cast<std::ptrdiff_t>(
        std::upper_bound(time.begin(), time.end(), record.window().to + 1e-9) - time.begin());
    TimeSeries series(*record.flow());
    for (SeriesColumn& column : series.columns()) {
        const auto& values = record.series()[column.field];
        if (values.size() == time.size()) {
            column.values.assign(values.begin(), values.begin() + rows);
        } else {
            column.values.assign(static_cast<std::size_t>(rows), std::numeric_limits<double>::quiet_NaN());
        }
    }
    return series;
}

Twins twins_of(const RunRecord& record) {
    Twins twins;
    if (record.column() != nullptr) twins.column = *record.column();
    const auto& of = fields::section_numbers;
    const SectionTwin& section = record.section_twin();
    if (section.value(of.depth_mean_velocity)) {
        SectionResult result;
        result.depth_mean_velocity = section.value(of.depth_mean_velocity).value_or(0.0);
        result.bulk_velocity = section.value(of.bulk_velocity).value_or(0.0);
        result.relaxation_time = section.value(of.relaxation_time).value_or(0.0);
        twins.section = std::move(result);
    }
    return twins;
}

}  // namespace

Numbers window_summary(const RunRecord& record) {
    Convergence own;
    own.window_start = record.window().from;
    const Numbers all =
        summarise(*record.flow(), twins_of(record), series_up_to_window(record), record.profiles(), own);
    const auto& of = fields::summary;
    const std::array tested{of.converged, of.remaining_drift, of.velocity_fluctuation_growth,
                            of.velocity_fluctuation_growth_least};
    Numbers summary;
    for (const auto& number : all.all()) {
        const bool of_test = std::any_of(tested.begin(), tested.end(),
                                         [&](const Field& field) { return field.name == number.first; });
        if (!of_test) summary.set(number.first, number.second);
    }
    return summary;
}

}  // namespace riffle::inline analysis
