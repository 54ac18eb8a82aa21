#include "case/bed_heights.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <utility>

#include "base/error.hpp"
#include "case/end_buffers.hpp"
#include "case/height_file.hpp"
#include "case/text_lines.hpp"

namespace riffle::inline case_file {

namespace {

/// A length for messages, in three digits.
std::string length_text(double value) {
    return std::abs(value) < 1.0 ? fmt::format("{:.3g} mm", 1e3 * value) : fmt::format("{:.4g} m", value);
}

/// Mean and standard deviation of heights, and their range.
struct HeightSpread {
    double mean = 0.0;
    double deviation = 0.0;
    double low = 0.0;
    double high = 0.0;

    explicit HeightSpread(const std::vector<double>& z) {
        const auto [least, most] = std::minmax_element(z.begin(), z.end());
        low = *least;
        high = *most;
        for (const double value : z) mean += value / static_cast<double>(z.size());
        double squares = 0.0;
        for (const double value : z) {
            squares += (value - mean) * (value - mean) / static_cast<double>(z.size());
        }
        deviation = std::sqrt(squares);
    }
};

/// The units that files of heights may be in.
constexpr std::array<std::pair<double, const char*>, 3> file_units{{{1.0, "m"}, {1e-3, "mm"}, {1e-2, "cm"}}};

/// Which other unit would make a length of the file fit, as a sentence; empty where none does or the present
/// one fits.
std::string other_unit(const char* key, double extent, double unit, double least, double most) {
    if (extent >= least && extent <= most) return "";
    for (const auto& [other, name] : file_units) {
        const double with_it = extent / unit * other;
        if (other != unit && with_it >= least && with_it <= most) {
            return fmt::format(" In {} it would be {}: did you mean {} = \"1 {}\"?", name,
                               length_text(with_it), key, name);
        }
    }
    return "";
}

class BedMaker {
  public:
    BedMaker(const Case& c, const Solid& solid)
        : c_(c),
          solid_(solid),
          space_(c.channel.dimensions == 3),
          height_unit_(solid.height_unit.value_or(solid.unit)),
          extent_{c.channel.length, space_ ? c.channel.simulated_width() : 0.0} {}

    BedHeights make() {
        if (space_) {
            make_grid();
        } else {
            make_line();
        }
        check_units();
        for (std::size_t axis = 0; axis < (space_ ? 2U : 1U); ++axis) {
            const bool periodic =
                axis == 0 ? c_.channel.ends == Ends::periodic : c_.channel.sides == Sides::periodic;
            if (periodic) join_ends(axis);
        }
        if (c_.channel.ends == Ends::open) level_ends();
        check_level();
        const HeightSpread spread(bed_.z);
        note(fmt::format("heights {} to {} above the bed level, mean {}, standard deviation {}",
                         length_text(spread.low), length_text(spread.high), length_text(spread.mean),
                         length_text(spread.deviation)));
        return std::move(bed_);
    }

  private:
    [[noreturn]] void refuse_bed(const std::string& what) const {
        throw InputError(fmt::format("{}: {}", solid_.heights.string(), what));
    }
    void note(const std::string& what) { bed_.notes.push_back(fmt::format("{}: {}", solid_.name, what)); }

    [[nodiscard]] double origin(std::size_t axis) const {
        return axis < solid_.origin.size() ? solid_.origin[axis] : 0.0;
    }
    [[nodiscard]] std::string content() const {
        return data_file_content(solid_.heights.string(), "file of heights", 20.0);
    }
    [[nodiscard]] double height(double in_file) const {
        return height_unit_ * (in_file - origin(space_ ? 2 : 1));
    }

    /// The places over the channel at which it has heights.
    void lay_out() {
        const auto steps = [&](double extent) {
            return static_cast<std::size_t>(std::max(1.0, std::round(extent / c_.numerics.spacing)));
        };
        bed_.columns = steps(extent_[0]);
        bed_.step_x = extent_[0] / static_cast<double>(bed_.columns);
        if (space_) {
            bed_.rows = steps(extent_[1]);
            bed_.step_y = extent_[1] / static_cast<double>(bed_.rows);
        }
        constexpr double most_places = 2e7;
        const double places = static_cast<double>(bed_.columns + 1) * static_cast<double>(bed_.rows + 1);
        if (places > most_places) {
            refuse_bed(
                fmt::format("the channel has {:.2g} places of a particle spacing in plan, expected at most "
                            "{:.2g}: choose a larger spacing or a smaller channel",
                            places, most_places));
        }
        bed_.z.assign((bed_.columns + 1) * (bed_.rows + 1), 0.0);
    }

