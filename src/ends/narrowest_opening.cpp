#include "ends/narrowest_opening.hpp"

#include <algorithm>
#include <cmath>

#include "case/outline_check.hpp"
#include "case/solid_places.hpp"

namespace riffle::inline ends {

namespace {

/// Points that see a slit by the spacing; a large duct costs no more than a cell of eddies.
int points_over(const Case& c, double extent) {
    return std::clamp(static_cast<int>(std::lround(extent / c.numerics.spacing)), 24, 64);
}

}  // namespace

double narrowest_opening(const Case& c) {
    const SolidPlaces solids(c);
    const auto is_open = [&solids](const Point3& place) { return !solids.resting_at(place); };
    const int rows = points_over(c, c.total_depth());
    const int files = c.channel.dimensions == 3 ? points_over(c, c.channel.simulated_width()) : 1;
    double least = 1.0;
    for (const Solid& solid : c.solids) {
        const auto along = solid.rests() ? extent_of(c, solid, 0) : std::nullopt;
        if (!along) continue;
        const double from = std::max(along->low, 0.0);
        const double to = std::min(along->high, c.channel.length);
        const int sections = std::clamp(static_cast<int>(std::ceil((to - from) / c.numerics.spacing)), 1, 64);
        for (int i = 0; i < sections; ++i) {
            const double x = from + (to - from) * (i + 0.5) / sections;
            least = std::min(least, open_share(c, x, c.total_depth(), rows, files, is_open));
        }
    }
    return least;
}

}  // namespace riffle::inline ends
