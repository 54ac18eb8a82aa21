#pragma once

#include "engine/pair_setup.hpp"
#include "walls/wall_treatment.hpp"

namespace riffle::inline walls {

/// Particles like those of the water that rest, with a density by the continuity equation (Dalrymple & Knio
/// 2001).
template <int D, class Real>
class DynamicWalls final : public WallTreatment<D, Real> {
  public:
    using typename WallTreatment<D, Real>::Flow;
    using typename WallTreatment<D, Real>::Task;
    using WallTreatment<D, Real>::WallTreatment;

    void wet(Flow& /*flow*/) const override {}  // their density says how much they push

    void update(Flow& flow, Task& task, const Stage& stage, std::size_t begin, std::size_t end) override {
        flow.loops.wall(flow.data, begin, end, task.sums);
        this->for_walls(flow, begin, end, [&](std::size_t slot, std::size_t i) {
            double& s = flow.walls.density_deviation[i];
            s += stage.wall * (1.0 + s) *
                 static_cast<double>(task.sums.wall.density_rate[slot - begin * cluster_size]);
            auto& record = flow.data.wall_force[slot];
            record.pressure = static_cast<Real>(pair_pressure(flow.c, flow.scheme, s));
            record.u = {};
        });
    }
};

}  // namespace riffle::inline walls
