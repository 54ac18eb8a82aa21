#include "case/case.hpp"

#include <cmath>

namespace riffle::inline case_file {

double Case::streamwise_gravity() const { return fluid.gravity * std::sin(std::atan(channel.slope)); }

double Case::normal_gravity() const { return fluid.gravity * std::cos(std::atan(channel.slope)); }

std::optional<double> Case::inflow_unit_discharge() const {
    return inflow.discharge ? std::optional(*inflow.discharge / channel.width) : inflow.unit_discharge;
}

double usual_surface_threshold(SurfaceDetection detection, int dimensions) {
    switch (detection) {
        case SurfaceDetection::volume_fraction:
            return 0.5;
        case SurfaceDetection::position_divergence:
            return 0.5 * dimensions;
        case SurfaceDetection::density_ratio:
            return 0.9;
        case SurfaceDetection::depth_sum:
            break;
    }
    return 0.0;
}

bool Case::same_parameters(const Case& other) const {
    return title == other.title && description == other.description && channel == other.channel &&
           inflow == other.inflow && outflow == other.outflow && bed == other.bed &&
           side_walls == other.side_walls && turbulence == other.turbulence && fluid == other.fluid &&
           numerics == other.numerics && start == other.start && stirring == other.stirring &&
           run == other.run && output == other.output && measured == other.measured &&
           probes == other.probes && solids == other.solids && bed_patches == other.bed_patches &&
           surface_patches == other.surface_patches && vegetation == other.vegetation &&
           porous == other.porous;
}

}  // namespace riffle::inline case_file
