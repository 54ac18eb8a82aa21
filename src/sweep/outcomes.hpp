#pragma once

#include <filesystem>
#include <limits>
#include <map>
#include <string>
#include <vector>

namespace riffle::inline sweep {

/// What kind of number an outcome is: it decides how it is plotted and extrapolated.
enum class OutcomeKind {
    value,      ///< tends to a limit as the resolution grows
    departure,  ///< should vanish: an error against the twin or the momentum balance
    cost,       ///< grows with the resolution
};

/// A number that a run is judged by.
struct Outcome {
    std::string key;  ///< as in /summary of the results file, where it is from there
    std::string label;
    std::string unit;  ///< SI; "1" for dimensionless ones
    std::string shown_unit;
    double factor = 1.0;  ///< from SI to the unit shown
    OutcomeKind kind = OutcomeKind::value;
    bool usual = false;      ///< shown without being asked for
    bool magnitude = false;  ///< never negative: a root mean square, a largest magnitude, a length
};

/// All of them, in the order of tables.
[[nodiscard]] const std::vector<Outcome>& known_outcomes();

/// The outcomes of these keys; the usual ones where none is named. Throws InputError for an unknown key,
/// naming the nearest and all that there are.
[[nodiscard]] std::vector<Outcome> chosen_outcomes(const std::vector<std::string>& keys);

/// An outcome of a run, SI; what is not known is not-a-number.
struct OutcomeValue {
    double value = std::numeric_limits<double>::quiet_NaN();
    double half_width = std::numeric_limits<double>::quiet_NaN();  ///< of the 95 % interval
    double twin = std::numeric_limits<double>::quiet_NaN();        ///< the column's, or the section's, value
};

/// What the results of a run say of all known outcomes, by key; those that it lacks are left out. Intervals
/// are those of the summary, else those of the mean of the series over the averaging window, correlation
/// taken into account. Throws FileError where the file cannot be read.
[[nodiscard]] std::map<std::string, OutcomeValue> read_outcomes(const std::filesystem::path& results);

}  // namespace riffle::inline sweep
