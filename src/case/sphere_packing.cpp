// Layers of spheres as solids: [[solid]] shape = "spheres".

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <limits>
#include <map>
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

/// A sphere seen from above.
struct Disc {
    PlanePoint place{};
    double diameter = 0.0;
};

/// A layer of spheres in plan.
class SphereLayer {
  public:
    SphereLayer(const Case& c, const Solid& solid)
        : d_(solid.diameter),
          sizes_(sizes_of(solid)),
          shares_(shares_of(solid)),
          on_bed_(!solid.level),
          packing_(solid.packing),
          length_(c.channel.length),
          width_(c.channel.simulated_width()),
          along_(c.channel.ends == Ends::periodic),
          across_(c.channel.sides == Sides::periodic),
          random_(static_cast<std::uint64_t>(solid.seed)) {}

    [[nodiscard]] std::vector<Disc> discs() {
        if (packing_ == SolidPacking::random) return random_discs();
        std::vector<Disc> discs;
        for (const PlanePoint& place : lattice_places()) discs.push_back({place, d_});
        return discs;
    }

  private:
    /// From the largest on.
    [[nodiscard]] static std::vector<double> sizes_of(const Solid& solid) {
        std::vector<double> sizes{solid.diameter};
        sizes.insert(sizes.end(), solid.smaller_diameters.begin(), solid.smaller_diameters.end());
        return sizes;
    }

    /// Of the plan, for each size but the smallest.
    [[nodiscard]] static std::vector<double> shares_of(const Solid& solid) {
        const std::size_t larger = solid.smaller_diameters.size();
        constexpr double covered = 0.45;
        return solid.area_shares.empty() ? std::vector<double>(larger, covered / static_cast<double>(larger))
                                         : solid.area_shares;
    }

    /// Distance in plan of two spheres that touch: on the bed a small one lies partly below a large one.
    [[nodiscard]] double apart(double d, double other) const {
        if (d == other) return d;
        return on_bed_ ? std::sqrt(d * other) : 0.5 * (d + other);
    }

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
    /// places in a row are not free; of the larger of several sizes until they cover their share.
    [[nodiscard]] std::vector<Disc> random_discs() {
        std::vector<Disc> discs;
        const auto uniform = [&](double low, double high) {  // the same numbers with every library
            return low + (high - low) * static_cast<double>(random_() >> 11U) * 0x1p-53;
        };
        constexpr int most_misses = 20000;
        for (std::size_t k = 0; k < sizes_.size(); ++k) {
            const double d = sizes_[k];
            const double wanted =
                k < shares_.size() ? shares_[k] * length_ * width_ : std::numeric_limits<double>::infinity();
            double covered = 0.0;
            for (int misses = 0; misses < most_misses && covered < wanted;) {
                const double beyond = 0.5 * d;
                const PlanePoint place{uniform(along_ ? 0.0 : -beyond, along_ ? length_ : length_ + beyond),
                                       uniform(across_ ? 0.0 : -beyond, across_ ? width_ : width_ + beyond)};
                const bool taken = std::any_of(discs.begin(), discs.end(), [&](const Disc& other) {
                    return std::hypot(way_along(place[0], other.place[0], length_, along_),
                                      way_along(place[1], other.place[1], width_, across_)) <
                           apart(d, other.diameter);
                });
                misses = taken ? misses + 1 : 0;
                if (taken) continue;
                discs.push_back({place, d});
                const bool within =
                    place[0] >= 0.0 && place[0] < length_ && place[1] >= 0.0 && place[1] < width_;
                covered += within ? 0.25 * std::numbers::pi * d * d : 0.0;
            }
        }
        // Beyond periodic ends and sides they repeat.
        const std::size_t count = discs.size();
        for (int i = along_ ? -1 : 0; i <= (along_ ? 1 : 0); ++i) {
            for (int j = across_ ? -1 : 0; j <= (across_ ? 1 : 0); ++j) {
                for (std::size_t k = 0; k < count && (i != 0 || j != 0); ++k) {
                    discs.push_back({{discs[k].place[0] + i * length_, discs[k].place[1] + j * width_},
                                     discs[k].diameter});
                }
            }
        }
        return discs;
    }

    double d_;
    std::vector<double> sizes_;
    std::vector<double> shares_;
    bool on_bed_;
    SolidPacking packing_;
    double length_;
    double width_;
    bool along_;
    bool across_;
    std::mt19937_64 random_;
};

}  // namespace

std::vector<LaidSphere> laid_spheres(const Case& c, const Solid& solid) {
    const double least = solid.smaller_diameters.empty() ? solid.diameter : solid.smaller_diameters.back();
    const double spheres = c.channel.length * c.channel.simulated_width() / (least * least);
    constexpr double most_spheres = 20000.0;
    if (spheres > most_spheres) {
        throw InputError(
            fmt::format("{:.2g} spheres of {} would lie in the channel, expected at most {:.0f}: see "
                        "their diameter",
                        spheres, shown_quantity(least, Dimension::length), most_spheres));
    }
    std::vector<LaidSphere> laid;
    for (const auto& [place, diameter] : SphereLayer(c, solid).discs()) {
        const double reach = 0.5 * diameter + (c.numerics.wall_layers + 1) * c.numerics.spacing;
        if (place[0] > -reach && place[0] < c.channel.length + reach && place[1] > -reach &&
            place[1] < c.channel.simulated_width() + reach) {
            laid.push_back({{place[0], place[1], solid.level.value_or(0.5 * diameter)}, diameter});
        }
    }
    return laid;
}

Triangles sphere_layer_triangles(const Case& c, const Solid& solid, std::vector<std::string>* notes) {
    Triangles all;
    std::map<double, int, std::greater<>> count;  // in the channel, by size
    for (const auto& [centre, diameter] : laid_spheres(c, solid)) {
        // Many of them: a fiftieth of the spacing is fine enough.
        const Triangles one = sphere_triangles(centre, diameter, 2.0 * facet_error(c));
        all.insert(all.end(), one.begin(), one.end());
        count[diameter] += centre[0] >= 0.0 && centre[0] < c.channel.length && centre[1] >= 0.0 &&
                                   centre[1] < c.channel.simulated_width()
                               ? 1
                               : 0;
    }
    for (const auto& [diameter, spheres] : count) {
        if (notes == nullptr || solid.smaller_diameters.empty()) break;
        notes->push_back(fmt::format("{}: {} spheres of {} cover {:.1f} % of the plan", solid.name, spheres,
                                     shown_quantity(diameter, Dimension::length),
                                     25.0 * std::numbers::pi * spheres * diameter * diameter /
                                         (c.channel.length * c.channel.simulated_width())));
    }
    return all;
}

}  // namespace riffle::inline case_file
