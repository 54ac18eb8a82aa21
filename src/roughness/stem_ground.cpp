#include "roughness/stem_ground.hpp"

#include <algorithm>
#include <cmath>

#include "case/patch_range.hpp"
#include "case/stem_feet.hpp"

namespace riffle::inline roughness {

StemGround::StemGround(const Case& c, const Vegetation& stems) {
    if (stems.stands_on.empty()) return;
    const auto ranges = ranges_of(c, stems);
    for (std::size_t k = 0; k < (c.channel.dimensions == 3 ? 2 : 1); ++k) {
        const double extent = ranges[k].to - ranges[k].from;
        const double cells = std::max(1.0, std::ceil(extent / c.numerics.spacing));
        axes_[k] = {ranges[k].from, extent / cells, static_cast<std::size_t>(cells) + 1};
    }
    // On the edge of the patch the top of a solid that ends there has two values: look a little inside.
    const auto inside = [](const Axis& axis, std::size_t n) {
        const auto last = static_cast<double>(axis.count - 1);
        constexpr double little = 1e-3;
        return axis.from +
               axis.step * std::clamp(static_cast<double>(n), little, std::max(little, last - little));
    };
    for (std::size_t j = 0; j < axes_[1].count; ++j) {
        for (std::size_t i = 0; i < axes_[0].count; ++i) {
            height_.push_back(stem_foot(c, stems, inside(axes_[0], i), inside(axes_[1], j)));
        }
    }
}

StemGround::Place StemGround::place(double at, std::size_t axis) const {
    const Axis& a = axes_[axis];
    const auto last = static_cast<double>(a.count - 1);
    const double cells = std::clamp((at - a.from) / a.step, 0.0, last);
    const auto cell = static_cast<std::size_t>(cells);
    return {cell, std::min(cell + 1, a.count - 1), cells - static_cast<double>(cell)};
}

}  // namespace riffle::inline roughness
