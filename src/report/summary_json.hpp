#pragma once

#include <string>

#include "analysis/figure.hpp"
#include "report/json_parts.hpp"
#include "report/report_data.hpp"

namespace riffle::inline report {

/// The summary for machines, SI: title, versions, window, quantities, diagnostics, verdict, and the findings
/// and warnings of the analysis. Described in docs/results-format.md.
[[nodiscard]] Json summary_object(const ReportData& data, const Analysis& analysis);

/// The same as text.
[[nodiscard]] std::string summary_json(const ReportData& data, const Analysis& analysis = {});

/// The flow in one line: version, depth, slope, spheres.
[[nodiscard]] std::string flow_line(const ReportData& data);

}  // namespace riffle::inline report
