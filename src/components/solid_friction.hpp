#pragma once

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

#include "boundary/solid_distance.hpp"
#include "boundary/wall_motion.hpp"
#include "case/bed_friction.hpp"
#include "case/end_buffers.hpp"
#include "case/solid_volume.hpp"
#include "case/surface_roughness.hpp"
#include "engine/component.hpp"
#include "engine/pass_order.hpp"
#include "roughness/log_law_friction.hpp"
#include "roughness/patch_area.hpp"

namespace riffle::inline components {

/// The friction of solids whose surface has a log law: a drag on the water in a layer beside each, by the
/// speed of each particle past the surface, on patches by their own roughness. Of a particle that the edge of
/// the layer cuts acts the share within. It is a force of walls, and that on the solid is booked with its
/// friction.
template <int D, class Real>
class SolidFriction final : public Component<D, Real> {
  public:
    using typename Component<D, Real>::Flow;
    using typename Component<D, Real>::Task;

    explicit SolidFriction(Flow& flow) : layer_(solid_friction_layer(flow.c)), width_(flow.scheme.spacing) {
        flow.inputs.acceleration = true;
        flow.with_solid_friction = true;
        distance_ = SolidDistance<D>(flow.c, layer_ + 2.0 * width_);
        for (std::size_t k = 0; k < flow.c.solids.size(); ++k) {
            const Solid& solid = flow.c.solids[k];
            if (solid.surface == SolidSurface::log_law) {
                surfaces_.push_back({k, solid_friction(flow.c, solid), moment_point(flow.c, solid), {}});
                for (const SurfacePatch* const patch : patches_on(flow.c, solid)) {
                    surfaces_.back().patches.push_back(
                        {PatchArea(flow.c, *patch), solid_friction(flow.c, *patch)});
                }
            }
        }
    }

    void begin_step(Flow& flow, double dt) override {
        step_ = dt;
        loads_.resize(flow.keeps_solid_forces() ? blocks_of(flow.clusters.size()) * surfaces_.size() : 0);
    }

    void add_forces(Flow& flow, Task& task, std::size_t begin, std::size_t end) override {
        for (std::size_t n = 0; n < surfaces_.size(); ++n) {
            BodyLoad load;
            flow.for_particles(begin, end, [&](std::size_t i, std::size_t lane) {
                hold_back(flow, task, surfaces_[n], i, lane, load);
            });
            if (!loads_.empty()) loads_[begin / block_clusters * surfaces_.size() + n] = load;
        }
    }

    /// The sums over the blocks, in their order.
    void end_evaluation(Flow& flow) override {
        for (std::size_t i = 0; i < loads_.size(); ++i) {
            ForceOnSolid& force = flow.solid_forces[surfaces_[i % surfaces_.size()].solid];
            for (std::size_t k = 0; k < 3; ++k) {
                force.friction[k] += loads_[i].force[k];
                force.friction_moment[k] += loads_[i].moment[k];
            }
        }
    }

    [[nodiscard]] std::size_t bytes() const override {
        return loads_.capacity() * sizeof(BodyLoad) + distance_.bytes();
    }

  private:
    /// A part of a surface that is rough in another way.
    struct Patch {
        PatchArea area;
        LogLawFriction friction;
    };
    struct Surface {
        std::size_t solid;
        LogLawFriction friction;
        Point3 about;  ///< what moments on it are about, at t = 0
        std::vector<Patch> patches;
    };

    /// beta, 1/m, at a place: at the edge of a patch a particle has shares of both.
    [[nodiscard]] double coefficient(const Surface& surface, const Flow& flow, std::size_t i,
                                     double square) const {
        double outside = 1.0;
        double inside = 0.0;
        for (const Patch& patch : surface.patches) {
            const auto& position = flow.particles.position;
            const double share = patch.area.share(position[0][i], across_of<D>(position, i), width_);
            if (share <= 0.0) continue;
            outside -= share;
            inside += share * patch.friction.coefficient(square);
        }
        return outside > 0.0 ? inside + outside * surface.friction.coefficient(square) : inside;
    }

    void hold_back(const Flow& flow, Task& task, const Surface& surface, std::size_t i, std::size_t lane,
                   BodyLoad& load) const {
        static const BodyState rest;
        const Vec<D> position = vector_of(flow.particles.position, i);
        const double distance = distance_.from(surface.solid, flow.bodies, position);
        const double share = std::clamp((layer_ - distance) / width_ + 0.5, 0.0, 1.0);
        if (share <= 0.0) return;
        const BodyState& body = flow.bodies.empty() ? rest : flow.bodies[first_solid + surface.solid];
        const Point3 place = place_beside<D>(flow.domain, body, position);
        Vec<D> past = vector_of(flow.particles.velocity, i);
        const Vec<D> of_surface = in_flow<D>(body.velocity_at(place));
        double square = 0.0;
        for (std::size_t k = 0; k < Flow::axes; ++k) {
            past[k] -= of_surface[k];
            square += past[k] * past[k];
        }
        const double rate = share * coefficient(surface, flow, i, square) * std::sqrt(square);
        // That of the explicit step to the second order, and never more than what brings the water to rest.
        const double limited = rate / std::sqrt(1.0 + step_ * step_ * rate * rate);
        Vec<D> force{};
        for (std::size_t k = 0; k < Flow::axes; ++k) {
            const double acceleration = -limited * past[k];
            task.wall_acceleration[k][lane] += acceleration;
            task.particles.acceleration[k][lane] += acceleration;
            force[k] = -flow.particles.mass[i] * acceleration;
        }
        if (!loads_.empty() && in_channel(flow.c, position[0])) {
            const Point3 on_solid = in_space_of<D>(force);
            const Point3 about = body.placed(surface.about);
            const Point3 near = image_beside<D>(flow.domain, about, position);
            load += {on_solid, cross(minus(near, about), on_solid)};
        }
    }

    double layer_;  ///< m
    double width_;  ///< of a particle, m
    double step_ = 0.0;
    SolidDistance<D> distance_;
    std::vector<Surface> surfaces_;
    std::vector<BodyLoad> loads_;  ///< by block and surface, N and N m; empty where they are not kept
};

template <int D, class Real>
std::unique_ptr<Component<D, Real>> make_solid_friction(FlowOf<D, Real>& flow) {
    const bool any = std::any_of(flow.c.solids.begin(), flow.c.solids.end(),
                                 [](const Solid& solid) { return solid.surface == SolidSurface::log_law; });
    return any ? std::make_unique<SolidFriction<D, Real>>(flow) : nullptr;
}

}  // namespace riffle::inline components
