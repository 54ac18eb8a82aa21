#include "column/twin_reaches.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <optional>
#include <string>

#include "base/error.hpp"
#include "case/bed_patch.hpp"
#include "case/flow_kind.hpp"
#include "case/patch_range.hpp"
#include "column/twin_channel.hpp"

namespace riffle::inline column {

namespace {

/// Places along a channel of a length where its bed may change, from 0 to its end, m. What reaches to the end
/// of the case goes on behind it.
std::vector<double> edges_of_beds(const Case& c, double length) {
    std::vector<double> edges{0.0, length};
    const auto add = [&](double x) {
        constexpr double rounding = 1e-9;
        if (x < std::min(length, c.channel.length * (1.0 - rounding))) edges.push_back(x);
    };
    for (const BedPatch& patch : c.bed_patches) {
        if (is_outlined(patch)) {
            throw InputError(fmt::format(
                "[[bed_patch]] {} has an outline, and varied flow is that over beds which begin and end at one place "
                "each: give it x_from and x_to, or leave it out",
                patch.name));
        }
        const PatchRange along = ranges_of(c, patch)[0];
        add(along.from);
        add(along.to);
    }
    std::sort(edges.begin(), edges.end());
    edges.erase(std::unique(edges.begin(), edges.end()), edges.end());
    return edges;
}

/// Names of the patches at a place along the channel, "" where there are none.
std::string names_at(const Case& c, double x) {
    std::string names;
    for (const BedPatch& patch : c.bed_patches) {
        if (stretches_of(c, patch, 1, x).empty()) continue;
        names += (names.empty() ? "" : " and ") + patch.name;
    }
    return names;
}

std::string bed_text(const std::string& names) {
    return names.empty() ? std::string("[bed]") : fmt::format("[[bed_patch]] {}", names);
}

}  // namespace

std::vector<Reach> twin_reaches(const Case& c, double unit_discharge, double length) {
    const std::vector<double> edges = edges_of_beds(c, length);
    std::vector<Reach> reaches;
    std::optional<Case> last;
    for (std::size_t k = 0; k + 1 < edges.size(); ++k) {
        const double x = std::min(0.5 * (edges[k] + edges[k + 1]), c.channel.length);
        const Case here = with_bed_at(c, x);
        if (last && here.same_parameters(*last)) {
            reaches.back().to = edges[k + 1];
            continue;
        }
        const std::string names = names_at(c, x);
        if (!here.bed_patches.empty() && !strips_have_section(c, x)) {
            throw InputError(fmt::format(
                "[[bed_patch]] {} lies in a part of the width, and the friction of beds beside each other is that of the "
                "cross-section's twin: plane beds between side walls, the same on both sides of the centreline; let it "
                "cover the width, or leave it out",
                names));
        }
        if (!channel_or_walls_resist(here)) {
            throw InputError(fmt::format(
                "nothing resists the flow over {}: the varied flow is found with the friction of each bed; give it a "
                "roughness, or kind = \"smooth\"",
                bed_text(names)));
        }
        reaches.push_back({names, edges[k], edges[k + 1], twin_channel(here, unit_discharge)});
        last = here;
    }
    return reaches;
}

}  // namespace riffle::inline column
