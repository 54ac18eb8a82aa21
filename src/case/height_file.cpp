#include "case/height_file.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cctype>
#include <numeric>
#include <optional>
#include <utility>

#include "base/error.hpp"
#include "case/height_raster.hpp"
#include "case/text_lines.hpp"

namespace riffle::inline case_file {

namespace {

constexpr double missing_height = std::numeric_limits<double>::quiet_NaN();

std::string lower_case(std::string_view word) {
    std::string text(word);
    std::transform(text.begin(), text.end(), text.begin(),
                   [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
    return text;
}

/// ESRI ASCII grids: a header of names and numbers, then rows of heights from the north down.
class AscReader {
  public:
    AscReader(std::string_view content, const std::string& name) : lines_(content, name) {}

    HeightGrid read() {
        read_header();
        const auto columns = size_of(columns_, "ncols");
        const auto rows = size_of(rows_, "nrows");
        // Each height takes a digit and what parts it from the next.
        if (static_cast<double>(columns) * static_cast<double>(rows) >
            0.5 * static_cast<double>(lines_.bytes_left() + line_bytes() + 1)) {
            lines_.fault(
                fmt::format("cut short: ncols and nrows announce {} x {} heights, for which {} bytes are "
                            "too few",
                            columns, rows, lines_.bytes_left() + line_bytes()));
        }
        HeightGrid grid{.columns = columns, .rows = rows, .step_x = step_x_, .step_y = step_y_, .z = {}};
        grid.x = x_ + (x_is_corner_ ? 0.5 * step_x_ : 0.0);
        grid.y = y_ + (y_is_corner_ ? 0.5 * step_y_ : 0.0);
        grid.z.assign(columns * rows, missing_height);
        std::size_t read = 0;
        for (bool more = !lines_.words().empty(); more; more = lines_.next()) {
            for (const std::string_view word : lines_.words()) {
                if (read == grid.z.size()) {
                    lines_.fault(fmt::format("more heights than the {} x {} that ncols and nrows announce",
                                             columns, rows));
                }
                const double value = height_of(word);
                grid.at(read % columns, rows - 1 - read / columns) = value;
                ++read;
            }
        }
        if (read < grid.z.size()) {
            lines_.fault(
                fmt::format("cut short: holds {} of the {} x {} heights that ncols and nrows announce", read,
                            columns, rows));
        }
        return grid;
    }

  private:
    void read_header() {
        while (lines_.next()) {
            const auto& words = lines_.words();
            double ignored = 0.0;
            if (read_number(words[0], ignored)) {
                break;  // the first row of heights
            }
            const std::string key = lower_case(words[0]);
            if (words.size() != 2) {
                lines_.fault(
                    fmt::format("expected a name and a number of the header, found {} words", words.size()));
            }
            const double value = lines_.number(words[1], fmt::format("a number behind {}", key));
            set(key, value);
        }
        if (!(step_x_ > 0.0 && step_y_ > 0.0)) {
            lines_.fault("the header has no `cellsize` above zero: not an ESRI ASCII grid");
        }
        if (!has_x_ || !has_y_) {
            lines_.fault("the header has no xllcorner or xllcenter and yllcorner or yllcenter");
        }
    }

    void set(const std::string& key, double value) {
        if (key == "ncols") {
            columns_ = value;
        } else if (key == "nrows") {
            rows_ = value;
        } else if (key == "xllcorner" || key == "xllcenter") {
            x_ = value;
            has_x_ = true;
            x_is_corner_ = key == "xllcorner";
        } else if (key == "yllcorner" || key == "yllcenter") {
            y_ = value;
            has_y_ = true;
            y_is_corner_ = key == "yllcorner";
        } else if (key == "cellsize") {
            step_x_ = step_y_ = value;
        } else if (key == "dx") {
            step_x_ = value;
        } else if (key == "dy") {
            step_y_ = value;
        } else if (key == "nodata_value") {
            none_ = value;
        } else {
            lines_.fault(
                fmt::format("expected ncols, nrows, xllcorner, yllcorner, cellsize or NODATA_value, "
                            "found `{}`: not an ESRI ASCII grid",
                            shown_word(key)));
        }
    }

    [[nodiscard]] std::size_t size_of(double value, std::string_view key) const {
        if (!(value >= 1.0 && value <= 1e9 && value == std::floor(value))) {
            lines_.fault(fmt::format("the header needs `{}`, a whole number of at least 1", key));
        }
        return static_cast<std::size_t>(value);
    }

    [[nodiscard]] double height_of(std::string_view word) const {
        double value = 0.0;
        if (!read_number(word, value)) {
            lines_.fault(fmt::format("expected a height, found `{}`", shown_word(word)));
        }
        if (std::isinf(value)) {
            lines_.fault(fmt::format("expected a height, found `{}`: mark what is missing by NODATA_value",
                                     shown_word(word)));
        }
        return value == none_ ? missing_height : value;
    }

    [[nodiscard]] std::size_t line_bytes() const {
        const auto& words = lines_.words();
        return words.empty() ? 0
                             : static_cast<std::size_t>(words.back().data() + words.back().size() -
                                                        words.front().data());
    }

    TextLines lines_;
    double columns_ = 0.0;
    double rows_ = 0.0;
    double x_ = 0.0;
    double y_ = 0.0;
    double step_x_ = 0.0;
    double step_y_ = 0.0;
    double none_ = -9999.0;
    bool has_x_ = false;
    bool has_y_ = false;
    bool x_is_corner_ = false;
    bool y_is_corner_ = false;
};

/// A point of a file, and its line.
struct HeightPoint {
    std::array<double, 2> place{};
    double z = 0.0;
    std::size_t line = 0;
};

/// Lines of two or three numbers. `names`: of the columns, the height last.
std::vector<HeightPoint> read_points(std::string_view content, const std::string& name,
                                     const std::vector<std::string_view>& names) {
    TextLines lines(content, name, ",;");
    std::vector<std::size_t> columns(names.size());
    std::iota(columns.begin(), columns.end(), std::size_t{0});
    std::vector<HeightPoint> points;
    const std::string expected = fmt::format("{}", fmt::join(names, ", "));
    std::size_t count = names.size();
    bool first = true;
    while (lines.next()) {
        const auto& words = lines.words();
        double number = 0.0;
        if (words[0].starts_with('#')) continue;
        if (std::exchange(first, false) && !read_number(words[0], number)) {  // names of the columns
            count = words.size();
            if (std::any_of(words.begin(), words.end(),
                            [](auto word) { return word.find('[') != std::string_view::npos; })) {
                lines.fault(
                    fmt::format("expected columns of the names {} without units; give the unit of the "
                                "file by `unit`, such as unit = \"mm\"",
                                expected));
            }
            for (std::size_t k = 0; k < names.size(); ++k) {
                const auto found = std::find_if(words.begin(), words.end(),
                                                [&](auto word) { return lower_case(word) == names[k]; });
                if (found == words.end()) {
                    lines.fault(fmt::format("expected columns of the names {}, or numbers; `{}` is missing",
                                            expected, names[k]));
                }
                columns[k] = static_cast<std::size_t>(found - words.begin());
            }
            continue;
        }
        if (words.size() != count) {
            lines.fault(
                fmt::format("expected {} numbers ({}), found {}; decimals have a point, and what is "
                            "missing is nan",
                            count, expected, words.size()));
        }
        HeightPoint point;
        point.line = lines.line();
        for (std::size_t k = 0; k + 1 < names.size(); ++k) {
            point.place[k] = lines.number(words[columns[k]], fmt::format("the number {}", names[k]));
        }
        const std::string_view height = words[columns.back()];
        if (!read_number(height, point.z) || std::isinf(point.z)) {
            lines.fault(fmt::format("expected a height, found `{}`", shown_word(height)));
        }
        point.z = point.z == -9999.0 ? missing_height : point.z;
        points.push_back(point);
    }
    if (points.size() < 2) {
        throw FileError(
            fmt::format("{}: holds {} points: expected lines of {}", name, points.size(), expected));
    }
    return points;
}

/// The regular places that numbers stand on.
struct RegularPlaces {
    double first = 0.0;
    double step = 0.0;
    std::size_t count = 0;
};

/// Unset where the numbers do not stand on regular places within a tenth of their step.
std::optional<RegularPlaces> regular_places(std::vector<double> values) {
    std::sort(values.begin(), values.end());
    const double range = values.back() - values.front();
    if (!(range > 0.0)) {
        return RegularPlaces{values.front(), 0.0, 1};
    }
    double least = range;
    for (std::size_t i = 1; i < values.size(); ++i) {
        const double gap = values[i] - values[i - 1];
        if (gap > 1e-6 * range) least = std::min(least, gap);
    }
    // From gap to gap: places that were rounded when they were written have gaps longer and shorter than the
    // step, and the least of them would count too many over a long row.
    double steps = 0.0;
    double last = values.front();
    for (const double value : values) {
        if (value - last <= 1e-6 * range) continue;
        steps += std::round((value - last) / least);
        last = value;
    }
    const RegularPlaces places{values.front(), range / steps, static_cast<std::size_t>(steps) + 1};
    constexpr double most_rounding = 0.1;  // of a step
    for (const double value : values) {
        const double at = (value - places.first) / places.step;
        if (std::abs(at - std::round(at)) > most_rounding) return std::nullopt;
    }
    return places;
}

HeightGrid grid_of_points(const std::vector<HeightPoint>& points, const std::string& name) {
    std::array<RegularPlaces, 2> places;
    for (std::size_t axis = 0; axis < 2; ++axis) {
        std::vector<double> values;
        values.reserve(points.size());
        for (const HeightPoint& point : points) values.push_back(point.place[axis]);
        const auto regular = regular_places(std::move(values));
        if (!regular) {
            throw FileError(
                fmt::format("{}: its values of {} are not evenly apart: a bed needs points on a "
                            "regular grid; interpolate them onto one first",
                            name, axis == 0 ? "x" : "y"));
        }
        if (regular->count < 2) {
            throw FileError(
                fmt::format("{}: all of its points have the same {}: a bed in three dimensions "
                            "needs points on a grid",
                            name, axis == 0 ? "x" : "y"));
        }
        places[axis] = *regular;
    }
    const double cells = static_cast<double>(places[0].count) * static_cast<double>(places[1].count);
    // Scattered points look like a grid of which nearly all is missing.
    if (cells > 10.0 * static_cast<double>(points.size()) + 100.0) {
        throw FileError(fmt::format(
            "{}: its {} points would fill a small part of a regular grid of {} x {}: a bed needs points on a "
            "regular grid; interpolate them onto one first",
            name, points.size(), places[0].count, places[1].count));
    }
    HeightGrid grid{.columns = places[0].count,
                    .rows = places[1].count,
                    .x = places[0].first,
                    .y = places[1].first,
                    .step_x = places[0].step,
                    .step_y = places[1].step,
                    .z = {}};
    grid.z.assign(grid.columns * grid.rows, missing_height);
    std::vector<std::size_t> line_of(grid.z.size(), 0);
    for (const HeightPoint& point : points) {
        const auto index = [&](std::size_t axis) {
            return static_cast<std::size_t>(
                std::lround((point.place[axis] - places[axis].first) / places[axis].step));
        };
        const std::size_t i = index(1) * grid.columns + index(0);
        if (line_of[i] != 0) {
            throw FileError(
                fmt::format("{}:{}: a second point at the place of line {}: leave one of them out", name,
                            point.line, line_of[i]));
        }
        line_of[i] = point.line;
        grid.z[i] = point.z;
    }
    return grid;
}

/// The grid of a file of a kind that always holds one; nothing of lines of points.
std::optional<HeightGrid> whole_grid(std::string_view content, const std::string& name) {
    const std::string lower = lower_case(name);
    if (lower.ends_with(".asc")) return AscReader(content, name).read();
    if (lower.ends_with(".tif") || lower.ends_with(".tiff")) return parse_height_raster(content, name);
    return std::nullopt;
}

}  // namespace

HeightGrid parse_height_grid(std::string_view content, const std::string& name) {
    std::optional<HeightGrid> whole = whole_grid(content, name);
    HeightGrid grid =
        whole ? *std::move(whole) : grid_of_points(read_points(content, name, {"x", "y", "z"}), name);
    if (std::all_of(grid.z.begin(), grid.z.end(), [](double z) { return std::isnan(z); })) {
        throw FileError(fmt::format("{}: holds no height: all are marked as missing", name));
    }
    return grid;
}

HeightLine parse_height_line(std::string_view content, const std::string& name) {
    HeightLine line;
    if (const std::optional<HeightGrid> grid = whole_grid(content, name)) {
        if (grid->rows != 1) {
            throw FileError(
                fmt::format("{}: a grid of {} rows: in two dimensions give lines of x and z, or a "
                            "grid of one row",
                            name, grid->rows));
        }
        for (std::size_t i = 0; i < grid->columns; ++i) {
            line.x.push_back(grid->x + grid->step_x * static_cast<double>(i));
            line.z.push_back(grid->z[i]);
        }
        line.unit = grid->unit;
    } else {
        std::vector<HeightPoint> points = read_points(content, name, {"x", "z"});
        std::stable_sort(points.begin(), points.end(),
                         [](const HeightPoint& a, const HeightPoint& b) { return a.place[0] < b.place[0]; });
        for (std::size_t i = 0; i < points.size(); ++i) {
            if (i > 0 && points[i].place[0] == points[i - 1].place[0]) {
                throw FileError(
                    fmt::format("{}:{}: a second point at the x of line {}: leave one of them out", name,
                                points[i].line, points[i - 1].line));
            }
            line.x.push_back(points[i].place[0]);
            line.z.push_back(points[i].z);
        }
    }
    if (std::all_of(line.z.begin(), line.z.end(), [](double z) { return std::isnan(z); })) {
        throw FileError(fmt::format("{}: holds no height: all are marked as missing", name));
    }
    return line;
}

}  // namespace riffle::inline case_file
