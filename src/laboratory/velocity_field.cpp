#include "laboratory/velocity_field.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <cmath>
#include <map>
#include <utility>

#include "base/error.hpp"
#include "base/not_a_number.hpp"
#include "laboratory/unit.hpp"

namespace riffle::inline laboratory {

namespace {

std::string plain(std::string_view name) {
    std::string result;
    for (const char c : name) {
        if (c == ' ' || c == '_') continue;
        result += static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
    }
    return result;
}

/// Number of the column with one of these names; none if there is none.
std::optional<std::size_t> column_named(const CsvTable& table,
                                        std::initializer_list<std::string_view> names) {
    for (std::size_t i = 0; i < table.columns.size(); ++i) {
        const std::string name = plain(table.columns[i].name);
        if (std::find(names.begin(), names.end(), name) != names.end()) return i;
    }
    return std::nullopt;
}

/// Where a table has what a field needs; heights are y where no z is there, as image velocimetry names them.
struct Places {
    std::optional<std::size_t> x, z, u, w, time, u_uncertainty, w_uncertainty, flags, mask, valid;
};
Places places_of(const CsvTable& table) {
    Places p;
    p.x = column_named(table, {"x"});
    p.u = column_named(table, {"u", "vx", "umean", "velocityu"});
    p.z = column_named(table, {"z", "height"});
    p.w = column_named(table, {"w", "vz", "wmean", "velocityw"});
    if (!p.z) p.z = column_named(table, {"y"});
    if (!p.w) p.w = column_named(table, {"v", "vy", "vmean", "velocityv"});
    p.time = column_named(table, {"t", "time"});
    p.u_uncertainty = column_named(table, {"uuncertainty", "vxuncertainty"});
    p.w_uncertainty = column_named(table, {"wuncertainty", "vuncertainty", "vyuncertainty"});
    p.flags = column_named(table, {"flags", "flag"});
    p.mask = column_named(table, {"mask"});
    p.valid = column_named(table, {"isvalid", "valid"});
    return p;
}

/// A column in SI; the unit of columns that give none from the comment "# units: mm, m/s".
class Units {
  public:
    Units(const CsvTable& table, std::vector<std::string>& warnings) : table_(table) {
        const bool given = std::any_of(table.columns.begin(), table.columns.end(),
                                       [](const CsvColumn& column) { return !column.unit.empty(); });
        const auto comment = table.comment_value("units");
        if (comment) {
            const std::size_t comma = comment->find(',');
            if (comma == std::string::npos || given) {
                fail(given
                         ? "the comment units is for columns without units, and these have some: remove it"
                         : R"(expected the comment units to be those of positions and velocities, like "mm, )"
                           R"(m/s")");
            }
            length_ = std::string(trimmed(std::string_view(*comment).substr(0, comma)));
            velocity_ = std::string(trimmed(std::string_view(*comment).substr(comma + 1)));
        } else if (!given) {
            warnings.push_back(
                R"(the columns have no units and are taken in m and m/s; a comment "# units: mm, m/s" says )"
                "otherwise");
        }
    }

    [[nodiscard]] std::vector<double> positions(std::size_t column) const {
        return in_si(column, "m", length_);
    }
    [[nodiscard]] std::vector<double> velocities(std::size_t column) const {
        return in_si(column, "m/s", velocity_);
    }

  private:
    [[noreturn]] void fail(const std::string& problem) const {
        throw FileError(fmt::format("{}: {}", table_.path.string(), problem));
    }
    [[nodiscard]] std::vector<double> in_si(std::size_t column, std::string_view si,
                                            const std::optional<std::string>& of_comment) const {
        if (!of_comment) return column_in_si(table_, column, si);
        const auto unit = parse_unit(*of_comment);
        if (!unit || !unit->same_dimension(*parse_unit(si))) {
            fail(fmt::format(R"(expected a unit like "{}" in the comment units, got "{}")", si, *of_comment));
        }
        std::vector<double> values = table_.columns[column].values;
        for (double& value : values) value = unit->to_si(value);
        return values;
    }

