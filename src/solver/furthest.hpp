#pragma once

#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <utility>

namespace riffle::inline solver {

/// The furthest of values added one by one, and the third furthest: of places of particles along a way that
/// is the front of the water, where two drops that fly ahead do not count.
class Furthest {
  public:
    void add(double value) {
        for (double& kept : values_) {
            if (value > kept) std::swap(value, kept);
        }
    }
    void add(const Furthest& other) {
        for (const double value : other.values_) add(value);
    }
    [[nodiscard]] double furthest() const { return values_.front(); }
    /// The third, or of fewer values the last one.
    [[nodiscard]] double front() const {
        std::size_t last = values_.size() - 1;
        while (last > 0 && !std::isfinite(values_[last])) --last;
        return values_[last];
    }

  private:
    static constexpr double nowhere = -std::numeric_limits<double>::infinity();
    std::array<double, 3> values_{nowhere, nowhere, nowhere};  ///< the furthest first
};

}  // namespace riffle::inline solver
