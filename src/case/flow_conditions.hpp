#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "case/case.hpp"

namespace riffle::inline case_file {

/// Names of the built-in cases: "rough-bed" (a plain example), "dam-break" (violent flow), "condition-1" to
/// "condition-8" (the measured flow conditions of the thesis, Table 3.1), "paper-2016", and of conditions 1,
/// 2, 5 and 8 in three dimensions "condition-1-3d" (the size of the thesis' runs), "condition-1-3d-coarse"
/// (half width, two spheres long) and "condition-1-3d-wide" (periodic across).
[[nodiscard]] std::vector<std::string> builtin_case_names();

/// The built-in case of that name; the files of cases/ hold the same. Throws InputError for an unknown name.
[[nodiscard]] Case builtin_case(std::string_view name);

/// The flow condition of the thesis' Table 3.1 whose depth, slope and spheres a case has, whatever its
/// closure and numerics; nothing where it has none of theirs.
[[nodiscard]] std::optional<int> flow_condition_of(const Case& c);

}  // namespace riffle::inline case_file
