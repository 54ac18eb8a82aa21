#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "particles/domain.hpp"
#include "particles/joined_values.hpp"

namespace riffle::inline particles {

/// Particles sorted into cells at least as wide as a kernel reaches, so that those around a point are found
/// without looking at all. Keeps views of the positions, which must outlive it and stay as they are.
template <int D>
class ParticleCells {
  public:
    using Positions = std::array<JoinedValues, static_cast<std::size_t>(D)>;

    /// Cells at least as high as wide, or columns as high as the domain, around a point of any height.
    enum class Shape { cells, columns };

    /// `reach`: distance within which around() finds all particles, m.
    ParticleCells(const Domain<D>& domain, const Positions& positions, double reach,
                  Shape shape = Shape::cells);

    [[nodiscard]] const Positions& positions() const { return positions_; }

    /// Distance a - b along an axis, of the nearest images where it is periodic.
    [[nodiscard]] double distance(std::size_t axis, double a, double b) const {
        const double d = a - b;
        if (!domain_.periodic[axis] || axis == vertical) return d;
        const double extent = extent_[axis];
        return d > 0.5 * extent ? d - extent : (d < -0.5 * extent ? d + extent : d);
    }

    /// f(particle) for the particles of the cells that hold all within `reach` of a point, in an order that
    /// follows from the order of the particles alone.
    template <class F>
    void around(const Vec<D>& point, const F& f) const {
        const int row = index(vertical, point[vertical]);
        const int first = row > 0 ? row - 1 : 0;
        const int end = row + 2 < count_[vertical] ? row + 2 : count_[vertical];
        beside(0, point[0], [&](int column) {
            if constexpr (D == 2) {
                members(column, first, end, f);
            } else {
                beside(1, point[1], [&](int file) { members(column * count_[1] + file, first, end, f); });
            }
        });
    }

    /// The same for the whole cross-section: the particles within `reach` of x, from the lowest row of cells
    /// up in each column.
    template <class F>
    void around_section(double x, const F& f) const {
        beside(0, x, [&](int column) {
            const int files = D == 2 ? 1 : count_[1];
            for (int file = 0; file < files; ++file) members(column * files + file, 0, count_[vertical], f);
        });
    }

  private:
    static constexpr std::size_t vertical = D - 1;

    /// f(cell along the axis) for the one that holds x and its neighbours.
    template <class F>
    void beside(std::size_t axis, double x, const F& f) const {
        const int count = count_[axis];
        const int centre = index(axis, x);
        for (int c = centre - 1; c <= centre + 1; ++c) {
            if (domain_.periodic[axis] && count >= 3) {
                f((c + count) % count);
            } else if (c >= 0 && c < count) {  // of one or two cells all are in range
                f(c);
            }
        }
    }
    /// f(particle) for some rows of a column of cells.
    template <class F>
    void members(int column, int first_row, int end_row, const F& f) const {
        const std::size_t cell =
            static_cast<std::size_t>(column) * static_cast<std::size_t>(count_[vertical]);
        const auto begin = static_cast<std::size_t>(begin_[cell + static_cast<std::size_t>(first_row)]);
        const auto end = static_cast<std::size_t>(begin_[cell + static_cast<std::size_t>(end_row)]);
        for (std::size_t k = begin; k < end; ++k) f(static_cast<std::size_t>(members_[k]));
    }
    [[nodiscard]] int index(std::size_t axis, double x) const;

    Positions positions_;
    Domain<D> domain_;
    Shape shape_;
    Vec<D> extent_{};
    Vec<D> per_length_{};                                   ///< cells per length
    std::array<int, static_cast<std::size_t>(D)> count_{};  ///< cells along each axis
    std::vector<std::int32_t> begin_;    ///< by cell, columns first: its first member; and the end
    std::vector<std::int32_t> members_;  ///< particles by cell
};

}  // namespace riffle::inline particles
