#pragma once

#include <span>
#include <vector>

#include "particles/sparse_values.hpp"
#include "particles/working_values.hpp"

namespace riffle::inline engine {

/// Quantities of the particles at the last evaluation of the forces, for sampling and output. By particle,
/// SI.
struct ParticleFields {
    WorkingValues pressure;                      ///< p, Pa
    WorkingValues eddy_viscosity;                ///< nu_t
    WorkingValues shear;                         ///< du/dz
    WorkingValues regularity;                    ///< smallest eigenvalue of M; in two dimensions only
    std::vector<double> pair_acceleration_x;     ///< of the pressure pairs, and of contact with walls
    std::vector<double> viscous_acceleration_x;  ///< of viscosity and closure
    SparseValues wall_acceleration_x;            ///< part of both from walls
    SparseValues wall_acceleration_z;            ///< the same, normal to the bed
    SparseValues drag_acceleration_x;            ///< of the bed drag (negative for u > 0)
    SparseValues vegetation_acceleration_x;      ///< of the drag of stems, where there are any
    SparseValues porous_acceleration_x;          ///< of the resistance of porous zones, where there are any
    std::vector<double> shear_stress;            ///< tau_xz of viscosity and closure, Pa
    // Three dimensions only, else empty.
    SparseValues drag_acceleration_y;       ///< of the bed drag
    SparseValues side_wall_acceleration_x;  ///< of the drag in the side walls' layers
    SparseValues side_wall_acceleration_z;
    std::vector<double> lateral_shear_stress;  ///< tau_xy, Pa

    /// Take n particles, all values zero. `Real`: of the pair arithmetic; `density`: of the water, kg/m3.
    template <class Real>
    void reset(std::size_t n, int dimensions, double density) {
        pressure.reset<Real>(n, density);
        eddy_viscosity.reset<Real>(n);
        shear.reset<Real>(n);
        regularity.reset<Real>(dimensions == 2 ? n : 0);
        pair_acceleration_x.assign(n, 0.0);
        viscous_acceleration_x.assign(n, 0.0);
        shear_stress.assign(n, 0.0);
        lateral_shear_stress.assign(dimensions == 3 ? n : 0, 0.0);
        for (SparseValues ParticleFields::*const force : near_walls(dimensions)) (this->*force).reset(n);
    }
    /// Keep those of these particles alone, in this order, which is that of their numbers, out of so many.
    /// Values of another number of them are of before some came or went, and are freed.
    void keep(const std::vector<std::int32_t>& particles, std::size_t out_of);
    /// Free all but the eddy viscosity, which snapshots show, or that too.
    void release(bool with_viscosity);
    [[nodiscard]] std::size_t bytes() const;

  private:
    [[nodiscard]] static std::span<SparseValues ParticleFields::*const> near_walls(int dimensions);
    /// The one table of the fields: f(values) for each but the eddy viscosity.
    template <class Self, class F>
    static void for_each(Self& self, const F& f);
};

}  // namespace riffle::inline engine
