#include "sph/lattice_sum.hpp"

#include <cmath>

#include "particles/lattice.hpp"
#include "sph/scalar_kernel.hpp"

namespace riffle::inline sph {

template <int D>
double lattice_kernel_sum(const Case& c) {
    const Lattice lattice = lattice_of(c);
    const double h = c.numerics.smoothing_ratio * c.numerics.spacing;
    const ScalarKernel kernel = scalar_kernel<D>(c.numerics.kernel);
    const int columns = static_cast<int>(2.0 * h / lattice.dx) + 2;
    const int files = D == 3 ? static_cast<int>(2.0 * h / lattice.dy) + 2 : 0;
    const int rows = 2 * static_cast<int>(h / lattice.dz) + 4;  // an even number: the same shift
    double sum = 0.0;
    for (int row = -rows; row <= rows; ++row) {
        for (int column = -columns; column <= columns; ++column) {
            for (int file = -files; file <= files; ++file) {
                const double across = D == 3 ? lattice.y(file, row) - lattice.y(0, 0) : 0.0;
                const double q = std::hypot(lattice.x(column, row) - lattice.x(0, 0), across,
                                            lattice.z(row) - lattice.z(0)) /
                                 h;
                sum += q < 2.0 ? kernel.value(q) : 0.0;
            }
        }
    }
    return sum * lattice.volume() / (D == 2 ? h * h : h * h * h);
}

template double lattice_kernel_sum<2>(const Case&);
template double lattice_kernel_sum<3>(const Case&);

}  // namespace riffle::inline sph
