#pragma once

#include <string>
#include <vector>

#include "case/case.hpp"

namespace riffle::inline instruments {

/// The instruments that record without being asked for.
struct StandardProbes {
    std::vector<Probe> probes;
    std::vector<std::string> notes;  ///< what was left out, and why
};

/// Those that suit the kind of the case; none with output.standard_probes = false. `largest_step`: of the
/// run, s; no instrument samples faster than every fourth step.
[[nodiscard]] StandardProbes standard_probes(const Case& c, double largest_step);

}  // namespace riffle::inline instruments
