#pragma once

// What the loops over particles share: the particles of a cluster in lanes, and their records. Compiled once
// per instruction set, like pair_loops_impl.hpp.

#include <cmath>

#include "sph/pair_terms.hpp"
#include "sph/particle_loops.hpp"
#include "sph/record_lanes.hpp"

namespace riffle::inline sph::RIFFLE_ISA {

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
        if constexpr (!Full) stdx::where(!present<Value>(), v) = Lanes<Value>(0);
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
        if (measure == StrainMeasure::wale) return wale_rate<T>(g);
        if (measure == StrainMeasure::vreman) return vreman_rate<T>(g);
    }
    if (measure == StrainMeasure::rotation) return rotation_rate<T, D>(g);
    const T strain = strain_rate<T, D>(g);
    if (measure == StrainMeasure::strain_and_rotation) return sqrt(strain * rotation_rate<T, D>(g));
    return strain;
}

/// Pressure over rho0 in lanes.
RIFFLE_INLINE Doubles pressure_of(const StateEquation& state, const Doubles& s) {
    if (state.kind == EquationOfState::linear) return state.sound_speed * state.sound_speed * s;
    Column<double> values = column(s);
    for (double& value : values) value = state.pressure(value);
    return load_lanes(values.data());
}

/// The stress records of a cluster.
template <class Record, class Real, std::size_t N>
RIFFLE_INLINE void put_stress(const std::array<Lanes<Real>, N>& stress, const Lanes<Real>& root,
                              const Lanes<Real>& weight, const Lanes<Real>& pressure, Record* records) {
    if constexpr (records_in_registers<Record, Real>()) {
        RecordLanes<Record, Real> words{};
        for (std::size_t k = 0; k < N; ++k) words[k] = stress[k];
        words[N] = root;
        words[N + 1] = weight;
        words[N + 2] = pressure;
        store_records<Record>(words, records);
    } else {
        std::array<Column<Real>, N> stress_of;
        for (std::size_t k = 0; k < N; ++k) stress_of[k] = column(stress[k]);
        const Column<Real> root_of = column(root);
        const Column<Real> weight_of = column(weight);
        const Column<Real> pressure_of = column(pressure);
        for (std::size_t l = 0; l < cluster_size; ++l) {
            for (std::size_t k = 0; k < N; ++k) records[l].stress[k] = stress_of[k][l];
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

}  // namespace riffle::inline sph::RIFFLE_ISA
