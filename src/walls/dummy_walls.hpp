#pragma once

#include "walls/wall_treatment.hpp"

namespace riffle::inline walls {

/// Dummy particles with the pressure that the water would have at their place (Adami et al. 2012).
template <int D, class Real>
class DummyWalls final : public WallTreatment<D, Real> {
  public:
    using typename WallTreatment<D, Real>::Flow;
    using typename WallTreatment<D, Real>::Task;
    using WallTreatment<D, Real>::WallTreatment;

    void update(Flow& flow, Task& task, const Stage& /*stage*/, std::size_t begin, std::size_t end) override {
        flow.loops.wall(flow.data, begin, end, task.sums);
        this->for_walls(flow, begin, end, [&](std::size_t slot, std::size_t i) {
            const std::size_t lane = slot - begin * cluster_size;
            auto& record = flow.data.wall_force[slot];
            record.pressure = Real(0);
            record.u = {};
            if (task.sums.wall.weight[lane] > Real(0)) {
                record.pressure = static_cast<Real>(pressure(flow, task.sums.wall, lane, slot, i));
                if (this->action().rests_at(flow.walls, i)) {
                    record.u = velocity(flow, task.sums.wall, lane, i);
                }
            }
        });
    }

  private:
    static const BodyState* body_of(const Flow& flow, std::size_t i) {
        return flow.bodies.empty() ? nullptr : &flow.bodies[static_cast<std::size_t>(flow.walls.body[i])];
    }

    /// A point so far before a wall particle that is the part of a body which turns, beside that body.
    static Vec<3> beside(const Flow& flow, const BodyState& body, std::size_t i, double before) {
        const Vec<D> normal = vector_of(flow.walls.normal, i);
        Vec<3> place = place_beside<D>(flow.domain, body, vector_of(flow.walls.position, i));
        const Vec<3> out = in_space_of<D>(normal);
        for (std::size_t k = 0; k < 3; ++k) place[k] += before * out[k];
        return place;
    }

    /// Adami et al. (2012), eq. 27: p_w = [sum p_f W + (g - a_w) . sum rho r_wf W] / sum W.
    double pressure(Flow& flow, const WallResult<D, Real>& sums, std::size_t lane, std::size_t slot,
                    std::size_t i) const {
        constexpr std::size_t vertical = Flow::vertical;
        const auto weight = static_cast<double>(sums.weight[lane]);
        const auto offset = static_cast<double>(sums.offset[vertical][lane]);
        double pressure = static_cast<double>(sums.pressure[lane]) - flow.scheme.normal_gravity * offset;
        if (const BodyState* const body = body_of(flow, i)) {
            const Vec<D> acceleration = in_flow<D>(
                body->turns ? body->acceleration_at(beside(flow, *body, i, 0.0)) : body->acceleration);
            double product = 0.0;
            for (std::size_t k = 0; k < Flow::axes; ++k) {
                product += acceleration[k] * static_cast<double>(sums.offset[k][lane]);
            }
            pressure -= product;
        }
        pressure /= weight;
        // Suction at a solid in the water is no sign of a surface: its particles fade only where the water
        // lies below them, and else the state that says how wet they are is that of one under water.
        const bool below = offset > 0.25 * weight * flow.c.numerics.spacing;
        const double wetting = is_solid(flow.walls, i) && !below
                                   ? std::max(pressure, flow.scheme.normal_gravity * flow.c.numerics.spacing)
                                   : pressure;
        flow.walls.density_deviation[i] = flow.scheme.state.deviation(wetting);
        // Of the saved deviation, so that a resumed run finds the same.
        this->wet(flow, slot, i, flow.scheme.state.pressure(flow.walls.density_deviation[i]));
        const HydrostaticReference& reference = flow.particle_data.reference_pressure;
        return reference.acts() ? pressure - reference.value(flow.walls.position[vertical][i]) : pressure;
    }

    /// No slip at the wall's surface: u is extrapolated along the line through the velocity of the surface
    /// that fits the fluid's momentum near by, so that a linear profile is met exactly.
    static std::array<Real, static_cast<std::size_t>(D)> velocity(const Flow& flow,
                                                                  const WallResult<D, Real>& sums,
                                                                  std::size_t lane, std::size_t i) {
        const auto weight = static_cast<double>(sums.weight[lane]);
        const BodyState* const body = body_of(flow, i);
        const Vec<D> surface =
            body == nullptr ? Vec<D>{}
            : body->turns   ? in_flow<D>(body->velocity_at(beside(flow, *body, i, flow.walls.depth[i])))
                            : in_flow<D>(body->velocity);
        double height = -flow.walls.depth[i] * weight;
        for (std::size_t k = 0; k < Flow::axes; ++k) {
            height -= flow.walls.normal[k][i] * static_cast<double>(sums.offset[k][lane]);
        }
        if (height > 0.0) {
            // Behind the corner of a solid the water may lie beside the face, and all that a wall particle
            // sees may be a drop on the surface: the mean height is nearly 0 there.
            height = std::max(height, 0.25 * flow.c.numerics.spacing * weight);
        }
        std::array<Real, static_cast<std::size_t>(D)> result{};
        for (std::size_t k = 0; k < Flow::axes; ++k) {
            double u = surface[k];
            if (height > 0.0) {
                u -= flow.walls.depth[i] / height *
                     (static_cast<double>(sums.velocity[k][lane]) - weight * surface[k]);
            }
            result[k] = static_cast<Real>(u);
        }
        return result;
    }
};

}  // namespace riffle::inline walls
