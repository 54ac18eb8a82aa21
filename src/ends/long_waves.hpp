#pragma once

#include <memory>
#include <utility>

#include "hydraulics/section_shape.hpp"

namespace riffle::inline ends {

/// Long waves on the water of a cross-section: along dx/dt = U + c goes U + R, along dx/dt = U - c goes U -
/// R, with c = sqrt(g A/B) of the area A and the width B of the surface, and R the integral of sqrt(g B/A)
/// over the depth (Stoker 1957, section 10.12); in a rectangle c = sqrt(g h) and R = 2 c. Depths are over the
/// lowest point, areas over the width of the channel, both in m.
class LongWaves {
  public:
    /// Of a rectangle; `gravity` normal to the bed, m/s2.
    LongWaves(double gravity) : gravity_(gravity) {}  // a gravity is all that they are of
    /// Of a section, null: of a rectangle, whose lowest point is `lowest` (m) above where depths count from.
    LongWaves(double gravity, std::shared_ptr<const SectionShape> section, double lowest = 0.0)
        : gravity_(gravity), section_(std::move(section)), lowest_(lowest) {}

    [[nodiscard]] double gravity() const { return gravity_; }
    [[nodiscard]] bool in_rectangle() const { return section_ == nullptr; }
    /// Depth at which there is no water, m.
    [[nodiscard]] double lowest() const { return lowest_; }
    /// Area of the water over the width of the channel, m.
    [[nodiscard]] double area(double depth) const {
        return section_ ? section_->area(depth - lowest_) : depth;
    }
    [[nodiscard]] double depth_of_area(double area) const {
        return section_ ? lowest_ + section_->depth_of_area(area) : area;
    }
    /// c, m/s.
    [[nodiscard]] double speed(double depth) const;
    /// R, m/s.
    [[nodiscard]] double invariant(double depth) const;
    [[nodiscard]] double depth_of_invariant(double invariant) const;
    /// dR/dh, 1/s.
    [[nodiscard]] double invariant_by_depth(double depth) const;
    /// Depth of critical flow with a discharge over the width of the channel, m2/s.
    [[nodiscard]] double critical_depth(double unit_discharge) const;
    /// Depth behind a jump, m: where the momentum function is the same (Bélanger).
    [[nodiscard]] double sequent_depth(double depth, double velocity) const;

  private:
    double gravity_;
    std::shared_ptr<const SectionShape> section_;
    double lowest_ = 0.0;
};

}  // namespace riffle::inline ends
