#pragma once

#include <algorithm>
#include <cmath>
#include <memory>
#include <vector>

#include "engine/component.hpp"
#include "sph/lattice_sum.hpp"
#include "sph/listed_pairs.hpp"
#include "sph/scalar_kernel.hpp"
#include "sph/strain_measure.hpp"

namespace riffle::inline components {

/// The density that a particle carries goes, at a rate in proportion to the strain rate, to what the kernel's
/// sum over the particles makes of it. The continuity equation knows changes alone, and density diffusion
/// parts them from the particles: where water is sheared long, particles crowd in one place and part in
/// another while their densities stay even (docs/theory.md, section 11). The sum is looked at each so many
/// steps, and not near a free surface, where it is small for want of neighbours.
template <int D, class Real>
class DensityRelaxation final : public Component<D, Real> {
  public:
    using typename Component<D, Real>::Flow;
    using typename Component<D, Real>::Task;

    explicit DensityRelaxation(Flow& flow)
        : coefficient_(flow.c.numerics.density_relaxation),
          kernel_(scalar_kernel<D>(flow.c.numerics.kernel)),
          full_(lattice_kernel_sum<D>(flow.c)),
          rows_(lattice_surface_rows<D>(flow.c)),
          surplus_(flow.particles.add_field(
              {"volume_surplus", "1", "how much more volume of particles than room the kernel finds"})) {}

    [[nodiscard]] bool looks_at_walls(const Flow& flow) const override {
        return flow.clock.steps % interval == 0;
    }
    void begin_step(Flow& flow, double /*dt*/) override {
        // A particle that has just come has none yet.
        flow.particles.further[surplus_].values.resize(flow.particles.size(), 0.0);
        if (looks_at_walls(flow)) look_at_volumes(flow);
    }

    void complete_gradients(Flow& flow, Task& task, std::size_t begin, std::size_t end) override {
        const double* const surplus = flow.particles.further[surplus_].values.data();
        auto& sums = task.sums.gradient;
        const auto rate = static_cast<Real>(coefficient_);
        flow.for_clusters(begin, end, [&](std::size_t first, std::size_t last, std::size_t first_lane) {
            for (std::size_t i = first; i < last; ++i) {
                const std::size_t lane = first_lane + (i - first);
                Components<Real, D * D> gradient{};
                for (std::size_t k = 0; k < gradient.size(); ++k) {
                    gradient[k] = sums.velocity_gradient[k][lane];
                }
                sums.diffusion[lane] += rate * strain_rate<Real, D>(gradient) * static_cast<Real>(surplus[i]);
            }
        });
    }

    [[nodiscard]] std::size_t bytes() const override {
        return (fill_.capacity() + at_surface_.capacity() + sees_.capacity()) * sizeof(double) +
               lean_.capacity() * sizeof(Vec<D>);
    }

  private:
    /// Steps from one look to the next: some hundredths of the time in which strain moves a particle by a
    /// spacing.
    static constexpr std::int64_t interval = 16;
    /// Whether it goes up to a free surface, but for its uppermost row; else it leaves what sees that row
    /// alone.
    static constexpr bool up_to_surface = D == 2;
    // By the sum over the lattice: a particle of the uppermost row has 0.75 at most, one of the second 0.87
    // and more.
    static constexpr double surface_row = 0.80;
    static constexpr double below_surface_row = 0.92;
    // Share of the uppermost row in what a particle sees: 0.23 of the second row, 0.02 of the third at h
    // = 1.5 dx.
    static constexpr double sees_no_surface = 0.01;
    static constexpr double sees_surface = 0.06;
    static constexpr double largest_surplus = 0.1;

