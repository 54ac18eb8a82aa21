#include "statistics/record.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>

#include "base/error.hpp"

namespace riffle::inline statistics {

namespace {

void require_finite_or_gap(std::span<const double> record, std::string_view what) {
    const auto infinite = std::find_if(record.begin(), record.end(), [](double v) { return std::isinf(v); });
    if (infinite == record.end()) return;
    throw InputError(std::string(what) + ": sample " + std::to_string(infinite - record.begin() + 1) +
                     " of " + std::to_string(record.size()) +
                     " is infinite; a missing sample must be not-a-number");
}

}  // namespace

double mean_of(std::span<const double> record) {
    // Shifted by the first sample: a constant record gives its value to the bit.
    const auto first = std::find_if(record.begin(), record.end(), [](double v) { return !std::isnan(v); });
    if (first == record.end()) return std::numeric_limits<double>::quiet_NaN();
    const double shift = *first;
    double sum = 0.0;
    std::size_t count = 0;
    for (auto v = first; v != record.end(); ++v) {
        if (std::isnan(*v)) continue;
        sum += *v - shift;
        ++count;
    }
    return shift + sum / static_cast<double>(count);
}

double median_of(std::span<const double> numbers) {
    if (numbers.empty()) return std::numeric_limits<double>::quiet_NaN();
    std::vector<double> values(numbers.begin(), numbers.end());
    const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
    std::nth_element(values.begin(), middle, values.end());
    if (values.size() % 2 == 1) return *middle;
    return 0.5 * (*middle + *std::max_element(values.begin(), middle));
}

Fluctuations fluctuations_of(std::span<const double> record, std::string_view what) {
    require_finite_or_gap(record, what);
    Fluctuations result;
    result.mean = mean_of(record);
    result.values.resize(record.size());
    result.present.resize(record.size());
    for (std::size_t i = 0; i < record.size(); ++i) {
        if (std::isnan(record[i])) continue;
        result.values[i] = record[i] - result.mean;
        result.present[i] = true;
        ++result.count;
    }
    if (result.count < 2) {
        throw InputError(std::string(what) + ": " + std::to_string(result.count) +
                         " samples are there; at least two are needed");
    }
    return result;
}

PairOfFluctuations fluctuations_of(std::span<const double> first, std::span<const double> second,
                                   std::string_view what) {
    require_same_length(first, second, what);
    std::vector<double> a(first.begin(), first.end());
    std::vector<double> b(second.begin(), second.end());
    for (std::size_t i = 0; i < a.size(); ++i) {
        if (std::isnan(a[i]) || std::isnan(b[i])) a[i] = b[i] = std::numeric_limits<double>::quiet_NaN();
    }
    return {fluctuations_of(a, what), fluctuations_of(b, what)};
}

void require_no_gaps(std::span<const double> record, std::string_view what) {
    const auto is_gap = [](double v) { return !std::isfinite(v); };
    const auto gaps = std::count_if(record.begin(), record.end(), is_gap);
    if (gaps == 0) return;
    const auto first = std::find_if(record.begin(), record.end(), is_gap);
    throw InputError(std::string(what) + ": " + std::to_string(gaps) + " of " +
                     std::to_string(record.size()) +
                     " samples are missing or infinite, the first is sample " +
                     std::to_string(first - record.begin() + 1) +
                     "; this needs a record without gaps: fill them or choose a part without");
}

void require_same_length(std::span<const double> first, std::span<const double> second,
                         std::string_view what) {
    if (first.size() == second.size()) return;
    throw InputError(std::string(what) + ": the records have " + std::to_string(first.size()) + " and " +
                     std::to_string(second.size()) +
                     " samples; they must be as long and taken at the same times");
}

}  // namespace riffle::inline statistics
