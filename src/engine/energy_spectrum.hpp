#pragma once

#include <filesystem>
#include <vector>

namespace riffle::inline engine {

/// Energy spectrum E(k) of isotropic turbulence, whose integral over the wave number k is the kinetic energy
/// per mass: straight between its points on logarithmic axes, nothing beyond them.
class EnergySpectrum {
  public:
    /// From the columns `wavenumber` (1/m, rising, above 0) and `energy` (m3/s2, 0 or more) of a CSV file.
    /// Throws FileError with file and line where they are not so.
    explicit EnergySpectrum(const std::filesystem::path& path);

    [[nodiscard]] double at(double wavenumber) const;

    /// Root mean square of a component of the velocity of eddies up to a largest wave number (1/m), m/s.
    [[nodiscard]] double velocity_rms(double largest) const;

  private:
    std::vector<double> wavenumber_;
    std::vector<double> energy_;
};

}  // namespace riffle::inline engine
