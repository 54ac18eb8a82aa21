#include "sph/free_surface.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>

#include "base/not_a_number.hpp"
#include "base/parallel.hpp"
#include "particles/particle_cells.hpp"
#include "sph/kernel_registry.hpp"

namespace riffle::inline sph {

namespace {

constexpr std::size_t places_per_block = 16;

/// Particles in columns of about 2h.
template <int D>
class Columns {
  public:
    explicit Columns(const FluidParticles<D>& fluid) : Columns(fluid, fluid.position) {}
    Columns(const FluidParticles<D>& fluid, const typename ParticleCells<D>::Positions& position)
        : cells_(fluid.domain, position, 2.0 * fluid.smoothing_length, ParticleCells<D>::Shape::columns) {}

    /// Indices of the particles in the columns around a place.
    void around(const Vec<D - 1>& place, std::vector<std::size_t>& result) const {
        Vec<D> point{};
        std::copy(place.begin(), place.end(), point.begin());
        result.clear();
        cells_.around(point, [&result](std::size_t particle) { result.push_back(particle); });
    }

    /// Square of the horizontal distance of a particle, m2.
    [[nodiscard]] double horizontal_squared(const Vec<D - 1>& place, std::size_t particle) const {
        double squared = 0.0;
        for (std::size_t k = 0; k + 1 < D; ++k) {
            const double d = cells_.distance(k, place[k], cells_.positions()[k][particle]);
            squared += d * d;
        }
        return squared;
    }

    [[nodiscard]] double height(std::size_t particle) const { return cells_.positions()[D - 1][particle]; }

  private:
    ParticleCells<D> cells_;
};

/// A particle near a place: the square of its horizontal distance, and its height.
struct Near {
    std::size_t particle;
    double horizontal_squared;
    double height;
};

/// Sum of term(near, squared distance) at a height over the particles within 2h.
template <class Term>
double sum_at(double z, const std::vector<Near>& near, double h, const Term& term) {
    double sum = 0.0;
    for (const Near& n : near) {
        const double rz = z - n.height;
        const double squared = n.horizontal_squared + rz * rz;
        if (squared < 4.0 * h * h) sum += term(n, squared);
    }
    return sum;
}

/// Where a field passes the threshold between a height inside the water and one above it, to 1e-7 h: by false
/// position, with the Illinois rule against one end that stays.
template <class Field>
double crossing(const Field& field, double threshold, double inside, double outside, double h) {
    double f_inside = field(inside) - threshold;
    double f_outside = field(outside) - threshold;
    int last = 0;
    constexpr int most = 60;
    const auto between = [&] { return (f_inside * outside - f_outside * inside) / (f_inside - f_outside); };
    for (int i = 0; i < most && std::abs(outside - inside) > 1e-7 * h; ++i) {
        const double z = between();
        const double f = field(z) - threshold;
        if (f == 0.0) return z;
        if (f > 0.0) {
            inside = z;
            f_inside = f;
            f_outside *= last == 1 ? 0.5 : 1.0;
            last = 1;
        } else {
            outside = z;
            f_outside = f;
            f_inside *= last == -1 ? 0.5 : 1.0;
            last = -1;
        }
    }
    return between();
}

/// The particles of one kind around a place, and those of them that reach a stretch of heights.
template <int D>
class Around {
  public:
    Around(const Columns<D>& columns, double smoothing_length) : columns_(columns), h_(smoothing_length) {}

    void move_to(const Vec<D - 1>& place) {
        place_ = place;
        columns_.around(place, all_);
    }
    [[nodiscard]] bool empty() const { return all_.empty(); }
    [[nodiscard]] double top() const {
        double top = -std::numeric_limits<double>::infinity();
        for (const std::size_t j : all_) top = std::max(top, columns_.height(j));
        return top;
    }
    void gather(double from, double to) {
        band_.clear();
        for (const std::size_t j : all_) {
            const double height = columns_.height(j);
            if (height <= from - 2.0 * h_ || height >= to + 2.0 * h_) continue;
            const double squared = columns_.horizontal_squared(place_, j);
            if (squared < 4.0 * h_ * h_) band_.push_back({j, squared, height});
        }
    }
    [[nodiscard]] const std::vector<Near>& band() const { return band_; }

