#include "roughness/patch_area.hpp"

#include <algorithm>

namespace riffle::inline roughness {

double PatchStretch::share(double place, double width) const {
    if (all) return 1.0;
    const auto overlap = [&](double shift) {
        return std::max(
            0.0, std::min(place + 0.5 * width, to + shift) - std::max(place - 0.5 * width, from + shift));
    };
    double length = overlap(0.0);
    if (period > 0.0) length += overlap(-period) + overlap(period);
    return length / width;
}

}  // namespace riffle::inline roughness
