#pragma once

#include <type_traits>
#include <vector>

#include "case/case.hpp"
#include "particles/domain.hpp"

namespace riffle::inline components {

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
    void add(const Vec<2>& x, double t, Vec<2>& a) const { add(x[0], x[1], t, a[0], a[1]); }

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

/// The same in three dimensions: beside those modes, rolls across the channel whose sense changes along it,
///   chi = sum_m (F/sqrt(M)/|k_m|) sin^2(m pi z/H) g_m(y) cos(2 pi m (x - c t)/L + phase_m),  a = (0,
///   dchi/dz, -dchi/dy),
/// g_m = cos(2 pi m y/W + phase_m) between periodic sides, sin(m pi y/W) between side walls, through which
/// nothing is driven.
class Stirring3D {
  public:
    Stirring3D() = default;
    Stirring3D(const Case& c, double celerity);

    [[nodiscard]] bool active() const { return plane_.active(); }
    void add(const Vec<3>& x, double t, Vec<3>& a) const;

  private:
    struct Roll {
        double amplitude = 0.0;
        double kx = 0.0;
        double ky = 0.0;
        double kz = 0.0;
        double phase_x = 0.0;
        double phase_y = 0.0;  ///< of g = cos(ky y + phase_y)
    };
    Stirring2D plane_;
    std::vector<Roll> rolls_;
    double celerity_ = 0.0;
};

template <int D>
using StirringIn = std::conditional_t<D == 2, Stirring2D, Stirring3D>;

}  // namespace riffle::inline components