    void look_at_volumes(Flow& flow) {
        const std::size_t slots = flow.clusters.size() * cluster_size;
        fill_.assign(slots, 0.0);
        at_surface_.assign(slots, 0.0);
        if constexpr (up_to_surface) lean_.assign(slots, Vec<D>{});
        const double support = 2.0 * flow.scheme.smoothing_length;
        const double unit = std::pow(flow.scheme.smoothing_length, D);
        const auto share = [&](double volume, double squared) {
            return volume * kernel_.value(std::sqrt(squared) / flow.scheme.smoothing_length) / unit;
        };
        flow.for_blocks([&](Task& task, std::size_t begin, std::size_t end) {
            flow.loops.filter(flow.data, begin, end, task.sums);
            flow.for_particles(begin, end, [&](std::size_t, std::size_t lane) {
                const std::size_t slot = begin * cluster_size + lane;
                fill_[slot] = static_cast<double>(task.sums.filter.zeroth[lane]);
                if constexpr (up_to_surface) {
                    for (std::size_t k = 0; k < D; ++k) {
                        lean_[slot][k] = static_cast<double>(task.sums.filter.first[k][lane]);
                    }
                }
            });
            if (flow.data.fluid_wall != nullptr) {
                for_listed_pairs<D>(flow.fluid_wall, flow.clusters, flow.data.motion, flow.data.wall_gradient,
                                    flow.fixed_point, support, begin, end,
                                    [&](std::size_t i, std::size_t j, const Vec<D>& r, double squared) {
                                        const double of_wall = share(
                                            static_cast<double>(flow.data.wall_gradient[j].volume), squared);
                                        fill_[i] += of_wall;
                                        if constexpr (up_to_surface) {
                                            for (std::size_t k = 0; k < D; ++k) lean_[i][k] += of_wall * r[k];
                                        }
                                    });
            }
            flow.for_particles(begin, end, [&](std::size_t, std::size_t lane) {
                const std::size_t slot = begin * cluster_size + lane;
                fill_[slot] /= full_;
                at_surface_[slot] = in_uppermost_row(flow, slot);
            });
        });
        std::vector<double>& surplus = flow.particles.further[surplus_].values;
        sees_.assign(slots, 0.0);
        flow.for_blocks([&](Task& /*task*/, std::size_t begin, std::size_t end) {
            for_listed_pairs<D>(
                flow.fluid_fluid, flow.clusters, flow.data.motion, flow.data.motion, flow.fixed_point,
                support, begin, end,
                [&](std::size_t i, std::size_t j, const Vec<D>&, double squared) {
                    sees_[i] +=
                        at_surface_[j] * share(static_cast<double>(flow.data.motion[j].volume), squared);
                },
                [&](std::size_t slot) { return at_surface_[slot] > 0.0; });
            flow.for_particles(begin, end, [&](std::size_t i, std::size_t lane) {
                surplus[i] = surplus_of(flow, begin * cluster_size + lane);
            });
        });
    }

    /// 1 in the uppermost row, 0 below it: by the sum, which is small at the edge of a gap too, or by how far
    /// the water leans, which is not.
    [[nodiscard]] double in_uppermost_row(const Flow& flow, std::size_t slot) const {
        if constexpr (up_to_surface) {
            const double halfway = 0.5 * (rows_[0].lean + rows_[1].lean);
            return smoothstep<double>(halfway, 0.85 * rows_[0].lean, lean_of(flow, slot));
        } else {
            return 1.0 - smoothstep<double>(surface_row, below_surface_row, fill_[slot]);
        }
    }

    /// By how much the sum is larger than that of even water there.
    [[nodiscard]] double surplus_of(const Flow& flow, std::size_t slot) const {
        const auto near = smoothstep<double>(sees_no_surface, sees_surface, sees_[slot]);
        double expected = 1.0;
        double left_alone = near;
        if constexpr (up_to_surface) {
            expected -= near * (1.0 - expected_fill(lean_of(flow, slot)));
            left_alone = at_surface_[slot];
        }
        return std::clamp(fill_[slot] - expected, -largest_surplus, largest_surplus) * (1.0 - left_alone);
    }

    /// How far the water around a particle leans to one side, as SurfaceRow has it.
    [[nodiscard]] double lean_of(const Flow& flow, std::size_t slot) const {
        double squared = 0.0;
        for (const double along : lean_[slot]) squared += along * along;
        return std::sqrt(squared) / (flow.scheme.smoothing_length * full_);
    }

    /// What the sum is near the surface in even water that leans so far, straight between the rows of the
    /// lattice. A little is disorder.
    [[nodiscard]] double expected_fill(double lean) const {
        for (std::size_t row = 0; row + 1 < rows_.size(); ++row) {
            const SurfaceRow& upper = rows_[row];
            const bool lowest = row + 2 >= rows_.size();
            const SurfaceRow lower = lowest ? SurfaceRow{1.0, 0.5 * upper.lean} : rows_[row + 1];
            if (lean >= upper.lean) return upper.fill;
            if (lean > lower.lean) {
                return lower.fill +
                       (upper.fill - lower.fill) * (lean - lower.lean) / (upper.lean - lower.lean);
            }
        }
        return 1.0;
    }

    double coefficient_;
    ScalarKernel kernel_;
    double full_;                     ///< lattice_kernel_sum()
    std::vector<SurfaceRow> rows_;    ///< lattice_surface_rows()
    std::size_t surplus_;             ///< field of the particles
    std::vector<double> fill_;        ///< by slot, sum of V W of water and walls over that of the lattice
    std::vector<Vec<D>> lean_;        ///< by slot, sum of V W r, m
    std::vector<double> at_surface_;  ///< by slot, 1 in the uppermost row
    std::vector<double> sees_;        ///< by slot, share of the uppermost row in its sum
};

template <int D, class Real>
std::unique_ptr<Component<D, Real>> make_density_relaxation(FlowOf<D, Real>& flow) {
    return flow.c.numerics.density_relaxation > 0.0 ? std::make_unique<DensityRelaxation<D, Real>>(flow)
                                                    : nullptr;
}

}  // namespace riffle::inline components
