#include "laboratory/probe_record.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <span>
#include <utility>

#include "base/error.hpp"
#include "laboratory/timed_table.hpp"
#include "laboratory/unit.hpp"

namespace riffle::inline laboratory {

namespace {

/// Descriptions in the comments "# probe P1: ...".
std::vector<ProbeDescription> described_probes(const CsvTable& table) {
    std::vector<ProbeDescription> result;
    constexpr std::string_view word = "probe ";
    for (const CsvComment& comment : table.comments) {
        const std::string_view text = comment.text;
        if (text.substr(0, word.size()) != word || text.find(':') == std::string_view::npos) continue;
        try {
            result.push_back(parse_probe_description(text.substr(word.size())));
        } catch (const InputError& error) {
            throw FileError(fmt::format("{}:{}: {}", table.path.string(), comment.line, error.what()));
        }
    }
    return result;
}

template <class Range, class Name>
auto find_named(const Range& range, const std::string& name, Name name_of) {
    return std::find_if(range.begin(), range.end(),
                        [&](const auto& entry) { return name_of(entry) == name; });
}

/// The description of a column: the options' entries before those of the file.
ProbeDescription description_of(const std::string& name, const std::vector<ProbeDescription>& given,
                                const std::vector<ProbeDescription>& written) {
    const auto name_of = [](const ProbeDescription& p) { return p.name; };
    ProbeDescription result;
    result.name = name;
    for (const auto* list : {&given, &written}) {
        const auto found = find_named(*list, name, name_of);
        if (found == list->end()) continue;
        if (!result.x) result.x = found->x;
        if (!result.y) result.y = found->y;
        if (!result.offset) result.offset = found->offset;
        if (!result.gain) result.gain = found->gain;
    }
    return result;
}

/// Every description and calibration must belong to a column: a misspelled name is not to go unnoticed.
void require_columns(const CsvTable& table, std::optional<std::size_t> time_column,
                     const std::vector<ProbeDescription>& written, const ProbeRecordOptions& options) {
    std::string names;
    for (std::size_t i = 0; i < table.columns.size(); ++i) {
        if (i != time_column) names += fmt::format("{}{}", names.empty() ? "" : ", ", table.columns[i].name);
    }
    const auto known = [&](const std::string& name) {
        for (std::size_t i = 0; i < table.columns.size(); ++i) {
            if (i != time_column && table.columns[i].name == name) return true;
        }
        return false;
    };
    for (const ProbeDescription& probe : written) {
        if (known(probe.name)) continue;
        throw FileError(fmt::format("{}: probe \"{}\" is described, but the columns are {}",
                                    table.path.string(), probe.name, names));
    }
    for (const ProbeDescription& probe : options.probes) {
        if (known(probe.name)) continue;
        throw InputError(fmt::format("{}: there is no probe \"{}\"; the columns are {}", table.path.string(),
                                     probe.name, names));
    }
}

/// Fitted calibrations without a column are of no harm (a file for more probes), but are told.
void warn_of_unused(const CsvTable& table, const std::vector<NamedCalibration>& calibrations,
                    std::vector<std::string>& warnings) {
    for (const NamedCalibration& c : calibrations) {
        const bool used = std::any_of(table.columns.begin(), table.columns.end(),
                                      [&c](const CsvColumn& column) { return column.name == c.probe; });
        if (!used) {
            warnings.push_back(
                fmt::format("the calibration of {} is not used: there is no such column", c.probe));
        }
    }
}

/// The calibration of a column of voltages.
ProbeCalibration calibration_of(const CsvTable& table, std::size_t column,
                                const ProbeDescription& description, const ProbeRecordOptions& options) {
    const auto fitted =
        find_named(options.calibrations, description.name, [](const NamedCalibration& c) { return c.probe; });
    if (fitted != options.calibrations.end()) return fitted->calibration;
    if (!description.gain) {
        throw FileError(fmt::format(
            "{}: {} holds voltages: expected a calibration of it, as a comment \"# probe {}: x = 0 mm, "
            "offset = -12.3 "
            "mm, gain = 20.4 mm/V\", as the same text on the command line, or in a calibration file",
            table.path.string(), table.column_name(column), description.name));
    }
    ProbeCalibration line;
    line.gain = *description.gain;
    line.offset = description.offset.value_or(0.0);
    return line;
}

/// Voltages outside of the calibrated range are an extrapolation, which the reader must know.
void warn_of_extrapolation(const ProbeCalibration& line, std::span<const double> voltages,
                           const std::string& name, std::vector<std::string>& warnings) {
    if (!line.fit) return;
    const auto outside = std::count_if(voltages.begin(), voltages.end(), [&line](double v) {
        return v < line.lowest_voltage || v > line.highest_voltage;
    });
    if (outside == 0) return;
    warnings.push_back(fmt::format("{}: {} samples lie outside of the calibrated {:.4g} to {:.4g} V", name,
                                   outside, line.lowest_voltage, line.highest_voltage));
}

bool holds_voltages(const CsvTable& table, std::size_t column) {
    const CsvColumn& c = table.columns[column];
    const auto unit = parse_unit(c.unit);
    const bool voltage = unit && unit->same_dimension(*parse_unit("V"));
    const bool length = unit && unit->same_dimension(*parse_unit("m"));
    if (c.unit.empty() || (!voltage && !length)) {
        throw FileError(
            fmt::format("{}:{}: expected a unit of voltage or length for {}, like [V] or [mm], got [{}]",
                        table.path.string(), table.header_line, table.column_name(column), c.unit));
    }
    return voltage;
}

}  // namespace

ProbeRecord read_probe_record(const std::filesystem::path& path, const ProbeRecordOptions& options) {
    const CsvTable table = read_csv_table(path, MissingValues::allowed);
    if (table.header_line == 0) {
        throw FileError(
            fmt::format("{}: expected a header line with the names and units of the columns, like \"t [s], "
                        "P1 [V], P2 [V]\"",
                        path.string()));
    }
    ProbeRecord record;
    record.source = path;
    record.title = table.comment_value("title").value_or("");
    record.comments = table.comments;
    const auto [sampling, time_column] =
        sampling_of(table, options.sampling_frequency, options.time_tolerance, record.warnings);
    record.start = sampling.start;
    record.sampling_frequency = sampling.frequency;
    const std::vector<ProbeDescription> written = described_probes(table);
    require_columns(table, time_column, written, options);
    warn_of_unused(table, options.calibrations, record.warnings);

    for (std::size_t i = 0; i < table.columns.size(); ++i) {
        if (i == time_column) continue;
        const ProbeDescription description = description_of(table.columns[i].name, options.probes, written);
        WaveProbe probe;
        probe.name = description.name;
        probe.x = description.x.value_or(std::numeric_limits<double>::quiet_NaN());
        probe.y = description.y.value_or(0.0);
        if (!description.x) {
            record.warnings.push_back(fmt::format("{}: its position x is not known", probe.name));
        }
        const bool voltages = holds_voltages(table, i);
        std::vector<double> values = column_in_si(table, i, voltages ? "V" : "m");
        if (voltages) {
            probe.calibration = calibration_of(table, i, description, options);
            warn_of_extrapolation(*probe.calibration, values, probe.name, record.warnings);
            for (double& v : values) v = probe.calibration->elevation(v);
        } else if (description.gain || description.offset) {
            throw FileError(
                fmt::format("{}:{}: {} holds elevations, which take no calibration (offset, gain)",
                            path.string(), table.header_line, table.column_name(i)));
        }
        probe.elevation = on_even_grid(sampling, values);
        probe.quality = repair_record(probe.elevation, options.repair);
        if (std::string sentence = describe(probe.quality, probe.name); !sentence.empty()) {
            record.warnings.push_back(std::move(sentence));
        }
        record.probes.push_back(std::move(probe));
    }
    if (record.probes.empty()) {
        throw FileError(fmt::format("{}: expected a column for each probe", path.string()));
    }
    return record;
}

}  // namespace riffle::inline laboratory
