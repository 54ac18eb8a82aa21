#pragma once

#include <functional>
#include <vector>

#include "case/case.hpp"
#include "ends/entering_flow.hpp"

namespace riffle::inline ends {

/// The velocity of the water that enters a canal, over the mean of its section: across it that of uniform
/// flow by lateral_profile(), over the height of the water above its bed at a place that of a law; the same
/// for all time.
class CanalFlowProfile final : public EnteringFlow {
  public:
    /// u over its mean above a place, at a height over the bed there in water of a depth there over a bed of
    /// a roughness there, m.
    using Law = std::function<double(double height, double depth, double roughness)>;

    /// Of water of a depth over the lowest point of the section (m), whose velocities are known in the
    /// middles of strips across the channel, m/s, and the roughness of the bed there, m. Nothing enters
    /// nearer to the bed than `least_height` (m): where the water is deeper than that, a place close over a
    /// bank would stand below it.
    CanalFlowProfile(double width, double depth, double least_height, std::vector<double> bed,
                     std::vector<double> velocity, std::vector<double> roughness, Law law);

    [[nodiscard]] double mean_at(double y, double place) const override;
    [[nodiscard]] double largest() const override { return largest_; }
    [[nodiscard]] std::size_t bytes() const override {
        return (bed_.capacity() + velocity_.capacity() + roughness_.capacity()) * sizeof(double);
    }

  private:
    double width_;  ///< of the simulated channel, m
    double depth_;
    double least_height_;
    std::vector<double> bed_;        ///< over the lowest point, m
    std::vector<double> velocity_;   ///< over the mean of the section
    std::vector<double> roughness_;  ///< k_s, m
    Law law_;
    double largest_ = 1.0;
};

/// What enters a canal by the keys of a case, with a discharge over the width of its channel (m2/s) in water
/// of a depth (m): `inflow.profile` twin, power-law, log-law or uniform.
[[nodiscard]] std::shared_ptr<const EnteringFlow> canal_entering(const Case& c, double unit_discharge,
                                                                 double depth);

}  // namespace riffle::inline ends
