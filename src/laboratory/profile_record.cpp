#include "laboratory/profile_record.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numeric>
#include <utility>

#include "base/error.hpp"

namespace riffle::inline laboratory {

namespace {

void sort_by_height(ProfileRecord& record) {
    std::vector<std::size_t> order(record.z.size());
    std::iota(order.begin(), order.end(), std::size_t{0});
    std::stable_sort(order.begin(), order.end(),
                     [&record](std::size_t a, std::size_t b) { return record.z[a] < record.z[b]; });
    reorder(record.z, order);
    reorder(record.lines, order);
    for (ProfileColumn& column : record.columns) {
        reorder(column.values, order);
        reorder(column.uncertainty, order);
    }
    for (std::size_t i = 1; i < record.z.size(); ++i) {
        if (record.z[i] > record.z[i - 1]) continue;
        throw FileError(fmt::format("{}: expected one point for each height; z = {:.6g} m is also in line {}",
                                    record.place(i), record.z[i], record.lines[i - 1]));
    }
}

}  // namespace

const ProfileColumn* ProfileRecord::find(ProfileQuantity quantity) const {
    for (const ProfileColumn& column : columns) {
        if (column.quantity == quantity) return &column;
    }
    return nullptr;
}

std::string ProfileRecord::place(std::size_t point) const {
    return fmt::format("{}:{}", source.string(), lines.at(point));
}

ProfileRecord read_profile_record(const std::filesystem::path& path) {
    const CsvTable table = read_csv_table(path, MissingValues::allowed);
    QuantityColumns taken = quantity_columns(table, "z");
    ProfileRecord record;
    record.source = path;
    record.title = table.comment_value("title").value_or("");
    record.comments = table.comments;
    record.lines = table.lines;
    record.z = std::move(taken.z);
    record.columns = std::move(taken.columns);
    record.warnings = std::move(taken.warnings);
    if (record.z.empty() || record.columns.empty()) {
        throw FileError(
            fmt::format("{}:{}: expected a column z and one of u, w, u_rms, w_rms, -u'w' or du/dz",
                        path.string(), table.header_line));
    }
    for (std::size_t row = 0; row < record.z.size(); ++row) {
        if (std::isnan(record.z[row])) {
            throw FileError(fmt::format("{}: expected a height z", record.place(row)));
        }
    }
    sort_by_height(record);
    for (std::string& warning : missing_values(record.columns, record.z.size())) {
        record.warnings.push_back(std::move(warning));
    }
    return record;
}

}  // namespace riffle::inline laboratory
