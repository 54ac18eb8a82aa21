#include "laboratory/timed_table.hpp"

#include <fmt/format.h>

#include <cmath>
#include <numeric>

#include "base/error.hpp"
#include "laboratory/unit.hpp"

namespace riffle::inline laboratory {

namespace {

std::optional<double> stated_frequency(const CsvTable& table) {
    const auto text = table.comment_value("sampling_frequency");
    if (!text) return std::nullopt;
    const auto frequency = parse_quantity(*text, "Hz");
    if (!frequency || !(*frequency > 0.0)) {
        throw FileError(fmt::format(R"({}: expected "# sampling_frequency: 100 Hz", got "{}")",
                                    table.path.string(), *text));
    }
    return frequency;
}

}  // namespace

TableSampling sampling_of(const CsvTable& table, std::optional<double> frequency, double tolerance,
                          std::vector<std::string>& warnings) {
    if (frequency && !(*frequency > 0.0)) {
        throw InputError("the sampling frequency must be greater than 0 Hz");
    }
    if (!frequency) frequency = stated_frequency(table);
    TableSampling result;
    for (std::size_t i = 0; i < table.columns.size(); ++i) {
        const std::string& name = table.columns[i].name;
        if (name == "t" || name == "time" || name == "Time" || name == "T") result.time_column = i;
    }
    if (result.time_column) {
        const std::vector<double> times = column_in_si(table, *result.time_column, "s");
        for (std::size_t row = 0; row < times.size(); ++row) {
            if (std::isfinite(times[row])) continue;
            throw FileError(fmt::format("{}: expected a time in {}", table.place(row),
                                        table.column_name(*result.time_column)));
        }
        result.sampling =
            find_even_sampling(times, tolerance, [&table](std::size_t row) { return table.place(row); });
        constexpr double allowed = 1e-3;
        if (frequency && std::abs(result.sampling.frequency / *frequency - 1.0) > allowed) {
            warnings.push_back(fmt::format(
                "the times are {:.6g} Hz apart, not the {:.6g} Hz that are stated; the times count",
                result.sampling.frequency, *frequency));
        }
        return result;
    }
    if (!frequency) {
        throw FileError(
            fmt::format(R"({}: expected a column "t [s]", or a comment "# sampling_frequency: 100 Hz")",
                        table.path.string()));
    }
    result.sampling.frequency = *frequency;
    result.sampling.samples = table.lines.size();
    result.sampling.slots.resize(table.lines.size());
    std::iota(result.sampling.slots.begin(), result.sampling.slots.end(), std::size_t{0});
    return result;
}

}  // namespace riffle::inline laboratory
