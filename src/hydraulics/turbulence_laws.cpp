#include "hydraulics/turbulence_laws.hpp"

#include <cmath>

namespace riffle::inline hydraulics {

TurbulenceIntensities nezu_intensities(double z, double depth, double friction_velocity) {
    const double decay = friction_velocity * std::exp(-z / depth);
    return {2.30 * decay, 1.27 * decay, 1.63 * decay};
}

}  // namespace riffle::inline hydraulics
