#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "particles/domain.hpp"

namespace riffle {

/// Particles sorted into cells at least as wide and high as a kernel reaches, so that those around a point
/// are found without looking at all. Keeps views of the positions, which must outlive it and stay as they
/// are.
class ParticleCells {
  public:
    /// `reach`: distance within which around() finds all particles, m.
    ParticleCells(const Domain<2>& domain, std::span<const double> x, std::span<const double> z,
                  double reach);

    [[nodiscard]] std::span<const double> x() const { return x_; }
    [[nodiscard]] std::span<const double> z() const { return z_; }
    /// Lowest height of the domain, m.
    [[nodiscard]] double lowest() const { return lower_z_; }

    /// Distance a - b along the channel, of the nearest images where it is periodic.
    [[nodiscard]] double distance(double a, double b) const {
        const double d = a - b;
        if (!periodic_) {
            return d;
        }
        return d > 0.5 * extent_x_ ? d - extent_x_ : (d < -0.5 * extent_x_ ? d + extent_x_ : d);
    }

    /// f(particle) for the particles of the cells that hold all within `reach` of a point, in an order that
    /// follows from the order of the particles alone.
    template <class F>
    void around(double x, double z, const F& f) const {
        const int row = row_of(z);
        around(x, row > 0 ? row - 1 : 0, row + 2 < rows_ ? row + 2 : rows_, f);
    }

    /// The same for all heights: the particles within `reach` of x, from the lowest row of cells up in each
    /// column.
    template <class F>
    void around(double x, const F& f) const {
        around(x, 0, rows_, f);
    }

  private:
    template <class F>
    void around(double x, int first_row, int end_row, const F& f) const {
        const int centre = column_of(x);
        for (int c = centre - 1; c <= centre + 1; ++c) {
            int column = c;
            if (periodic_ && columns_ >= 3) {
                column = (c + columns_) % columns_;
            } else if (c < 0 || c >= columns_) {
                continue;  // of one or two columns all are in range
            }
            const std::size_t cell = static_cast<std::size_t>(column) * static_cast<std::size_t>(rows_);
            const auto begin = static_cast<std::size_t>(begin_[cell + static_cast<std::size_t>(first_row)]);
            const auto end = static_cast<std::size_t>(begin_[cell + static_cast<std::size_t>(end_row)]);
            for (std::size_t k = begin; k < end; ++k) {
                f(static_cast<std::size_t>(members_[k]));
            }
        }
    }
    [[nodiscard]] int column_of(double x) const;
    [[nodiscard]] int row_of(double z) const;

    std::span<const double> x_;
    std::span<const double> z_;
    double lower_x_, lower_z_, extent_x_;
    double columns_per_length_, rows_per_length_;
    bool periodic_;
    int columns_ = 1;
    int rows_ = 1;
    std::vector<std::int32_t> begin_;    ///< by cell, columns first: its first member; and the end
    std::vector<std::int32_t> members_;  ///< particles by cell
};

}  // namespace riffle
