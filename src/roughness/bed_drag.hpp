#pragma once

#include <cassert>
#include <cstddef>
#include <memory>
#include <span>

#include "case/case.hpp"

namespace riffle::inline roughness {

/// Drag of the bed's roughness elements as a body force: acceleration -beta u |u|, in three dimensions also
/// -beta v |v| across the channel.
class BedDrag {
  public:
    virtual ~BedDrag() = default;

    /// beta(z), 1/m, at height z above the bed level; zero outside the roughness zone. Where the elements
    /// stand at their places, the mean over the horizontal plane: what the column twin needs.
    [[nodiscard]] virtual double coefficient(double z) const = 0;

    /// Height above which the coefficient is zero, m.
    [[nodiscard]] virtual double top() const = 0;

    /// beta at a point, where the elements stand at their places; else that of the height.
    [[nodiscard]] virtual double coefficient_at(double x, double y, double z) const {
        static_cast<void>(x);
        static_cast<void>(y);
        return coefficient(z);
    }
    /// Whether coefficient_at() varies over the horizontal plane.
    [[nodiscard]] virtual bool varies_in_plan() const { return false; }

    /// Whether the coefficient changes with the speed of the water, and its factor at height z and a speed,
    /// m/s.
    [[nodiscard]] virtual bool varies_with_speed() const { return false; }
    [[nodiscard]] virtual double speed_factor(double z, double speed) const {
        static_cast<void>(z);
        static_cast<void>(speed);
        return 1.0;
    }
    /// The factor at a point, where that changes over the plane; else that of the height.
    [[nodiscard]] virtual double speed_factor_at(double x, double y, double z, double speed) const {
        static_cast<void>(x);
        static_cast<void>(y);
        return speed_factor(z, speed);
    }

    /// coefficient() at each height.
    void coefficients(std::span<const double> z, std::span<double> result) const {
        assert(result.size() == z.size());
        for (std::size_t i = 0; i < z.size(); ++i) result[i] = coefficient(z[i]);
    }
};

/// The drag law of the case's spheres; nullptr for a bed without.
[[nodiscard]] std::unique_ptr<const BedDrag> make_bed_drag(const Case& c);

}  // namespace riffle::inline roughness
