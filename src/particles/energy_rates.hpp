#pragma once

#include <array>

namespace riffle::inline particles {

/// Rates at which the energy of the water changes, kinetic, potential and of the compression together, W; in
/// two dimensions per width, W/m. Each is positive where the water gains.
struct EnergyRates {
    double gravity = 0.0;            ///< work of the weight along a channel without ends
    double bed_drag = 0.0;           ///< by the drag of the bed
    double side_drag = 0.0;          ///< by that of the side walls
    double vegetation = 0.0;         ///< by the drag of stems
    double porous = 0.0;             ///< by the resistance of porous zones
    double closure = 0.0;            ///< by the eddy stresses
    double viscosity = 0.0;          ///< by the molecular viscosity, and friction on walls
    double density_diffusion = 0.0;  ///< of the compression, by the density diffusion
    /// What the pressure gives to the motion and the continuity does not take from the compression: nothing
    /// in the exact equations.
    double pressure = 0.0;
    double further_forces = 0.0;  ///< stirring, the push of repulsive walls
    double solids = 0.0;          ///< work of moving solids
    double kinetic = 0.0;         ///< of all forces, the whole weight among them, on the kinetic energy
    double compression = 0.0;     ///< by the continuity on the energy of the compression
};

inline constexpr std::array energy_rate_parts{&EnergyRates::gravity,    &EnergyRates::bed_drag,
                                              &EnergyRates::side_drag,  &EnergyRates::vegetation,
                                              &EnergyRates::porous,     &EnergyRates::closure,
                                              &EnergyRates::viscosity,  &EnergyRates::density_diffusion,
                                              &EnergyRates::pressure,   &EnergyRates::further_forces,
                                              &EnergyRates::solids,     &EnergyRates::kinetic,
                                              &EnergyRates::compression};

inline EnergyRates operator+(EnergyRates sum, const EnergyRates& other) {
    for (double EnergyRates::*const part : energy_rate_parts) sum.*part += other.*part;
    return sum;
}

}  // namespace riffle::inline particles
