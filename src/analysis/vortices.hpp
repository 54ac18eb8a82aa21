#pragma once

#include <array>
#include <cstddef>
#include <vector>

namespace riffle::inline analysis {

/// A box of cells for derivatives and regions: the first axis runs fastest; an axis of one cell has no
/// derivative.
struct CellBox {
    std::array<std::size_t, 3> cells{1, 1, 1};
    std::array<double, 3> spacing{0.0, 0.0, 0.0};  ///< m
    std::array<bool, 3> periodic{false, false, false};

    [[nodiscard]] std::size_t size() const { return cells[0] * cells[1] * cells[2]; }
};

/// Derivative along an axis, 1/m times the values' unit: central differences, one-sided beside an end and
/// beside cells that are not numbers; not-a-number where there is nothing to take a difference with.
[[nodiscard]] std::vector<double> derivative(const CellBox& box, const std::vector<double>& values,
                                             std::size_t axis);

/// Swirling strength of the motion in a plane, 1/s, with the sign of the rotation from the first towards the
/// second axis: the imaginary part of the eigenvalues of the velocity gradient, zero where they are real
/// (Zhou, Adrian, Balachandar & Kendall 1999).
[[nodiscard]] std::vector<double> swirling_strength(const CellBox& plane, const std::vector<double>& first,
                                                    const std::vector<double>& second);

/// Rotation of the motion in a plane, d second/d first axis - d first/d second axis, 1/s.
[[nodiscard]] std::vector<double> plane_vorticity(const CellBox& plane, const std::vector<double>& first,
                                                  const std::vector<double>& second);

/// Q = (|Omega|^2 - |S|^2)/2 of a motion in space, 1/s2: positive where it turns more than it strains (Hunt,
/// Wray & Moin 1988).
[[nodiscard]] std::vector<double> q_criterion(const CellBox& box,
                                              const std::array<std::vector<double>, 3>& velocity);

/// Regions of cells that hang together by their faces and have the mark, the largest first; those of fewer
/// than `smallest` cells are left out.
[[nodiscard]] std::vector<std::vector<std::size_t>> connected_regions(const CellBox& box,
                                                                      const std::vector<bool>& marked,
                                                                      std::size_t smallest = 1);

/// Root mean square over the values that are numbers; 0 where there are none.
[[nodiscard]] double root_mean_square(const std::vector<double>& values);

}  // namespace riffle::inline analysis