    const CsvTable& table_;
    std::optional<std::string> length_, velocity_;
};

double offset_of(const CsvTable& table, const char* key) {
    const auto text = table.comment_value(key);
    if (!text) return 0.0;
    const auto value = parse_quantity(*text, "m");
    if (!value) {
        throw FileError(fmt::format(R"({}: expected the comment {} to be a length like "4 mm", got "{}")",
                                    table.path.string(), key, *text));
    }
    return *value;
}

/// Whether the comment says that an axis points the other way.
bool turned(const CsvTable& table, const char* key, const char* word) {
    const auto text = table.comment_value(key);
    if (!text) return false;
    if (*text == word) return true;
    throw FileError(fmt::format(R"({}: expected the comment {} to be "{}", got "{}")", table.path.string(),
                                key, word, *text));
}

/// The different values of a coordinate, ascending; those that differ by rounding are one.
std::vector<double> axis_of(std::vector<double> values) {
    std::sort(values.begin(), values.end());
    const double tolerance = 1e-6 * (values.back() - values.front());
    std::vector<double> axis;
    for (const double value : values) {
        if (axis.empty() || value - axis.back() > tolerance) axis.push_back(value);
    }
    return axis;
}

std::size_t index_in(const std::vector<double>& axis, double value) {
    const auto above = std::lower_bound(axis.begin(), axis.end(), value);
    if (above == axis.end()) return axis.size() - 1;
    const auto i = static_cast<std::size_t>(above - axis.begin());
    return i > 0 && value - axis[i - 1] < axis[i] - value ? i - 1 : i;
}

/// The rows of a table as points.
struct Points {
    std::vector<double> x, z, u, w, u_uncertainty, w_uncertainty, time;
};

Points points_of(const CsvTable& table, std::vector<std::string>& warnings) {
    const Places places = places_of(table);
    if (!places.x || !places.z || !places.u || !places.w) {
        throw FileError(fmt::format("{}:{}: expected columns x, z, u, w, or x, y, u, v with the height y",
                                    table.path.string(), table.header_line));
    }
    const Units units(table, warnings);
    Points p{units.positions(*places.x),
             units.positions(*places.z),
             units.velocities(*places.u),
             units.velocities(*places.w),
             {},
             {},
             {}};
    if (places.u_uncertainty) p.u_uncertainty = units.velocities(*places.u_uncertainty);
    if (places.w_uncertainty) p.w_uncertainty = units.velocities(*places.w_uncertainty);
    if (places.time) p.time = column_in_si(table, *places.time, "s");
    const bool zero_is_missing = table.comment_value("zero vectors") == "missing";
    std::size_t refused = 0;
    const auto value = [&](const std::optional<std::size_t>& column, std::size_t row, double otherwise) {
        return column ? table.columns[*column].values[row] : otherwise;
    };
    for (std::size_t row = 0; row < p.x.size(); ++row) {
        if (std::isnan(p.x[row]) || std::isnan(p.z[row])) {
            throw FileError(fmt::format("{}: expected a place, x and z", table.place(row)));
        }
        const bool bad = value(places.flags, row, 0.0) == 1.0 || value(places.mask, row, 0.0) != 0.0 ||
                         value(places.valid, row, 1.0) == 0.0 ||
                         (zero_is_missing && p.u[row] == 0.0 && p.w[row] == 0.0);
        if (!bad) continue;
        p.u[row] = p.w[row] = not_a_number;
        ++refused;
    }
    if (refused > 0) {
        warnings.push_back(
            fmt::format("{} of {} vectors are marked as none and left out", refused, p.x.size()));
    }
    const double x_sign = turned(table, "flow", "-x") ? -1.0 : 1.0;
    const double z_sign = turned(table, "z_axis", "down") ? -1.0 : 1.0;
    const double x_offset = offset_of(table, "x_offset");
    const double z_offset = offset_of(table, "z_offset");
    for (std::size_t row = 0; row < p.x.size(); ++row) {
        p.x[row] = x_sign * p.x[row] + x_offset;
        p.z[row] = z_sign * p.z[row] + z_offset;
        p.u[row] *= x_sign;
        p.w[row] *= z_sign;
    }
    return p;
}

class FieldReader {
  public:
    explicit FieldReader(const std::filesystem::path& source) { field_.source = source; }

