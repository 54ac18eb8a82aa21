#include "laboratory/section_record.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <utility>

#include "base/error.hpp"
#include "laboratory/unit.hpp"

namespace riffle::inline laboratory {

namespace {

LateralOrigin origin_of(const CsvTable& table) {
    const std::string text = table.comment_value("y_from").value_or("wall");
    if (text == "wall" || text == "side wall") return LateralOrigin::wall;
    if (text == "centreline" || text == "centerline" || text == "centre") return LateralOrigin::centreline;
    throw FileError(
        fmt::format("{}: expected the comment y_from to be \"wall\" or \"centreline\", got \"{}\"",
                    table.path.string(), text));
}

/// The one height of all points, from the comment "# z: ...".
double height_of(const CsvTable& table) {
    const auto text = table.comment_value("z");
    if (!text) {
        throw FileError(
            fmt::format("{}: expected the height of the points: a column z, or a comment \"# z: 12 mm\", "
                        "of means over the depth \"# z: depth mean\"",
                        table.path.string()));
    }
    if (*text == "depth mean" || *text == "depth-mean") return std::numeric_limits<double>::quiet_NaN();
    const auto height = parse_quantity(*text, "m");
    if (!height) {
        throw FileError(
            fmt::format("{}: expected the comment z to be a length over the datum, like \"12 mm\", "
                        "or \"depth mean\", got \"{}\"",
                        table.path.string(), *text));
    }
    return *height;
}

void sort_points(SectionRecord& record) {
    const auto before = [&record](std::size_t a, std::size_t b) {
        if (record.z[a] != record.z[b] && !std::isnan(record.z[a]) && !std::isnan(record.z[b])) {
            return record.z[a] < record.z[b];
        }
        return record.y[a] < record.y[b];
    };
    std::vector<std::size_t> order(record.y.size());
    std::iota(order.begin(), order.end(), std::size_t{0});
    std::stable_sort(order.begin(), order.end(), before);
    reorder(record.y, order);
    reorder(record.z, order);
    reorder(record.lines, order);
    for (ProfileColumn& column : record.columns) {
        reorder(column.values, order);
        reorder(column.uncertainty, order);
    }
    for (std::size_t i = 1; i < record.y.size(); ++i) {
        if (before(static_cast<std::size_t>(i - 1), i)) continue;
        throw FileError(
            fmt::format("{}: expected one point for each place; y = {:.6g} m at this height is also in "
                        "line {}",
                        record.place(i), record.y[i], record.lines[i - 1]));
    }
}

}  // namespace

const ProfileColumn* SectionRecord::find(ProfileQuantity quantity) const {
    for (const ProfileColumn& column : columns) {
        if (column.quantity == quantity) return &column;
    }
    return nullptr;
}

std::string SectionRecord::place(std::size_t point) const {
    return fmt::format("{}:{}", source.string(), lines.at(point));
}

SectionRecord read_section_record(const std::filesystem::path& path) {
    const CsvTable table = read_csv_table(path, MissingValues::allowed);
    QuantityColumns taken = quantity_columns(table, "yz");
    if (taken.y.empty() || taken.columns.empty()) {
        throw FileError(
            fmt::format("{}:{}: expected a column y and one of u, v, w, u_rms, v_rms, w_rms or -u'w'",
                        path.string(), table.header_line));
    }
    SectionRecord record;
    record.source = path;
    record.title = table.comment_value("title").value_or("");
    record.origin = origin_of(table);
    record.lines = table.lines;
    record.y = std::move(taken.y);
    record.z = taken.z.empty() ? std::vector<double>(record.y.size(), height_of(table)) : std::move(taken.z);
    record.columns = std::move(taken.columns);
    record.warnings = std::move(taken.warnings);
    for (std::size_t row = 0; row < record.y.size(); ++row) {
        if (std::isnan(record.y[row])) {
            throw FileError(fmt::format("{}: expected a distance y", record.place(row)));
        }
        if (has_position(table, 'z') && std::isnan(record.z[row])) {
            throw FileError(fmt::format("{}: expected a height z", record.place(row)));
        }
    }
    sort_points(record);
    for (std::string& warning : missing_values(record.columns, record.y.size())) {
        record.warnings.push_back(std::move(warning));
    }
    return record;
}

}  // namespace riffle::inline laboratory
