#include "solver/cell_sums.hpp"

#include <algorithm>

namespace riffle::inline solver {

CellSums::CellSums(const CellPlace& count)
    : count_(count),
      dense_(count[0] * count[1] * count[2] * dense_quantities),
      bed_(count[0] * count[2]),
      sides_(count[0] * count[1]) {}

void CellSums::add(const CellPlace& cell, const CellSample& sample) {
    float* const values = &dense_[index(cell) * dense_quantities];
    const auto at = [&](CellQuantity quantity) -> float& {
        return values[static_cast<std::size_t>(quantity)];
    };
    using enum CellQuantity;
    at(count) += 1.0F;
    const double share = 1.0 / static_cast<double>(at(count));
    // What a value departs from the mean of those before it; and the mean that includes it.
    const auto step = [&](CellQuantity quantity, double value) {
        const double departure = value - static_cast<double>(at(quantity));
        at(quantity) = static_cast<float>(static_cast<double>(at(quantity)) + share * departure);
        return departure;
    };
    constexpr std::array means{u, v, w};
    std::array<double, 3> before{};
    std::array<double, 3> after{};
    for (std::size_t k = 0; k < means.size(); ++k) {
        before[k] = step(means[k], sample.velocity[k]);
        after[k] = sample.velocity[k] - static_cast<double>(at(means[k]));
    }
    const auto multiply = [&](CellQuantity quantity, std::size_t k, std::size_t l) {
        at(quantity) = static_cast<float>(static_cast<double>(at(quantity)) + before[k] * after[l]);
    };
    multiply(uu, 0, 0);
    multiply(vv, 1, 1);
    multiply(ww, 2, 2);
    multiply(uw, 0, 2);
    multiply(uv, 0, 1);
    multiply(vw, 1, 2);
    step(shear_stress, sample.shear_stress);
    step(lateral_shear_stress, sample.lateral_shear_stress);
    step(pressure, sample.pressure);
    step(eddy_viscosity, sample.eddy_viscosity);
    add_forces(cell, sample.drag_force, sample.spanwise_drag_force, sample.side_wall_force);
}

void CellSums::add_forces(const CellPlace& cell, double drag, double across, double side) {
    const auto [x, y, z] = cell;
    if (drag != 0.0 || across != 0.0) {
        Row& row = bed_[x * count_[2] + z];
        if (row == nullptr) {
            row = std::make_unique<double[]>(2 * count_[1]);  // NOLINT(*-avoid-c-arrays)
        }
        row[2 * y] += drag;
        row[2 * y + 1] += across;
    }
    if (side != 0.0) {
        Row& column = sides_[x * count_[1] + y];
        if (column == nullptr) {
            column = std::make_unique<double[]>(count_[2]);  // NOLINT(*-avoid-c-arrays)
        }
        column[z] += side;
    }
}

double CellSums::get(const CellPlace& cell, CellQuantity quantity) const {
    const auto [x, y, z] = cell;
    const Row& row = bed_[x * count_[2] + z];
    switch (quantity) {
        case CellQuantity::drag_force:
            return row != nullptr ? row[2 * y] : 0.0;
        case CellQuantity::spanwise_drag_force:
            return row != nullptr ? row[2 * y + 1] : 0.0;
        case CellQuantity::side_wall_force: {
            const Row& column = sides_[x * count_[1] + y];
            return column != nullptr ? column[z] : 0.0;
        }
        default:
            break;
    }
    const float* const values = &dense_[index(cell) * dense_quantities];
    const auto value = static_cast<double>(values[static_cast<std::size_t>(quantity)]);
    const bool product = quantity >= CellQuantity::uu && quantity <= CellQuantity::vw;
    const auto samples = static_cast<double>(values[0]);
    return product && samples > 0.0 ? value / samples : value;
}

void CellSums::clear() {
    std::fill(dense_.begin(), dense_.end(), 0.0F);
    clear_forces();
}

void CellSums::clear_forces() {
    for (std::vector<Row>* const rows : {&bed_, &sides_}) {
        for (Row& row : *rows) row.reset();
    }
}

double CellSums::force(std::size_t number) const {
    return get(place(number / forces), static_cast<CellQuantity>(dense_quantities + number % forces));
}

void CellSums::set_forces(const std::vector<double>& values) {
    clear_forces();
    for (std::size_t i = 0; i + forces <= values.size(); i += forces) {
        add_forces(place(i / forces), values[i], values[i + 1], values[i + 2]);
    }
}

std::size_t CellSums::bytes() const {
    std::size_t values = bed_.capacity() + sides_.capacity();
    for (const Row& row : bed_) values += row != nullptr ? 2 * count_[1] : 0;
    for (const Row& column : sides_) values += column != nullptr ? count_[2] : 0;
    return values * sizeof(double) + dense_.capacity() * sizeof(float);
}

}  // namespace riffle::inline solver