  private:
    const Columns<D>& columns_;
    double h_;
    Vec<D - 1> place_{};
    std::vector<std::size_t> all_;
    std::vector<Near> band_;
};

/// Elevation where a sum over particles, term(volume, squared distance), `inside` the water, first reaches
/// the threshold on the way down.
template <int D, class Term>
std::vector<double> scan_from_above(const FluidParticles<D>& fluid, std::span<const Vec<D - 1>> at,
                                    double threshold, double inside, const Term& term) {
    const double h = fluid.smoothing_length;
    const Columns<D> of_water(fluid);
    typename ParticleCells<D>::Positions solid_position;
    std::copy(fluid.solids.position.begin(), fluid.solids.position.end(), solid_position.begin());
    const Columns<D> of_solids(fluid, solid_position);
    std::vector<double> elevation(at.size(), not_a_number);
    parallel_blocks(at.size(), places_per_block, [&](std::size_t begin, std::size_t end) {
        Around<D> water(of_water, h);
        Around<D> solids(of_solids, h);
        const auto field = [&](double z) {
            const double sum = sum_at(z, water.band(), h, [&](const Near& n, double squared) {
                return term(fluid.volume[n.particle], squared);
            });
            if (solids.band().empty()) return sum;
            double solid = 0.0;
            const double below = sum_at(z, solids.band(), h, [&](const Near& n, double squared) {
                const double volume = fluid.solids.volume[n.particle];
                const double share = term(volume, squared);
                solid += share;
                const double height = std::pow(volume, 1.0 / D);
                return share * std::clamp(0.5 + (z - n.height) / height, 0.0, 1.0);
            });
            // A face itself is still wet, whose particles' sum is a half but for their places.
            constexpr double on_a_face = 1.2;
            return std::min({sum + below, 2.0 * sum, on_a_face * (inside - solid)});
        };
        for (std::size_t n = begin; n < end; ++n) {
            water.move_to(at[n]);
            if (water.empty()) continue;
            solids.move_to(at[n]);
            double low = std::numeric_limits<double>::infinity();
            const auto gather = [&](double from, double to) {
                low = from;
                water.gather(from, to);
                solids.gather(from, to);
            };
            const double step = 0.25 * h;
            double above = water.top() + 2.0 * h;
            for (double z = above - step; z > fluid.domain.lower[D - 1]; z -= step) {
                if (z < low) gather(z - 3.0 * h, above);
                if (field(z) < threshold) {
                    above = z;
                    continue;
                }
                gather(z, above);
                elevation[n] = crossing(field, threshold, z, above, h);
                break;
            }
        }
    });
    return elevation;
}

/// Volume fraction at a particle: sum V_b W_ab over all particles, itself included.
template <int D, class Kernel>
double fraction_at(const Columns<D>& columns, const FluidParticles<D>& fluid, std::size_t particle,
                   std::vector<std::size_t>& near, Kernel) {
    const double h = fluid.smoothing_length;
    Vec<D - 1> place{};
    for (std::size_t k = 0; k + 1 < D; ++k) place[k] = fluid.position[k][particle];
    columns.around(place, near);
    double sum = 0.0;
    for (const std::size_t j : near) {
        const double rz = columns.height(particle) - columns.height(j);
        const double squared = columns.horizontal_squared(place, j) + rz * rz;
        sum += fluid.volume[j] * Kernel::value(std::sqrt(squared) / h);
    }
    return sum / std::pow(h, D);
}

}  // namespace

template <int D>
std::vector<double> surface_by_position_divergence(const FluidParticles<D>& fluid,
                                                   std::span<const Vec<D - 1>> at, double threshold) {
    const double h = fluid.smoothing_length;
    const double scale = 1.0 / (D == 2 ? h * h * h * h : h * h * h * h * h);
    return visit_kernel<D>(fluid.kernel, [&](auto kernel) {
        return scan_from_above<D>(fluid, at, threshold, D, [&](double volume, double squared) {
            return -volume * squared * decltype(kernel)::gradient_factor(std::sqrt(squared) / h) * scale;
        });
    });
}

template <int D>
std::vector<double> surface_by_volume_fraction(const FluidParticles<D>& fluid, std::span<const Vec<D - 1>> at,
                                               double threshold) {
    const double h = fluid.smoothing_length;
    const double scale = 1.0 / std::pow(h, D);
    return visit_kernel<D>(fluid.kernel, [&](auto kernel) {
        return scan_from_above<D>(fluid, at, threshold, 1.0, [&](double volume, double squared) {
            return volume * decltype(kernel)::value(std::sqrt(squared) / h) * scale;
        });
    });
}

template <int D>
std::vector<double> surface_by_density_ratio(const FluidParticles<D>& fluid, std::span<const Vec<D - 1>> at,
                                             double ratio) {
    const Columns<D> columns(fluid);
    std::vector<double> elevation(at.size(), not_a_number);
    visit_kernel<D>(fluid.kernel, [&](auto kernel) {
        parallel_blocks(at.size(), places_per_block, [&](std::size_t begin, std::size_t end) {
            std::vector<std::size_t> near, around_particle;
            for (std::size_t n = begin; n < end; ++n) {
                columns.around(at[n], near);
                std::erase_if(near, [&](std::size_t j) {
                    const double spacing = std::pow(fluid.volume[j], 1.0 / D);
                    return columns.horizontal_squared(at[n], j) > spacing * spacing;
                });
                std::sort(near.begin(), near.end(), [&](std::size_t a, std::size_t b) {
                    return columns.height(a) > columns.height(b);
                });
                for (const std::size_t j : near) {
                    if (fraction_at(columns, fluid, j, around_particle, kernel) >= ratio) continue;
                    elevation[n] = columns.height(j);
                    break;
                }
            }
        });
    });
    return elevation;
}

template <int D>
std::vector<double> surface_by_depth_sum(const FluidParticles<D>& fluid, std::span<const Vec<D - 1>> at,
                                         double bed_level) {
    const double h = fluid.smoothing_length;
    const double scale = 1.0 / std::pow(h, D - 1);
    const Columns<D> columns(fluid);
    std::vector<double> elevation(at.size(), not_a_number);
    visit_kernel<D - 1>(fluid.kernel, [&](auto kernel) {
        parallel_blocks(at.size(), places_per_block, [&](std::size_t begin, std::size_t end) {
            std::vector<std::size_t> near;
            for (std::size_t n = begin; n < end; ++n) {
                columns.around(at[n], near);
                double depth = 0.0;
                for (const std::size_t j : near) {
                    const double q = std::sqrt(columns.horizontal_squared(at[n], j)) / h;
                    depth += fluid.volume[j] * decltype(kernel)::value(q) * scale;
                }
                if (depth > 0.0) elevation[n] = bed_level + depth;
            }
        });
    });
    return elevation;
}

template std::vector<double> surface_by_position_divergence<2>(const FluidParticles<2>&,
                                                               std::span<const Vec<1>>, double);
template std::vector<double> surface_by_position_divergence<3>(const FluidParticles<3>&,
                                                               std::span<const Vec<2>>, double);
template std::vector<double> surface_by_volume_fraction<2>(const FluidParticles<2>&, std::span<const Vec<1>>,
                                                           double);
template std::vector<double> surface_by_volume_fraction<3>(const FluidParticles<3>&, std::span<const Vec<2>>,
                                                           double);
template std::vector<double> surface_by_density_ratio<2>(const FluidParticles<2>&, std::span<const Vec<1>>,
                                                         double);
template std::vector<double> surface_by_density_ratio<3>(const FluidParticles<3>&, std::span<const Vec<2>>,
                                                         double);
template std::vector<double> surface_by_depth_sum<2>(const FluidParticles<2>&, std::span<const Vec<1>>,
                                                     double);
template std::vector<double> surface_by_depth_sum<3>(const FluidParticles<3>&, std::span<const Vec<2>>,
                                                     double);

template <int D>
std::vector<double> find_surface(SurfaceDetection detection, double threshold, const FluidParticles<D>& fluid,
                                 std::span<const Vec<D - 1>> at) {
    switch (detection) {
        case SurfaceDetection::volume_fraction:
            return surface_by_volume_fraction<D>(fluid, at, threshold);
        case SurfaceDetection::position_divergence:
            return surface_by_position_divergence<D>(fluid, at, threshold);
        case SurfaceDetection::density_ratio:
            return surface_by_density_ratio<D>(fluid, at, threshold);
        case SurfaceDetection::depth_sum:
            return surface_by_depth_sum<D>(fluid, at);
    }
    return {};
}

template std::vector<double> find_surface<2>(SurfaceDetection, double, const FluidParticles<2>&,
                                             std::span<const Vec<1>>);
template std::vector<double> find_surface<3>(SurfaceDetection, double, const FluidParticles<3>&,
                                             std::span<const Vec<2>>);

}  // namespace riffle::inline sph
