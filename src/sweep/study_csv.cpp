#include <fmt/format.h>

#include <cmath>

#include "base/csv_text.hpp"
#include "sweep/study_files.hpp"

namespace riffle::inline sweep {

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
        csv += fmt::format("{},{}", csv_cell(run.run.combination.name), word(run.report.fate));
        for (std::size_t k = 0; k < sweep.keys.size(); ++k) {
            csv += "," + csv_cell(run.run.combination.values[k]);
            if (sweep.keys[k].is_number()) csv += "," + csv_number(sweep.keys[k].numbers[i]);
        }
        for (const Outcome& outcome : sweep.outcomes) {
            const OutcomeValue found = run.outcome(outcome.key);
            csv += fmt::format(",{},{},{}", csv_number(found.value), csv_number(found.half_width),
                               csv_number(found.twin));
        }
        csv += "\n";
    }
    return csv;
}

}  // namespace riffle::inline sweep
