#pragma once

#include <algorithm>
#include <cmath>
#include <vector>

#include "case/case.hpp"

namespace riffle::inline case_file {

// Patches on the two sides of a channel's centreline.

/// A part of the width, without its name, as a mirror shows it from the centreline.
template <class Patch>
[[nodiscard]] Patch mirrored(Patch patch, double width) {
    const double from = patch.y_from.value_or(0.0);
    patch.y_from = width - patch.y_to.value_or(width);
    patch.y_to = width - from;
    patch.name.clear();
    return patch;
}

/// A section is solved over half of the channel, of which the other half is the mirror image: the first patch
/// that has none on the other side of the centreline; nullptr where all have, or half is all that there is.
template <class Patch>
[[nodiscard]] const Patch* without_image(const Case& c, const std::vector<Patch>& patches) {
    const double width = c.channel.width;
    const double tolerance = 1e-6 * width;
    const auto found = std::find_if(patches.begin(), patches.end(), [&](const Patch& patch) {
        const Patch image = mirrored(patch, width);
        return std::none_of(patches.begin(), patches.end(), [&](const Patch& other) {
            Patch same = other;
            same.name.clear();
            same.y_from = image.y_from;
            same.y_to = image.y_to;
            return std::abs(other.y_from.value_or(0.0) - *image.y_from) < tolerance &&
                   std::abs(other.y_to.value_or(width) - *image.y_to) < tolerance && same == image;
        });
    });
    return c.channel.sides == Sides::half || found == patches.end() ? nullptr : &*found;
}

}  // namespace riffle::inline case_file