    /// Refuse data that reach from `low` to `high` along an axis, m, with half a step beyond either end,
    /// where they do not cover the channel.
    void check_cover(std::size_t axis, double low, double high) const {
        const double slack = 1e-6 * extent_[axis];
        if (low <= slack && high >= extent_[axis] - slack) return;
        const char* const name = axis == 0 ? "x" : "y";
        const double size = high - low;
        std::string cure = other_unit("unit", size, solid_.unit, 0.99 * extent_[axis], 4.0 * extent_[axis]);
        if (cure.empty() && size >= extent_[axis] - slack) {
            cure = fmt::format(
                " It is long enough: set the value for {} in origin, the place in the file that comes to the "
                "channel's begin, to {:.10g}.",
                name, origin(axis) + low / solid_.unit);
        } else if (cure.empty()) {
            cure = fmt::format(" Make the channel shorter than {}, or give more data.", length_text(size));
        }
        refuse_bed(
            fmt::format("its heights reach from {} = {} to {} in the channel, which reaches from 0 to {}.{}",
                        name, length_text(low), length_text(high), length_text(extent_[axis]), cure));
    }

    /// Refuse data of which the whole channel lies between two points, far apart, where another unit puts
    /// many over it.
    void check_step(std::size_t axis, double step, std::size_t points) const {
        constexpr std::size_t few = 2;  // a plane bed may be drawn by its ends
        constexpr double far_apart = 10.0;
        const std::string cure = other_unit("unit", step, solid_.unit, 0.0, 0.5 * extent_[axis]);
        if (step <= far_apart * extent_[axis] || points <= few || cure.empty()) return;
        refuse_bed(fmt::format("its points stand {} apart, and the channel is {} {}.{}", length_text(step),
                               length_text(extent_[axis]), axis == 0 ? "long" : "wide", cure));
    }

    void check_holes(const FilledHoles& filled, std::size_t points, bool in_plane) {
        if (filled.heights == 0) return;
        const std::string place = in_plane
                                      ? fmt::format("({}, {})", length_text(filled.x), length_text(filled.y))
                                      : fmt::format("x = {}", length_text(filled.x));
        const double most = largest_filled_hole(c_, solid_);
        if (filled.heights == points || filled.widest > most * (1 + 1e-9)) {
            refuse_bed(
                filled.heights == points
                    ? "holds no height in the channel: all are marked as missing"
                    : fmt::format("the hole without heights around {} is {} wide, and up to {} are "
                                  "filled. Give the heights that are missing, or allow it: largest_hole "
                                  "= \"{:.3g} mm\"",
                                  place, length_text(filled.widest), length_text(most),
                                  1e3 * filled.widest * 1.001));
        }
        note(fmt::format("{} of {} heights were missing, in {} {}, the widest {} around {}: filled {}",
                         filled.heights, points, filled.holes, filled.holes == 1 ? "hole" : "holes",
                         length_text(filled.widest), place,
                         in_plane ? "with the mean of the neighbours of each, as a membrane in the hole"
                                  : "with a straight line from edge to edge"));
    }

