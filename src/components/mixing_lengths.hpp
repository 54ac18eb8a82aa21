#pragma once

#include <algorithm>
#include <optional>
#include <utility>

#include "boundary/solid_distance.hpp"
#include "case/bed_patch.hpp"
#include "case/closure_traits.hpp"
#include "case/flow_kind.hpp"
#include "components/local_depth.hpp"
#include "engine/component.hpp"
#include "particles/lattice.hpp"
#include "roughness/vegetation.hpp"
#include "turbulence/closure.hpp"

namespace riffle::inline components {

/// Mixing lengths of the closure at the particles: in water of the depth of the case, or where the flow
/// varies along the channel of the depth at each place; over patches of the bed those over their roughness;
/// among stems and above them those of their canopy; in porous zones at most that of their pores; beside
/// solids at most kappa times the distance from them.
template <int D, class Real>
class MixingLengths final : public Component<D, Real> {
  public:
    using typename Component<D, Real>::Flow;
    using typename Component<D, Real>::Task;

    MixingLengths(Flow& flow, std::unique_ptr<const Closure> closure) : closure_(std::move(closure)) {
        const double row = lattice_of(flow.c).dz;
        for (const BedPatch& patch : flow.c.bed_patches) {
            if (has_mixing_length(flow.c)) {
                patches_.push_back({PatchArea(flow.c, patch), std::nullopt,
                                    make_particle_closure(with_bed_of(flow.c, patch), row)});
            }
        }
        for (const Vegetation& stems : flow.c.vegetation) {
            if (has_mixing_length(flow.c)) {
                patches_.push_back({PatchArea(flow.c, stems), StemGround(flow.c, stems),
                                    make_canopy_closure(flow.c, stems, make_particle_closure(flow.c, row))});
            }
        }
        // Farther off no mixing length is limited: the largest of the closures is 0.16 H.
        constexpr double reach = 0.5;
        if (uses_local_depth(flow.c)) depth_.emplace(flow);
        if (depth_ || traits_of(flow.c.turbulence.closure).damped_at_walls) {
            solids_ = SolidDistance<D>(flow.c, reach * flow.scheme.depth);
        }
    }

    void begin_step(Flow& flow, double dt) override {
        if (depth_) depth_->update(flow, dt);
    }

    void complete_gradients(Flow& flow, Task& task, std::size_t begin, std::size_t end) override {
        const auto& position = flow.particles.position;
        const auto first = static_cast<std::size_t>(flow.clusters.begin[begin]);
        const auto count = static_cast<std::size_t>(flow.clusters.begin[end]) - first;
        double* const lengths = task.particles.mixing_length.data();
        if (depth_) {
            follow_depth(flow, first, count, lengths);
        } else {
            closure_->mixing_lengths({&position[Flow::vertical][first], count}, {lengths, count});
        }
        if (!patches_.empty()) follow_patches(flow, first, count, lengths);
        if (!flow.porous.empty()) limit_in_pores(flow, first, count, lengths);
        if (!solids_.empty()) limit_beside_solids(flow, first, count, lengths);
        if constexpr (D == 3) {
            for (std::size_t i = 0; closure_->varies_across() && i < count; ++i) {
                lengths[i] *= closure_->side_factor(position[1][first + i]);
            }
        }
    }

  private:
    /// A part of the channel with lengths of its own: of the bed, or of vegetation, which lie side by side.
    struct Patch {
        PatchArea area;
        std::optional<StemGround> ground;  ///< of vegetation
        std::unique_ptr<const Closure> closure;
    };

    /// Particles at the edge of a patch have shares of both lengths.
    void follow_patches(const Flow& flow, std::size_t first, std::size_t count, double* lengths) const {
        const auto& position = flow.particles.position;
        for (std::size_t n = 0; n < count; ++n) {
            const std::size_t i = first + n;
            const double water = depth_ ? water_over(flow, i) : flow.c.total_depth();
            double outside = 1.0;
            double inside = 0.0;
            for (const Patch& patch : patches_) {
                const double share = patch.area.share(position[0][i], position[1][i], flow.scheme.spacing);
                if (share > 0.0) {
                    const double ground =
                        patch.ground ? patch.ground->at(position[0][i], across_of<D>(position, i)) : 0.0;
                    const double z = position[Flow::vertical][i] - ground;
                    outside -= share;
                    // At the water's edge the depth, which follows the water, may not reach the particle.
                    const double over_ground =
                        ground > 0.0 ? std::max({water - ground, z, flow.scheme.spacing}) : water;
                    inside += share * patch.closure->mixing_length_in(z, over_ground);
                }
            }
            lengths[n] = std::max(0.0, outside) * lengths[n] + inside;
        }
    }

    [[nodiscard]] double water_over(const Flow& flow, std::size_t particle) const {
        const double depth = depth_->values(flow)[particle];
        // A particle that has come since the last look at the depth has none yet.
        return depth > 0.0 ? depth : flow.scheme.depth;
    }

    void follow_depth(const Flow& flow, std::size_t first, std::size_t count, double* lengths) const {
        const auto& position = flow.particles.position;
        for (std::size_t n = 0; n < count; ++n) {
            const std::size_t i = first + n;
            lengths[n] = closure_->mixing_length_in(position[Flow::vertical][i], water_over(flow, i));
        }
    }

    static void limit_in_pores(const Flow& flow, std::size_t first, std::size_t count, double* lengths) {
        const auto& position = flow.particles.position;
        for (std::size_t n = 0; n < count; ++n) {
            const std::size_t i = first + n;
            lengths[n] = flow.porous.limited(lengths[n], position[0][i], across_of<D>(position, i),
                                             position[Flow::vertical][i]);
        }
    }

    void limit_beside_solids(const Flow& flow, std::size_t first, std::size_t count, double* lengths) const {
        const double kappa = flow.c.turbulence.kappa;
        for (std::size_t n = 0; n < count; ++n) {
            const double distance = solids_.at(flow.bodies, vector_of(flow.particles.position, first + n));
            lengths[n] = std::min(lengths[n], kappa * distance);
        }
    }

    std::unique_ptr<const Closure> closure_;
    std::vector<Patch> patches_;
    std::optional<LocalDepth<D, Real>> depth_;
    SolidDistance<D> solids_;
};

template <int D, class Real>
std::unique_ptr<Component<D, Real>> make_mixing_lengths(FlowOf<D, Real>& flow) {
    auto closure = make_particle_closure(flow.c, lattice_of(flow.c).dz);
    return closure ? std::make_unique<MixingLengths<D, Real>>(flow, std::move(closure)) : nullptr;
}

}  // namespace riffle::inline components
