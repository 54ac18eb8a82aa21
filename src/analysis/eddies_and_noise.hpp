#pragma once

#include <array>
#include <cstddef>
#include <vector>

#include "particles/domain.hpp"

namespace riffle::inline analysis {

/// What of the velocities of the particles is a field that neighbours share, and what is each particle's own.
/// Around each particle the linear field that fits its neighbours within `noise_reach` spacings best, itself
/// left out, is what a probe would see: eddies larger than some four spacings. What the particle departs from
/// it is noise, and smaller eddies. By layer of one spacing; about the means of the layers over time.
struct EddiesAndNoise {
    std::vector<double> z;         ///< middle of the layer above the bed level, m
    std::vector<double> velocity;  ///< mean of u, m/s
    /// Root mean squares of u, v, w, m/s: of the fitted field, and of the departures from it.
    std::array<std::vector<double>, 3> eddies, noise;
    std::vector<double> stress;            ///< -<u'w'> of the particles, m2/s2
    std::vector<double> stress_of_eddies;  ///< the same of the fitted field
    std::size_t snapshots = 0;             ///< that it is the mean of

    [[nodiscard]] bool empty() const { return z.empty(); }
};

inline constexpr double noise_reach = 2.2;

/// The viscosity as which the noise carries momentum down the gradient of the mean velocity, its mean stress
/// over the mean gradient of the layers between two heights (m), m2/s; 0 where they are fewer than two, or
/// the velocity does not grow upwards.
[[nodiscard]] double noise_viscosity(const EddiesAndNoise& split, double from, double to);

/// The particles of one moment: m and m/s, component after component.
struct ParticleVelocities {
    std::array<std::vector<double>, 3> position, velocity;
};

/// Makes this split of the particles at some moments: add() each, then result().
class NoiseSplit {
  public:
    /// `spacing` and `height` (of the layers in all), m.
    NoiseSplit(const Domain<3>& domain, double spacing, double height);

    void add(const ParticleVelocities& particles);
    /// Layers that hold at least `fewest` particles on the average of the moments.
    [[nodiscard]] EddiesAndNoise result(double fewest = 20.0) const;

  private:
    /// Sums over the particles of a layer: of the particles, of the fitted field, of the departures.
    struct Layer {
        double count = 0.0;
        std::array<double, 3> particle{}, eddy{};  ///< velocities
        std::array<double, 3> eddy_squared{}, noise_squared{};
        double particle_product = 0.0;  ///< u w
        double eddy_product = 0.0;
    };

    Domain<3> domain_;
    double spacing_;
    std::vector<Layer> layers_;
    std::size_t moments_ = 0;
};

}  // namespace riffle::inline analysis