    void take(const std::filesystem::path& file) {
        const CsvTable table = read_field_table(file);
        std::vector<std::string> warnings;
        const Points points = points_of(table, warnings);
        if (field_.frames == 0) {
            field_.title = table.comment_value("title").value_or("");
            set_grid(table, points);
        }
        for (const std::string& warning : warnings) ++warnings_[warning];
        if (points.time.empty()) {
            add_frame(table, points, 0, points.x.size());
            take_time(table);
            return;
        }
        for (std::size_t first = 0; first < points.x.size();) {
            std::size_t last = first;
            while (last < points.x.size() && points.time[last] == points.time[first]) ++last;
            add_frame(table, points, first, last);
            field_.time.push_back(points.time[first]);
            first = last;
        }
    }

    [[nodiscard]] VelocityField finish(std::optional<double> sampling_frequency) {
        for (const auto& [warning, count] : warnings_) {
            field_.warnings.push_back(count == 1 ? warning : fmt::format("{} (in {} files)", warning, count));
        }
        if (field_.time.size() != field_.frames) {
            if (!field_.time.empty()) {
                throw FileError(fmt::format("{}: {} of {} frames tell their time: give it in all or in none",
                                            field_.source.string(), field_.time.size(), field_.frames));
            }
            for (std::size_t k = 0; sampling_frequency && k < field_.frames; ++k) {
                field_.time.push_back(static_cast<double>(k) / *sampling_frequency);
            }
        }
        for (std::size_t k = 1; k < field_.time.size(); ++k) {
            if (field_.time[k] > field_.time[k - 1]) continue;
            throw FileError(
                fmt::format("{}: expected frames at rising times, frame {} is at {:.6g} s behind {:.6g} s",
                            field_.source.string(), k + 1, field_.time[k], field_.time[k - 1]));
        }
        return std::move(field_);
    }

  private:
    void set_grid(const CsvTable& table, const Points& points) {
        field_.x = axis_of(points.x);
        field_.z = axis_of(points.z);
        std::size_t of_first = points.x.size();
        for (std::size_t row = 0; row < points.time.size(); ++row) {
            if (points.time[row] != points.time.front()) {
                of_first = row;
                break;
            }
        }
        // Of scattered points nearly every one has a row and a column of its own.
        if (field_.x.size() < 2 || field_.z.size() < 2 || 4 * of_first < field_.points()) {
            throw FileError(fmt::format(
                "{}: expected the points of a grid, rows of x at each of several z; {} points lie at {} "
                "different x and {} different heights",
                table.path.string(), of_first, field_.x.size(), field_.z.size()));
        }
    }

    void add_frame(const CsvTable& table, const Points& points, std::size_t first, std::size_t last) {
        const std::size_t begin = field_.frames * field_.points();
        field_.u.resize(begin + field_.points(), not_a_number);
        field_.w.resize(begin + field_.points(), not_a_number);
        std::vector<int> line(field_.points(), 0);
        const double x_tolerance = 0.25 * (field_.x[1] - field_.x[0]);
        const double z_tolerance = 0.25 * (field_.z[1] - field_.z[0]);
        const auto uncertainty = [&](std::vector<double>& of_field, const std::vector<double>& values,
                                     std::size_t at, std::size_t row) {
            if (values.empty()) return;
            of_field.resize(field_.points(), not_a_number);
            of_field[at] = values[row];
        };
        for (std::size_t row = first; row < last; ++row) {
            const std::size_t i = index_in(field_.x, points.x[row]);
            const std::size_t j = index_in(field_.z, points.z[row]);
            if (std::abs(points.x[row] - field_.x[i]) > x_tolerance ||
                std::abs(points.z[row] - field_.z[j]) > z_tolerance) {
                throw FileError(
                    fmt::format("{}: the point x = {:.6g} m, z = {:.6g} m is not on the grid of the first "
                                "frame: expected all frames on one grid",
                                table.place(row), points.x[row], points.z[row]));
            }
            const std::size_t at = j * field_.x.size() + i;
            if (line[at] != 0) {
                throw FileError(
                    fmt::format("{}: expected one vector at each point; x = {:.6g} m, z = {:.6g} m is also "
                                "in line {}",
                                table.place(row), points.x[row], points.z[row], line[at]));
            }
            line[at] = table.lines[row];
            field_.u[begin + at] = points.u[row];
            field_.w[begin + at] = points.w[row];
            if (field_.frames > 0) continue;
            uncertainty(field_.u_uncertainty, points.u_uncertainty, at, row);
            uncertainty(field_.w_uncertainty, points.w_uncertainty, at, row);
        }
        ++field_.frames;
    }

