#include "solver/start_packing.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <set>
#include <utility>

#include "base/notice.hpp"
#include "base/parallel.hpp"
#include "boundary/wall.hpp"
#include "case/outline.hpp"
#include "particles/lattice.hpp"
#include "particles/particle_cells.hpp"
#include "sph/scalar_kernel.hpp"

namespace riffle {

namespace {

constexpr std::size_t packing_block = 256;
// A heavy ball that rolls down the kernel's sum: of lambda, its largest curvature in units of 1/(h dx), some
// 4, pace * lambda must stay below 2 (1 + inertia).
constexpr double inertia = 0.9;
constexpr double pace = 0.3;
constexpr double longest_move = 0.1;  // of a spacing, in an iteration
constexpr int most_iterations = 2000;
constexpr double even_enough = 2e-3;

using Places = std::array<std::vector<double>, 2>;

/// Particles at rest on the lattice, without displacement.
Particles<2> on_lattice(Case c) {
    c.start.jitter = 0.0;
    return lattice_particles<2>(c);
}

/// The places of the lattice within `reach` above the water or beside it that no solid takes: what the water
/// would be pressed against if its surface were none.
Places places_over_water(const Case& c, double reach) {
    Case full = c;
    double top = c.total_depth();
    for (const double z : c.start.water_z) {
        top = std::max(top, z);
    }
    const Domain<2> domain = domain_of<2>(c);
    full.start.water_x = {domain.lower[0], domain.upper[0], domain.upper[0], domain.lower[0]};
    full.start.water_z = {0.0, 0.0, top + reach, top + reach};
    const Particles<2> all = on_lattice(full);
    const Particles<2> wet = on_lattice(c);
    std::set<std::pair<double, double>> water;
    for (std::size_t i = 0; i < wet.size(); ++i) {
        water.emplace(wet.position[0][i], wet.position[1][i]);
    }
    Places places;
    for (std::size_t i = 0; i < all.size(); ++i) {
        if (!water.contains({all.position[0][i], all.position[1][i]})) {
            places[0].push_back(all.position[0][i]);
            places[1].push_back(all.position[1][i]);
        }
    }
    return places;
}

class Packer {
  public:
    Packer(const Case& c, const Scheme& scheme, Particles<2>& particles)
        : c_(c),
          h_(scheme.smoothing_length),
          kernel_(scalar_kernel<2>(c.numerics.kernel)),
          domain_(domain_of<2>(c)),
          volume_(lattice_of(c).volume<2>()),
          particles_(particles) {
        const WallParticles<2> walls = wall_particles<2>(c);
        fixed_ = {walls.position[0], walls.position[1]};
        fixed_volume_ = walls.volume;
        const Places above = places_over_water(c, 2.0 * h_);
        for (std::size_t k = 0; k < 2; ++k) {
            fixed_[k].insert(fixed_[k].end(), above[k].begin(), above[k].end());
        }
        fixed_volume_.resize(fixed_[0].size(), volume_);
        for (const Solid& solid : c.solids) {
            outlines_.push_back({solid.x, solid.z});
        }
        choose_mobile();
    }

    PackedStart run() {
        PackedStart result;
        notice(fmt::format("packing {} particles", mobile_.size()));
        std::vector<Vec<2>> velocity(mobile_.size());
        std::vector<Sum> sums = sums_of_mobile();
        result.unevenness_before = result.unevenness_after = unevenness(sums);
        while (result.unevenness_after >= even_enough && result.iterations < most_iterations) {
            for (std::size_t m = 0; m < mobile_.size(); ++m) {
                move(mobile_[m], sums[m].gradient, velocity[m]);
            }
            sums = sums_of_mobile();
            result.unevenness_after = unevenness(sums);
            ++result.iterations;
        }
        result.share.assign(particles_.size(), 1.0);
        const double full = lattice_sum();
        for (std::size_t m = 0; m < mobile_.size(); ++m) {
            result.share[mobile_[m]] = full / sums[m].value;
        }
        return result;
    }

  private:
    struct Sum {
        double value = 0.0;  ///< of V W
        Vec<2> gradient{};   ///< h times that of V grad W
    };

    static double unevenness(const std::vector<Sum>& sums) {
        double largest = 0.0;
        for (const Sum& sum : sums) {
            largest = std::max(largest, std::hypot(sum.gradient[0], sum.gradient[1]));
        }
        return largest;
    }

    void choose_mobile() {
        const double reach = 8.0 * h_;
        for (std::size_t i = 0; i < particles_.size(); ++i) {
            const double z = particles_.position[1][i];
            const bool near = beside_any(particles_.position[0][i], [&](const Outline& outline, double x) {
                return distance_from_outline(outline, x, z) < reach;
            });
            if (near || c_.start.jitter > 0.0) {
                mobile_.push_back(i);
            }
        }
    }

