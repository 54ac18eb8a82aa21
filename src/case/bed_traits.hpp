#pragma once

#include <array>
#include <cstddef>
#include <string>
#include <vector>

#include "case/options.hpp"
#include "case/words.hpp"

namespace riffle::inline case_file {

/// What the rest of Riffle needs to know of a kind of bed, and of a patch of it, beside the law by which it
/// acts: a new one is a row here.
struct BedTraits {
    BedKind kind = BedKind::slip;
    bool spheres =
        false;  ///< elements with crests hold the water back by their drag; a datum lies among them
    bool no_slip = false;    ///< particles of the wall hold the water at rest: its viscous layer is resolved
    bool wall_law = false;   ///< its friction is that of a log law, over rows that do not resolve it
    bool roughness = false;  ///< that law is of a rough bed, by k_s or Manning's n
};

/// Of each kind, in the order of the enumerators.
inline constexpr std::array<BedTraits, Words<BedKind>::list.size()> bed_table{{
    {BedKind::spheres, true, false, false, false},
    {BedKind::slip, false, false, false, false},
    {BedKind::no_slip, false, true, false, false},
    {BedKind::roughness, false, false, true, true},
    {BedKind::smooth, false, false, true, false},
}};

static_assert(
    [] {
        for (std::size_t i = 0; i < bed_table.size(); ++i) {
            if (bed_table[i].kind != static_cast<BedKind>(i)) return false;
        }
        return true;
    }(),
    "each kind of bed has one row of traits, in the order of the enumerators");

[[nodiscard]] constexpr const BedTraits& traits_of(BedKind kind) {
    return bed_table[static_cast<std::size_t>(kind)];
}

/// Whether spheres hold the water back at a bed or at a patch of it.
template <class BedOrPatch>
[[nodiscard]] constexpr bool has_spheres(const BedOrPatch& bed) {
    return traits_of(bed.kind).spheres;
}

/// Whether the water rests at a bed or at a patch of it, and its viscous layer is resolved.
template <class BedOrPatch>
[[nodiscard]] constexpr bool is_no_slip(const BedOrPatch& bed) {
    return traits_of(bed.kind).no_slip;
}

/// Whether a bed or a patch of it acts by the log law of an equivalent roughness.
template <class BedOrPatch>
[[nodiscard]] constexpr bool has_roughness(const BedOrPatch& bed) {
    return traits_of(bed.kind).roughness;
}

/// The words of the kinds of which `holds(traits)`: those that a key goes with.
template <class Holds>
[[nodiscard]] std::vector<std::string> beds_where(const Holds& holds) {
    std::vector<std::string> words;
    for (const BedTraits& traits : bed_table) {
        if (holds(traits)) words.emplace_back(word(traits.kind));
    }
    return words;
}

}  // namespace riffle::inline case_file
