#pragma once

#include <array>
#include <cstddef>
#include <optional>

#include "case/case.hpp"

namespace riffle::inline case_file {

/// Two solids of which one at least moves, and the time from which they stand in each other.
struct SolidOverlap {
    std::size_t first = 0;
    std::size_t second = 0;
    double time = 0.0;
    std::array<double, 3> place{};  ///< where, m; y in three dimensions
};

/// The first overlap of solids up to the end of the run, deeper than a tenth of the spacing: solids may touch
/// and slide along each other. Ends and sides that are periodic count.
[[nodiscard]] std::optional<SolidOverlap> first_overlap(const Case& c);

}  // namespace riffle::inline case_file
