#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <vector>

#include "base/parallel.hpp"
#include "engine/flow.hpp"

namespace riffle::inline components {

/// Depth of the water over each place of the bed, for the mixing lengths: from the particles in plan cells
/// about a kernel support wide, smoothed over two cells to each side. Without bodies it is the volume over
/// the bed, with bodies the level of the highest particle, for the water below one is no part of the height
/// over the bed. Each particle keeps the depth that it meets, relaxed in the time in which a wave runs over a
/// depth, as a field of its own: sorted, saved and resumed with it.
template <int D, class Real>
class LocalDepth {
  public:
    using Flow = FlowOf<D, Real>;

    explicit LocalDepth(Flow& flow)
        : field_(flow.particles.add_field({"closure_depth", "m", "depth that the mixing length follows"})),
          with_bodies_(!flow.c.solids.empty()),
          half_row_(0.5 * flow.scheme.spacing),
          relaxation_time_(flow.scheme.depth / std::sqrt(flow.scheme.normal_gravity * flow.scheme.depth)),
          length_{flow.c.channel.length, flow.c.channel.flow_width()},
          open_(flow.c.channel.ends == Ends::open),
          periodic_{flow.domain.periodic[0], D == 3 && flow.domain.periodic[1]} {
        const double support = 2.0 * flow.scheme.smoothing_length;
        for (std::size_t k = 0; k < 2; ++k) {
            const bool axis = k == 0 || D == 3;
            count_[k] = axis ? std::max<std::size_t>(1, static_cast<std::size_t>(length_[k] / support)) : 1;
        }
    }

    /// At the begin of a step of dt, s.
    void update(Flow& flow, double dt) {
        std::vector<double>& depth = flow.particles.further[field_].values;
        const bool first = depth.size() != flow.particles.size();
        // The depth changes over hundreds of steps.
        constexpr std::int64_t interval = 8;
        if (!first && flow.clock.steps % interval != 0) return;
        depth.resize(flow.particles.size(), 0.0);
        const std::vector<double> cells = smoothed(levels(flow));
        const double share = -std::expm1(-static_cast<double>(interval) * dt / relaxation_time_);
        parallel_blocks(depth.size(), block, [&](std::size_t begin, std::size_t end) {
            for (std::size_t i = begin; i < end; ++i) {
                const double now = at(cells, flow.particles, i);
                // A particle that has just come has no depth yet.
                depth[i] = depth[i] > 0.0 ? depth[i] + share * (now - depth[i]) : now;
            }
        });
    }

    /// The depth at each particle, m.
    [[nodiscard]] const std::vector<double>& values(const Flow& flow) const {
        return flow.particles.further[field_].values;
    }

  private:
    static constexpr std::size_t block = 16384;

    /// Place of a particle in cells along an axis; cell i reaches from i to i + 1.
    [[nodiscard]] double place(const Particles<D>& particles, std::size_t i, std::size_t axis) const {
        const auto cells = static_cast<double>(count_[axis]);
        return std::clamp(particles.position[axis][i] / length_[axis] * cells, 0.0, cells);
    }
    [[nodiscard]] std::size_t cell_along(const Particles<D>& particles, std::size_t i,
                                         std::size_t axis) const {
        return std::min(static_cast<std::size_t>(place(particles, i, axis)), count_[axis] - 1);
    }
    [[nodiscard]] std::size_t cell(const Particles<D>& particles, std::size_t i) const {
        std::size_t index = cell_along(particles, i, 0);
        if constexpr (D == 3) index += count_[0] * cell_along(particles, i, 1);
        return index;
    }

    /// Share of a particle's width that stands between open ends.
    [[nodiscard]] double share_in_channel(const Particles<D>& particles, std::size_t i) const {
        const double x = particles.position[0][i];
        return open_ ? std::clamp(0.5 + 0.5 * std::min(x, length_[0] - x) / half_row_, 0.0, 1.0) : 1.0;
    }

    /// The cells along an axis that a particle's width reaches into, and the share of it in the second.
    struct Overlap {
        std::array<std::size_t, 2> cell{};
        std::array<double, 2> share{1.0, 0.0};
    };
    [[nodiscard]] Overlap overlap(const Particles<D>& particles, std::size_t i, std::size_t axis) const {
        const std::size_t own = cell_along(particles, i, axis);
        const double half = half_row_ / length_[axis] * static_cast<double>(count_[axis]);
        const double offset = place(particles, i, axis) - static_cast<double>(own);
        const double behind = std::max(0.0, 0.5 * (offset + half - 1.0) / half);
        const double before = std::max(0.0, 0.5 * (half - offset) / half);
        return {{own, beside(own, axis, behind > 0.0)}, {1.0 - behind - before, behind + before}};
    }
    /// Give a particle's part of the depth to the cells that it reaches into: a lattice of particles then
    /// fills cells of any width evenly.
    void spread(const Particles<D>& particles, std::size_t i, double part, std::vector<double>& cells) const {
        const Overlap along = overlap(particles, i, 0);
        const Overlap across = D == 3 ? overlap(particles, i, 1) : Overlap{};
        for (std::size_t b = 0; b < (D == 3 ? 2 : 1); ++b) {
            for (std::size_t a = 0; a < 2; ++a) {
                cells[along.cell[a] + count_[0] * across.cell[b]] += part * along.share[a] * across.share[b];
            }
        }
    }

