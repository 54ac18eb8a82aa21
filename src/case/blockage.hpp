#pragma once

#include <cstddef>
#include <optional>

#include "case/case.hpp"

namespace riffle::inline case_file {

/// Solids at rest that leave the water no way along the channel.
struct Blockage {
    std::size_t solid = 0;  ///< the one that closes the last way
    double x = 0.0;         ///< so far the water comes from x = 0, m
    double level = 0.0;     ///< up to which a way was looked for, m
};

/// The highest level at which water may pass along a channel over what stands in it, m over z = 0: the lid;
/// between open ends half as high again as what the ends name, where a discharge comes in or a table rules as
/// far as the channel has room; in a periodic channel the level of water that the slope has driven to one end
/// and that stands there.
[[nodiscard]] double highest_way(const Case& c);

/// Whether a channel whose water a slope drives, or that has open ends, is closed by solids at rest: no way
/// of the particles' width leads through it from the bed up to highest_way(). Solids that move may open one,
/// and porous zones are one. Solids must have their shapes.
[[nodiscard]] std::optional<Blockage> blockage(const Case& c);

/// The narrowest place of the widest way along a channel.
struct Narrows {
    int width = 0;   ///< in spacings
    double x = 0.0;  ///< so far a wider way leads from x = 0, m
};

/// Of a channel with solids at rest that reach up to highest_way(): of the ways beside, below and between
/// them. Nothing where it is `most` spacings wide or wider, where nothing stands so tall, and where the
/// channel is closed. Solids must have their shapes.
[[nodiscard]] std::optional<Narrows> narrowest_way(const Case& c, int most);

}  // namespace riffle::inline case_file
