#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace riffle::inline ends {

/// A quantity that changes in time: straight lines between its rows, the first value before and the last
/// behind them.
class TimeTable {
  public:
    explicit TimeTable(double constant) : time_{0.0}, value_{constant} {}
    /// Rising times, s, as many as values.
    TimeTable(std::vector<double> time, std::vector<double> value);

    [[nodiscard]] double at(double time) const;
    [[nodiscard]] double largest() const;
    [[nodiscard]] double smallest() const;
    /// Time in which it would go through its range as fast as it ever changes, s; 0 of a constant.
    [[nodiscard]] double fastest_passage() const;
    /// The times of its rows, s.
    [[nodiscard]] const std::vector<double>& times() const { return time_; }

  private:
    std::vector<double> time_;
    std::vector<double> value_;
};

/// A column that a file may have, with the SI unit of its values and what makes the quantity of them.
struct TableColumn {
    std::string name;
    std::string unit;
    double factor = 1.0;
    double offset = 0.0;
};

/// Two columns of a CSV file: one named `first`, rising, and one of `others`, in SI times its factor and with
/// its offset. Throws FileError with file and line where a column is missing, a value in SI is not a number
/// or below `least`, or the first column does not rise.
struct TwoColumns {
    std::vector<double> first;
    std::vector<double> second;
};
[[nodiscard]] TwoColumns read_two_columns(const std::filesystem::path& path, const TableColumn& first,
                                          const std::vector<TableColumn>& others, double least);

/// A table in time from a file, from t = 0 on: rows before it are left out, those after the end of a run are
/// kept, for it may be prolonged. Throws FileError as read_two_columns, and where it begins after t = 0: what
/// is before its first row is not known.
[[nodiscard]] TimeTable read_time_table(const std::filesystem::path& path,
                                        const std::vector<TableColumn>& columns, double least);

}  // namespace riffle::inline ends
