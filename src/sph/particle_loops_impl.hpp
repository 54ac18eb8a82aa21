#pragma once

// Compiled once per instruction set, like pair_loops_impl.hpp.

#include <cmath>
#include <limits>

#include "sph/pair_terms.hpp"
#include "sph/particle_loops.hpp"
#include "sph/record_lanes.hpp"
#include "sph/spray.hpp"

namespace riffle::RIFFLE_ISA {

using Doubles = Lanes<double>;
using Integers = Lanes<std::int32_t>;

/// The particles of one cluster in lanes. A full one loads and stores whole lanes; in another the lanes past
/// the last particle repeat it.
template <bool Full>
struct Members {
    std::size_t first;
    int count;

    /// The lanes that hold particles.
    template <class Value>
    [[nodiscard]] RIFFLE_INLINE typename Lanes<Value>::mask_type present() const {
        return Lanes<Value>([](int l) { return static_cast<Value>(l); }) < static_cast<Value>(count);
    }
    template <class Value>
    RIFFLE_INLINE Lanes<Value> load(const Value* values) const {
        if constexpr (Full) {
            return load_lanes(values + first);
        } else {
            Lanes<Value> lanes(values[first + static_cast<std::size_t>(count - 1)]);
            stdx::where(present<Value>(), lanes).copy_from(values + first, stdx::element_aligned);
            return lanes;
        }
    }
    /// x + dt rate. The product is rounded by itself where a cluster is not full, and with the sum where it
    /// is and the processor can: so the bits of the motion have always been, and no optimisation may change
    /// them.
    RIFFLE_INLINE Doubles step(const Doubles& x, double dt, const Doubles& rate) const {
        if constexpr (Full) {
            return x + dt * rate;
        } else {
            Doubles product = dt * rate;
            asm("" : "+m"(product));
            return x + product;
        }
    }
    template <class Value>
    RIFFLE_INLINE void store(const Lanes<Value>& v, Value* values) const {
        if constexpr (Full) {
            store_lanes(v, values + first);
        } else {
            stdx::where(present<Value>(), v).copy_to(values + first, stdx::element_aligned);
        }
    }
    /// Zero in the lanes past the last particle.
    template <class Value>
    RIFFLE_INLINE Lanes<Value> cut(Lanes<Value> v) const {
        if constexpr (!Full) {
            stdx::where(!present<Value>(), v) = Lanes<Value>(0);
        }
        return v;
    }
};

/// The values of the particles of a cluster in an array of its block, whose first particle is `block_first`;
/// zero in the lanes past the last particle.
template <class M>
RIFFLE_INLINE Doubles of_block(const M& members, std::size_t block_first, const LaneArray<double>& values) {
    const M in_block{members.first - block_first, members.count};
    return in_block.cut(in_block.load(values.data()));
}

/// The masses of the particles of a cluster.
template <int D, class M>
RIFFLE_INLINE Doubles masses(const ParticleData<D>& p, const M& members) {
    return p.uniform_mass > 0.0 ? Doubles(p.uniform_mass) : members.load(p.mass);
}

/// Call f(Members) for a cluster.
template <int D, class F>
RIFFLE_INLINE void with_members(const Clusters<D>& clusters, std::size_t cluster, const F& f) {
    const auto first = static_cast<std::size_t>(clusters.begin[cluster]);
    const int count = clusters.count(cluster);
    if (count == cluster_size) {
        f(Members<true>{first, count});
    } else {
        f(Members<false>{first, count});
    }
}

template <class To, class From>
RIFFLE_INLINE Lanes<To> convert(const Lanes<From>& v) {
    return stdx::static_simd_cast<Lanes<To>>(v);
}

/// One lane array per field, to be copied into records.
template <class Value>
using Column = std::array<Value, cluster_size>;

template <class Value>
RIFFLE_INLINE Column<Value> column(const Lanes<Value>& v) {
    alignas(64) Column<Value> values;
    store_lanes(v, values.data());
    return values;
}

/// The measure of the velocity gradient that a closure's length goes with, 1/s.
template <class T, int D>
RIFFLE_INLINE T strain_measure(StrainMeasure measure, const Components<T, D * D>& g) {
    if constexpr (D == 3) {
        if (measure == StrainMeasure::wale) {
            return wale_rate<T>(g);
        }
        if (measure == StrainMeasure::vreman) {
            return vreman_rate<T>(g);
        }
    }
    return strain_rate<T, D>(g);
}

/// Pressure over rho0 in lanes.
RIFFLE_INLINE Doubles pressure_of(const StateEquation& state, const Doubles& s) {
    if (state.kind == EquationOfState::linear) {
        return state.sound_speed * state.sound_speed * s;
    }
    Column<double> values = column(s);
    for (double& value : values) {
        value = state.pressure(value);
    }
    return load_lanes(values.data());
}

/// The stress records of a cluster.
template <class Record, class Real, std::size_t N>
RIFFLE_INLINE void put_stress(const std::array<Lanes<Real>, N>& stress, const Lanes<Real>& root,
                              const Lanes<Real>& weight, const Lanes<Real>& pressure, Record* records) {
    if constexpr (records_in_registers<Record, Real>()) {
        RecordLanes<Record, Real> words{};
        for (std::size_t k = 0; k < N; ++k) {
            words[k] = stress[k];
        }
        words[N] = root;
        words[N + 1] = weight;
        words[N + 2] = pressure;
        store_records<Record>(words, records);
    } else {
        std::array<Column<Real>, N> stress_of;
        for (std::size_t k = 0; k < N; ++k) {
            stress_of[k] = column(stress[k]);
        }
        const Column<Real> root_of = column(root);
        const Column<Real> weight_of = column(weight);
        const Column<Real> pressure_of = column(pressure);
        for (std::size_t l = 0; l < cluster_size; ++l) {
            for (std::size_t k = 0; k < N; ++k) {
                records[l].stress[k] = stress_of[k][l];
            }
            records[l].viscosity_root = root_of[l];
            records[l].weight = weight_of[l];
            records[l].pressure = pressure_of[l];
        }
    }
}

/// The motion records of a cluster.
template <int D, class Real>
RIFFLE_INLINE void put_motion(const Components<Integers, D>& x, const Components<Lanes<Real>, D>& u,
                              const Lanes<Real>& s, const Lanes<Real>& volume,
                              MotionRecord<D, Real>* records) {
    using Record = MotionRecord<D, Real>;
    if constexpr (records_in_registers<Record, Real>()) {
        RecordLanes<Record, Real> words{};
#ifdef __AVX2__
        for (std::size_t k = 0; k < D; ++k) {
            words[k] = words_of(x[k]);
            words[D + k] = u[k];
        }
#endif
        words[2 * D] = s;
        words[2 * D + 1] = volume;
        store_records<Record>(words, records);
    } else {
        std::array<Column<std::int32_t>, static_cast<std::size_t>(D)> x_of;
        std::array<Column<Real>, static_cast<std::size_t>(D)> u_of;
        for (std::size_t k = 0; k < D; ++k) {
            x_of[k] = column(x[k]);
            u_of[k] = column(u[k]);
        }
        const Column<Real> s_of = column(s);
        const Column<Real> volume_of = column(volume);
        for (std::size_t l = 0; l < cluster_size; ++l) {
            for (std::size_t k = 0; k < D; ++k) {
                records[l].x[k] = x_of[k][l];
                records[l].u[k] = u_of[k][l];
            }
            records[l].s = s_of[l];
            records[l].volume = volume_of[l];
        }
    }
}

template <int D, class Real>
[[gnu::flatten]] void stress_loop(const ParticleData<D>& particles, PairData<D, Real>& data,
                                  const BlockWork<D, Real>& work, ParticleWork<D, Real>& own, double step,
                                  std::size_t begin, std::size_t end) {
    using T = Lanes<Real>;
    using stdx::abs;
    using stdx::sqrt;
    const ParticleData<D> p = particles;  // which no store of the loop can change
    const auto block_first = static_cast<std::size_t>(p.clusters->begin[begin]);
    const bool tensor = !data.stress.empty();
    const double inverse_density = 1.0 / p.density;
    for (std::size_t cluster = begin; cluster < end; ++cluster) {
        const std::size_t slot = cluster * cluster_size;
        const std::size_t lane = (cluster - begin) * cluster_size;
        const std::int32_t correction_lane = data.correction_of(cluster);
        with_members(*p.clusters, cluster, [&](const auto& members) {
            Doubles s = members.load(p.density_deviation);
            const Doubles compression = convert<double>(load_lanes(&work.gradient.density_rate[lane]));
            Doubles rate =
                (1.0 + s) * compression + convert<double>(load_lanes(&work.gradient.diffusion[lane]));
            Doubles water(1.0);
            bool spray = false;
            if (tensor) {
                const T regularity = load_lanes(&work.gradient.regularity[lane]);
                spray = stdx::any_of(regularity < T(Real(spray_end)));
                if (spray) {
                    water = convert<double>(share_of_water<T>(regularity));
                    rate -= (1.0 - water) * (p.sound_rate * s);
                }
            }
            s += step * rate;
            store_lanes(rate, &own.density_rate[lane]);
            members.store(s, p.density_deviation);

            Doubles pressure_double = pressure_of(p.state, s);
            if (spray) {
                pressure_double -= (1.0 - water) * stdx::min(pressure_double, Doubles(0.0));
            }
            if (p.bulk_viscosity > 0.0) {
                pressure_double += p.bulk_viscosity * (water * compression);
            }
            const T pressure = convert<Real>(pressure_double);
            store_lanes(pressure, &own.pressure[lane]);
            const T density_ratio = convert<Real>(Doubles(1.0 + s));  // rho/rho0
            const T mass = convert<Real>(Doubles(masses(p, members) * inverse_density));
            // The symmetric form (thesis 2.42) has weights m_j and divides stresses by rho^2.
            const T scale = p.corrected ? T(1) : T(T(1) / (density_ratio * density_ratio));
            const T weight = p.corrected ? T(mass / density_ratio) : mass;

            T nu_t(0);
            Components<T, D * D> g{};
            if (tensor) {
                for (std::size_t k = 0; k < g.size(); ++k) {
                    g[k] = load_lanes(&work.gradient.velocity_gradient[k][lane]);
                }
                if (p.closure) {
                    const T length = convert<Real>(of_block(members, block_first, own.mixing_length));
                    const T strain =
                        p.shear_only ? T(abs(g[D - 1])) : strain_measure<T, D>(p.strain_measure, g);
                    nu_t = length * length * strain;
                }
            }
            store_lanes(nu_t, &own.eddy_viscosity[lane]);
            T nu(static_cast<Real>(p.viscosity));
            if (p.two_point) {
                nu += nu_t;
            }
            if (tensor) {
                nu *= load_lanes(&work.gradient.viscosity_factor[lane]);
            }
            // mu/rho0 = (1 + s) nu; over (1 + s)^2 where the weight is a mass.
            const T viscosity = p.corrected ? T(density_ratio * nu) : T(nu / density_ratio);
            const T root = viscosity_root(viscosity);
            const T wall_pressure(pressure * scale);
            if (!tensor) {
                put_stress<PressureRecord<Real>, Real>(std::array<T, 1>{wall_pressure}, root,
                                                       members.cut(weight), wall_pressure,
                                                       &data.pressure[slot]);
                return;
            }
            T pair_pressure = wall_pressure;
            if (p.reference_pressure.acts()) {
                pair_pressure = convert<Real>(
                    Doubles(pressure_double - p.reference_pressure.value(members.load(p.position[D - 1]))));
                store_lanes(pair_pressure, &data.pair_pressure[slot]);
            }
            Components<T, D * D> stress{};
            for (std::size_t k = 0; k < D; ++k) {
                for (std::size_t l = 0; l < D; ++l) {
                    const T b = load_lanes(&work.gradient.correction[k * D + l][lane]);
                    T& q = stress[k * D + l];
                    q = pair_pressure * b;
                    // tau_ij = rho nu_t 2 S_ij, or its xz component alone from du/dz alone.
                    const bool xz = k != l && (k == 0 || l == 0) && (k == D - 1 || l == D - 1);
                    if (!p.two_point && (!p.shear_only || xz)) {
                        const T twice_strain = p.shear_only ? g[D - 1] : T(g[k * D + l] + g[l * D + k]);
                        if constexpr (D == 3) {
                            const double weight_kl = k == 1 && l == 1   ? p.normal_weight_across
                                                     : k == 1 || l == 1 ? p.shear_weight_across
                                                                        : 1.0;
                            q -= static_cast<Real>(weight_kl) * nu_t * density_ratio * scale * twice_strain;
                        } else {
                            q -= nu_t * density_ratio * scale * twice_strain;
                        }
                    }
                    if (correction_lane >= 0) {
                        store_lanes(b,
                                    &data.correction[k * D + l][static_cast<std::size_t>(correction_lane)]);
                    }
                }
            }
            put_stress<StressRecord<D, Real>, Real>(stress, root, members.cut(weight), wall_pressure,
                                                    &data.stress[slot]);
        });
    }
}

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

/// The drags of bed and side walls on a cluster in three dimensions, whose particles stand at y; `bed` is the
/// coefficient of the former.
template <class Real>
RIFFLE_INLINE void drag_in_space(const ParticleData<3>& p, const AdvanceOptions& options, std::size_t lane,
                                 const Doubles& y, const Doubles& mass, Components<Doubles, 3>& u,
                                 const Doubles& bed, ParticleWork<3, Real>& own, Doubles& bed_drag,
                                 Doubles& side_layer) {
    using stdx::abs;
    const double kick = kick_of(options);
    Doubles inside(0.0);
    stdx::where(p.in_side_layer(y), inside) = Doubles(1.0);
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
                if (options.acceleration) {
                    a += load_lanes(&own.acceleration[k][lane]);
                }
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
                const Doubles y = options.side_drag > 0.0 || options.sum_of_drags
                                      ? members.load(p.position[1])
                                      : Doubles(0.0);
                const Doubles mass = options.sum_of_drags ? members.cut(masses(p, members)) : Doubles(0.0);
                drag_in_space(p, options, lane, y, mass, u, bed, own, bed_drag, side_layer);
            }
            // Written so that a NaN is a fault too.
            auto fine = abs(s) <= 1e300;
            for (std::size_t k = 0; k < D; ++k) {
                members.store(u[k], p.velocity[k]);
                Doubles transport = u[k];
                if (options.transport) {
                    transport += load_lanes(&own.transport[k][lane]);
                }
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

}  // namespace riffle::RIFFLE_ISA
