#include "ends/duct_section.hpp"

#include <algorithm>

namespace riffle::inline ends {

DuctSection duct_section(double sound_speed, double going, double coming) {
    return {0.5 * (going + coming), 0.5 * sound_speed * (going - coming)};
}

DuctSection duct_inflow(double sound_speed, const DuctSection& now, double coming, double wanted,
                        double change, double time, double dt) {
    if (time <= 0.0) {
        return {wanted, sound_speed * (wanted - coming)};
    }
    const double going = now.velocity + now.pressure / sound_speed;
    const DuctSection passed = duct_section(sound_speed, going, coming);
    const double share = std::min(1.0, dt / time);
    // The velocity is half of the invariant that enters.
    return duct_section(sound_speed, going + 2.0 * (share * (wanted - passed.velocity) + change), coming);
}

double duct_relaxation(double sound_speed, const DuctSection& now, double pressure, double time, double dt) {
    return 2.0 * std::min(1.0, dt / time) * (now.pressure - pressure) / sound_speed;
}

}  // namespace riffle::inline ends
