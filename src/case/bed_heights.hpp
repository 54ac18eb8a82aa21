#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "case/case.hpp"

namespace riffle::inline case_file {

/// The heights of a bed as the particle spacing resolves them: at regular places over the channel from its
/// begin to its end and from side to side, m above the bed level.
struct BedHeights {
    std::size_t columns = 0;  ///< steps along the channel
    std::size_t rows = 0;     ///< steps across it; 0 in two dimensions
    double step_x = 0.0;      ///< m
    double step_y = 0.0;
    std::vector<double> z;           ///< (columns + 1) (rows + 1), row by row along the channel
    std::vector<std::string> notes;  ///< what was made of the data, for people

    [[nodiscard]] double& at(std::size_t column, std::size_t row) { return z[row * (columns + 1) + column]; }
    [[nodiscard]] double at(std::size_t column, std::size_t row) const {
        return z[row * (columns + 1) + column];
    }
};

/// The heights of a solid by `shape` = "bed". Where data are finer than the spacing a height is their mean
/// over one spacing around its place, else it lies straight between them; holes up to `largest_hole` are
/// filled (fill_holes()); over `blend` before periodic ends and sides half of the difference between the two
/// is added to the one and taken from the other. Beside open ends the bed is made the same along the channel
/// over watched_stretch(), and over `blend` behind that, or as far again, goes over to the data. FileError
/// for the file (parse_height_grid()); InputError, with what to do, where it does not cover the channel, has
/// too large a hole, lies below the bed level, does not repeat at periodic ends, or has heights that look
/// like a wrong unit.
[[nodiscard]] BedHeights bed_heights(const Case& c, const Solid& solid);

/// The widest hole that is filled of a bed, m: `largest_hole`, else four particle spacings.
[[nodiscard]] double largest_filled_hole(const Case& c, const Solid& solid);

}  // namespace riffle::inline case_file
