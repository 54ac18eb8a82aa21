#pragma once

// From the sums of the force pass: drag and motion. Compiled once per instruction set, like
// pair_loops_impl.hpp.

#include <cmath>
#include <limits>

#include "sph/cluster_members.hpp"
#include "sph/spray.hpp"

namespace riffle::inline sph::RIFFLE_ISA {

/// dt of the velocities.
RIFFLE_INLINE double kick_of(const AdvanceOptions& options) {
    return options.kick < 0.0 ? options.step : options.kick;
}

/// One implicit step of a drag, u1 + dt beta u1|u1| = u; its acceleration.
RIFFLE_INLINE Doubles drag_step(const Doubles& beta, double dt, Doubles& u) {
    using stdx::abs;
    using stdx::sqrt;
    Doubles drag(0.0);
    if (stdx::any_of(beta > 0.0)) {
        const Doubles free = u;
        u = 2.0 * free / (1.0 + sqrt(Doubles(1.0 + 4.0 * dt * beta * abs(free))));
        drag = (u - free) / dt;
    }
    return drag;
}

/// The drags of bed and side walls on a cluster in three dimensions, whose particles stand at x and y; `bed`
/// is the coefficient of the former.
template <class Real>
RIFFLE_INLINE void drag_in_space(const ParticleData<3>& p, const AdvanceOptions& options, std::size_t lane,
                                 const Doubles& x, const Doubles& y, const Doubles& mass,
                                 Components<Doubles, 3>& u, const Doubles& bed, ParticleWork<3, Real>& own,
                                 Doubles& bed_drag, Doubles& side_layer) {
    using stdx::abs;
    const double kick = kick_of(options);
    Doubles inside(0.0);
    stdx::where(p.in_side_layer(x, y), inside) = Doubles(1.0);
    const Doubles side = options.side_drag * inside;
    const Doubles both = bed + side;
    // Bed and side wall act on the same velocity along x, and share the step in proportion.
    const Doubles along = drag_step(both, kick, u[0]);
    Doubles share = side;
    stdx::where(both > 0.0, share) = side / both;
    const Doubles by_side = share * along;
    store_lanes(Doubles(along - by_side), &own.drag_force[lane]);
    store_lanes(by_side, &own.side_force[lane]);
    store_lanes(drag_step(bed, kick, u[1]), &own.drag_force_across[lane]);
    store_lanes(drag_step(side, kick, u[2]), &own.side_force_vertical[lane]);
    if (options.sum_of_drags) {
        const Doubles square = mass * u[0] * abs(u[0]);
        bed_drag += bed * square;
        side_layer += inside * square;
    }
}

template <int D, class Real>
[[gnu::flatten]] AdvanceResult<D> advance_loop(const ParticleData<D>& particles,
                                               const BlockWork<D, Real>& work, ParticleWork<D, Real>& own,
                                               const AdvanceOptions& wanted, std::size_t begin,
                                               std::size_t end) {
    using T = Lanes<Real>;
    using stdx::abs;
    using stdx::sqrt;
    const ParticleData<D> p = particles;  // which no store of the loop can change
    const AdvanceOptions options = wanted;
    const double dt = options.step;
    const double kick = kick_of(options);
    const auto block_first = static_cast<std::size_t>(p.clusters->begin[begin]);
    Doubles largest(0.0);
    Components<Doubles, D> slowest{};
    Components<Doubles, D> fastest{};
    for (std::size_t k = 0; k < D; ++k) {
        slowest[k] = std::numeric_limits<double>::infinity();
        fastest[k] = -std::numeric_limits<double>::infinity();
    }
    bool good = true;
    Doubles bed_drag(0.0);
    Doubles side_layer(0.0);
    for (std::size_t cluster = begin; cluster < end; ++cluster) {
        const std::size_t lane = (cluster - begin) * cluster_size;
        with_members(*p.clusters, cluster, [&](const auto& members) {
            const Doubles s = members.load(p.density_deviation);
            const T factor = p.corrected ? T(Real(1) / convert<Real>(Doubles(1.0 + s))) : T(1);
            Doubles squared(0.0);
            Components<Doubles, D> u{};
            for (std::size_t k = 0; k < D; ++k) {
                const T pairs =
                    load_lanes(&work.force.tensor[k][lane]) + load_lanes(&work.force.viscous[k][lane]);
                Doubles a = convert<double>(T(factor * pairs)) + p.gravity[k];
                if (options.acceleration) a += load_lanes(&own.acceleration[k][lane]);
                squared += a * a;
                u[k] = members.step(members.load(p.velocity[k]), kick, a);
            }
            largest = stdx::max(largest, squared);
            const bool dragged = options.drag && (own.drag_clusters >> (cluster - begin) & 1U) != 0;
            const Doubles bed = dragged ? of_block(members, block_first, own.drag) : Doubles(0.0);
            if constexpr (D == 2) {
                if (dragged) {
                    store_lanes(drag_step(bed, kick, u[0]), &own.drag_force[lane]);
                } else if (options.drag) {
                    store_lanes(Doubles(0.0), &own.drag_force[lane]);
                }
            } else {
                const bool beside_walls = options.side_drag > 0.0 || options.sum_of_drags;
                const Doubles x = beside_walls ? members.load(p.position[0]) : Doubles(0.0);
                const Doubles y = beside_walls ? members.load(p.position[1]) : Doubles(0.0);
                const Doubles mass = options.sum_of_drags ? members.cut(masses(p, members)) : Doubles(0.0);
                drag_in_space(p, options, lane, x, y, mass, u, bed, own, bed_drag, side_layer);
            }
            // Written so that a NaN is a fault too.
            auto fine = abs(s) <= 1e300;
            for (std::size_t k = 0; k < D; ++k) {
                members.store(u[k], p.velocity[k]);
                Doubles transport = u[k];
                if (options.transport) transport += load_lanes(&own.transport[k][lane]);
                slowest[k] = stdx::min(slowest[k], transport);
                fastest[k] = stdx::max(fastest[k], transport);
                Doubles x = members.step(members.load(p.position[k]), dt, transport);
                if (p.domain.periodic[k]) {
                    const double extent = p.domain.upper[k] - p.domain.lower[k];
                    stdx::where(x < p.domain.lower[k], x) = x + extent;
                    stdx::where(x >= p.domain.upper[k], x) = x - extent;
                }
                members.store(x, p.position[k]);
                fine = fine && x >= p.stay_from[k] && x < p.stay_to[k] && abs(u[k]) <= 1e300;
            }
            good = good && stdx::all_of(fine);
        });
    }
    AdvanceResult<D> result{.largest = stdx::hmax(largest),
                            .fault = !good,
                            .bed_drag = stdx::reduce(bed_drag),
                            .side_layer = stdx::reduce(side_layer)};
    for (std::size_t k = 0; k < D; ++k) {
        result.slowest[k] = stdx::hmin(slowest[k]);
        result.fastest[k] = stdx::hmax(fastest[k]);
    }
    return result;
}

}  // namespace riffle::inline sph::RIFFLE_ISA