    /// The heights of the file at places so far apart, m, by `at`, on the places of the bed.
    template <class At>
    void resample(const std::array<double, 2>& apart, const HeightSpread& before, const At& at) {
        const auto parts = [](double step, double data) {
            return static_cast<int>(std::clamp(std::ceil(step / data - 1e-6), 1.0, 100.0));
        };
        const int along = parts(bed_.step_x, apart[0]);
        const int across = space_ ? parts(bed_.step_y, apart[1]) : 1;
        const auto shift = [](int part, int count, double step) {
            return ((part + 0.5) / count - 0.5) * step;
        };
        for (std::size_t row = 0; row <= bed_.rows; ++row) {
            for (std::size_t column = 0; column <= bed_.columns; ++column) {
                double sum = 0.0;
                for (int i = 0; i < along; ++i) {
                    for (int j = 0; j < across; ++j) {
                        sum += at(static_cast<double>(column) * bed_.step_x + shift(i, along, bed_.step_x),
                                  static_cast<double>(row) * bed_.step_y + shift(j, across, bed_.step_y));
                    }
                }
                bed_.at(column, row) = sum / (along * across);
            }
        }
        const HeightSpread after(bed_.z);
        const bool finer = along > 1 || across > 1;
        note(fmt::format(
            "{} {} apart become {} apart ({}); standard deviation {} becomes {}", "heights",
            space_ && apart[0] != apart[1]
                ? fmt::format("{} and {}", length_text(apart[0]), length_text(apart[1]))
                : length_text(apart[0]),
            length_text(bed_.step_x),
            finer ? "means over one particle spacing" : "straight between the data, which are no finer",
            length_text(before.deviation), length_text(after.deviation)));
    }

    /// Refuse another unit than that which the file itself says.
    void check_unit_of_file(const std::optional<double>& unit) const {
        if (unit && std::abs(solid_.unit / *unit - 1.0) > 1e-6) {
            refuse_bed(fmt::format(
                "its places are in units of {0:.7g} m, as it says, and unit is {1:.7g} m: set unit = \"{0:.7g} m\"",
                *unit, solid_.unit));
        }
    }

    void make_grid() {
        HeightGrid grid = parse_height_grid(content(), solid_.heights.string());
        check_unit_of_file(grid.unit);
        const auto placed = [&](double& first, double& step, std::size_t axis) {
            first = solid_.unit * (first - origin(axis));
            step *= solid_.unit;
        };
        placed(grid.x, grid.step_x, 0);
        placed(grid.y, grid.step_y, 1);
        for (double& z : grid.z) z = height(z);
        check_step(0, grid.step_x, grid.columns);
        check_step(1, grid.step_y, grid.rows);
        check_cover(0, grid.x - 0.5 * grid.step_x,
                    grid.x + (static_cast<double>(grid.columns) - 0.5) * grid.step_x);
        check_cover(1, grid.y - 0.5 * grid.step_y,
                    grid.y + (static_cast<double>(grid.rows) - 0.5) * grid.step_y);
        grid = over_channel(grid);
        lay_out();
        note(fmt::format("{} x {} heights of {} over the channel", grid.columns, grid.rows,
                         solid_.heights.filename().string()));
        check_holes(fill_holes(grid), grid.z.size(), true);
        resample({grid.step_x, grid.step_y}, HeightSpread(grid.z),
                 [&](double x, double y) { return height_between(grid, x, y); });
    }

    /// The part of a grid that lies over the channel, with a point beyond it on each side where there is one.
    [[nodiscard]] HeightGrid over_channel(const HeightGrid& grid) const {
        const auto range = [](double first, double step, std::size_t count, double extent) {
            const auto most = static_cast<double>(count - 1);
            const double low = std::clamp(std::floor(-first / step + 1e-6), 0.0, most);
            const double high = std::clamp(std::ceil((extent - first) / step - 1e-6), low, most);
            return std::pair(static_cast<std::size_t>(low), static_cast<std::size_t>(high));
        };
        const auto [left, right] = range(grid.x, grid.step_x, grid.columns, extent_[0]);
        const auto [near, far] = range(grid.y, grid.step_y, grid.rows, extent_[1]);
        HeightGrid part{.columns = right - left + 1,
                        .rows = far - near + 1,
                        .x = grid.x + grid.step_x * static_cast<double>(left),
                        .y = grid.y + grid.step_y * static_cast<double>(near),
                        .step_x = grid.step_x,
                        .step_y = grid.step_y,
                        .z = {}};
        for (std::size_t row = near; row <= far; ++row) {
            for (std::size_t column = left; column <= right; ++column) part.z.push_back(grid.at(column, row));
        }
        return part;
    }

