// Layers of spheres as solids: [[solid]] shape = "spheres".

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <numbers>
#include <random>

#include "base/error.hpp"
#include "case/bed_surface.hpp"
#include "case/polygon.hpp"
#include "case/solid_shapes.hpp"
#include "case/units.hpp"

namespace riffle::inline case_file {

namespace {

/// Distance between two places along an axis, the shorter way around where it is periodic.
double way_along(double from, double to, double extent, bool periodic) {
    const double way = to - from;
    return periodic ? way - extent * std::round(way / extent) : way;
}

/// A layer of spheres in plan.
class SphereLayer {
  public:
    SphereLayer(const Case& c, const Solid& solid)
        : d_(solid.diameter),
          packing_(solid.packing),
          length_(c.channel.length),
          width_(c.channel.simulated_width()),
          along_(c.channel.ends == Ends::periodic),
          across_(c.channel.sides == Sides::periodic),
          random_(static_cast<std::uint64_t>(solid.seed)) {}

    [[nodiscard]] std::vector<PlanePoint> places() {
        return packing_ == SolidPacking::random ? random_places() : lattice_places();
    }

  private:
    /// Places of a lattice, from beyond the one end to beyond the other.
    [[nodiscard]] std::vector<PlanePoint> lattice_places() const {
        const bool shifted = packing_ == SolidPacking::hexagonal;
        const double rows_apart = shifted ? 0.5 * std::numbers::sqrt3 * d_ : d_;
        // Periods of the lattice: every other row of a hexagonal one is the same again.
        const auto fitted = [](double extent, double period, bool periodic) {
            return periodic ? extent / std::max(1.0, std::round(extent / period)) : period;
        };
        const double step_x = fitted(length_, d_, along_);
        const double step_y =
            shifted ? 0.5 * fitted(width_, 2.0 * rows_apart, across_) : fitted(width_, rows_apart, across_);
        std::vector<PlanePoint> places;
        const auto last = [](double extent, double step) {
            return static_cast<int>(std::ceil(extent / step)) + 1;
        };
        for (int row = -2; row <= last(width_, step_y); ++row) {
            for (int column = -2; column <= last(length_, step_x); ++column) {
                const double shift = shifted && row % 2 != 0 ? 0.75 : 0.25;
                places.push_back({(column + shift) * step_x, (row + 0.5) * step_y});
            }
        }
        return places;
    }

    /// Random sequential addition (Feder 1980): a place is taken where no sphere stands, until thousands of
    /// places in a row are not free.
    [[nodiscard]] std::vector<PlanePoint> random_places() {
        std::vector<PlanePoint> places;
        const auto uniform = [&](double low, double high) {  // the same numbers with every library
            return low + (high - low) * static_cast<double>(random_() >> 11U) * 0x1p-53;
        };
        constexpr int most_misses = 20000;
        for (int misses = 0; misses < most_misses;) {
            const double beyond = 0.5 * d_;
            const PlanePoint place{uniform(along_ ? 0.0 : -beyond, along_ ? length_ : length_ + beyond),
                                   uniform(across_ ? 0.0 : -beyond, across_ ? width_ : width_ + beyond)};
            const bool taken = std::any_of(places.begin(), places.end(), [&](const PlanePoint& other) {
                return std::hypot(way_along(place[0], other[0], length_, along_),
                                  way_along(place[1], other[1], width_, across_)) < d_;
            });
            misses = taken ? misses + 1 : 0;
            if (!taken) places.push_back(place);
        }
        // Beyond periodic ends and sides they repeat.
        const std::size_t count = places.size();
        for (int i = along_ ? -1 : 0; i <= (along_ ? 1 : 0); ++i) {
            for (int j = across_ ? -1 : 0; j <= (across_ ? 1 : 0); ++j) {
                for (std::size_t k = 0; k < count && (i != 0 || j != 0); ++k) {
                    places.push_back({places[k][0] + i * length_, places[k][1] + j * width_});
                }
            }
        }
        return places;
    }

    double d_;
    SolidPacking packing_;
    double length_;
    double width_;
    bool along_;
    bool across_;
    std::mt19937_64 random_;
};

}  // namespace

std::vector<Point3> sphere_centres(const Case& c, const Solid& solid) {
    const double spheres = c.channel.length * c.channel.simulated_width() / (solid.diameter * solid.diameter);
    constexpr double most_spheres = 20000.0;
    if (spheres > most_spheres) {
        throw InputError(
            fmt::format("{:.2g} spheres of {} would lie in the channel, expected at most {:.0f}: see "
                        "their diameter",
                        spheres, shown_quantity(solid.diameter, Dimension::length), most_spheres));
    }
    const double reach = 0.5 * solid.diameter + (c.numerics.wall_layers + 1) * c.numerics.spacing;
    const double height = solid.level.value_or(0.5 * solid.diameter);
    std::vector<Point3> centres;
    for (const PlanePoint& place : SphereLayer(c, solid).places()) {
        if (place[0] > -reach && place[0] < c.channel.length + reach && place[1] > -reach &&
            place[1] < c.channel.simulated_width() + reach) {
            centres.push_back({place[0], place[1], height});
        }
    }
    return centres;
}

Triangles sphere_layer_triangles(const Case& c, const Solid& solid) {
    Triangles all;
    for (const Point3& centre : sphere_centres(c, solid)) {
        // Many of them: a fiftieth of the spacing is fine enough.
        const Triangles one = sphere_triangles(centre, solid.diameter, 2.0 * facet_error(c));
        all.insert(all.end(), one.begin(), one.end());
    }
    return all;
}

}  // namespace riffle::inline case_file
