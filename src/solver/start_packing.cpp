#include "solver/start_packing.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <set>

#include "base/notice.hpp"
#include "base/parallel.hpp"
#include "boundary/boundary_planes.hpp"
#include "boundary/solid_surface.hpp"
#include "boundary/wall.hpp"
#include "boundary/wall_motion.hpp"
#include "case/outline.hpp"
#include "particles/lattice.hpp"
#include "particles/particle_cells.hpp"
#include "sph/lattice_sum.hpp"
#include "sph/scalar_kernel.hpp"

namespace riffle::inline solver {

namespace {

constexpr std::size_t packing_block = 256;
// A heavy ball that rolls down the kernel's sum: of lambda, its largest curvature in units of 1/(h dx), some
// 4, pace * lambda must stay below 2 (1 + inertia).
constexpr double inertia = 0.9;
constexpr double pace = 0.3;
constexpr double longest_move = 0.1;  // of a spacing, in an iteration
constexpr int most_iterations = 2000;
constexpr int iterations_against_air = 300;  ///< where it finds its places it takes some hundred
constexpr double even_enough = 2e-3;
// A start that is not asked to be packed keeps its lattice up to here.
constexpr double worth_packing = 0.05;

template <int D>
using Places = std::array<std::vector<double>, static_cast<std::size_t>(D)>;

/// Particles at rest on the lattice, without displacement.
template <int D>
Particles<D> on_lattice(Case c) {
    c.start.jitter = 0.0;
    return lattice_particles<D>(c);
}

/// The surface of the water at the start: level, or the outline that the case draws.
class SurfaceAtStart {
  public:
    explicit SurfaceAtStart(const Case& c)
        : level_(c.total_depth()), outline_{c.start.water_x, c.start.water_z} {}

    /// How far a place is out of the water, m; below zero in it. Beside an outline that follows bed and walls
    /// that is no more than the distance from these.
    template <int D>
    [[nodiscard]] double distance(const Vec<D>& place) const {
        const double height = place[D - 1];
        if (outline_.size() == 0) return height - level_;
        const double distance = distance_from_outline(outline_, place[0], height);
        return contains(outline_, place[0], height) ? -distance : distance;
    }

  private:
    double level_;  ///< m
    Outline outline_;
};

/// The places of the lattice within `reach` of the water that no solid takes: what it would be pressed
/// against if its surface were none. None under a lid.
template <int D>
Places<D> places_over_water(const Case& c, const SurfaceAtStart& surface, double reach) {
    if (c.channel.top == Top::wall) {
        return {};
    }
    Case full = c;
    double top = c.total_depth();
    for (const double z : c.start.water_z) top = std::max(top, z);
    const Domain<D> domain = domain_of<D>(c);
    full.start.water_x = {domain.lower[0], domain.upper[0], domain.upper[0], domain.lower[0]};
    full.start.water_z = {0.0, 0.0, top + reach, top + reach};
    const Particles<D> all = on_lattice<D>(full);
    const Particles<D> wet = on_lattice<D>(c);
    std::set<Vec<D>> water;
    for (std::size_t i = 0; i < wet.size(); ++i) water.insert(vector_of(wet.position, i));
    Places<D> places;
    for (std::size_t i = 0; i < all.size(); ++i) {
        const Vec<D> place = vector_of(all.position, i);
        if (water.contains(place) || surface.distance<D>(place) > reach) continue;
        for (std::size_t k = 0; k < places.size(); ++k) places[k].push_back(place[k]);
    }
    return places;
}

template <int D>
class Packer {
  public:
    /// `air_moves`: whether the places over the water may, beside a solid that stands through its surface.
    Packer(const Case& c, const Scheme& scheme, bool air_moves, Particles<D>& particles)
        : c_(c),
          h_(scheme.smoothing_length),
          kernel_(scalar_kernel<D>(c.numerics.kernel)),
          domain_(domain_of<D>(c)),
          volume_(lattice_of(c).volume()),
          surface_(c),
          surfaces_(c),
          planes_(boundary_planes<D>(c)),
          particles_(particles) {
        WallParticles<D> walls = wall_particles<D>(c);
        walls_ = std::move(walls.position);
        wall_volume_ = std::move(walls.volume);
        places_ = particles.position;
        // The kernel of the water sees places up to 2 h above it, and those that move as far again.
        Places<D> above = places_over_water<D>(c, surface_, 2.0 * h_);
        stands_through_ = c.channel.top == Top::free_surface && stands_through_surface(above);
        air_moves_ = air_moves && stands_through_;
        if (air_moves_) above = places_over_water<D>(c, surface_, 4.0 * h_);
        for (std::size_t k = 0; k < axes; ++k) {
            Places<D>& side = air_moves_ ? places_ : walls_;
            side[k].insert(side[k].end(), above[k].begin(), above[k].end());
        }
        wall_volume_.resize(walls_[0].size(), volume_);
        choose_mobile();
    }

    /// Whether a solid stands among the places over the water.
    [[nodiscard]] bool stands_through() const { return stands_through_; }

