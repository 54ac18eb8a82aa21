#include "sph/lattice_sum.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "particles/lattice.hpp"
#include "sph/scalar_kernel.hpp"

namespace riffle::inline sph {

namespace {

/// Sums of W (h^D of it) and of W z/h over the places of the lattice around one of them, up to the row `top`
/// above it.
struct Sums {
    double zeroth = 0.0;
    double first = 0.0;
};
template <int D>
Sums sums_up_to(const Case& c, int top) {
    const Lattice lattice = lattice_of(c);
    const double h = c.numerics.smoothing_ratio * c.numerics.spacing;
    const ScalarKernel kernel = scalar_kernel<D>(c.numerics.kernel);
    const int columns = static_cast<int>(2.0 * h / lattice.dx) + 2;
    const int files = D == 3 ? static_cast<int>(2.0 * h / lattice.dy) + 2 : 0;
    const int rows = 2 * static_cast<int>(h / lattice.dz) + 4;  // an even number: the same shift
    Sums sums;
    for (int row = -rows; row <= std::min(rows, top); ++row) {
        for (int column = -columns; column <= columns; ++column) {
            for (int file = -files; file <= files; ++file) {
                const double across = D == 3 ? lattice.y(file, row) - lattice.y(0, 0) : 0.0;
                const double up = lattice.z(row) - lattice.z(0);
                const double q = std::hypot(lattice.x(column, row) - lattice.x(0, 0), across, up) / h;
                const double w = q < 2.0 ? kernel.value(q) : 0.0;
                sums.zeroth += w;
                sums.first += w * up / h;
            }
        }
    }
    return sums;
}

}  // namespace

template <int D>
double lattice_kernel_sum(const Case& c) {
    const double h = c.numerics.smoothing_ratio * c.numerics.spacing;
    return sums_up_to<D>(c, std::numeric_limits<int>::max()).zeroth * lattice_of(c).volume() /
           (D == 2 ? h * h : h * h * h);
}

template <int D>
std::vector<SurfaceRow> lattice_surface_rows(const Case& c) {
    const double all = sums_up_to<D>(c, std::numeric_limits<int>::max()).zeroth;
    std::vector<SurfaceRow> rows;
    for (int above = 0; rows.empty() || rows.back().fill < 1.0; ++above) {
        const Sums sums = sums_up_to<D>(c, above);
        rows.push_back({sums.zeroth / all, std::abs(sums.first) / all});
    }
    return rows;
}

template double lattice_kernel_sum<2>(const Case&);
template double lattice_kernel_sum<3>(const Case&);
template std::vector<SurfaceRow> lattice_surface_rows<2>(const Case&);
template std::vector<SurfaceRow> lattice_surface_rows<3>(const Case&);

}  // namespace riffle::inline sph
