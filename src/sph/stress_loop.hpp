#pragma once

// From the sums of the gradient pass: density, pressure, closure and stress. Compiled once per instruction
// set, like pair_loops_impl.hpp.

#include <cmath>

#include "sph/cluster_members.hpp"

namespace riffle::inline sph::RIFFLE_ISA {

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
            if (spray) pressure_double -= (1.0 - water) * stdx::min(pressure_double, Doubles(0.0));
            if (p.bulk_viscosity > 0.0) pressure_double += p.bulk_viscosity * (water * compression);
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
            if (p.two_point) nu += nu_t;
            if (tensor) nu *= load_lanes(&work.gradient.viscosity_factor[lane]);
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

}  // namespace riffle::inline sph::RIFFLE_ISA
