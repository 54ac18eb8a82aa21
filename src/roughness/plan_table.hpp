#pragma once

#include <array>
#include <cstddef>
#include <utility>
#include <vector>

#include "base/interpolation.hpp"

namespace riffle::inline roughness {

/// A quantity at places evenly apart in plan, linear between them; outside of them as at the nearest.
class PlanTable {
  public:
    /// The places along an axis, m.
    struct Axis {
        double first = 0.0;
        double step = 1.0;
        std::size_t count = 1;

        [[nodiscard]] double at(std::size_t i) const { return first + step * static_cast<double>(i); }
    };

    PlanTable() = default;
    /// `values`: [across, along].
    PlanTable(const Axis& along, const Axis& across, std::vector<double> values)
        : axes_{along, across}, values_(std::move(values)) {}

    [[nodiscard]] bool empty() const { return values_.empty(); }

    [[nodiscard]] double at(double x, double y) const {
        const TablePlace along = place(x, axes_[0]);
        const TablePlace across = place(y, axes_[1]);
        const auto on_line = [&](std::size_t line) { return along.in(&values_[line * axes_[0].count]); };
        const double here = on_line(across.low);
        return here + across.share * (on_line(across.high) - here);
    }

  private:
    [[nodiscard]] static TablePlace place(double at, const Axis& axis) {
        return place_among((at - axis.first) / axis.step, axis.count);
    }

    std::array<Axis, 2> axes_{};
    std::vector<double> values_;
};

}  // namespace riffle::inline roughness
