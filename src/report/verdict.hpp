#pragma once

#include <string>
#include <vector>

#include "report/diagnostics.hpp"
#include "report/quantities.hpp"
#include "report/report_data.hpp"

namespace riffle {

/// The report's opening paragraph: what came out, in plain words.
struct Verdict {
    Health mark = Health::none;
    std::string headline;
    std::vector<std::string> sentences;
};

[[nodiscard]] Verdict judge(const ReportData& data, const std::vector<Quantity>& quantities,
                            const std::vector<Diagnostic>& diagnostics);

}  // namespace riffle
