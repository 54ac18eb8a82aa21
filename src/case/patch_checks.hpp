#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <functional>
#include <string>
#include <vector>

#include "case/case_check.hpp"
#include "case/outline_check.hpp"
#include "case/patch_range.hpp"
#include "case/units.hpp"

namespace riffle::inline case_file {

// What is wrong with patches, of the bed and of vegetation alike.

/// What is wrong with the ranges of a patch: beyond the channel, or the wrong way round.
template <class Patch>
[[nodiscard]] Findings beyond_channel(const Case& c, const Patch& patch, const std::string& section) {
    const auto ranges = ranges_of(c, patch);
    const std::array extent{c.channel.length, c.channel.simulated_width()};
    constexpr std::array axes{"x", "y"};
    const std::size_t count = c.channel.dimensions == 3 ? 2 : 1;
    for (std::size_t k = 0; k < count; ++k) {
        if (ranges[k].to > extent[k] * (1 + 1e-9) || ranges[k].from < -1e-9 * extent[k] ||
            ranges[k].from >= ranges[k].to) {
            return {{.detail = fmt::format("stands from {} = {} to {}: expected a stretch between 0 and {}",
                                           axes[k], shown_length(ranges[k].from), shown_length(ranges[k].to),
                                           shown_length(extent[k])),
                     .key = fmt::format("{}.{}{}", section, axes[k], is_outlined(patch) ? "" : "_to")}};
        }
    }
    return {};
}

/// The rows of a section for the outlines of its patches in plan, and those that follow.
template <class Patch>
[[nodiscard]] std::vector<CaseCheck> plan_outline_rows(const std::string& section,
                                                       const std::vector<CaseCheck>& following) {
    const auto key = [&](const char* name) { return section + "." + name; };
    const std::vector<std::string> corners{key("x"), key("y")};
    const auto fault = [](OutlineFault kind) {
        return [kind](const Case&, const Patch& patch) {
            return patch.x.empty() && patch.y.empty() ? Findings{}
                                                      : outline_findings({patch.x, patch.y}, kind, "", "y");
        };
    };
    std::vector<CaseCheck> rows{
        {{key("x"), key("x_from"), key("x_to"), key("y_from"), key("y_to")},
         "an outline (`x`, `y`) beside `x_from`, `x_to`, `y_from` or `y_to`",
         "each says by itself where the patch lies",
         "keep one of them",
         [](const Case&, const Patch& patch) {
             return found_if((!patch.x.empty() || !patch.y.empty()) &&
                                 (patch.x_from || patch.x_to || patch.y_from || patch.y_to),
                             "an outline stands beside bounds of a rectangle");
         },
         true},
        outline_row(OutlineFault::uneven, corners, "not as many values of `x` as of `y`",
                    fault(OutlineFault::uneven)),
        outline_row(OutlineFault::few, corners, "an outline of fewer than three corners",
                    fault(OutlineFault::few)),
        {corners, "outlines of more than 1000 corners", "each edge is compared with each other one",
         "leave out corners nearer to each other than a spacing of the particles",
         [](const Case&, const Patch& patch) {
             constexpr std::size_t most = 1000;
             return found_if(patch.x.size() > most, "{} corners", patch.x.size());
         },
         true},
        outline_row(OutlineFault::crossing, corners, "an outline that crosses or touches itself",
                    fault(OutlineFault::crossing)),
    };
    rows.insert(rows.end(), following.begin(), following.end());
    return rows;
}

/// The first of the patches before one in its list that lies where it does; nullptr where none does.
/// `counts`: of which of them it is asked.
template <class Patch>
[[nodiscard]] const Patch* patch_below(
    const Case& c, const std::vector<Patch>& patches, const Patch& patch,
    const std::function<bool(const Patch&)>& counts = [](const Patch&) { return true; }) {
    const Patch* const own = &patch;
    const auto* const found = std::find_if(patches.data(), own, [&](const Patch& other) {
        return counts(other) && lie_over_each_other(c, patch, other);
    });
    return found != own ? found : nullptr;
}

/// What is wrong with a patch whose least extent (m) no particle resolves. One that ends before it begins is
/// told of by beyond_channel().
[[nodiscard]] inline Findings below_spacing(const Case& c, double least_extent) {
    return found_if(least_extent >= 0.0 && least_extent < c.numerics.spacing * (1 - 1e-9),
                    "is {} in one direction, and the particles stand {} apart", shown_length(least_extent),
                    shown_length(c.numerics.spacing));
}

}  // namespace riffle::inline case_file
