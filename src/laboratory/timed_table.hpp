#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "laboratory/csv_table.hpp"
#include "laboratory/sampling.hpp"

namespace riffle::inline laboratory {

/// The sampling of a table of a time series: from its column `t` or `time`, else from `frequency`, else from
/// the comment "# sampling_frequency: 100 Hz". Where a time column and a frequency are both there and differ
/// by more than 0.1 %, a line is added to `warnings`; the times count. Throws FileError if there is neither,
/// or as find_even_sampling.
struct TableSampling {
    EvenSampling sampling;
    std::optional<std::size_t> time_column;
};
[[nodiscard]] TableSampling sampling_of(const CsvTable& table, std::optional<double> frequency,
                                        double tolerance, std::vector<std::string>& warnings);

}  // namespace riffle::inline laboratory
