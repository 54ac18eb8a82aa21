#pragma once

#include <string>
#include <vector>

#include "analysis/figure.hpp"
#include "report/report_data.hpp"

namespace riffle::inline report {

/// Mark of a diagnostic: in its healthy range, not far out of it (up to twice), further out, or without a
/// range.
enum class Health { good, caution, bad, none };

/// A row of the diagnostics table. Texts may carry <i>, <sub> marks.
struct Diagnostic {
    std::string key;
    std::string label;
    std::string value;
    std::string healthy;      ///< the range, in words
    std::string explanation;  ///< for a hydraulics engineer
    Health mark = Health::none;
};

/// The diagnostics that the results file allows, of its kind of flow (case/flow_kind.hpp). `analysis`: of the
/// same file; what follows from its findings is left out without it.
[[nodiscard]] std::vector<Diagnostic> diagnose(const ReportData& data, const Analysis& analysis = {});

}  // namespace riffle::inline report
