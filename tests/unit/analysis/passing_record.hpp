#pragma once

#include <functional>
#include <string>
#include <utility>
#include <vector>

#include "simulated_record.hpp"

namespace riffle::test {

/// A channel with open ends, 100 mm deep, whose sections recorded discharge and depth over the window.
class PassingRecord : public SimulatedRecord {
  public:
    explicit PassingRecord(TimeWindow window) : SimulatedRecord(window, Case{}) {
        flow_->channel.ends = Ends::open;
        flow_->channel.depth = 0.1;
    }
    [[nodiscard]] const std::vector<ScalarProbe>& scalar_probes() const override { return probes_; }
    [[nodiscard]] const SpaceTime& surface() const override { return surface_; }

    std::vector<ScalarProbe> probes_;
    SpaceTime surface_;

  protected:
    /// Section `number` of the instrument `name` at x (m): what passes it at a time, and how deep, each
    /// `interval` (s).
    void add_section(const std::string& name, std::size_t number, double x,
                     const std::function<double(double time)>& discharge,
                     const std::function<double(double time)>& depth, double interval = 0.02) {
        for (const auto& [quantity, of] : {std::pair{"flow_rate_", discharge}, {"depth_", depth}}) {
            ScalarProbe probe;
            probe.name = name;
            probe.kind = "flow_rate";
            probe.quantity = quantity + std::to_string(number);
            probe.x = x;
            for (int i = 0; interval * i <= window().to + 1e-9; ++i) {
                probe.time.push_back(interval * i);
                probe.value.push_back(of(interval * i));
            }
            probes_.push_back(std::move(probe));
        }
    }
};

}  // namespace riffle::test
