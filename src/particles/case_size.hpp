#pragma once

#include <cstddef>
#include <optional>
#include <string>

#include "case/case.hpp"

namespace riffle::inline particles {

/// How large a case is, from its keys alone: before anything is built.
struct CaseSize {
    double places = 0.0;  ///< of the lattice that the water is cut from, solids included
    double walls = 0.0;   ///< wall particles
    double cells = 0.0;   ///< of the grids over the domain and of the mean field
    double bytes = 0.0;   ///< of memory that a run takes at least
};
[[nodiscard]] CaseSize estimate_size(const Case& c);

/// Which length of a case looks as if it had a wrong unit, with what may be meant, as a sentence: one that is
/// some thousands of spacings. Empty where none does.
[[nodiscard]] std::string unit_slip(const Case& c);

/// Refuse a case that is larger than the memory `available` (bytes, if the system tells), or has more than a
/// million particles and a length that looks like a slip of units, unless `confirmed`; and one with more
/// particles or cells than 32-bit numbers count, in any case. Throws InputError that tells the estimate, the
/// slip, and the option `--large` that confirms.
void check_size(const Case& c, bool confirmed, std::optional<std::size_t> available);

}  // namespace riffle::inline particles
