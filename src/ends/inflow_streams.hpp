#pragma once

#include <cstddef>
#include <functional>
#include <utility>

#include "ends/end_lattice.hpp"
#include "ends/open_ends_state.hpp"

namespace riffle::inline ends {

/// The streams in which water enters a channel: rows over each other, in three dimensions files beside each
/// other, each a line of particles that moves at one velocity. A row is as high as the depth over their
/// number, and a particle as long in it as its volume demands, so that the area that the streams bring in is
/// the integral of their velocities, to rounding: the discharge is exact, whatever the particles. In a
/// cross-section of its own only those streams run that its lattice holds.
class InflowStreams {
  public:
    /// `area`: of a particle in the vertical plane of its file, m2; `row_height`: that of the lattice, m;
    /// `upstream_edge`: where the streams end, m.
    InflowStreams(int files, double area, double row_height, double upstream_edge, EndLattice lattice = {})
        : files_(files),
          area_(area),
          row_height_(row_height),
          upstream_edge_(upstream_edge),
          lattice_(std::move(lattice)) {}

    [[nodiscard]] const EndLattice& lattice() const { return lattice_; }
    /// Rows for a depth.
    [[nodiscard]] int rows_for(double depth) const;
    /// Length of a particle in its stream, m.
    [[nodiscard]] double length(int rows, double depth) const { return area_ * rows / depth; }
    [[nodiscard]] double height_of(int row, int rows, double depth) const {
        return (row + 0.5) * depth / rows;
    }

    /// Streams of so many rows whose last particles stand at x = `front`.
    void begin(OpenEndsState& state, int rows, double front) const;
    /// Move the streams for dt, each at its velocity at x = 0, which falls by `spreading` (1/s) along it.
    void advance(OpenEndsState& state, double dt, double spreading,
                 const std::function<double(int row, int file)>& velocity) const;
    /// Take another number of rows where the depth has changed by more than most of a row; the area stays.
    void rearrange(OpenEndsState& state, double depth) const;
    /// Fill the streams up to their edge: add(row, file, x) for each new particle, in a fixed order; streams
    /// that have gone back beyond it give theirs up.
    void fill(OpenEndsState& state, double depth,
              const std::function<void(int row, int file, double x)>& add) const;

  private:
    [[nodiscard]] std::size_t index(int row, int file) const {
        return static_cast<std::size_t>(row) * static_cast<std::size_t>(files_) +
               static_cast<std::size_t>(file);
    }
    [[nodiscard]] double& front(OpenEndsState& state, int row, int file) const {
        return state.front[index(row, file)];
    }

    int files_;
    double area_, row_height_, upstream_edge_;
    EndLattice lattice_;
};

}  // namespace riffle::inline ends
