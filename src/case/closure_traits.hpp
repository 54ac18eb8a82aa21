#pragma once

#include <array>
#include <cstddef>
#include <string>
#include <vector>

#include "case/options.hpp"
#include "case/words.hpp"

namespace riffle::inline case_file {

/// What a closure models.
enum class ClosureFamily {
    none,           ///< nothing: laminar flow
    mixing_length,  ///< all turbulence, by a length that grows from the bed and follows the depth
    filter,         ///< the stress of a filter width, in the mean flow
    resolved        ///< what is smaller than the eddies that the particles carry
};

/// What the rest of Riffle needs to know of a closure beside its formula: a new one is a row here.
struct ClosureTraits {
    ClosureKind kind = ClosureKind::none;
    ClosureFamily family = ClosureFamily::none;
    bool has_kappa = false;         ///< von Karman's constant is one of its numbers
    bool has_zero = false;          ///< its length begins at the height turbulence.zero
    bool by_velocity_rate = false;  ///< its eddy viscosity goes with the strain rate, or the rotation
    bool parts_stress = false;      ///< turbulence.stress_terms chooses what is kept of it
    bool damped_at_walls = false;   ///< beside a solid its length is at most kappa times the distance
};

/// Of each closure, in the order of the enumerators.
inline constexpr std::array<ClosureTraits, Words<ClosureKind>::list.size()> closure_table{{
    {ClosureKind::none, ClosureFamily::none, false, false, false, false, false},
    {ClosureKind::ramp, ClosureFamily::mixing_length, true, true, true, true, false},
    {ClosureKind::nezu_rodi, ClosureFamily::mixing_length, true, true, true, true, false},
    {ClosureKind::nikuradse, ClosureFamily::mixing_length, false, true, true, true, false},
    {ClosureKind::sps, ClosureFamily::filter, false, false, true, true, false},
    {ClosureKind::czernuszenko_rylov, ClosureFamily::mixing_length, true, true, true, false, false},
    {ClosureKind::wale, ClosureFamily::resolved, false, false, false, false, false},
    {ClosureKind::vreman, ClosureFamily::resolved, false, false, false, false, false},
    {ClosureKind::smagorinsky, ClosureFamily::resolved, true, true, false, false, true},
}};

static_assert(
    [] {
        for (std::size_t i = 0; i < closure_table.size(); ++i) {
            if (closure_table[i].kind != static_cast<ClosureKind>(i)) return false;
        }
        return true;
    }(),
    "each closure has one row of traits, in the order of the enumerators");

[[nodiscard]] constexpr const ClosureTraits& traits_of(ClosureKind kind) {
    return closure_table[static_cast<std::size_t>(kind)];
}

/// The words of the closures of which `holds(traits)`: those that a key goes with.
template <class Holds>
[[nodiscard]] std::vector<std::string> closures_where(const Holds& holds) {
    std::vector<std::string> words;
    for (const ClosureTraits& traits : closure_table) {
        if (holds(traits)) words.emplace_back(word(traits.kind));
    }
    return words;
}

}  // namespace riffle::inline case_file
