#include "instruments/particle_cells.hpp"

#include <algorithm>
#include <cmath>

namespace riffle {

ParticleCells::ParticleCells(const Domain<2>& domain, std::span<const double> x, std::span<const double> z,
                             double reach)
    : x_(x),
      z_(z),
      lower_x_(domain.lower[0]),
      lower_z_(domain.lower[1]),
      extent_x_(domain.extent(0)),
      periodic_(domain.periodic[0]) {
    columns_ = std::max(1, static_cast<int>(extent_x_ / reach));
    rows_ = std::max(1, static_cast<int>(domain.extent(1) / reach));
    columns_per_length_ = columns_ / extent_x_;
    rows_per_length_ = rows_ / domain.extent(1);
    const auto cells = static_cast<std::size_t>(columns_) * static_cast<std::size_t>(rows_);
    begin_.assign(cells + 1, 0);
    std::vector<std::int32_t> cell_of(x.size());
    for (std::size_t i = 0; i < x.size(); ++i) {
        cell_of[i] = column_of(x[i]) * rows_ + row_of(z[i]);
        ++begin_[static_cast<std::size_t>(cell_of[i]) + 1];
    }
    for (std::size_t cell = 0; cell < cells; ++cell) {
        begin_[cell + 1] += begin_[cell];
    }
    std::vector<std::int32_t> next(begin_.begin(), begin_.end() - 1);
    members_.resize(x.size());
    for (std::size_t i = 0; i < x.size(); ++i) {
        members_[static_cast<std::size_t>(next[static_cast<std::size_t>(cell_of[i])]++)] =
            static_cast<std::int32_t>(i);
    }
}

int ParticleCells::column_of(double x) const {
    double d = x - lower_x_;
    if (periodic_ && (d < 0.0 || d >= extent_x_)) {
        d -= extent_x_ * std::floor(d / extent_x_);
    }
    return std::clamp(static_cast<int>(d * columns_per_length_), 0, columns_ - 1);
}

int ParticleCells::row_of(double z) const {
    return std::clamp(static_cast<int>((z - lower_z_) * rows_per_length_), 0, rows_ - 1);
}

}  // namespace riffle
