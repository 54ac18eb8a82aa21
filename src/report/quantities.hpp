#pragma once

#include <optional>
#include <string>
#include <vector>

#include "analysis/figure.hpp"
#include "report/report_data.hpp"

namespace riffle::inline report {

/// A value of the summary table with the half-width of its 95 % interval, where one is known. SI.
struct SummaryValue {
    double value = 0;
    std::optional<double> half_width;
};

/// A row of the summary table. `factor` turns SI into the unit shown.
struct SummaryRow {
    std::string key;  ///< as in the JSON summary
    std::string label;
    std::string symbol;  ///< with <i>, <sub> marks
    std::string unit;    ///< shown; "1" for dimensionless
    double factor = 1;
    int digits = 4;  ///< significant digits shown
    std::optional<SummaryValue> simulated, measured, column;
    std::optional<SummaryValue> theory{};  ///< of flows that theory knows: a wave, a dam break, vortices
};

/// The rows of the summary table by the kind of flow, those without any value left out. What the analysis
/// finds is taken from there: the surface's fluctuation, what stands at the centreline between side walls,
/// what a channel with bodies and a flow that nothing drives are known by.
[[nodiscard]] std::vector<SummaryRow> summarize(const ReportData& data, const Analysis& analysis = {});

/// The row with this key; nullptr if it is not there.
[[nodiscard]] const SummaryRow* find_quantity(const std::vector<SummaryRow>& quantities,
                                              const std::string& key);

}  // namespace riffle::inline report
