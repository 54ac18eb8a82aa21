#include <fmt/format.h>

#include <cmath>

#include "sweep/study_files.hpp"

namespace riffle {

namespace {

std::string number(double value) { return std::isfinite(value) ? fmt::format("{:.9g}", value) : ""; }

/// A text cell: quoted where it holds what separates cells or lines (RFC 4180).
std::string cell(const std::string& text) {
    if (text.find_first_of(",\"\n\r") == std::string::npos) {
        return text;
    }
    std::string quoted = "\"";
    for (const char letter : text) {
        quoted += letter == '"' ? std::string("\"\"") : std::string(1, letter);
    }
    return quoted + '"';
}

}  // namespace

std::string sweep_csv(const SweepStudy& sweep) {
    std::string csv = "run,state";
    for (const VariedKey& key : sweep.keys) {
        csv += "," + key.variation.key;
        if (key.is_number()) {
            csv += fmt::format(",{} [{}]", key.label, key.unit);
        }
    }
    for (const Outcome& outcome : sweep.outcomes) {
        csv += fmt::format(",{0} [{1}],{0}_half_width [{1}],{0}_twin [{1}]", outcome.key, outcome.unit);
    }
    csv += "\n";
    for (std::size_t i = 0; i < sweep.runs.size(); ++i) {
        const StudiedRun& run = sweep.runs[i];
        csv += fmt::format("{},{}", cell(run.run.combination.name), word(run.report.fate));
        for (std::size_t k = 0; k < sweep.keys.size(); ++k) {
            csv += "," + cell(run.run.combination.values[k]);
            if (sweep.keys[k].is_number()) {
                csv += "," + number(sweep.keys[k].numbers[i]);
            }
        }
        for (const Outcome& outcome : sweep.outcomes) {
            const OutcomeValue found = run.outcome(outcome.key);
            csv +=
                fmt::format(",{},{},{}", number(found.value), number(found.half_width), number(found.twin));
        }
        csv += "\n";
    }
    return csv;
}

}  // namespace riffle