    void make_line() {
        HeightLine line = parse_height_line(content(), solid_.heights.string());
        check_unit_of_file(line.unit);
        HeightLine part;
        std::vector<double> gaps;
        for (std::size_t i = 0; i < line.x.size(); ++i) {
            line.x[i] = solid_.unit * (line.x[i] - origin(0));
            line.z[i] = height(line.z[i]);
            if (i > 0) gaps.push_back(line.x[i] - line.x[i - 1]);
        }
        if (gaps.empty()) refuse_bed("holds one height: expected two or more");
        for (std::size_t i = 0; i < gaps.size(); ++i) {
            if (line.x[i] <= 0.0 && line.x[i + 1] >= extent_[0]) check_step(0, gaps[i], line.x.size());
        }
        check_cover(0, line.x.front() - 0.5 * gaps.front(), line.x.back() + 0.5 * gaps.back());
        for (std::size_t i = 0; i < line.x.size(); ++i) {
            const bool before = i + 1 < line.x.size() && line.x[i + 1] <= 0.0;
            const bool behind = i > 0 && line.x[i - 1] >= extent_[0];
            if (!before && !behind) {
                part.x.push_back(line.x[i]);
                part.z.push_back(line.z[i]);
            }
        }
        lay_out();
        note(fmt::format("{} heights of {} over the channel", part.x.size(),
                         solid_.heights.filename().string()));
        check_holes(fill_holes(part), part.x.size(), false);
        std::nth_element(gaps.begin(), gaps.begin() + static_cast<std::ptrdiff_t>(gaps.size() / 2),
                         gaps.end());
        resample({gaps[gaps.size() / 2], 0.0}, HeightSpread(part.z),
                 [&](double x, double) { return height_between(part, x); });
    }

    void check_units() const {
        const HeightSpread spread(bed_.z);
        const double range = spread.high - spread.low;
        const double water = std::max(c_.total_depth(), c_.channel.wall_height.value_or(0.0));
        const double least = 0.02 * c_.numerics.spacing;
        const double most = 5.0 * water;
        if (range > 1e-6 * c_.numerics.spacing && (range < least || range > most)) {
            refuse_bed(
                fmt::format("its heights range over {}, {}.{}", length_text(range),
                            range < least ? "far less than the particle spacing"
                                          : "more than five times the depth of the water",
                            other_unit("height_unit", range, height_unit_, 10.0 * least, 2.0 * water).empty()
                                ? std::string(" See unit and height_unit, the lengths of the file's units.")
                                : other_unit("height_unit", range, height_unit_, 10.0 * least, 2.0 * water)));
        }
    }

    void check_level() const {
        const HeightSpread spread(bed_.z);
        const std::size_t axis = space_ ? 2 : 1;
        const double raised = origin(axis) + spread.low / height_unit_;
        if (spread.low < -1e-6 * c_.numerics.spacing) {
            refuse_bed(fmt::format(
                "its lowest height is {}, below the bed level z = 0, where the floor of the channel stands: set "
                "the height in origin (the height in the file that comes to z = 0) to {:.10g} or less",
                length_text(spread.low), raised));
        }
        if (spread.low >= c_.total_depth() && c_.start.water_x.empty()) {
            refuse_bed(
                fmt::format("stands above the water everywhere: its lowest height is {}, the water's "
                            "level {}. Set the height in origin to {:.10g}, or see unit and height_unit",
                            length_text(spread.low), length_text(c_.total_depth()), raised));
        }
    }

    /// 1 up to a place, from which on it falls smoothly to 0 over a way of 1.
    [[nodiscard]] static double faded(double way) {
        const double t = std::clamp(1.0 - way, 0.0, 1.0);
        return t * t * (3.0 - 2.0 * t);
    }

