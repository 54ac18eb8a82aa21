#pragma once

#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "solver/simulation.hpp"

namespace riffle::verification {

/// A case of cases/checks/, read, started and ready to step on one thread.
class CheckRun {
  public:
    /// `name` without folder and ending, e.g. "poiseuille".
    explicit CheckRun(const std::string& name, const std::vector<Override>& overrides = {});

    /// Step until t >= time; `each` is called after every step.
    void advance_to(double time, const std::function<void()>& each = {});

    [[nodiscard]] const Case& parameters() const { return case_; }
    [[nodiscard]] const Simulation& simulation() const { return *simulation_; }
    [[nodiscard]] const Particles<2>& particles() const { return simulation_->particles(); }
    [[nodiscard]] double time() const { return simulation_->clock().time; }

  private:
    Case case_;
    std::unique_ptr<Simulation> simulation_;
};

/// Mass-weighted sums over the particles: sum m f(i) / sum m.
template <int D>
[[nodiscard]] double mass_mean(const Particles<D>& particles, const std::function<double(std::size_t)>& f);

/// Largest speed of any particle, m/s.
template <int D>
[[nodiscard]] double largest_speed(const Particles<D>& particles);

/// Departure of the pressure from that of water at rest, rms over the particles more than 2h below the
/// surface, over rho g H.
[[nodiscard]] double hydrostatic_error(const CheckRun& run);

/// Departure of the streamwise velocity from a profile u(z), m/s.
struct ProfileError {
    double largest = 0.0;  ///< of any particle
    double rms = 0.0;      ///< of the particles
    double profile = 0.0;  ///< rms over the height of the departures averaged along x, in bins of one spacing
};
[[nodiscard]] ProfileError profile_error(const CheckRun& run, const std::function<double(double)>& profile);

/// Print one row of the table of docs/verification.md, and fail the test unless measured < bar.
void expect_below(const std::string& check, const std::string& norm, double bar, double measured);

}  // namespace riffle::verification
