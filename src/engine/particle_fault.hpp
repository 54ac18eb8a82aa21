#pragma once

#include <string>

#include "base/error.hpp"

namespace riffle::inline engine {

/// The simulation cannot go on because of one particle.
class ParticleFault : public RunError {
  public:
    /// `particle`: its index in the arrays.
    ParticleFault(std::size_t particle, const std::string& message)
        : RunError(message), particle_(particle) {}
    [[nodiscard]] std::size_t particle() const { return particle_; }

  private:
    std::size_t particle_;
};

}  // namespace riffle::inline engine
