#include "solver/cell_sums.hpp"

#include <algorithm>

namespace riffle {

CellSums::CellSums(const CellPlace& count)
    : count_(count),
      dense_(count[0] * count[1] * count[2] * dense_quantities),
      bed_(count[0] * count[2]),
      sides_(count[0] * count[1]) {}

void CellSums::add(const CellPlace& cell, const std::array<double, cell_quantities>& terms) {
    double* const sums = &dense_[index(cell) * dense_quantities];
    for (std::size_t q = 0; q < dense_quantities; ++q) {
        sums[q] += terms[q];
    }
    add_forces(cell, terms[dense_quantities], terms[dense_quantities + 1], terms[dense_quantities + 2]);
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
            return dense_[index(cell) * dense_quantities + static_cast<std::size_t>(quantity)];
    }
}

void CellSums::clear() {
    std::fill(dense_.begin(), dense_.end(), 0.0);
    clear_forces();
}

void CellSums::clear_forces() {
    for (std::vector<Row>* const rows : {&bed_, &sides_}) {
        for (Row& row : *rows) {
            row.reset();
        }
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
    std::size_t values = dense_.capacity() + bed_.capacity() + sides_.capacity();
    for (const Row& row : bed_) {
        values += row != nullptr ? 2 * count_[1] : 0;
    }
    for (const Row& column : sides_) {
        values += column != nullptr ? count_[2] : 0;
    }
    return values * sizeof(double);
}

}  // namespace riffle
