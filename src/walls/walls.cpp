#include "walls/walls.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "walls/wall_records.hpp"

namespace riffle::inline walls {

template <int D, class Real>
Walls<D, Real>::Walls(Flow& flow) : treatment_(make_wall_treatment<D, Real>(flow.c)) {
    flow.walls = wall_particles<D>(flow.c);
    set_hydrostatic(flow);
}

template <int D, class Real>
void Walls<D, Real>::set_hydrostatic(Flow& flow) const {
    flow.walls.density_deviation.resize(flow.walls.size());
    for (std::size_t i = 0; i < flow.walls.size(); ++i) {
        flow.walls.density_deviation[i] =
            flow.scheme.hydrostatic_deviation(flow.walls.position[Flow::vertical][i]);
    }
}

template <int D, class Real>
void Walls<D, Real>::place_at_start(Flow& flow) {
    if (flow.walls.size() == 0) return;
    if (flow.motion.displaces()) {
        reference_ = flow.walls;
        measure_reach(flow);
        order_.resize(flow.walls.size());
        for (std::size_t i = 0; i < order_.size(); ++i) order_[i] = static_cast<std::int32_t>(i);
        place(flow, flow.bodies_now());
        set_hydrostatic(flow);  // again, where they stand now
    } else {
        sort(flow);
        pack_wall_records<D, Real>(flow.c, flow.scheme, flow.walls, flow.wall_clusters, flow.data);
        treatment_->walls_placed(flow);
    }
    if (D == 3 || starts_beside_dry_walls(flow.c)) treatment_->wet(flow);
}

template <int D, class Real>
void Walls<D, Real>::measure_reach(const Flow& flow) {
    const std::vector<BodyState> bodies = flow.motion.at(0.0);
    reach_.assign(bodies.size(), 0.0);
    for (std::size_t i = 0; i < reference_.size(); ++i) {
        const auto b = static_cast<std::size_t>(reference_.body[i]);
        const Vec<D> centre = in_flow<D>(bodies[b].centre);
        double squared = 0.0;
        for (std::size_t k = 0; k < Flow::axes; ++k) {
            const double apart = flow.domain.image_near(centre[k], reference_.position[k][i], k) - centre[k];
            squared += apart * apart;
        }
        // The surface is half a spacing before its first particles.
        reach_[b] = std::max(reach_[b], std::sqrt(squared) + flow.c.numerics.spacing);
    }
}

template <int D, class Real>
void Walls<D, Real>::restore(Flow& flow, std::vector<double> deviation) {
    if (flow.motion.displaces()) place(flow, flow.bodies_listed());
    flow.walls.density_deviation.swap(deviation);
    if (flow.clock.steps > 0 || starts_beside_dry_walls(flow.c)) treatment_->wet(flow);
}

template <int D, class Real>
void Walls<D, Real>::place_for_lists(Flow& flow) {
    if (flow.motion.displaces()) {
        flow.clock.listed_time = flow.clock.time;
        flow.clock.listed_free_bodies = flow.clock.free_bodies;
        place(flow, flow.bodies_listed());
    }
}

template <int D, class Real>
void Walls<D, Real>::lists_built(Flow& flow, double reach) {
    if (flow.walls.size() > 0) treatment_->lists_built(flow, reach);
}

template <int D, class Real>
std::vector<std::int32_t> Walls<D, Real>::sort(Flow& flow) {
    const PositionView<D> unsorted = position_view<D>(flow.walls.position);
    std::vector<std::int32_t> order =
        spatial_order<D>(flow.domain, unsorted, flow.column_width, 0.5 * flow.c.numerics.spacing);
    flow.walls.permute(order);
    flow.wall_clusters = build_clusters<D>(flow.domain, flow.fixed_point,
                                           position_view<D>(flow.walls.position), flow.column_width);
    return order;
}

// Always sorted from the same order, so that where the walls stand follows from the bodies alone, in a
// resumed run too.
template <int D, class Real>
void Walls<D, Real>::place(Flow& flow, const std::vector<BodyState>& bodies) {
    WallParticles<D>& walls = flow.walls;
    for (std::size_t i = 0; i < walls.size(); ++i) {
        reference_.density_deviation[static_cast<std::size_t>(order_[i])] = walls.density_deviation[i];
    }
    walls = reference_;
    for (std::size_t i = 0; i < walls.size(); ++i) {
        stand(flow, i, i, bodies[static_cast<std::size_t>(walls.body[i])]);
    }
    order_ = sort(flow);
    pack_wall_records<D, Real>(flow.c, flow.scheme, walls, flow.wall_clusters, flow.data);
    treatment_->walls_placed(flow);
    treatment_->wet(flow);
}

template <int D, class Real>
Vec<3> Walls<D, Real>::stand(Flow& flow, std::size_t i, std::size_t reference, const BodyState& body) const {
    WallParticles<D>& walls = flow.walls;
    Vec<D> start = vector_of(reference_.position, reference);
    if (body.turns) {
        const Vec<D> centre = in_flow<D>(body.centre);
        for (std::size_t k = 0; k < Flow::axes; ++k) {
            start[k] = flow.domain.image_near(centre[k], start[k], k);
        }
        const Vec<D> normal =
            in_flow<D>(body.turned(in_space_of<D>(vector_of(reference_.normal, reference))));
        for (std::size_t k = 0; k < Flow::axes; ++k) walls.normal[k][i] = normal[k];
    }
    const Vec<3> now = body.placed(in_space_of<D>(start));
    const Vec<D> place = in_flow<D>(now);
    for (std::size_t k = 0; k < Flow::axes; ++k) walls.position[k][i] = within(flow, place[k], k);
    return body.velocity_at(now);
}

template <int D, class Real>
double Walls<D, Real>::within(const Flow& flow, double x, std::size_t k) {
    const Domain<D>& domain = flow.domain;
    if (domain.periodic[k]) {
        const double extent = domain.upper[k] - domain.lower[k];
        x -= extent * std::floor((x - domain.lower[k]) / extent);
        return x < domain.upper[k] ? x : domain.lower[k];
    }
    // Far from all water: where exactly does not matter any more.
    return std::clamp(x, domain.lower[k], domain.upper[k] - 4.0 * flow.fixed_point.unit(k));
}

template <int D, class Real>
template <class Moved>
void Walls<D, Real>::stand_solids(Flow& flow, const std::vector<BodyState>& bodies, const Moved& moved) {
    PairData<D, Real>& data = flow.data;
    for (std::size_t slot = 0; slot < flow.wall_clusters.slots(); ++slot) {
        const std::int32_t particle = flow.wall_clusters.particle_of(slot);
        if (particle < 0 || !is_solid(flow.walls, static_cast<std::size_t>(particle))) continue;
        const auto i = static_cast<std::size_t>(particle);
        const BodyState& body = bodies[static_cast<std::size_t>(flow.walls.body[i])];
        const Vec<3> velocity = stand(flow, i, static_cast<std::size_t>(order_[i]), body);
        auto& gradient = data.wall_gradient[slot];
        for (std::size_t k = 0; k < Flow::axes; ++k) {
            gradient.x[k] = flow.fixed_point.encode(flow.walls.position[k][i], k);
        }
        data.wall_force[slot].x = gradient.x;
        moved(slot, i, in_flow<D>(velocity));
    }
}

template <int D, class Real>
void Walls<D, Real>::bring_to_clock(Flow& flow) {
    if (!flow.motion.displaces()) return;
    stand_solids(flow, flow.bodies_now(), [](std::size_t, std::size_t, const Vec<D>&) {});
}

template <int D, class Real>
void Walls<D, Real>::move(Flow& flow, const Stage& stage) {
    if (!flow.c.solids.empty()) {
        std::vector<FreeBodyState> after = flow.clock.free_bodies;
        for (std::size_t n = 0; n < after.size(); ++n) {
            flow.free[n].predict(after[n], stage.velocity_step(), stage.motion);
        }
        flow.bodies_after = flow.motion.at(flow.clock.time + stage.motion, after);
    }
    if (!flow.motion.any()) return;
    flow.bodies = flow.bodies_now();
    if (!flow.motion.displaces()) return;
    const WallParticles<D>& walls = flow.walls;
    flow.data.wall_drift.assign(flow.data.wall_force.size(), {});
    stand_solids(flow, flow.bodies, [&](std::size_t slot, std::size_t i, const Vec<D>& velocity) {
        for (std::size_t k = 0; k < Flow::axes; ++k) {
            double drift = 0.0;
            for (std::size_t l = 0; l < Flow::axes; ++l) {
                drift += walls.projector[k * Flow::axes + l][i] * velocity[l];
            }
            flow.data.wall_drift[slot][k] = static_cast<Real>(drift);
        }
    });
}

template <int D, class Real>
void Walls<D, Real>::add_motion(const Flow& flow, double step, Vec<D>& slowest, Vec<D>& fastest) const {
    if (!flow.motion.displaces() || step <= 0.0) return;
    for (std::size_t b = first_solid; b < flow.bodies_after.size(); ++b) {
        const Vec<D> from = in_flow<D>(flow.bodies[b].displacement);
        const Vec<D> to = in_flow<D>(flow.bodies_after[b].displacement);
        const auto spin_of = [b](const std::vector<BodyState>& bodies) {
            return std::sqrt(dot(bodies[b].angular_velocity, bodies[b].angular_velocity));
        };
        const double around = flow.bodies_after[b].turns
                                  ? reach_[b] * std::max(spin_of(flow.bodies_after), spin_of(flow.bodies))
                                  : 0.0;
        for (std::size_t k = 0; k < Flow::axes; ++k) {
            const double speed = (to[k] - from[k]) / step;
            slowest[k] = std::min(slowest[k], speed - around);
            fastest[k] = std::max(fastest[k], speed + around);
        }
    }
}

template class Walls<2, float>;
template class Walls<2, double>;
template class Walls<3, float>;
template class Walls<3, double>;

}  // namespace riffle::inline walls
