#pragma once

#include <array>
#include <cmath>
#include <cstdint>

namespace riffle::inline particles {

template <int D>
using Vec = std::array<double, static_cast<std::size_t>(D)>;

/// The image of a coordinate that is nearest to another one along an axis that repeats itself after a period,
/// m; the coordinate itself where the period is 0.
[[nodiscard]] inline double image_near(double other, double x, double period) {
    return period > 0.0 ? x - period * std::round((x - other) / period) : x;
}

/// The box that holds all particles. A periodic axis covers [lower, upper); the others carry a margin around
/// fluid and walls, beyond which a particle has left the domain.
template <int D>
struct Domain {
    Vec<D> lower{};
    Vec<D> upper{};
    std::array<bool, static_cast<std::size_t>(D)> periodic{};

    /// The image of a coordinate along an axis that is nearest to another one.
    [[nodiscard]] double image_near(double other, double x, std::size_t k) const {
        return riffle::image_near(other, x, periodic[k] ? upper[k] - lower[k] : 0.0);
    }

    [[nodiscard]] double extent(int axis) const {
        const auto k = static_cast<std::size_t>(axis);
        return upper[k] - lower[k];
    }
};

/// Positions as 32-bit integers. On a periodic axis one period is 2^32 units, so that the wrap of integer
/// subtraction is the nearest periodic image; on the others the box is 2^31 units wide and no difference
/// overflows. The unit is about 1e-10 of the extent, far below the rounding of the pair arithmetic.
template <int D>
class FixedPoint {
  public:
    FixedPoint() = default;
    explicit FixedPoint(const Domain<D>& domain) {
        for (std::size_t k = 0; k < D; ++k) {
            const double extent = domain.upper[k] - domain.lower[k];
            periodic_[k] = domain.periodic[k];
            unit_[k] = extent / (periodic_[k] ? 4294967296.0 : 2147483648.0);
            inverse_unit_[k] = 1.0 / unit_[k];
            origin_[k] = periodic_[k] ? domain.lower[k] : 0.5 * (domain.lower[k] + domain.upper[k]);
        }
    }

    /// Whether a coordinate lies inside the range that an axis can represent.
    [[nodiscard]] bool in_range(double x, std::size_t axis) const {
        const double units = (x - origin_[axis]) * inverse_unit_[axis];
        return periodic_[axis] ? (units >= 0.0 && units < 4294967296.0)
                               : (units >= -1073741824.0 && units < 1073741824.0);
    }

    /// Integer coordinate; x must be in range.
    [[nodiscard]] std::int32_t encode(double x, std::size_t axis) const {
        const auto units = static_cast<std::int64_t>(std::floor((x - origin_[axis]) * inverse_unit_[axis]));
        return static_cast<std::int32_t>(static_cast<std::uint32_t>(units));
    }

    /// Coordinate of an integer position.
    [[nodiscard]] double decode(std::int32_t code, std::size_t axis) const {
        const double units = periodic_[axis] ? static_cast<double>(static_cast<std::uint32_t>(code)) : code;
        return origin_[axis] + (units + 0.5) * unit_[axis];
    }

    /// Length of one unit along an axis, m.
    [[nodiscard]] double unit(std::size_t axis) const { return unit_[axis]; }
    [[nodiscard]] double inverse_unit(std::size_t axis) const { return inverse_unit_[axis]; }
    /// Coordinate of the code 0.
    [[nodiscard]] double origin(std::size_t axis) const { return origin_[axis]; }
    /// The range of coordinates that an axis can represent, [lowest, highest).
    [[nodiscard]] double lowest(std::size_t axis) const {
        return periodic_[axis] ? origin_[axis] : origin_[axis] - 1073741824.0 * unit_[axis];
    }
    [[nodiscard]] double highest(std::size_t axis) const {
        return origin_[axis] + (periodic_[axis] ? 4294967296.0 : 1073741824.0) * unit_[axis];
    }

  private:
    Vec<D> unit_{};
    Vec<D> inverse_unit_{};
    Vec<D> origin_{};
    std::array<bool, static_cast<std::size_t>(D)> periodic_{};
};

/// Difference of two integer coordinates with the wrap of a periodic axis.
[[nodiscard]] inline std::int32_t wrapped_difference(std::int32_t a, std::int32_t b) {
    return static_cast<std::int32_t>(static_cast<std::uint32_t>(a) - static_cast<std::uint32_t>(b));
}

}  // namespace riffle::inline particles
