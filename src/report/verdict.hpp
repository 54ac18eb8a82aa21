#pragma once

#include <string>
#include <vector>

#include "report/diagnostics.hpp"
#include "report/quantities.hpp"
#include "report/report_data.hpp"

namespace riffle::inline report {

/// The report's opening paragraph: what came out, in plain words.
struct Verdict {
    Health mark = Health::none;
    std::string headline;
    std::vector<std::string> sentences;
};

/// Judge a run by its kind of flow: whether it has come to its end or converged, what came out, and which
/// diagnostics stand outside of their ranges. No headline calls a run good whose diagnostics do not.
[[nodiscard]] Verdict judge(const ReportData& data, const std::vector<SummaryRow>& quantities,
                            const std::vector<Diagnostic>& diagnostics);

}  // namespace riffle::inline report
