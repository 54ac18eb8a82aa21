#pragma once

#include <optional>
#include <string>

#include "report/report_data.hpp"

namespace riffle {

/// Those of the named one-dimensional datasets of a group that exist.
template <typename Names>
[[nodiscard]] Columns read_columns(const ResultsReader& reader, const std::string& group,
                                   const Names& names) {
    Columns columns;
    for (const char* name : names) {
        const std::string path = group + "/" + name;
        if (reader.has(path)) columns[name] = reader.read_doubles(path);
    }
    return columns;
}

/// The time-averaged profiles; empty before the first average.
[[nodiscard]] Columns read_profiles(const ResultsReader& reader);

/// Profile of the column twin.
[[nodiscard]] Columns read_column(const ResultsReader& reader);

/// Add `hydrostatic_pressure` under the mean level to the profiles.
void add_hydrostatic_pressure(ReportData& data);

/// Solve the column twin for those of its values that the results file lacks; nothing where the case has
/// none.
void complete_column(ReportData& data);

/// Fit the simulated profile to the rough log law about the datum, as the column's is (log_law_range), and
/// tabulate the law.
void add_log_law(ReportData& data);

/// The measured profile of the case: its CSV file where it can be found, else the log law of its u_* and k_s.
[[nodiscard]] std::optional<MeasuredProfile> measured_profile(ReportData& data);

}  // namespace riffle