    PackedStart run(int at_most) {
        PackedStart result;
        std::vector<Sum> sums = sums_of_mobile();
        result.unevenness_before = result.unevenness_after = unevenness(sums);
        if (!c_.start.packed && result.unevenness_before < worth_packing) return result;
        notice(fmt::format("packing {} particles", mobile_.size()));
        while (result.unevenness_after >= even_enough && result.iterations < at_most) {
            parallel_blocks(mobile_.size(), packing_block, [&](std::size_t begin, std::size_t end) {
                for (std::size_t m = begin; m < end; ++m) move(mobile_[m], sums[m].gradient);
            });
            sums = sums_of_mobile();
            result.unevenness_after = unevenness(sums);
            ++result.iterations;
        }
        result.share.assign(particles_.size(), 1.0);
        const double full = lattice_kernel_sum<D>(c_);
        for (std::size_t m = 0; m < mobile_.size(); ++m) {
            const std::size_t i = mobile_[m].place;
            if (is_water(i)) result.share[i] = full / sums[m].value;
        }
        return result;
    }

    /// Move the water to the places that run() has found.
    void place() {
        for (const Mobile& mobile : mobile_) {
            for (std::size_t k = 0; k < axes && is_water(mobile.place); ++k) {
                particles_.position[k][mobile.place] = places_[k][mobile.place];
            }
        }
    }

  private:
    static constexpr std::size_t axes = D;

    /// The kernel's sum at a place.
    struct Sum {
        double value = 0.0;  ///< of V W
        Vec<D> gradient{};   ///< h times that of V grad W
    };
    /// A place that may move.
    struct Mobile {
        std::size_t place = 0;
        Vec<D> velocity{};       ///< m an iteration
        double clearance = 0.0;  ///< no solid is nearer, m
    };

    /// The largest gradient at the water's places.
    [[nodiscard]] double unevenness(const std::vector<Sum>& sums) const {
        double largest = 0.0;
        for (std::size_t m = 0; m < sums.size(); ++m) {
            largest = std::max(largest, is_water(mobile_[m].place) ? length_of(sums[m].gradient) : 0.0);
        }
        return largest;
    }

    static double length_of(const Vec<D>& a) {
        return D == 2 ? std::hypot(a[0], a[1]) : std::hypot(a[0], a[1], a[axes - 1]);
    }

    [[nodiscard]] bool is_water(std::size_t place) const { return place < particles_.size(); }

    /// Whether a solid stands among the places over the surface. Those beside it then move too: else the gaps
    /// that its face leaves among them would draw water up along it. They and the water keep to their sides
    /// of the surface.
    [[nodiscard]] bool stands_through_surface(const Places<D>& above) const {
        for (std::size_t i = 0; i < above[0].size(); ++i) {
            const Vec<D> place = vector_of(above, i);
            if (surface_.distance<D>(place) < 2.0 * h_ &&
                distance_from_solids(place, reach_of_air()) < reach_of_air()) {
                return true;
            }
        }
        return false;
    }
    /// How far from solids water moves, and the places over it.
    [[nodiscard]] double reach_of_water() const { return 8.0 * h_; }
    [[nodiscard]] double reach_of_air() const { return 3.0 * h_; }

    [[nodiscard]] bool keeps_its_side(std::size_t place, const Vec<D>& at) const {
        if (!stands_through_) return true;
        const double over = surface_.distance<D>(at);
        return is_water(place) ? over < 0.0 : over > 0.0 && over < 2.0 * h_;
    }

    void choose_mobile() {
        for (std::size_t i = 0; i < places_[0].size(); ++i) {
            const Vec<D> place = vector_of(places_, i);
            if (!is_water(i) && (!air_moves_ || !keeps_its_side(i, place))) {
                continue;  // what the places over the water that move are pressed against
            }
            const double reach = is_water(i) ? reach_of_water() : reach_of_air();
            const double clearance = distance_from_solids(place, reach);
            if (clearance < reach || (is_water(i) && c_.start.jitter > 0.0)) {
                mobile_.push_back({i, {}, clearance});
            }
        }
    }

    /// Distance from the nearest surface of a solid, at most `limit`; below zero inside.
    [[nodiscard]] double distance_from_solids(const Vec<D>& place, double limit) const {
        double nearest = limit;
        for (std::size_t solid = 0; solid < surfaces_.size(); ++solid) {
            if (const auto foot = surfaces_.nearest(solid, in_space_of<D>(place), limit)) {
                nearest = std::min(nearest, foot->distance);
            }
        }
        return nearest;
    }

    [[nodiscard]] std::vector<Sum> sums_of_mobile() const {
        typename ParticleCells<D>::Positions positions;
        for (std::size_t k = 0; k < axes; ++k) positions[k] = JoinedValues(places_[k], walls_[k]);
        const ParticleCells<D> cells(domain_, positions, 2.0 * h_);
        std::vector<Sum> sums(mobile_.size());
        parallel_blocks(mobile_.size(), packing_block, [&](std::size_t begin, std::size_t end) {
            for (std::size_t m = begin; m < end; ++m) {
                sums[m] = sum_at(cells, vector_of(places_, mobile_[m].place));
            }
        });
        return sums;
    }

