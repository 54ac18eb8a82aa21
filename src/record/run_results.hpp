#pragma once

#include <cstddef>
#include <filesystem>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "case/case.hpp"
#include "output/results_file.hpp"
#include "record/field.hpp"
#include "record/numbers.hpp"
#include "record/series_table.hpp"

namespace riffle::inline record {

/// Where a field stands: in its own group, or in that of an instrument or a snapshot.
struct FieldPlace {
    std::string group;
    std::string name;

    FieldPlace(const Field& field) : group(field.group->path), name(field.name) {}
    FieldPlace(std::string in_group, const Field& field) : group(std::move(in_group)), name(field.name) {}
    FieldPlace(std::string in_group, std::string field)
        : group(std::move(in_group)), name(std::move(field)) {}
    [[nodiscard]] std::string path() const { return group + "/" + name; }
};

/// The results of a run as its file has them, asked for by field: what analysis, report, watch and sweep
/// read. It holds what the file held when it was opened, also while the run goes on to write.
///
/// Throws FileError where the file is missing, damaged or not as this Riffle writes it.
class RunResults {
  public:
    explicit RunResults(const std::filesystem::path& results);

    [[nodiscard]] const std::filesystem::path& path() const { return reader_.path(); }
    /// The case of the run, read when it is first asked for. Throws FileError where the file holds none, or
    /// one that this version cannot read.
    [[nodiscard]] const Case& flow() const;

    [[nodiscard]] bool has(const Group& group) const { return reader_.has(group.path); }
    [[nodiscard]] bool has(const FieldPlace& field) const { return reader_.has(field.path()); }
    [[nodiscard]] std::vector<std::size_t> shape(const FieldPlace& field) const;
    /// All values of a dataset; none where it is not there.
    [[nodiscard]] std::vector<double> values(const FieldPlace& field) const;
    /// Some of its rows along the first axis.
    [[nodiscard]] std::vector<double> rows(const FieldPlace& field, std::size_t first,
                                           std::size_t count) const;
    /// A dataset that is a text. Throws FileError where it is not there.
    [[nodiscard]] std::string stored_text(const FieldPlace& field) const;
    /// An attribute of a group.
    [[nodiscard]] std::optional<double> number(const FieldPlace& field) const;
    [[nodiscard]] std::string text(const FieldPlace& field) const;  ///< empty where it is not there
    /// Unit and long name of a dataset.
    [[nodiscard]] std::string unit(const FieldPlace& field) const;
    [[nodiscard]] std::string long_name(const FieldPlace& field) const;

    /// All attributes of a group that are numbers.
    [[nodiscard]] Numbers numbers(const Group& group) const;
    /// The time series; of a run that was stopped between two appends the common rows.
    [[nodiscard]] SeriesTable series() const;
    /// The averaging window of the run, s: that of its profiles, else of its summary; nothing before there is
    /// one.
    [[nodiscard]] std::optional<std::pair<double, double>> averaging_window() const;
    /// Names of what a group holds, such as "/probes" or "/snapshots", sorted; none where it is not there.
    [[nodiscard]] std::vector<std::string> children(const std::string& group) const;

  private:
    ResultsReader reader_;
    mutable std::optional<Case> flow_;
};

}  // namespace riffle::inline record
