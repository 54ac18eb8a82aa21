#pragma once

#include <cstddef>
#include <vector>

#include "case/case.hpp"

namespace riffle::inline column {

/// Finite-volume grid of half a cross-section, from the side wall y = 0 to the plane of symmetry, m. Faces
/// stand where a coefficient has a kink: over the height those of the column, across the channel the edge of
/// the wall's layer and that of the edge zone of the mixing lengths; cosine-spaced between them, and dense in
/// the lateral shear beside the wall. Cells count row by row: iz * y.size() + iy.
struct SectionGrid {
    std::vector<double> y_face, y;
    std::vector<double> z_face, z;

    [[nodiscard]] std::size_t columns() const { return y.size(); }
    [[nodiscard]] std::size_t rows() const { return z.size(); }
    [[nodiscard]] std::size_t size() const { return y.size() * z.size(); }
    [[nodiscard]] std::size_t cell(std::size_t iy, std::size_t iz) const { return iz * y.size() + iy; }
};

/// Grid of about `cells_across` x `cells_over_depth` cells. Throws InputError unless 0 <= datum < H.
[[nodiscard]] SectionGrid make_section_grid(const Case& c, int cells_across, int cells_over_depth);

}  // namespace riffle::inline column