    [[nodiscard]] Sum sum_at(const ParticleCells<D>& cells, const Vec<D>& at) const {
        const std::size_t places = places_[0].size();
        const double unit = D == 2 ? h_ * h_ : h_ * h_ * h_;
        Sum sum;
        cells.around(at, [&](std::size_t j) {
            Vec<D> way{};
            double squared = 0.0;
            for (std::size_t k = 0; k < axes; ++k) {
                way[k] = cells.distance(k, at[k], cells.positions()[k][j]);
                squared += way[k] * way[k];
            }
            if (squared >= 4.0 * h_ * h_) return;
            const double q = length_of(way) / h_;
            const double volume = (j < places ? volume_ : wall_volume_[j - places]) / unit;
            sum.value += volume * kernel_.value(q);
            const double slope = volume * kernel_.gradient_factor(q) / h_;
            for (std::size_t k = 0; k < axes; ++k) sum.gradient[k] += slope * way[k];
        });
        return sum;
    }

    void move(Mobile& mobile, const Vec<D>& gradient) {
        const double spacing = c_.numerics.spacing;
        for (std::size_t k = 0; k < axes; ++k) {
            mobile.velocity[k] = inertia * mobile.velocity[k] - pace * spacing * gradient[k];
        }
        const double length = length_of(mobile.velocity);
        const double cut = std::min(1.0, longest_move * spacing / std::max(length, 1e-300));
        Vec<D> to = vector_of(places_, mobile.place);
        for (std::size_t k = 0; k < axes; ++k) {
            mobile.velocity[k] *= cut;
            to[k] += mobile.velocity[k];
        }
        mobile.clearance -= cut * length;
        // Nothing leads through a face; what comes so near starts anew.
        if (mobile.clearance <= 0.0) {
            const double now = distance_from_solids(to, reach_of_water());
            if (now <= 0.0) {
                mobile.velocity = {};
                return;
            }
            mobile.clearance = now;
        }
        const auto wrapped = [&](Vec<D> x) {
            for (std::size_t k = 0; k < axes; ++k) {
                const double extent = domain_.extent(static_cast<int>(k));
                if (domain_.periodic[k]) x[k] -= extent * std::floor(x[k] / extent);
            }
            return x;
        };
        // At a surface, and at the steep front of a dam of water, the motion along it is left.
        for (const std::size_t k : {axes - 1, std::size_t{0}}) {
            if (keeps_its_side(mobile.place, wrapped(to))) break;
            to[k] -= mobile.velocity[k];
            mobile.velocity[k] = 0.0;
        }
        if (std::any_of(planes_.begin(), planes_.end(),
                        [&](const BoundaryPlane& plane) { return plane.distance<D>(to) <= 0.0; })) {
            mobile.velocity = {};
            return;
        }
        to = wrapped(to);
        for (std::size_t k = 0; k < axes; ++k) places_[k][mobile.place] = to[k];
    }

    const Case& c_;
    double h_;
    ScalarKernel kernel_;
    Domain<D> domain_;
    double volume_;  ///< of a particle of the lattice, m2 or m3
    bool stands_through_ = false;
    bool air_moves_ = false;
    SurfaceAtStart surface_;
    SolidSurfaces surfaces_;
    std::vector<BoundaryPlane> planes_;
    Particles<D>& particles_;
    Places<D> places_;  ///< of the water, then over it
    Places<D> walls_;
    std::vector<double> wall_volume_;
    std::vector<Mobile> mobile_;
};

/// Water that the case outlines may meet a solid at any slope. Beside a gentle one it packs against places
/// that stand still, which disorders it less; where it does not, these move too.
template <int D>
PackedStart packed(const Case& c, const Scheme& scheme, Particles<D>& particles) {
    if (!c.start.water_x.empty()) {
        Packer<D> packer(c, scheme, false, particles);
        PackedStart packing = packer.run(packer.stands_through() ? iterations_against_air : most_iterations);
        if (!packer.stands_through() || packing.unevenness_after < even_enough || packing.share.empty()) {
            packer.place();
            return packing;
        }
    }
    Packer<D> packer(c, scheme, true, particles);
    PackedStart packing = packer.run(most_iterations);
    packer.place();
    return packing;
}

}  // namespace

template <int D>
PackedStart pack_start(const Case& c, const Scheme& scheme, Particles<D>& particles) {
    PackedStart packing = packed<D>(c, scheme, particles);
    if (packing.share.empty()) return packing;
    notice(fmt::format(
        "packed in {} iterations: unevenness {:.2g}{}, was {:.2g}", packing.iterations,
        packing.unevenness_after,
        packing.unevenness_after < even_enough
            ? ""
            : fmt::format(" (above {:g}: gaps are left, look at the first snapshot)", even_enough),
        packing.unevenness_before));
    return packing;
}

template PackedStart pack_start<2>(const Case&, const Scheme&, Particles<2>&);
template PackedStart pack_start<3>(const Case&, const Scheme&, Particles<3>&);

}  // namespace riffle::inline solver
