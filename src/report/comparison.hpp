#pragma once

#include <cstddef>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "analysis/figure.hpp"
#include "report/case_names.hpp"
#include "report/report_data.hpp"

namespace riffle::inline report {

/// What a report is made from: a run and its analysis, or the analysis of a laboratory record alone.
struct ReportSubject {
    std::filesystem::path results;  ///< results file of the run; empty for a laboratory record
    Analysis analysis;
};

/// A run or a laboratory record of a comparison.
struct ComparedRun {
    std::string name;               ///< for legends and tables, distinct
    std::optional<ReportData> run;  ///< nothing for a laboratory record
    Analysis analysis;
};

/// Runs that are shown together, with chapters of their own.
struct ComparedSet {
    std::string title;
    std::string introduction;
    std::vector<std::size_t> members;   ///< in Comparison::runs
    std::vector<std::string> names;     ///< of the members in this set; empty: those of the runs
    bool side_by_side = false;          ///< curves in one panel for each run at first, else overlaid
    std::vector<std::string> chapters;  ///< the chapters shown; empty: all
};

/// A part of a comparison that was asked for but not given.
struct MissingRun {
    std::string what;     ///< "flow condition 5"
    std::string command;  ///< how to get it
};

/// All that a comparison page shows.
struct Comparison {
    std::string title;
    std::string introduction;
    std::vector<ComparedRun> runs;
    std::vector<CaseDifference> differences;  ///< of the runs; "–" for laboratory records
    std::vector<ComparedSet> sets;
    std::vector<MissingRun> missing;
};

/// Collect runs and records for a comparison, all in one set. Throws FileError where a results file cannot be
/// read, InputError without subjects.
[[nodiscard]] Comparison compare(const std::vector<ReportSubject>& subjects);

/// Runs with their data and names; the first step of every comparison.
[[nodiscard]] std::vector<ComparedRun> collect_runs(const std::vector<ReportSubject>& subjects);

/// Distinct names of some of the runs, made from what differs between these alone.
[[nodiscard]] std::vector<std::string> names_among(const std::vector<ComparedRun>& runs,
                                                   const std::vector<std::size_t>& members);

/// The keys in which the cases of the runs differ.
[[nodiscard]] std::vector<CaseDifference> differences_of(const std::vector<ComparedRun>& runs);

/// The page's data block: overview, tables and sets; without the analyses.
[[nodiscard]] std::string comparison_page_json(const Comparison& comparison);

/// The summary for machines, SI: a summary for each run, differences, what is missing. Described in
/// docs/results-format.md.
[[nodiscard]] std::string comparison_summary_json(const Comparison& comparison);

}  // namespace riffle::inline report
