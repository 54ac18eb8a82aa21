#include "particles/particle_cells.hpp"

#include <algorithm>
#include <cmath>

namespace riffle::inline particles {

template <int D>
ParticleCells<D>::ParticleCells(const Domain<D>& domain, const Positions& positions, double reach,
                                Shape shape)
    : positions_(positions), domain_(domain), shape_(shape) {
    std::size_t cells = 1;
    for (std::size_t k = 0; k < D; ++k) {
        extent_[k] = domain.extent(static_cast<int>(k));
        const bool whole = k == vertical && shape == Shape::columns;
        count_[k] = whole ? 1 : std::max(1, static_cast<int>(extent_[k] / reach));
        per_length_[k] = count_[k] / extent_[k];
        cells *= static_cast<std::size_t>(count_[k]);
    }
    const std::size_t n = positions[0].size();
    begin_.assign(cells + 1, 0);
    std::vector<std::int32_t> cell_of(n);
    for (std::size_t i = 0; i < n; ++i) {
        int cell = index(0, positions[0][i]);
        for (std::size_t k = 1; k < D; ++k) cell = cell * count_[k] + index(k, positions[k][i]);
        cell_of[i] = cell;
        ++begin_[static_cast<std::size_t>(cell) + 1];
    }
    for (std::size_t cell = 0; cell < cells; ++cell) begin_[cell + 1] += begin_[cell];
    std::vector<std::int32_t> next(begin_.begin(), begin_.end() - 1);
    members_.resize(n);
    for (std::size_t i = 0; i < n; ++i) {
        members_[static_cast<std::size_t>(next[static_cast<std::size_t>(cell_of[i])]++)] =
            static_cast<std::int32_t>(i);
    }
}

template <int D>
int ParticleCells<D>::index(std::size_t axis, double x) const {
    if (count_[axis] == 1) return 0;
    double d = x - domain_.lower[axis];
    const double extent = extent_[axis];
    if (axis != vertical && domain_.periodic[axis] && (d < 0.0 || d >= extent)) {
        d -= extent * std::floor(d / extent);
    }
    // Where a particle stands on an edge, rounding decides, and with it the order of the sums: each shape
    // keeps its own, so that no optimisation changes the bits of the results.
    const double cell = shape_ == Shape::columns ? d / extent * count_[axis] : d * per_length_[axis];
    return std::clamp(static_cast<int>(cell), 0, count_[axis] - 1);
}

template class ParticleCells<2>;
template class ParticleCells<3>;

}  // namespace riffle::inline particles
