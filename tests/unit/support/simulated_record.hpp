#pragma once

#include <optional>
#include <string>
#include <utility>

#include "analysis/flow_record.hpp"

namespace riffle::test {

/// What an analysis is made from, as of a run of a case, without a results file: a test overrides the parts
/// that it has.
class SimulatedRecord : public FlowRecord {
  public:
    explicit SimulatedRecord(TimeWindow window, std::optional<Case> flow = std::nullopt)
        : flow_(std::move(flow)), window_(window) {}

    [[nodiscard]] Origin origin() const override { return Origin::simulated; }
    [[nodiscard]] std::string name() const override { return "record"; }
    [[nodiscard]] std::string source() const override { return "record"; }
    [[nodiscard]] const Case* flow() const override { return flow_ ? &*flow_ : nullptr; }
    [[nodiscard]] TimeWindow window() const override { return window_; }

    std::optional<Case> flow_;  ///< none: no case is known

  private:
    TimeWindow window_;
};

}  // namespace riffle::test