    /// Depth in each cell, m; 0 where it is dry.
    [[nodiscard]] std::vector<double> levels(const Flow& flow) const {
        const Particles<D>& particles = flow.particles;
        const std::size_t cells = count_[0] * count_[1];
        const double area = length_[0] * length_[1] / static_cast<double>(cells);
        const double per_mass = 1.0 / (flow.scheme.density * area);
        return reduce_blocks(
            particles.size(), block, std::vector<double>(cells, 0.0),
            [&](std::size_t begin, std::size_t end) {
                std::vector<double> part(cells, 0.0);
                for (std::size_t i = begin; i < end; ++i) {
                    if (share_in_channel(particles, i) <= 0.0) continue;
                    if (with_bodies_) {
                        double& level = part[cell(particles, i)];
                        level = std::max(level, particles.position[Flow::vertical][i] + half_row_);
                    } else {
                        spread(particles, i,
                               share_in_channel(particles, i) * per_mass * particles.mass[i] /
                                   ((1.0 + particles.density_deviation[i]) *
                                    (flow.porous.empty() ? 1.0 : flow.porous_at[i].porosity)),
                               part);
                    }
                }
                return part;
            },
            [&](std::vector<double> a, const std::vector<double>& b) {
                for (std::size_t k = 0; k < cells; ++k) {
                    a[k] = with_bodies_ ? std::max(a[k], b[k]) : a[k] + b[k];
                }
                return a;
            });
    }

    /// The cell beside another along an axis; itself at a closed end.
    [[nodiscard]] std::size_t beside(std::size_t index, std::size_t axis, bool behind) const {
        const std::size_t n = count_[axis];
        if (periodic_[axis]) return (index + (behind ? 1 : n - 1)) % n;
        return behind ? std::min(index + 1, n - 1) : index - (index > 0 ? 1 : 0);
    }

    /// Twice 1/4, 1/2, 1/4 along each axis; dry cells have no share.
    [[nodiscard]] std::vector<double> smoothed(std::vector<double> values) const {
        constexpr int passes = 2;
        for (int pass = 0; pass < passes; ++pass) {
            for (std::size_t axis = 0; axis < D - 1; ++axis) smooth(values, axis);
        }
        return values;
    }
    void smooth(std::vector<double>& values, std::size_t axis) const {
        const std::vector<double> before = values;
        const std::size_t stride = axis == 0 ? 1 : count_[0];
        for (std::size_t i = 0; i < values.size(); ++i) {
            const std::size_t index = i / stride % count_[axis];
            const std::size_t line = i - index * stride;
            const std::array<double, 3> near = {before[line + stride * beside(index, axis, false)], before[i],
                                                before[line + stride * beside(index, axis, true)]};
            constexpr std::array<double, 3> weights = {0.25, 0.5, 0.25};
            double sum = 0.0;
            double weight = 0.0;
            for (std::size_t n = 0; n < near.size(); ++n) {
                sum += weights[n] * near[n];
                weight += near[n] > 0.0 ? weights[n] : 0.0;
            }
            values[i] = weight > 0.0 ? sum / weight : 0.0;
        }
    }

    /// The depth at a particle, linear between the middles of the cells.
    [[nodiscard]] double at(const std::vector<double>& cells, const Particles<D>& particles,
                            std::size_t i) const {
        std::array<std::array<std::size_t, 2>, 2> index{};
        std::array<double, 2> share{};
        for (std::size_t axis = 0; axis < D - 1; ++axis) {
            const std::size_t own = cell_along(particles, i, axis);
            const double offset = place(particles, i, axis) - static_cast<double>(own) - 0.5;
            index[axis] = {own, beside(own, axis, offset > 0.0)};
            share[axis] = std::abs(offset);
        }
        double sum = 0.0;
        double weight = 0.0;
        for (std::size_t across = 0; across < (D == 3 ? 2 : 1); ++across) {
            for (std::size_t along = 0; along < 2; ++along) {
                const double value = cells[index[0][along] + count_[0] * index[1][across]];
                const double part = (along == 0 ? 1.0 - share[0] : share[0]) *
                                    (D == 2 || across == 0 ? 1.0 - share[1] : share[1]);
                sum += value > 0.0 ? part * value : 0.0;
                weight += value > 0.0 ? part : 0.0;
            }
        }
        return weight > 0.0 ? sum / weight : half_row_;
    }

    std::size_t field_;
    bool with_bodies_;
    double half_row_;
    double relaxation_time_;
    std::array<double, 2> length_;
    bool open_;  ///< ends, beyond which there is water that stands in no cell
    std::array<bool, 2> periodic_;
    std::array<std::size_t, 2> count_{};
};

}  // namespace riffle::inline components
