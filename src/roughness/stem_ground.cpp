#include "roughness/stem_ground.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>
#include <vector>

#include "case/patch_range.hpp"
#include "case/stem_feet.hpp"

namespace riffle::inline roughness {

StemGround::StemGround(const Case& c, const Vegetation& stems) {
    if (stems.stands_on.empty()) return;
    const auto ranges = ranges_of(c, stems);
    std::array<PlanTable::Axis, 2> axes;
    for (std::size_t k = 0; k < (c.channel.dimensions == 3 ? 2 : 1); ++k) {
        const double extent = ranges[k].to - ranges[k].from;
        const double cells = std::max(1.0, std::ceil(extent / c.numerics.spacing));
        axes[k] = {ranges[k].from, extent / cells, static_cast<std::size_t>(cells) + 1};
    }
    // On the edge of the patch the top of a solid that ends there has two values: look a little inside.
    const auto inside = [](const PlanTable::Axis& axis, std::size_t n) {
        const auto last = static_cast<double>(axis.count - 1);
        constexpr double little = 1e-3;
        return axis.first +
               axis.step * std::clamp(static_cast<double>(n), little, std::max(little, last - little));
    };
    std::vector<double> heights;
    for (std::size_t j = 0; j < axes[1].count; ++j) {
        for (std::size_t i = 0; i < axes[0].count; ++i) {
            heights.push_back(stem_foot(c, stems, inside(axes[0], i), inside(axes[1], j)));
        }
    }
    height_ = {axes[0], axes[1], std::move(heights)};
}

}  // namespace riffle::inline roughness
