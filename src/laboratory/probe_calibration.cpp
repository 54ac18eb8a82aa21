#include "laboratory/probe_calibration.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <cmath>

#include "base/error.hpp"
#include "laboratory/csv_table.hpp"
#include "laboratory/unit.hpp"

namespace riffle::inline laboratory {

namespace {

constexpr std::string_view form =
    "\"NAME: x = 28 mm, y = 0 mm, offset = -12.3 mm, gain = 20.4 mm/V\", all but the name optional";

}  // namespace

double ProbeCalibration::elevation_half_width(double voltage) const {
    if (!fit) return 0.0;
    return propagated_half_width(*fit, Eigen::Vector2d(1.0, voltage));
}

ProbeCalibration fit_probe_calibration(std::span<const double> voltages, std::span<const double> levels) {
    constexpr std::size_t fewest = 3;
    if (voltages.size() != levels.size() || voltages.size() < fewest) {
        throw InputError(
            fmt::format("probe calibration: expected at least {} pairs of voltage and level, got {}", fewest,
                        std::min(voltages.size(), levels.size())));
    }
    const auto n = static_cast<Eigen::Index>(voltages.size());
    Eigen::MatrixXd basis(n, 2);
    basis.col(0).setOnes();
    basis.col(1) = Eigen::Map<const Eigen::VectorXd>(voltages.data(), n);
    const auto line = fit_linear(basis, Eigen::Map<const Eigen::VectorXd>(levels.data(), n));
    if (!line) throw InputError("probe calibration: expected different voltages, got one only");
    ProbeCalibration result;
    result.points = voltages.size();
    result.offset = line->coefficients(0);
    result.gain = line->coefficients(1);
    result.offset_half_width = coefficient(*line, 0).half_width;
    result.gain_half_width = coefficient(*line, 1).half_width;
    result.residual_rms = std::sqrt(line->sum_of_squares / static_cast<double>(n));
    const auto extremes = std::minmax_element(voltages.begin(), voltages.end());
    result.lowest_voltage = *extremes.first;
    result.highest_voltage = *extremes.second;
    result.fit = *line;
    return result;
}

std::vector<NamedCalibration> read_probe_calibrations(const std::filesystem::path& path) {
    const CsvTable table = read_csv_table(path, MissingValues::allowed);
    std::optional<std::size_t> level_column;
    for (std::size_t i = 0; i < table.columns.size(); ++i) {
        const std::string name = lower_case(table.columns[i].name);
        if (name == "level" || name == "elevation") level_column = i;
    }
    if (!level_column || table.columns.size() < 2) {
        throw FileError(fmt::format(
            "{}: expected a column \"level [mm]\" and one of voltages for each probe, like \"P1 [V]\"",
            path.string()));
    }
    const std::vector<double> levels = column_in_si(table, *level_column, "m");
    std::vector<NamedCalibration> result;
    for (std::size_t i = 0; i < table.columns.size(); ++i) {
        if (i == *level_column) continue;
        const std::vector<double> voltages = column_in_si(table, i, "V");
        std::vector<double> used_voltages;
        std::vector<double> used_levels;
        for (std::size_t row = 0; row < levels.size(); ++row) {
            if (std::isnan(voltages[row]) || std::isnan(levels[row])) continue;
            used_voltages.push_back(voltages[row]);
            used_levels.push_back(levels[row]);
        }
        try {
            result.push_back({table.columns[i].name, fit_probe_calibration(used_voltages, used_levels)});
        } catch (const InputError& error) {
            throw FileError(fmt::format("{}: {}: {}", path.string(), table.column_name(i), error.what()));
        }
    }
    return result;
}

ProbeDescription parse_probe_description(std::string_view text) {
    const auto fail = [text](std::string_view problem) {
        throw InputError(fmt::format("probe \"{}\": {}; expected {}", trimmed(text), problem, form));
    };
    const std::size_t colon = text.find(':');
    ProbeDescription probe;
    probe.name = std::string(trimmed(text.substr(0, colon)));
    if (probe.name.empty()) fail("no name");
    if (colon == std::string_view::npos) return probe;
    std::string_view rest = trimmed(text.substr(colon + 1));
    while (!rest.empty()) {
        const std::size_t comma = rest.find_first_of(",;");
        const std::string_view item = trimmed(rest.substr(0, comma));
        rest = comma == std::string_view::npos ? std::string_view{} : trimmed(rest.substr(comma + 1));
        const std::size_t equals = item.find('=');
        const std::string_view key = trimmed(item.substr(0, equals));
        if (equals == std::string_view::npos) {
            fail(fmt::format("\"{}\" is not of the form key = value", item));
        }
        struct Entry {
            std::string_view key, unit;
            std::optional<double>* target;
        };
        bool known = false;
        for (const Entry& entry : {Entry{"x", "m", &probe.x}, Entry{"y", "m", &probe.y},
                                   Entry{"offset", "m", &probe.offset}, Entry{"gain", "m/V", &probe.gain}}) {
            if (entry.key != key) continue;
            known = true;
            if (*entry.target) fail(fmt::format("{} is given twice", key));
            *entry.target = parse_quantity(item.substr(equals + 1), entry.unit);
            if (!*entry.target) {
                fail(fmt::format("\"{}\" is no number with a unit like {}", trimmed(item.substr(equals + 1)),
                                 entry.unit));
            }
        }
        if (!known) fail(fmt::format("\"{}\" is not known", key));
    }
    if (probe.gain && *probe.gain == 0.0) fail("a gain of 0 gives no elevation");
    return probe;
}

}  // namespace riffle::inline laboratory
