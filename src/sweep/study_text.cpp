#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "sweep/study_files.hpp"

namespace riffle::inline sweep {

namespace {

using Row = std::vector<std::string>;

/// Columns as wide as their longest cell, two spaces apart; the first is set to the left.
std::string aligned(const std::vector<Row>& rows) {
    std::vector<std::size_t> widths;
    for (const Row& row : rows) {
        widths.resize(std::max(widths.size(), row.size()));
        for (std::size_t i = 0; i < row.size(); ++i) widths[i] = std::max(widths[i], row[i].size());
    }
    std::string text;
    for (const Row& row : rows) {
        std::string line;
        for (std::size_t i = 0; i < row.size(); ++i) {
            line += i == 0 ? fmt::format("{:<{}}", row[i], widths[i])
                           : fmt::format("  {:>{}}", row[i], widths[i]);
        }
        text += line.substr(0, line.find_last_not_of(' ') + 1) + "\n";
    }
    return text;
}

/// A letter for each outcome, so that the columns of the table are as narrow as their numbers.
std::string letter_of(std::size_t outcome) { return fmt::format("({})", outcome + 1); }

}  // namespace

std::string sweep_text(const SweepStudy& sweep) {
    std::string text;
    for (std::size_t i = 0; i < sweep.outcomes.size(); ++i) {
        const Outcome& outcome = sweep.outcomes[i];
        text += fmt::format("{:>4} {}{}\n", letter_of(i), outcome.label,
                            outcome.shown_unit == "1" ? "" : ", " + outcome.shown_unit);
    }
    std::vector<Row> rows(1);
    rows.front() = {"run", "state"};
    for (std::size_t i = 0; i < sweep.outcomes.size(); ++i) rows.front().push_back(letter_of(i));
    for (const StudiedRun& run : sweep.runs) {
        Row row = {run.run.combination.name, word(run.report.fate)};
        for (const Outcome& outcome : sweep.outcomes) {
            const OutcomeValue found = run.outcome(outcome.key);
            row.push_back(value_text(outcome, found.value, found.half_width));
        }
        rows.push_back(std::move(row));
    }
    text += (text.empty() ? "" : "\n") + aligned(rows);
    std::string key;
    for (const RefinementStudy& study : sweep.refinements) {
        if (study.finding.empty()) continue;
        if (study.key != key) {
            key = study.key;
            text += fmt::format("\nAs {} gets smaller:\n", key);
        }
        text += fmt::format("  {}{}: {}\n", study.outcome,
                            study.others.empty() ? "" : " (" + study.others + ")", study.finding);
    }
    return text;
}

}  // namespace riffle::inline sweep