    /// Makes the two ends of an axis one: what lies at the begin and at the end of a periodic channel is the
    /// same place.
    void join_ends(std::size_t axis) {
        const std::size_t last = axis == 0 ? bed_.columns : bed_.rows;
        const std::size_t lines = axis == 0 ? bed_.rows : bed_.columns;
        const double step = axis == 0 ? bed_.step_x : bed_.step_y;
        const auto at = [&](std::size_t i, std::size_t line) -> double& {
            return axis == 0 ? bed_.at(i, line) : bed_.at(line, i);
        };
        double jump = 0.0;
        std::size_t where = 0;
        for (std::size_t line = 0; line <= lines; ++line) {
            if (const double here = std::abs(at(0, line) - at(last, line)); here > jump) {
                jump = here;
                where = line;
            }
        }
        const char* const ends = axis == 0 ? "ends" : "sides";
        if (jump > 0.5 * c_.numerics.spacing && solid_.blend == 0.0) {
            const std::string place = space_
                                          ? fmt::format(" at {} = {}", axis == 0 ? "y" : "x",
                                                        length_text(static_cast<double>(where) *
                                                                    (axis == 0 ? bed_.step_y : bed_.step_x)))
                                          : std::string();
            const double blend =
                std::min(std::max(5.0 * jump, 10.0 * c_.numerics.spacing), 0.25 * extent_[axis]);
            refuse_bed(fmt::format(
                "its heights do not repeat at the periodic {} of the channel: they differ by up to {}{}. Spread "
                "the difference, for example blend = \"{:.3g} mm\" (the length before either end), or give "
                "data that repeat, or set [channel] {} = \"walls\"",
                ends, length_text(jump), place, 1e3 * blend, ends));
        }
        const double over = std::max(solid_.blend, 0.5 * step);
        for (std::size_t line = 0; line <= lines; ++line) {
            const double half = 0.5 * (at(0, line) - at(last, line));
            for (std::size_t i = 0; i <= last; ++i) {
                const auto share = [&](std::size_t steps) {
                    return faded(static_cast<double>(steps) * step / over);
                };
                at(i, line) += half * (share(last - i) - share(i));
            }
        }
        if (jump > 1e-6 * c_.numerics.spacing) {
            note(fmt::format(
                "differs by up to {} between its {}, which are periodic: {}", length_text(jump), ends,
                solid_.blend > 0.0 ? fmt::format("spread over {} before either", length_text(solid_.blend))
                                   : std::string("both take the mean")));
        }
    }

    /// Makes the bed the same along the channel where water enters and leaves and where it is watched there:
    /// at each place across its mean over that stretch, from which it goes over to the heights of the file.
    void level_ends() {
        const double watched = watched_stretch(c_);
        const auto level = static_cast<std::size_t>(std::ceil(watched / bed_.step_x)) + 1;
        const double over = std::max(solid_.blend > 0.0 ? solid_.blend : watched, bed_.step_x);
        const auto all =
            std::min(bed_.columns / 2, level + static_cast<std::size_t>(std::ceil(over / bed_.step_x)));
        double change = 0.0;
        for (std::size_t row = 0; row <= bed_.rows; ++row) {
            for (const bool upstream : {true, false}) {
                const auto at = [&](std::size_t i) -> double& {
                    return bed_.at(upstream ? i : bed_.columns - i, row);
                };
                const std::size_t last = std::min(level, bed_.columns / 2);
                double mean = 0.0;
                for (std::size_t i = 0; i <= last; ++i) mean += at(i) / static_cast<double>(last + 1);
                for (std::size_t i = 0; i <= all; ++i) {
                    const double way =
                        (static_cast<double>(i) - static_cast<double>(last)) * bed_.step_x / over;
                    const double moved = faded(way) * (mean - at(i));
                    change = std::max(change, std::abs(moved));
                    at(i) += moved;
                }
            }
        }
        if (change > 1e-6 * c_.numerics.spacing) {
            note(fmt::format(
                "made the same along the channel over {} from either open end, at each place across its mean there, by up "
                "to {}; over the next {} it goes over to the heights of the file",
                length_text(static_cast<double>(level) * bed_.step_x), length_text(change),
                length_text(over)));
        }
    }

    const Case& c_;
    const Solid& solid_;
    bool space_;
    double height_unit_;
    std::array<double, 2> extent_;
    BedHeights bed_;
};

}  // namespace

double largest_filled_hole(const Case& c, const Solid& solid) {
    return solid.largest_hole.value_or(4.0 * c.numerics.spacing);
}

BedHeights bed_heights(const Case& c, const Solid& solid) { return BedMaker(c, solid).make(); }

}  // namespace riffle::inline case_file
