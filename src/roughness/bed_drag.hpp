#pragma once

#include <memory>
#include <span>

#include "case/case.hpp"

namespace riffle {

/// Drag of the bed's roughness elements as a body force: acceleration -beta(z) u |u|.
class BedDrag {
  public:
    virtual ~BedDrag() = default;

    /// beta(z), 1/m, at height z above the bed level; zero outside the roughness zone.
    [[nodiscard]] virtual double coefficient(double z) const = 0;

    /// Height above which the coefficient is zero, m.
    [[nodiscard]] virtual double top() const = 0;

    /// coefficient() at each height.
    virtual void coefficients(std::span<const double> z, std::span<double> result) const = 0;
};

/// The drag law that the case names; nullptr for a smooth bed.
[[nodiscard]] std::unique_ptr<const BedDrag> make_bed_drag(const Case& c);

}  // namespace riffle
