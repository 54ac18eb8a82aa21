#pragma once

#include <filesystem>
#include <string>

namespace riffle::testing {

/// The made-up flow of a run in three dimensions, at rest but for what is said here.
struct SampleSpace {
    std::string sides = "walls";  ///< channel.sides of its case
    double cells = 3.0;           ///< number n of cells of the secondary flow across the width
    /// Streamfunction A sin(n pi y/W) sin(pi z/H) of the secondary flow, m2/s.
    double streamfunction = 5e-5;
    double noise = 0.0;               ///< standard deviation of each cell's mean velocity in each window, m/s
    double form_u = 0.02;             ///< amplitude of u~ = form_u cos(4 pi x/L), m/s
    double form_w = -0.004;           ///< and of w~
    double reynolds_stress = 0.1;     ///< -rho u'w' in time, Pa, everywhere
    double wall_slope = 0.3;          ///< tau_xz = rho g S0 (H - z) (1 - wall_slope cos^2(pi y/W))
    double side_wall_share = 0.2;     ///< of the weight that the walls' layers carry
    double surface_deviation = 4e-5;  ///< m, of a standing pattern in plan
};

/// Its case: flow condition 2, 129.9 mm wide and 50 mm long, with its measured values.
[[nodiscard]] std::string sample_space_case(const std::string& sides);

/// Velocity of the sample, m/s: 0.5 (z/H)^(1/3) sin^(1/4)(pi y/W), and its secondary flow.
[[nodiscard]] double sample_space_velocity(double y, double z, double width, double depth);

/// Write the results file of such a run: the groups of a run in two dimensions, and those that three add,
/// with 19 windows of 1 s up to 30 s, of which the four before the averaging window (from 15 s) hold a flow
/// twice as fast.
void write_sample_space(const std::filesystem::path& path, const SampleSpace& sample = {});

}  // namespace riffle::testing
