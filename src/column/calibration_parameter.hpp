#pragma once

#include <span>
#include <string>
#include <string_view>

#include "case/case.hpp"

namespace riffle::inline column {

/// A parameter that can be fitted: where it lives in the case, and where it makes sense.
struct CalibrationParameter {
    std::string_view name;
    std::string_view key;
    std::string_view unit;
    double& (*member)(Case&);
    double (*lower)(const Case&);
    double (*upper)(const Case&);
    /// Length that steps are measured in, where the start may be 0; null: the start value.
    double (*scale)(const Case&);
    bool (*applies)(const Case&);
    std::string_view applies_to;

    [[nodiscard]] double value(Case c) const { return member(c); }
};

/// All of them; a new parameter is one entry of the table.
[[nodiscard]] std::span<const CalibrationParameter> calibration_parameter_table();

/// The one with this name. Throws InputError, naming those that there are, for another.
[[nodiscard]] const CalibrationParameter& find_calibration_parameter(const std::string& name);

}  // namespace riffle::inline column
