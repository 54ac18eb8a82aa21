#pragma once

// Records, how far particles have moved, and the tables of the loops over particles. Compiled once per
// instruction set, like pair_loops_impl.hpp.

#include <cmath>
#include <limits>

#include "sph/advance_loop.hpp"
#include "sph/stress_loop.hpp"

namespace riffle::inline sph::RIFFLE_ISA {

template <int D, class Real>
[[gnu::flatten]] void pack_loop(const ParticleData<D>& particles, PairData<D, Real>& data,
                                Displacement<D>* moved, std::size_t begin, std::size_t end) {
    using T = Lanes<Real>;
    const ParticleData<D> p = particles;  // which no store of the loop can change
    const double inverse_density = 1.0 / p.density;
    for (std::size_t cluster = begin; cluster < end; ++cluster) {
        const std::size_t slot = cluster * cluster_size;
        with_members(*p.clusters, cluster, [&](const auto& members) {
            Components<Integers, D> x{};
            Components<T, D> u{};
            for (std::size_t k = 0; k < D; ++k) {
                const Doubles units = stdx::floor(Doubles(
                    (members.load(p.position[k]) - p.fixed_point.origin(k)) * p.fixed_point.inverse_unit(k)));
                // As FixedPoint::encode: on a periodic axis the codes are unsigned, here shifted into the
                // range of a signed number and back.
                x[k] = p.domain.periodic[k] ? Integers(convert<std::int32_t>(Doubles(units - 2147483648.0)) ^
                                                       Integers(std::numeric_limits<std::int32_t>::min()))
                                            : convert<std::int32_t>(units);
                u[k] = convert<Real>(members.load(p.velocity[k]));
                if (moved != nullptr) {
                    const Integers d = x[k] - load_lanes(&p.clusters->slot_position[k][slot]);
                    moved->low[k][cluster] = stdx::hmin(d);
                    moved->high[k][cluster] = stdx::hmax(d);
                }
            }
            const Doubles s = members.load(p.density_deviation);
            const T mass = convert<Real>(Doubles(masses(p, members) * inverse_density));
            const T volume = members.cut(T(mass / convert<Real>(Doubles(1.0 + s))));
            put_motion<D, Real>(x, u, convert<Real>(s), volume, &data.motion[slot]);
        });
    }
}

template <int D>
[[gnu::flatten]] std::uint32_t standing_below_loop(const ParticleData<D>& p, double height, std::size_t begin,
                                                   std::size_t end) {
    const double* const z = p.position[D - 1];
    std::uint32_t standing = 0;
    for (std::size_t cluster = begin; cluster < end; ++cluster) {
        with_members(*p.clusters, cluster, [&](const auto& members) {
            const bool below = stdx::any_of(members.load(z) <= height);
            standing |= static_cast<std::uint32_t>(below) << (cluster - begin);
        });
    }
    return standing;
}

template <int D, class Real>
[[gnu::flatten]] double displaced_loop(const PairData<D, Real>& data, const FixedPoint<D>& fixed_point,
                                       const Displacement<D>& moved, std::size_t begin, std::size_t end) {
    using Floats = Lanes<float>;
    const NeighbourList& list = *data.fluid_fluid;
    const Integers lane([](int l) { return l; });
    Floats worst(0.0F);
    for (std::size_t i = begin; i < end; ++i) {
        for (std::size_t r = list.run_begin[i]; r < list.run_begin[i + 1]; ++r) {
            const ClusterRun run = list.runs[r];
            for (std::int32_t c = 0; c < run.count; c += cluster_size) {
                const auto j = static_cast<std::size_t>(run.first) + static_cast<std::size_t>(c);
                Floats squared(0.0F);
                for (std::size_t k = 0; k < D; ++k) {
                    const Integers up = moved.high[k][i] - load_lanes(&moved.low[k][j]);
                    const Integers down = load_lanes(&moved.high[k][j]) - moved.low[k][i];
                    const Floats d = convert<float>(Integers(stdx::max(up, down))) *
                                     static_cast<float>(fixed_point.unit(k));
                    squared += d * d;
                }
                stdx::where(convert<float>(lane) >= static_cast<float>(run.count - c), squared) =
                    Floats(0.0F);
                worst = stdx::max(worst, squared);
            }
        }
        if (data.fluid_wall != nullptr && data.fluid_wall->run_begin[i] < data.fluid_wall->run_begin[i + 1]) {
            float squared = 0.0F;
            for (std::size_t k = 0; k < D; ++k) {
                const auto low = static_cast<float>(-moved.low[k][i]);
                const auto high = static_cast<float>(moved.high[k][i]);
                const float d = (low > high ? low : high) * static_cast<float>(fixed_point.unit(k));
                squared += d * d;
            }
            worst = stdx::max(worst, Floats(squared));
        }
    }
    return static_cast<double>(stdx::hmax(worst));
}

template <int D, class Real>
ParticleLoops<D, Real> particle_loops_of() {
    return {.stress = &stress_loop<D, Real>,
            .advance = &advance_loop<D, Real>,
            .pack = &pack_loop<D, Real>,
            .standing_below = &standing_below_loop<D>,
            .displaced = &displaced_loop<D, Real>};
}

}  // namespace riffle::inline sph::RIFFLE_ISA
