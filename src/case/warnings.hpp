#pragma once

#include "case/case_check.hpp"

namespace riffle::inline case_file {

/// For the comparison of ratios that are given as decimals.
inline constexpr double rounding_of_ratios = 1e-9;

/// All that a valid case is warned of, beyond keys that have no effect.
[[nodiscard]] const CheckList& warnings();

/// Those of the numerics.
[[nodiscard]] CheckList numerics_warnings();

/// Those of vegetation and porous zones.
[[nodiscard]] CheckList patch_warnings();

/// Those of solids.
[[nodiscard]] CheckList solid_warnings();

}  // namespace riffle::inline case_file
