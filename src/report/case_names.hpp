#pragma once

#include <string>
#include <vector>

#include "case/case.hpp"

namespace riffle::inline report {

/// A key of the case file in which the cases of a comparison differ.
struct CaseDifference {
    std::string key;                  ///< "numerics.spacing"
    std::string label;                ///< "spacing"
    std::vector<std::string> values;  ///< of each case, with handy units
};

/// The keys in which the cases differ, in the order of the case file; titles, measured values and
/// output aside, but for output.surface_detection, which decides what is measured as the surface.
[[nodiscard]] std::vector<CaseDifference> case_differences(const std::vector<const Case*>& cases);

/// Short, distinct names of cases, made from what tells them apart: the flow condition or title, then one or
/// two keys in which those of one condition differ ("condition 2, spacing 1.5 mm"). `otherwise`: for each
/// case what is added where that does not tell them apart, e.g. the folder of its results.
[[nodiscard]] std::vector<std::string> names_of_cases(const std::vector<const Case*>& cases,
                                                      const std::vector<std::string>& otherwise);

/// The names, those that occur more than once with what is added to each in parentheses; what is the same
/// even so is numbered from the second on.
[[nodiscard]] std::vector<std::string> told_apart(const std::vector<std::string>& names,
                                                  const std::vector<std::string>& otherwise);

}  // namespace riffle::inline report
