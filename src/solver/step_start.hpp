#pragma once

#include "particles/particles.hpp"

namespace riffle {

/// State at the start of a step, for the methods that advance from there more than once.
template <int D>
struct StepStart {
    std::array<std::vector<double>, static_cast<std::size_t>(D)> position;
    std::array<std::vector<double>, static_cast<std::size_t>(D)> velocity;
    std::vector<double> density_deviation;

    void save(const Particles<D>& particles) {
        position = particles.position;
        velocity = particles.velocity;
        density_deviation = particles.density_deviation;
    }
};

}  // namespace riffle
