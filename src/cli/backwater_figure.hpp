#pragma once

#include <string>
#include <vector>

#include "hydraulics/varied_flow.hpp"

namespace riffle::inline cli {

/// What a table of a channel holds at one place.
struct BackwaterStation {
    double x = 0;             ///< m from the upstream end, along the bed
    double bed = 0;           ///< elevation of the bed's datum, m over that at the downstream end
    double depth = 0;         ///< m
    double surface = 0;       ///< elevation of the water surface (stage), m
    double energy_grade = 0;  ///< elevation of the energy grade line, m
    double velocity = 0;      ///< U, m/s
    double froude = 0;
    double manning = 0;  ///< n, s/m^(1/3)
    double friction_slope = 0;
    double area = 0;       ///< of the water's section, m2
    double top_width = 0;  ///< of the surface, m
    std::string profile;   ///< M1 to A3
};

/// The long profile with bed, surface, energy grade line, normal and critical depth, and velocity, Froude
/// number and Manning's n along it, as SVG. Both sides of a jump are stations.
[[nodiscard]] std::string backwater_figure(const std::string& title, const std::string& subtitle,
                                           const SteadyChannel& channel, const VariedFlow& flow,
                                           const std::vector<BackwaterStation>& stations);

}  // namespace riffle::inline cli
