#pragma once

#include <string>

#include "sweep/matrix.hpp"

namespace riffle::inline sweep {

/// What the folder of a run of a sweep holds.
enum class FolderState {
    empty,        ///< no results: the run is still to be done
    interrupted,  ///< a part of the run with a checkpoint to go on from
    complete,     ///< the whole run
    failed,       ///< the part of the run up to where the simulation failed
    other,        ///< results of another case, or ones that cannot be read
};

struct FolderStanding {
    FolderState state = FolderState::empty;
    std::string reason;  ///< the error of a failed run, what differs in another case
};

/// Look at the folder of a run. The case that its results hold decides, not the name of the folder; a case
/// written before a key was introduced counts as having its default.
[[nodiscard]] FolderStanding standing_of(const SweepRun& run);

/// The word of it for tables and files.
[[nodiscard]] const char* word(FolderState state);

}  // namespace riffle::inline sweep