    /// Whether f(outline, x) holds for a solid and a place or one of its images.
    template <class F>
    [[nodiscard]] bool beside_any(double x, const F& f) const {
        const double period = domain_.periodic[0] ? domain_.extent(0) : 0.0;
        return std::any_of(outlines_.begin(), outlines_.end(), [&](const Outline& outline) {
            return at_any_image(x, period, [&](double at) { return f(outline, at); });
        });
    }

    [[nodiscard]] bool in_solid(double x, double z) const {
        return beside_any(x, [z](const Outline& outline, double at) { return contains(outline, at, z); });
    }

    [[nodiscard]] std::vector<Sum> sums_of_mobile() const {
        const ParticleCells<2> cells(domain_,
                                     {JoinedValues(particles_.position[0], fixed_[0]),
                                      JoinedValues(particles_.position[1], fixed_[1])},
                                     2.0 * h_);
        std::vector<Sum> sums(mobile_.size());
        parallel_blocks(mobile_.size(), packing_block, [&](std::size_t begin, std::size_t end) {
            for (std::size_t m = begin; m < end; ++m) {
                sums[m] = sum_at(cells, vector_of(particles_.position, mobile_[m]));
            }
        });
        return sums;
    }

    [[nodiscard]] Sum sum_at(const ParticleCells<2>& cells, const Vec<2>& at) const {
        const std::size_t water = particles_.size();
        Sum sum;
        cells.around(at, [&](std::size_t j) {
            const double dx = cells.distance(0, at[0], cells.positions()[0][j]);
            const double dz = at[1] - cells.positions()[1][j];
            const double q = std::hypot(dx, dz) / h_;
            if (q >= 2.0) {
                return;
            }
            const double volume = (j < water ? volume_ : fixed_volume_[j - water]) / (h_ * h_);
            sum.value += volume * kernel_.value(q);
            const double slope = volume * kernel_.gradient_factor(q) / h_;
            sum.gradient[0] += slope * dx;
            sum.gradient[1] += slope * dz;
        });
        return sum;
    }

    void move(std::size_t i, const Vec<2>& gradient, Vec<2>& velocity) {
        const double spacing = c_.numerics.spacing;
        for (std::size_t k = 0; k < 2; ++k) {
            velocity[k] = inertia * velocity[k] - pace * spacing * gradient[k];
        }
        const double length = std::hypot(velocity[0], velocity[1]);
        const double cut = std::min(1.0, longest_move * spacing / std::max(length, 1e-300));
        const double x = particles_.position[0][i] + cut * velocity[0];
        const double z = particles_.position[1][i] + cut * velocity[1];
        // Nothing leads through a face; what comes so near starts anew.
        if (in_solid(x, z) || z <= 0.0) {
            velocity = {};
            return;
        }
        velocity = {cut * velocity[0], cut * velocity[1]};
        particles_.position[0][i] =
            domain_.periodic[0] ? x - domain_.extent(0) * std::floor(x / domain_.extent(0)) : x;
        particles_.position[1][i] = z;
    }

    /// Sum of V W in the lattice without end.
    [[nodiscard]] double lattice_sum() const {
        const Lattice lattice = lattice_of(c_);
        const int columns = static_cast<int>(2.0 * h_ / lattice.dx) + 2;
        const int rows = 2 * static_cast<int>(h_ / lattice.dz) + 4;  // an even number: the same shift
        double sum = 0.0;
        for (int row = -rows; row <= rows; ++row) {
            for (int column = -columns; column <= columns; ++column) {
                const double q =
                    std::hypot(lattice.x(column, row) - lattice.x(0, 0), lattice.z(row) - lattice.z(0)) / h_;
                sum += q < 2.0 ? kernel_.value(q) : 0.0;
            }
        }
        return sum * volume_ / (h_ * h_);
    }

    const Case& c_;
    double h_;
    ScalarKernel kernel_;
    Domain<2> domain_;
    double volume_;  ///< of a particle of the lattice, m2
    Particles<2>& particles_;
    Places fixed_;
    std::vector<double> fixed_volume_;
    std::vector<Outline> outlines_;
    std::vector<std::size_t> mobile_;
};

}  // namespace

PackedStart pack_start(const Case& c, const Scheme& scheme, Particles<2>& particles) {
    PackedStart packing = Packer(c, scheme, particles).run();
    notice(fmt::format(
        "packed in {} iterations: unevenness {:.2g}{}, was {:.2g}", packing.iterations,
        packing.unevenness_after,
        packing.unevenness_after < even_enough
            ? ""
            : fmt::format(" (above {:g}: gaps are left, look at the first snapshot)", even_enough),
        packing.unevenness_before));
    return packing;
}

}  // namespace riffle
