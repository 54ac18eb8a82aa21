#include "ends/time_table.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>

#include "base/error.hpp"
#include "base/interpolation.hpp"
#include "laboratory/csv_table.hpp"

namespace riffle::inline ends {

namespace {

std::string names_of(const std::vector<TableColumn>& columns) {
    std::string names;
    for (const TableColumn& column : columns) names += (names.empty() ? "" : " or ") + column.name;
    return names;
}

/// The one column of a table that has one of these names.
struct FoundColumn {
    TableColumn as;
    std::vector<double> values;  ///< SI
};
FoundColumn find_column(const CsvTable& table, const std::vector<TableColumn>& wanted) {
    std::optional<FoundColumn> found;
    for (std::size_t i = 0; i < table.columns.size(); ++i) {
        const auto named = std::find_if(wanted.begin(), wanted.end(), [&](const TableColumn& column) {
            return lower_case(table.columns[i].name) == column.name;
        });
        if (named == wanted.end()) continue;
        if (found) {
            throw FileError(fmt::format("{}: there are the columns {} and {}; leave one of them out",
                                        table.path.string(), found->as.name, named->name));
        }
        found = {*named, column_in_si(table, i, named->unit)};
    }
    if (found) return *std::move(found);
    throw FileError(fmt::format("{}: there is no column {}; give the columns names in the first line",
                                table.path.string(), names_of(wanted)));
}

}  // namespace

TimeTable::TimeTable(std::vector<double> time, std::vector<double> value)
    : time_(std::move(time)), value_(std::move(value)) {}

double TimeTable::at(double time) const { return place_in(time_, time).in(value_); }
double TimeTable::largest() const { return *std::max_element(value_.begin(), value_.end()); }
double TimeTable::smallest() const { return *std::min_element(value_.begin(), value_.end()); }

double TimeTable::fastest_passage() const {
    double fastest = 0.0;
    for (std::size_t i = 1; i < time_.size(); ++i) {
        fastest = std::max(fastest, std::abs(value_[i] - value_[i - 1]) / (time_[i] - time_[i - 1]));
    }
    return fastest > 0.0 ? (largest() - smallest()) / fastest : 0.0;
}

TwoColumns read_two_columns(const std::filesystem::path& path, const TableColumn& first,
                            const std::vector<TableColumn>& others, double least) {
    const CsvTable table = read_csv_table(path);
    TwoColumns columns{find_column(table, {first}).values, {}};
    const FoundColumn second = find_column(table, others);
    for (std::size_t row = 0; row < columns.first.size(); ++row) {
        if (row > 0 && !(columns.first[row] > columns.first[row - 1])) {
            throw FileError(
                fmt::format("{}: {} is {:g}, not above that of the row before, {:g}; sort the rows by it",
                            table.place(row), first.name, columns.first[row], columns.first[row - 1]));
        }
        if (!(second.values[row] >= least)) {
            throw FileError(fmt::format("{}: {} is {:g}; expected {:g} or more", table.place(row),
                                        second.as.name, second.values[row], least));
        }
        columns.second.push_back(second.as.factor * second.values[row] + second.as.offset);
    }
    return columns;
}

TimeTable read_time_table(const std::filesystem::path& path, const std::vector<TableColumn>& columns,
                          double least) {
    TwoColumns table = read_two_columns(path, {"time", "s"}, columns, least);
    if (table.first.front() > 0.0) {
        throw FileError(fmt::format("{}: the table begins at {:g} s, but the run at 0; add a row for t = 0",
                                    path.string(), table.first.front()));
    }
    // What was before the run sets none of its numerics.
    const auto before =
        std::upper_bound(table.first.begin(), table.first.end(), 0.0) - table.first.begin() - 1;
    table.first.erase(table.first.begin(), table.first.begin() + before);
    table.second.erase(table.second.begin(), table.second.begin() + before);
    if (table.first.front() < 0.0 && table.first.size() > 1) {
        table.second.front() = place_in(table.first, 0.0).in(table.second);
        table.first.front() = 0.0;
    }
    return {std::move(table.first), std::move(table.second)};
}

}  // namespace riffle::inline ends
