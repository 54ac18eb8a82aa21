#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <vector>

#include "case/case_check.hpp"
#include "case/patch_range.hpp"
#include "case/units.hpp"

namespace riffle::inline case_file {

// What is wrong with patches, of the bed and of vegetation alike.

/// What is wrong with the ranges of a patch: beyond the channel, or the wrong way round. `keys`: x_to and
/// y_to of its section.
template <class Patch>
[[nodiscard]] Findings beyond_channel(const Case& c, const Patch& patch,
                                      const std::array<const char*, 2>& keys) {
    const auto ranges = ranges_of(c, patch);
    const std::array extent{c.channel.length, c.channel.simulated_width()};
    constexpr std::array axes{"x", "y"};
    const std::size_t count = c.channel.dimensions == 3 ? 2 : 1;
    for (std::size_t k = 0; k < count; ++k) {
        if (ranges[k].to > extent[k] * (1 + 1e-9) || ranges[k].from >= ranges[k].to) {
            return {{.detail = fmt::format("stands from {} = {} to {}: expected a stretch between 0 and {}",
                                           axes[k], shown_length(ranges[k].from), shown_length(ranges[k].to),
                                           shown_length(extent[k])),
                     .key = keys[k]}};
        }
    }
    return {};
}

/// The first of the patches before one in its list that lies where it does; nullptr where none does.
template <class Patch>
[[nodiscard]] const Patch* patch_below(const Case& c, const std::vector<Patch>& patches, const Patch& patch) {
    const Patch* const own = &patch;
    const auto* const found = std::find_if(
        patches.data(), own, [&](const Patch& other) { return lie_over_each_other(c, patch, other); });
    return found != own ? found : nullptr;
}

}  // namespace riffle::inline case_file
