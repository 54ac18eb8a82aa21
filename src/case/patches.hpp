#pragma once

#include <numbers>
#include <optional>
#include <string>
#include <vector>

#include "case/options.hpp"

namespace riffle::inline case_file {

// The parts of a channel that differ from the rest of it; the axes and units are those of case.hpp.

/// [[bed_patch]]: a part of the bed that is rough in another way than [bed]. Its bed level is that of the
/// channel, z = 0. What follows from its keys: case/bed_patch.hpp.
struct BedPatch {
    std::string name;
    BedKind kind = BedKind::roughness;
    std::optional<double> equivalent_roughness;  ///< k_s, m
    std::optional<double> manning;               ///< n at the depth of the case instead of it, s/m^(1/3)
    double sphere_diameter = 0.025;              ///< D of its spheres, m
    std::optional<double> roughness_height;      ///< of their crests above the bed level, m
    Packing packing = Packing::hexagonal;
    double drag_coefficient = 0.8;  ///< C_d of its spheres
    std::optional<double> x_from;   ///< m; unset: the whole channel
    std::optional<double> x_to;
    std::optional<double> y_from;
    std::optional<double> y_to;
    std::vector<double> x;  ///< 3D: corners of its outline in plan, m, in place of the four
    std::vector<double> y;

    bool operator==(const BedPatch&) const = default;
};

/// [[surface_patch]]: a part of a solid whose surface has the log law that is rough in another way than the
/// rest of it: all of its surface that lies in a range or an outline in plan. What follows from its keys:
/// case/surface_roughness.hpp.
struct SurfacePatch {
    std::string name;
    std::string solid;                           ///< name of the [[solid]]
    std::optional<double> equivalent_roughness;  ///< k_s, m; 0: smooth
    std::optional<double> manning;               ///< n at the depth of the case instead of it, s/m^(1/3)
    std::optional<double> x_from;                ///< m; unset: the whole channel
    std::optional<double> x_to;
    std::optional<double> y_from;
    std::optional<double> y_to;
    std::vector<double> x;  ///< 3D: corners of its outline in plan, m, in place of the four
    std::vector<double> y;

    bool operator==(const SurfacePatch&) const = default;
};

/// [[vegetation]]: stems that stand in the water, of one kind, in a part of the channel.
struct Vegetation {
    std::string name;
    double stems_per_area = 0.0;               ///< n, 1/m2
    double stem_diameter = 0.0;                ///< d, m
    double height = 0.0;                       ///< of the stems' tops above what they stand on, m
    std::string stands_on;                     ///< name of a solid; empty: the bed
    std::optional<double> drag_coefficient;    ///< C_D; unset: Cheng & Nguyen's (roughness/stem_drag.hpp)
    double vogel_exponent = 0.0;               ///< psi of the force ~ U^(2 + psi); 0: rigid
    std::optional<double> reference_velocity;  ///< up to which flexible stems stand as rigid ones, m/s
    std::optional<double> x_from;              ///< m; unset: the whole channel
    std::optional<double> x_to;
    std::optional<double> y_from;
    std::optional<double> y_to;
    std::vector<double> x;  ///< 3D: corners of its outline in plan, m, in place of the four
    std::vector<double> y;

    /// Area of the stems that faces the flow, of a volume of water and stems: a = n d, 1/m.
    [[nodiscard]] double frontal_area() const { return stems_per_area * stem_diameter; }
    /// Share of that volume that the stems fill: phi = n pi d^2/4.
    [[nodiscard]] double solid_fraction() const {
        return stems_per_area * std::numbers::pi / 4.0 * stem_diameter * stem_diameter;
    }

    bool operator==(const Vegetation&) const = default;
};

/// [[porous]]: a part of the channel that grains fill, and the water moves in its pores. The laws of its
/// resistance: roughness/porous_resistance.hpp; where it is: case/porous_zone.hpp.
struct Porous {
    std::string name;
    double porosity = 0.0;                ///< n, the share of the volume that is water
    std::optional<double> grain_size;     ///< d, m: the resistance is Ergun's
    double laminar_coefficient = 150.0;   ///< A of Ergun's law
    double inertial_coefficient = 1.75;   ///< B of Ergun's law
    std::optional<double> permeability;   ///< K, m2, in place of grain size and coefficients
    double forchheimer = 0.0;             ///< c_F of the quadratic term c_F |q| q/sqrt(K), with K
    double viscosity_ratio = 1.0;         ///< of the shear stress in the medium (Brinkman's) over the water's
    std::optional<double> mixing_length;  ///< the largest one within, m; unset: by the grains
    std::optional<double> edge;           ///< over which the porosity changes at its surface, m; unset: 2.4 h
    std::optional<double> x_from;         ///< m; unset: the whole channel, from bed to surface and above
    std::optional<double> x_to;
    std::optional<double> y_from;  ///< 3D
    std::optional<double> y_to;
    std::optional<double> z_from;
    std::optional<double> z_to;
    std::vector<double> x;      ///< corners of an outline, m: seen from the side with z, in plan with y
    std::vector<double> y;      ///< 3D: in place of x and y from and to, m
    std::vector<double> z;      ///< in place of x and z from and to, m above the bed level
    std::vector<double> top_x;  ///< places along the channel where its top has the heights `top_z`, m
    std::vector<double> top_z;  ///< m above the bed level, in place of z_to

    bool operator==(const Porous&) const = default;
};

}  // namespace riffle::inline case_file
