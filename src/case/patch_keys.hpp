#pragma once

#include <vector>

#include "case/key_table.hpp"
#include "case/units.hpp"

namespace riffle::inline case_file {

/// Add to the keys of patches those that say where a patch lies: x_from, x_to, y_from, y_to.
template <class Patch>
void add_range_keys(SectionKeys& s, std::vector<Patch> Case::*patches) {
    const auto edge = [&](const char* name, auto member, const char* meaning, const char* otherwise) {
        return make_key(s.name, name, patches, member, meaning)
            .measured_in(Dimension::length)
            .at_least(0)
            .unset_by("auto", otherwise);
    };
    s.keys.push_back(
        edge("x_from", &Patch::x_from, "Where the patch begins along the channel.", "at its start"));
    s.keys.push_back(edge("x_to", &Patch::x_to, "Where it ends along the channel.", "at its end"));
    s.keys.push_back(edge("y_from", &Patch::y_from,
                          "Where the patch begins across a three-dimensional channel.", "at its side, y = 0")
                         .applies_with("channel.dimensions", {"3"}, true));
    s.keys.push_back(edge("y_to", &Patch::y_to, "Where it ends across the channel.", "at the other side")
                         .applies_with("channel.dimensions", {"3"}, true));
}

}  // namespace riffle::inline case_file
