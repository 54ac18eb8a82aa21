#pragma once

#include <cstddef>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "statistics/grid_convergence.hpp"
#include "sweep/outcomes.hpp"
#include "sweep/schedule.hpp"

namespace riffle::inline sweep {

/// A key that a sweep varies.
struct VariedKey {
    Variation variation;
    std::string label;  ///< "spacing"
    std::string unit;   ///< SI; "1" for numbers without, empty for words
    /// Its value in each run, SI; empty where it is not a number in every run. That of numerics.spacing is
    /// the size of the cells of the lattice, (area or volume per particle)^(1/dimensions), which the rounding
    /// to whole rows and columns changes a little.
    std::vector<double> numbers;
    bool refines = false;  ///< the results should converge as it gets smaller

    [[nodiscard]] bool is_number() const { return !numbers.empty(); }
};

/// A run of a sweep with what came out.
struct StudiedRun {
    SweepRun run;
    RunReport report;
    std::map<std::string, OutcomeValue> outcomes;  ///< of complete runs

    [[nodiscard]] bool complete() const {
        return report.fate == RunFate::taken || report.fate == RunFate::done;
    }
    /// Not-a-number where it is not known.
    [[nodiscard]] OutcomeValue outcome(const std::string& key) const;
};

/// An outcome along one refined key, all other keys being the same.
struct RefinementStudy {
    std::string key;  ///< that is refined
    std::string outcome;
    std::string others;                ///< values of the other keys: "kernel=cubic-spline"; empty without any
    std::vector<std::size_t> runs;     ///< that are complete, coarsest first
    std::vector<RefinedValue> values;  ///< of these runs
    std::optional<GridConvergence> convergence;  ///< of the three finest; of three runs or more
    std::optional<PowerLaw> power_law;           ///< of departures and costs
    std::string finding;                         ///< in words
};

/// What came out of a sweep.
struct SweepStudy {
    std::string title;  ///< of the case
    std::string case_file;
    std::vector<Outcome> outcomes;  ///< chosen ones that at least one run has
    std::vector<VariedKey> keys;
    std::vector<StudiedRun> runs;
    std::vector<RefinementStudy> refinements;

    /// "kernel=cubic-spline": values of the keys but one, in a run. `but`: index of that key.
    [[nodiscard]] std::string others(std::size_t run, std::size_t but) const;
};

/// Collect it from the results of the complete runs. Outcomes that no run has are left out, and with
/// `only_telling` those that are zero in every run (the drag of a smooth bed, say). Throws FileError where
/// results cannot be read.
[[nodiscard]] SweepStudy study_sweep(const SweepInput& input, const std::vector<SweepRun>& runs,
                                     const std::vector<RunReport>& reports,
                                     const std::vector<Outcome>& outcomes, bool only_telling = false);

/// The word of a fate for tables and files: "complete", "failed", "stopped", "waiting".
[[nodiscard]] const char* word(RunFate fate);

/// "0.4512 +- 0.0007" in the shown unit of an outcome; "-" where it is not known.
[[nodiscard]] std::string value_text(const Outcome& outcome, double value, double half_width);

}  // namespace riffle::inline sweep
