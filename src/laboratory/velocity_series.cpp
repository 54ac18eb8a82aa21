#include "laboratory/velocity_series.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <utility>

#include "base/error.hpp"
#include "base/not_a_number.hpp"
#include "laboratory/timed_table.hpp"
#include "laboratory/unit.hpp"

namespace riffle::inline laboratory {

namespace {

/// Half-width of a 95 % interval over the standard uncertainty.
constexpr double normal_quantile = 1.96;

std::optional<std::size_t> find_column(const CsvTable& table, std::string_view lower,
                                       std::string_view upper) {
    for (std::size_t i = 0; i < table.columns.size(); ++i) {
        if (table.columns[i].name == lower || table.columns[i].name == upper) return i;
    }
    return std::nullopt;
}

double position(const CsvTable& table, std::string_view key) {
    const auto text = table.comment_value(key);
    if (!text) return not_a_number;
    const auto value = parse_quantity(*text, "m");
    if (!value) {
        throw FileError(fmt::format(R"({}: expected a length in the comment "# {}: 12 mm", got "{}")",
                                    table.path.string(), key, *text));
    }
    return *value;
}

/// Rows whose correlation is too low.
std::vector<bool> poor_rows(const CsvTable& table, std::optional<std::size_t> column, double lowest) {
    std::vector<bool> poor(table.lines.size(), false);
    if (!column) return poor;
    const std::vector<double>& values = table.columns[*column].values;
    for (std::size_t row = 0; row < poor.size(); ++row) poor[row] = values[row] < lowest;
    return poor;
}

/// Mean and root mean square of a component, where it was measured.
void take_moments(const VelocityComponent& component, Estimate& mean, Estimate& rms) {
    mean = rms = {not_a_number, not_a_number};
    if (component.values.empty()) return;
    const Moments m = moments(component.values);
    mean = m.mean;
    rms = m.standard_deviation;
}

}  // namespace

VelocitySeries read_velocity_series(const std::filesystem::path& path, const VelocitySeriesOptions& options) {
    const CsvTable table = read_csv_table(path, MissingValues::allowed);
    VelocitySeries series;
    series.source = path;
    series.title = table.comment_value("title").value_or("");
    series.comments = table.comments;
    series.x = position(table, "x");
    series.y = position(table, "y");
    series.z = position(table, "z");
    const auto [sampling, time_column] =
        sampling_of(table, options.sampling_frequency, options.time_tolerance, series.warnings);
    series.start = sampling.start;
    series.sampling_frequency = sampling.frequency;

    const auto correlation = find_column(table, "correlation", "Correlation");
    const std::vector<bool> poor = poor_rows(table, correlation, options.lowest_correlation);
    std::vector<bool> used(table.columns.size(), false);
    if (time_column) used[*time_column] = true;
    if (correlation) used[*correlation] = true;
    struct Entry {
        std::string_view lower, upper;
        VelocityComponent* component;
    };
    for (const Entry& entry :
         {Entry{"u", "U", &series.u}, Entry{"v", "V", &series.v}, Entry{"w", "W", &series.w}}) {
        const auto column = find_column(table, entry.lower, entry.upper);
        if (!column) continue;
        used[*column] = true;
        std::vector<double> values = column_in_si(table, *column, "m/s");
        std::size_t refused = 0;
        for (std::size_t row = 0; row < values.size(); ++row) {
            if (!poor[row] || std::isnan(values[row])) continue;
            values[row] = not_a_number;
            ++refused;
        }
        entry.component->values = on_even_grid(sampling, values);
        entry.component->quality = repair_record(entry.component->values, options.repair, refused);
        if (std::string sentence = describe(entry.component->quality, entry.lower); !sentence.empty()) {
            series.warnings.push_back(std::move(sentence));
        }
    }
    if (series.u.values.empty()) {
        throw FileError(fmt::format("{}: expected a column \"u [m/s]\" of velocities", path.string()));
    }
    for (std::size_t i = 0; i < used.size(); ++i) {
        if (!used[i]) series.warnings.push_back(fmt::format("{} is not used", table.column_name(i)));
    }
    return series;
}

PointStatistics point_statistics(const VelocitySeries& series) {
    PointStatistics result;
    result.samples = series.u.values.size() - find_gaps(series.u.values).missing;
    take_moments(series.u, result.u, result.u_rms);
    take_moments(series.v, result.v, result.v_rms);
    take_moments(series.w, result.w, result.w_rms);
    result.reynolds_stress = {not_a_number, not_a_number};
    if (!series.w.values.empty()) {
        const Estimate product = covariance(series.u.values, series.w.values).covariance;
        result.reynolds_stress = {-product.value, product.half_width};
    }
    return result;
}

ProfileRecord profile_of_series(std::span<const VelocitySeries> series) {
    std::vector<const VelocitySeries*> sorted;
    for (const VelocitySeries& point : series) {
        if (std::isnan(point.z)) {
            throw InputError(fmt::format("{}: expected the height of the point, as a comment \"# z: 12 mm\"",
                                         point.source.string()));
        }
        sorted.push_back(&point);
    }
    std::sort(sorted.begin(), sorted.end(), [](const auto* a, const auto* b) { return a->z < b->z; });
    ProfileRecord record;
    using Q = ProfileQuantity;
    for (const Q quantity : {Q::velocity, Q::spanwise_velocity, Q::vertical_velocity, Q::streamwise_rms,
                             Q::spanwise_rms, Q::vertical_rms, Q::reynolds_stress}) {
        record.columns.push_back({quantity, {}, {}});
    }
    for (const VelocitySeries* point : sorted) {
        if (!record.z.empty() && !(point->z > record.z.back())) {
            throw InputError(fmt::format("{}: another file has the same height, z = {:.6g} m",
                                         point->source.string(), point->z));
        }
        record.z.push_back(point->z);
        record.lines.push_back(0);
        const PointStatistics s = point_statistics(*point);
        const Estimate* const statistics[] = {
            &s.u, &s.v, &s.w, &s.u_rms, &s.v_rms, &s.w_rms, &s.reynolds_stress};
        for (std::size_t i = 0; i < record.columns.size(); ++i) {
            record.columns[i].values.push_back(statistics[i]->value);
            record.columns[i].uncertainty.push_back(statistics[i]->half_width / normal_quantile);
        }
        for (const std::string& warning : point->warnings) {
            record.warnings.push_back(fmt::format("z = {:.4g} m: {}", point->z, warning));
        }
    }
    if (!sorted.empty()) record.source = sorted.front()->source.parent_path();
    // A component that no file has is no column.
    std::erase_if(record.columns, [](const ProfileColumn& column) {
        return find_gaps(column.values).missing == column.values.size();
    });
    return record;
}

}  // namespace riffle::inline laboratory
