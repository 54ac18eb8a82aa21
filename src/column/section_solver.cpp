#include "column/section_solver.hpp"

#include <algorithm>
#include <cmath>
#include <functional>

#include "base/error.hpp"
#include "base/interpolation.hpp"
#include "case/bed_traits.hpp"
#include "roughness/side_wall_partition.hpp"

namespace riffle::inline column {

void SectionFactorisation::compute(const SectionJacobian& jacobian, const Eigen::VectorXd& diagonal) {
    Eigen::SparseMatrix<double> matrix = jacobian.matrix;
    matrix.diagonal() += diagonal;
    if (!analysed_) {
        factors_.analyzePattern(matrix);
        analysed_ = true;
    }
    factors_.factorize(matrix);
    if (factors_.info() != Eigen::Success) {
        throw InputError(
            "the equations of the cross-section are singular: check fluid.kinematic_viscosity, "
            "channel.slope, bed.drag_coefficient and the [turbulence] constants of the case");
    }
    column_ = factors_.solve(jacobian.column);
    row_ = jacobian.row;
    denominator_ = 1.0 + row_.dot(column_);
}

Eigen::VectorXd SectionFactorisation::solve(const Eigen::VectorXd& right) const {
    Eigen::VectorXd x = factors_.solve(right);
    x -= column_ * (row_.dot(x) / denominator_);
    return x;
}

double SectionResult::velocity_at(double across, double height) const {
    const TablePlace column = place_in(y, across);
    const TablePlace row = place_in(z, height);
    const auto along = [&](std::size_t iz) { return column.in(velocity.data() + iz * y.size()); };
    const double low = along(row.low);
    return low + row.share * (along(row.high) - low);
}

std::vector<double> SectionResult::depth_means(double datum, double total_depth) const {
    std::vector<double> means(y.size(), 0.0);
    std::vector<double> water(y.size(), 0.0);
    double bottom = 0.0;
    for (std::size_t iz = 0; iz < z.size(); ++iz) {
        // The centres stand midway between the faces.
        const double top = iz + 1 == z.size() ? total_depth : 2.0 * z[iz] - bottom;
        const double part = std::max(0.0, top - std::max(bottom, datum));
        for (std::size_t iy = 0; iy < y.size(); ++iy) {
            const std::size_t cell = iz * y.size() + iy;
            const double share = porosity.empty() ? part : part * porosity[cell];
            means[iy] += velocity[cell] * share;
            water[iy] += share;
        }
        bottom = top;
    }
    std::transform(means.begin(), means.end(), water.begin(), means.begin(), std::divides<>());
    return means;
}

void check_section(const Case& c) {
    if (const auto reason = why_no_section(c)) throw InputError("the case has no section twin: " + *reason);
}

SectionResult section_result(const Case& c, const SectionGrid& grid, const SectionBalance& balance,
                             const Eigen::VectorXd& u) {
    const std::size_t columns = grid.columns();
    const std::size_t rows = grid.rows();
    const bool whole = c.channel.sides == Sides::walls;
    const double width = c.channel.width;
    const double depth = c.total_depth();
    SectionResult r;
    r.y = grid.y;
    r.z = grid.z;
    if (whole) {
        for (std::size_t i = columns; i-- > 0;) r.y.push_back(width - grid.y[i]);
    }
    const SectionBalance::Stresses stresses = balance.stresses(u);
    const double density = c.fluid.density;
    for (std::size_t iz = 0; iz < rows; ++iz) {
        for (std::size_t k = 0; k < r.y.size(); ++k) {
            const bool mirrored = k >= columns;
            const std::size_t iy = mirrored ? 2 * columns - 1 - k : k;
            const std::size_t cell = grid.cell(iy, iz);
            const auto i = static_cast<Eigen::Index>(cell);
            r.velocity.push_back(u(i) / balance.porosity(i));
            if (!c.porous.empty()) r.porosity.push_back(balance.porosity(i));
            r.mixing_length.push_back(balance.mixing_length(iy, iz));
            r.shear_stress.push_back(density * stresses.vertical[cell]);
            r.lateral_shear_stress.push_back((mirrored ? -density : density) * stresses.lateral[cell]);
        }
    }
    double above = 0.0;
    double above_area = 0.0;
    double layer = 0.0;
    double layer_area = 0.0;
    const double edge = c.side_walls.drag_form == SideDragForm::none ? 0.0 : c.side_layer();
    for (std::size_t iz = 0; iz < rows; ++iz) {
        for (std::size_t iy = 0; iy < columns; ++iy) {
            const auto i = static_cast<Eigen::Index>(grid.cell(iy, iz));
            const double area = balance.area()(i);
            if (grid.z[iz] > c.datum()) {
                above += area * u(i);
                above_area += area * balance.porosity(i);
            }
            if (grid.y[iy] < edge) {
                layer += area * u(i);
                layer_area += area * balance.porosity(i);
            }
        }
    }
    const double water = balance.water_area().sum();
    r.bulk_velocity = balance.area().dot(u) / water;
    // As of the column: in porous layers the momentum and energy of the water over its share of the section.
    double square = 0.0;
    double cube = 0.0;
    for (Eigen::Index i = 0; i < u.size(); ++i) {
        const double in_pores = u(i) / balance.porosity(i);
        square += balance.area()(i) * u(i) * in_pores;
        cube += balance.area()(i) * u(i) * in_pores * in_pores;
    }
    const double total_area = balance.area().sum();
    const double mean = balance.area().dot(u) / total_area;
    r.momentum_coefficient = square / water / (mean * mean);
    r.energy_coefficient = cube / total_area / (mean * mean * mean);
    r.depth_mean_velocity = above / above_area;
    r.centreline_velocity = r.depth_means(c.datum(), depth)[columns - 1];
    r.maximum_velocity = *std::max_element(r.velocity.begin(), r.velocity.end());
    r.wall_layer_velocity = layer_area > 0.0 ? layer / layer_area : 0.0;
    r.discharge = r.bulk_velocity * depth * width * (water / balance.area().sum());
    const double bed = balance.bed_force(u);
    const double wall = balance.wall_force(u);
    r.drag_share = bed / balance.weight();
    r.side_wall_share = wall / balance.weight();
    r.wall_share = is_no_slip(c.bed) ? r.drag_share + r.side_wall_share : 0.0;
    r.vegetation_share = balance.vegetation_force(u) / balance.weight();
    r.porous_share = balance.porous_force(u) / balance.weight();
    r.bed_stress = density * bed / c.channel.centreline();
    r.wall_stress = density * wall / depth;
    r.side_wall_coefficient = balance.wall_coefficient(u);
    r.partition = side_wall_partition(c);
    return r;
}

Eigen::VectorXd velocities_on(const SectionGrid& grid, const SectionResult& result) {
    Eigen::VectorXd u(static_cast<Eigen::Index>(grid.size()));
    for (std::size_t iz = 0; iz < grid.rows(); ++iz) {
        for (std::size_t iy = 0; iy < grid.columns(); ++iy) {
            u(static_cast<Eigen::Index>(grid.cell(iy, iz))) = result.velocity_at(grid.y[iy], grid.z[iz]);
        }
    }
    return u;
}

}  // namespace riffle::inline column
