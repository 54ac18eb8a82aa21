#include "column/twin_reaches.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "base/error.hpp"
#include "case/bed_patch.hpp"
#include "case/flow_kind.hpp"
#include "case/patch_range.hpp"
#include "column/twin_channel.hpp"

namespace riffle::inline column {

std::vector<Reach> twin_reaches(const Case& c, double unit_discharge, double length) {
    std::vector<const BedPatch*> across;
    for (const BedPatch& patch : c.bed_patches) {
        if (covers_width(c, patch) && ranges_of(c, patch)[0].from < length) across.push_back(&patch);
    }
    std::sort(across.begin(), across.end(), [&c](const BedPatch* a, const BedPatch* b) {
        return ranges_of(c, *a)[0].from < ranges_of(c, *b)[0].from;
    });
    for (const BedPatch& patch : c.bed_patches) {
        if (!covers_width(c, patch)) {
            throw InputError(fmt::format(
                "[[bed_patch]] {} lies in a part of the width, and varied flow is that over one bed at each place along "
                "the channel: let it cover the width, or leave it out",
                patch.name));
        }
    }
    Case plain = c;
    plain.bed_patches.clear();
    std::vector<Reach> reaches;
    double done = 0.0;
    const auto add = [&](const std::string& name, double to, const Case& of) {
        if (!(to > done)) return;
        if (!channel_or_walls_resist(of)) {
            throw InputError(fmt::format(
                "nothing resists the flow over {}: the varied flow is found with the friction of each bed; give it a "
                "roughness, or kind = \"smooth\"",
                name.empty() ? std::string("[bed]") : fmt::format("[[bed_patch]] {}", name)));
        }
        reaches.push_back({name, done, to, twin_channel(of, unit_discharge)});
        done = to;
    };
    for (const BedPatch* const patch : across) {
        const PatchRange along = ranges_of(c, *patch)[0];
        add("", along.from, plain);
        const bool to_the_end = along.to >= c.channel.length * (1.0 - 1e-9);
        add(patch->name, to_the_end ? length : std::min(along.to, length), with_bed_of(c, *patch));
    }
    add("", length, plain);
    return reaches;
}

}  // namespace riffle::inline column
