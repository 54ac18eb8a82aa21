#include "ends/narrowest_opening.hpp"

#include <algorithm>
#include <cmath>

#include "case/outline_check.hpp"
#include "case/solid_places.hpp"

namespace riffle::inline ends {

namespace {

/// The part of the section at a place that no solid at rest takes up.
double open_share(const Case& c, const SolidPlaces& solids, double x) {
    // A slit is seen by the spacing, and a large duct costs no more than a cell of eddies.
    const auto points = [&](double extent) {
        return std::clamp(static_cast<int>(std::lround(extent / c.numerics.spacing)), 24, 64);
    };
    const bool in_space = c.channel.dimensions == 3;
    const int rows = points(c.total_depth());
    const int files = in_space ? points(c.channel.simulated_width()) : 1;
    int open = 0;
    for (int i = 0; i < files; ++i) {
        for (int k = 0; k < rows; ++k) {
            const Point3 p{x, c.channel.simulated_width() * (i + 0.5) / files,
                           c.total_depth() * (k + 0.5) / rows};
            open += solids.resting_at(p) ? 0 : 1;
        }
    }
    return static_cast<double>(open) / (files * rows);
}

}  // namespace

double narrowest_opening(const Case& c) {
    const SolidPlaces solids(c);
    double least = 1.0;
    for (const Solid& solid : c.solids) {
        const auto along = solid.rests() ? extent_of(c, solid, 0) : std::nullopt;
        if (!along) continue;
        const double from = std::max(along->low, 0.0);
        const double to = std::min(along->high, c.channel.length);
        const int sections = std::clamp(static_cast<int>(std::ceil((to - from) / c.numerics.spacing)), 1, 64);
        for (int i = 0; i < sections; ++i) {
            least = std::min(least, open_share(c, solids, from + (to - from) * (i + 0.5) / sections));
        }
    }
    return least;
}

}  // namespace riffle::inline ends
