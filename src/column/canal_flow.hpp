#pragma once

#include <optional>

#include "case/case.hpp"
#include "case/cross_section.hpp"

namespace riffle::inline column {

/// Uniform flow in a canal of one cross-section by the equation of Colebrook and White with the constants of
/// a pipe and the hydraulic radius of the section: what the engineer's formula says, not a solution of the
/// flow. Patches of another roughness change it as share_of_patches().
struct CanalFlow {
    WettedSection wet;              ///< of the whole width; the perimeter of all that holds the water back
    double hydraulic_radius = 0.0;  ///< m
    double velocity = 0.0;          ///< U, m/s
    double discharge = 0.0;         ///< Q, m3/s
    bool alone = true;              ///< nothing but the section holds the water back: no stems, no stones
};

/// Nothing where a case is no canal (canal_of()) between periodic ends, or its roughness too large for the
/// equation.
[[nodiscard]] std::optional<CanalFlow> canal_flow(const Case& c);

}  // namespace riffle::inline column
