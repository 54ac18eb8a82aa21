#include "particles/particle_cells.hpp"

#include <gtest/gtest.h>

#include <algorithm>

#include "cloud.hpp"

namespace riffle::particle_cells_test {
namespace {

constexpr double reach = 0.11;

/// Around each particle the cells hold once every particle within reach, of columns at any height.
template <int D>
void check(typename ParticleCells<D>::Shape shape) {
    Domain<D> domain;
    domain.upper.fill(1.0);
    domain.upper[D - 1] = 0.6;
    domain.periodic[0] = true;
    const Cloud<D> cloud = random_cloud<D>(domain, 400, 0.1, 7);
    typename ParticleCells<D>::Positions positions;
    std::copy(cloud.position.begin(), cloud.position.end(), positions.begin());
    const ParticleCells<D> cells(domain, positions, reach, shape);
    for (std::size_t i = 0; i < cloud.size(); ++i) {
        std::vector<int> found(cloud.size(), 0);
        Vec<D> point{};
        for (std::size_t k = 0; k < D; ++k) point[k] = cloud.position[k][i];
        cells.around(point, [&](std::size_t j) { ++found[j]; });
        for (std::size_t j = 0; j < cloud.size(); ++j) {
            double squared = 0.0;
            for (std::size_t k = 0; k < D; ++k) {
                const double d = cells.distance(k, positions[k][i], positions[k][j]);
                const bool looked_at = k + 1 < D || shape == ParticleCells<D>::Shape::cells;
                squared += looked_at ? d * d : 0.0;
            }
            EXPECT_LE(found[j], 1);
            EXPECT_TRUE(found[j] == 1 || squared > reach * reach);
        }
    }
}

TEST(ParticleCells, HoldAllWithinReach) {
    check<2>(ParticleCells<2>::Shape::cells);
    check<3>(ParticleCells<3>::Shape::cells);
}

TEST(ParticleCells, ColumnsHoldAllOverAndUnderAPlace) {
    check<2>(ParticleCells<2>::Shape::columns);
    check<3>(ParticleCells<3>::Shape::columns);
}

}  // namespace
}  // namespace riffle::particle_cells_test
