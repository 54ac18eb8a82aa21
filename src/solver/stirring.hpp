#pragma once

#include <vector>

#include "case/case.hpp"

namespace riffle {

/// The stirring body force (a test option): divergence-free vortex modes that travel along the channel,
///   psi = sum_m (F/sqrt(M)/|k_m|) sin^2(m pi z/H) cos(2 pi m (x - c t)/L + phase_m),  a = (dpsi/dz,
///   -dpsi/dx),
/// of zero mean along x at every height, and zero at the bed and the surface (else the waves of the surface
/// would correlate with it), so that it disorders the particles and drives no mean flow.
class Stirring2D {
  public:
    Stirring2D() = default;

    /// `celerity`: speed of the modes, m/s.
    Stirring2D(const Case& c, double celerity);

    [[nodiscard]] bool active() const { return !modes_.empty(); }

    /// Acceleration at (x, z) and time t, m/s2, added to ax, az.
    void add(double x, double z, double t, double& ax, double& az) const;

  private:
    struct Mode {
        double amplitude = 0.0;  ///< of the stream function, m2/s2
        double kx = 0.0;
        double kz = 0.0;
        double phase = 0.0;
    };
    std::vector<Mode> modes_;
    double celerity_ = 0.0;
};

}  // namespace riffle
