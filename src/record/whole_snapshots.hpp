#pragma once

#include <string>
#include <vector>

#include "case/case.hpp"
#include "record/run_results.hpp"

namespace riffle::inline record {

/// Whether the snapshots of a case hold all of its water, so that each particle has its neighbours.
[[nodiscard]] bool snapshots_are_whole(const Case& c);

/// A snapshot of a run: its time, s, and its group.
struct SnapshotPlace {
    double time = 0.0;
    std::string group;
};

/// The snapshots that hold the velocities of their particles, in the order of their groups.
[[nodiscard]] std::vector<SnapshotPlace> snapshots_with_velocities(const RunResults& results);

}  // namespace riffle::inline record