    void take_time(const CsvTable& table) {
        const auto text = table.comment_value("time");
        if (!text) return;
        const auto time = parse_quantity(*text, "s");
        if (!time) {
            throw FileError(
                fmt::format(R"({}: expected the comment time to be a time like "0.04 s", got "{}")",
                            table.path.string(), *text));
        }
        field_.time.push_back(*time);
    }

    VelocityField field_;
    std::map<std::string, std::size_t> warnings_;
};

/// Names in the order of the numbers in them, so that frame_10 follows frame_9.
bool in_natural_order(const std::filesystem::path& a, const std::filesystem::path& b) {
    const std::string left = a.filename().string();
    const std::string right = b.filename().string();
    const auto is_digit = [](char c) { return c >= '0' && c <= '9'; };
    std::size_t i = 0;
    std::size_t j = 0;
    while (i < left.size() && j < right.size()) {
        if (!is_digit(left[i]) || !is_digit(right[j])) {
            if (left[i] != right[j]) return left[i] < right[j];
            ++i;
            ++j;
            continue;
        }
        const auto number = [&](const std::string& name, std::size_t& at) {
            while (at < name.size() && name[at] == '0') ++at;
            const std::size_t begin = at;
            while (at < name.size() && is_digit(name[at])) ++at;
            return std::string_view(name).substr(begin, at - begin);
        };
        const std::string_view first = number(left, i);
        const std::string_view second = number(right, j);
        if (first.size() != second.size()) return first.size() < second.size();
        if (first != second) return first < second;
    }
    return left.size() - i < right.size() - j;
}

}  // namespace

bool is_velocity_field(const CsvTable& table) {
    const Places places = places_of(table);
    if (!places.x || !places.z || !places.u || !places.w) return false;
    // A profile may say where along the channel it was taken.
    const std::vector<double>& x = table.columns[*places.x].values;
    return std::any_of(x.begin(), x.end(), [&](double value) { return value != x.front(); });
}

VelocityField read_velocity_field(const std::filesystem::path& path,
                                  std::optional<double> sampling_frequency) {
    FieldReader reader(path);
    std::error_code error;
    if (!std::filesystem::is_directory(path, error)) {
        reader.take(path);
        return reader.finish(sampling_frequency);
    }
    std::vector<std::filesystem::path> frames;
    for (const auto& entry : std::filesystem::directory_iterator(path, error)) {
        const std::string ending = plain(entry.path().extension().string());
        if (entry.is_regular_file() && (ending == ".csv" || ending == ".txt" || ending == ".dat")) {
            frames.push_back(entry.path());
        }
    }
    if (frames.empty()) {
        throw FileError(
            fmt::format("{}: expected frames of velocities in this folder, .csv, .txt or .dat, found none",
                        path.string()));
    }
    std::sort(frames.begin(), frames.end(), in_natural_order);
    for (const std::filesystem::path& frame : frames) reader.take(frame);
    return reader.finish(sampling_frequency);
}

}  // namespace riffle::inline laboratory
