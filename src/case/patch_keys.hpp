#pragma once

#include <vector>

#include "case/key_table.hpp"
#include "case/units.hpp"

namespace riffle::inline case_file {

/// Add to the keys of patches those that say where a patch lies: x_from, x_to, y_from, y_to; x, y.
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
    const auto corners = [&](const char* name, auto member, const char* meaning, const char* example) {
        return make_key(s.name, name, patches, member, meaning)
            .measured_in(Dimension::length)
            .may_be_empty()
            .with_default_note("a rectangle")
            .applies_with("channel.dimensions", {"3"}, true)
            .with_example(example);
    };
    s.keys.push_back(
        corners("x", &Patch::x,
                "Corners of the outline of the patch in the plan of a three-dimensional channel, one after "
                "the other in either sense, in place of x_from, x_to, y_from and y_to.",
                R"(["100 mm", "300 mm", "200 mm"])"));
    s.keys.push_back(corners("y", &Patch::y, "Places of the same corners across the channel.",
                             R"(["50 mm", "50 mm", "150 mm"])"));
}

}  // namespace riffle::inline case_file
