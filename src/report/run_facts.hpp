#pragma once

#include <string>
#include <vector>

#include "report/report_data.hpp"

namespace riffle::inline report {

/// A line of the report's list of run facts.
struct Fact {
    std::string label;
    std::string value;
};

/// A whole number with thin spaces between its thousands.
[[nodiscard]] std::string grouped_number(double value);

/// A time span in seconds, minutes or hours.
[[nodiscard]] std::string computing_time_text(double seconds);

/// Size, cost and origin of the run.
[[nodiscard]] std::vector<Fact> run_facts(const ReportData& data);

}  // namespace riffle::inline report
