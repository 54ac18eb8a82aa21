#pragma once

#include <string>

#include "report/diagnostics.hpp"
#include "report/quantities.hpp"
#include "report/report_data.hpp"
#include "report/verdict.hpp"

namespace riffle::inline report {

/// The page's data block, JSON in SI: everything that its tables and figures show.
[[nodiscard]] std::string page_json(const ReportData& data, const Analysis& analysis = {});

}  // namespace riffle::inline report
