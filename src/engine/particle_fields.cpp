#include "engine/particle_fields.hpp"

#include <array>

namespace riffle {

std::span<SparseValues ParticleFields::*const> ParticleFields::near_walls(int dimensions) {
    static constexpr std::array<SparseValues ParticleFields::*, 6> all = {
        &ParticleFields::wall_acceleration_x,      &ParticleFields::wall_acceleration_z,
        &ParticleFields::drag_acceleration_x,      &ParticleFields::drag_acceleration_y,
        &ParticleFields::side_wall_acceleration_x, &ParticleFields::side_wall_acceleration_z};
    return std::span(all).first(dimensions == 3 ? all.size() : 3);
}

void ParticleFields::release(bool with_viscosity) {
    pressure.release();
    shear.release();
    regularity.release();
    for (std::vector<double>* const values :
         {&pair_acceleration_x, &viscous_acceleration_x, &shear_stress, &lateral_shear_stress}) {
        std::vector<double>().swap(*values);
    }
    for (SparseValues ParticleFields::*const force : near_walls(3)) {
        (this->*force).release();
    }
    if (with_viscosity) {
        eddy_viscosity.release();
    }
}

void ParticleFields::keep(const std::vector<std::int32_t>& particles) {
    pressure.keep(particles);
    eddy_viscosity.keep(particles);
    shear.keep(particles);
    regularity.keep(particles);
    for (std::vector<double>* const values :
         {&pair_acceleration_x, &viscous_acceleration_x, &shear_stress, &lateral_shear_stress}) {
        WorkingValues::keep_values(*values, particles);
    }
    for (SparseValues ParticleFields::*const force : near_walls(3)) {
        (this->*force).keep(particles);
    }
}

std::size_t ParticleFields::bytes() const {
    std::size_t total = pressure.bytes() + eddy_viscosity.bytes() + shear.bytes() + regularity.bytes();
    for (const SparseValues ParticleFields::*const force : near_walls(3)) {
        total += (this->*force).bytes();
    }
    for (const std::vector<double>* const values :
         {&pair_acceleration_x, &viscous_acceleration_x, &shear_stress, &lateral_shear_stress}) {
        total += values->capacity() * sizeof(double);
    }
    return total;
}

}  // namespace riffle
