#pragma once

#include <cmath>
#include <cstddef>
#include <limits>
#include <optional>
#include <string>
#include <vector>

namespace riffle::inline case_file {

/// Heights on a regular grid, in any unit. Row by row along x, y growing from row to row.
struct HeightGrid {
    std::size_t columns = 0;  ///< along x
    std::size_t rows = 0;     ///< along y
    double x = 0.0;           ///< of the first column
    double y = 0.0;           ///< of the first row
    double step_x = 1.0;
    double step_y = 1.0;
    std::vector<double> z;                      ///< NaN where there is none
    std::optional<double> unit = std::nullopt;  ///< of its places, m, where the file says so

    [[nodiscard]] double& at(std::size_t column, std::size_t row) { return z[row * columns + column]; }
    [[nodiscard]] double at(std::size_t column, std::size_t row) const { return z[row * columns + column]; }
};

/// Heights at places along a line, which need not be evenly apart; by growing x. NaN where there is none.
struct HeightLine {
    std::vector<double> x;
    std::vector<double> z;
    std::optional<double> unit = std::nullopt;  ///< of its places, m, where the file says so
};

/// What was filled of heights with holes.
struct FilledHoles {
    std::size_t heights = 0;  ///< that were missing
    std::size_t holes = 0;    ///< parts that hang together
    double widest = 0.0;      ///< width of the widest hole across its narrower sense
    double x = 0.0;           ///< a place in it, the furthest from any height
    double y = 0.0;
};

/// Fill what is missing of a grid: each such height becomes the mean of its four neighbours (of those that
/// the grid has), as a membrane that hangs in the edge of the hole. Where nothing is known nothing is filled.
FilledHoles fill_holes(HeightGrid& grid);
/// The same of a line: straight from one side of the hole to the other; at an end of the line level.
FilledHoles fill_holes(HeightLine& line);

/// Height between the points of a grid or a line, which hold no holes: bilinear; beyond them straight on for
/// half a step, as far as a point stands for, and level from there.
[[nodiscard]] double height_between(const HeightGrid& grid, double x, double y);
[[nodiscard]] double height_between(const HeightLine& line, double x);

}  // namespace riffle::inline case_file
