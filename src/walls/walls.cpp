#include "walls/walls.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "walls/wall_records.hpp"

namespace riffle {

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
    if (flow.walls.size() == 0) {
        return;
    }
    if (flow.motion.displaces()) {
        reference_ = flow.walls;
        order_.resize(flow.walls.size());
        for (std::size_t i = 0; i < order_.size(); ++i) {
            order_[i] = static_cast<std::int32_t>(i);
        }
        place(flow, flow.clock.time);
        set_hydrostatic(flow);  // again, where they stand now
    } else {
        sort(flow);
        pack_wall_records<D, Real>(flow.c, flow.scheme, flow.walls, flow.wall_clusters, flow.data);
        treatment_->walls_placed(flow);
    }
    if (D == 3 || starts_beside_dry_walls(flow.c)) {
        treatment_->wet(flow);
    }
}

template <int D, class Real>
void Walls<D, Real>::restore(Flow& flow, std::vector<double> deviation) {
    if (flow.motion.displaces()) {
        place(flow, flow.clock.listed_time);
    }
    flow.walls.density_deviation.swap(deviation);
    if (flow.clock.steps > 0 || starts_beside_dry_walls(flow.c)) {
        treatment_->wet(flow);
    }
}

template <int D, class Real>
void Walls<D, Real>::place_for_lists(Flow& flow) {
    if (flow.motion.displaces()) {
        flow.clock.listed_time = flow.clock.time;
        place(flow, flow.clock.listed_time);
    }
}

template <int D, class Real>
void Walls<D, Real>::lists_built(Flow& flow, double reach) {
    if (flow.walls.size() > 0) {
        treatment_->lists_built(flow, reach);
    }
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

// Always sorted from the same order, so that where the walls stand follows from the time alone, in a resumed
// run too.
template <int D, class Real>
void Walls<D, Real>::place(Flow& flow, double time) {
    WallParticles<D>& walls = flow.walls;
    for (std::size_t i = 0; i < walls.size(); ++i) {
        reference_.density_deviation[static_cast<std::size_t>(order_[i])] = walls.density_deviation[i];
    }
    walls = reference_;
    const std::vector<BodyState> bodies = flow.motion.at(time);
    for (std::size_t i = 0; i < walls.size(); ++i) {
        const BodyState& body = bodies[static_cast<std::size_t>(walls.body[i])];
        for (std::size_t k = 0; k < Flow::axes; ++k) {
            walls.position[k][i] = displaced(flow, walls.position[k][i], body, k);
        }
    }
    order_ = sort(flow);
    pack_wall_records<D, Real>(flow.c, flow.scheme, walls, flow.wall_clusters, flow.data);
    treatment_->walls_placed(flow);
    treatment_->wet(flow);
}

template <int D, class Real>
double Walls<D, Real>::displaced(const Flow& flow, double x, const BodyState& body, std::size_t k) {
    const Domain<D>& domain = flow.domain;
    x += in_flow<D>(body.displacement)[k];
    if (domain.periodic[k]) {
        const double extent = domain.upper[k] - domain.lower[k];
        x -= extent * std::floor((x - domain.lower[k]) / extent);
        return x < domain.upper[k] ? x : domain.lower[k];
    }
    // Far from all water: where exactly does not matter any more.
    return std::clamp(x, domain.lower[k], domain.upper[k] - 4.0 * flow.fixed_point.unit(k));
}

template <int D, class Real>
void Walls<D, Real>::move(Flow& flow, const Stage& stage) {
    if (!flow.c.solids.empty()) {
        flow.bodies_after = flow.motion.at(flow.clock.time + stage.motion);
    }
    if (!flow.motion.any()) {
        return;
    }
    flow.bodies = flow.motion.at(flow.clock.time);
    if (!flow.motion.displaces()) {
        return;
    }
    PairData<D, Real>& data = flow.data;
    WallParticles<D>& walls = flow.walls;
    data.wall_drift.assign(data.wall_force.size(), {});
    for (std::size_t slot = 0; slot < flow.wall_clusters.slots(); ++slot) {
        const std::int32_t particle = flow.wall_clusters.particle_of(slot);
        if (particle < 0 || !is_solid(walls, static_cast<std::size_t>(particle))) {
            continue;
        }
        const auto i = static_cast<std::size_t>(particle);
        const BodyState& body = flow.bodies[static_cast<std::size_t>(walls.body[i])];
        const auto reference = static_cast<std::size_t>(order_[i]);
        auto& gradient = data.wall_gradient[slot];
        const Vec<D> velocity = in_flow<D>(body.velocity);
        for (std::size_t k = 0; k < Flow::axes; ++k) {
            walls.position[k][i] = displaced(flow, reference_.position[k][reference], body, k);
            gradient.x[k] = flow.fixed_point.encode(walls.position[k][i], k);
            double drift = 0.0;
            for (std::size_t l = 0; l < Flow::axes; ++l) {
                drift += walls.projector[k * Flow::axes + l][i] * velocity[l];
            }
            data.wall_drift[slot][k] = static_cast<Real>(drift);
        }
        data.wall_force[slot].x = gradient.x;
    }
}

template <int D, class Real>
void Walls<D, Real>::add_motion(const Flow& flow, double step, Vec<D>& slowest, Vec<D>& fastest) {
    if (!flow.motion.displaces() || step <= 0.0) {
        return;
    }
    for (std::size_t b = first_solid; b < flow.bodies_after.size(); ++b) {
        const Vec<D> from = in_flow<D>(flow.bodies[b].displacement);
        const Vec<D> to = in_flow<D>(flow.bodies_after[b].displacement);
        for (std::size_t k = 0; k < Flow::axes; ++k) {
            const double speed = (to[k] - from[k]) / step;
            slowest[k] = std::min(slowest[k], speed);
            fastest[k] = std::max(fastest[k], speed);
        }
    }
}

template class Walls<2, float>;
template class Walls<2, double>;
template class Walls<3, float>;
template class Walls<3, double>;

}  // namespace riffle
