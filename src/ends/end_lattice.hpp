#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <vector>

#include "case/case.hpp"
#include "ends/long_waves.hpp"
#include "hydraulics/section_shape.hpp"
#include "particles/lattice.hpp"

namespace riffle::inline ends {

/// Which places of the lattice across a channel hold water: all of them, or, where the channel has a
/// cross-section of its own or measured heights (uneven_bed_of()), those outside of that solid, as at the
/// start.
class EndLattice {
  public:
    /// All of them, in any number of rows.
    EndLattice() = default;
    /// Of a case, at a place along its channel, m.
    EndLattice(const Case& c, const Lattice& lattice, double x);

    [[nodiscard]] bool is_rectangle() const { return shape_ == nullptr; }
    /// Whether water may stand in a row and a file; rows above those that were looked at are as the last one.
    [[nodiscard]] bool holds(int row, int file) const;
    /// Height above z = 0 at which the water's lowest place in a file begins, m; of the highest row where it
    /// has none.
    [[nodiscard]] double floor_of(int file) const;
    /// The section as those places fill it; null of a rectangle.
    [[nodiscard]] const std::shared_ptr<const SectionShape>& shape() const { return shape_; }
    /// Its waves under a gravity normal to the bed (m/s2). Depths count from z = 0.
    [[nodiscard]] LongWaves waves(double gravity) const { return {gravity, shape_, lowest_}; }

  private:
    std::size_t files_ = 0;
    std::vector<std::uint8_t> holds_;  ///< by rows, within them by files
    std::vector<double> floor_;        ///< by file
    std::shared_ptr<const SectionShape> shape_;
    double lowest_ = 0.0;  ///< point of it above z = 0, m
};

/// A place beyond an end of a channel, m along it.
[[nodiscard]] inline double place_of_end(const Case& c, bool at_inflow) {
    return at_inflow ? -0.5 * c.numerics.spacing : c.channel.length + 0.5 * c.numerics.spacing;
}

/// Waves over the section of a case with open ends, at one of them, as its lattice fills it: those that rule
/// its ends. Depths count from z = 0.
[[nodiscard]] LongWaves waves_of_lattice(const Case& c, bool at_inflow = true);

/// The same over a section as it is drawn; of measured heights as the lattice fills it.
[[nodiscard]] LongWaves waves_of(const Case& c, bool at_inflow = true);

}  // namespace riffle::inline ends
