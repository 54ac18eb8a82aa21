#include "analysis/run_mean_field.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "base/error.hpp"
#include "base/not_a_number.hpp"
#include "record/flow_fields.hpp"
#include "record/twin_fields.hpp"

namespace riffle::inline analysis {

namespace {

[[noreturn]] void fail(const Field& field, const std::string& other) {
    throw FileError(fmt::format(
        "{} of the results file does not fit {}; the file is damaged, or not as this Riffle writes it",
        field.path(), other));
}

/// Windows of the mean field that lie within the averaging window.
std::vector<std::size_t> windows_within(const std::vector<double>& time, double interval,
                                        const TimeWindow& window) {
    // A window ends at the first sample behind its end.
    const double tolerance = 0.05 * interval;
    std::vector<std::size_t> rows;
    for (std::size_t row = 0; row < time.size(); ++row) {
        if (time[row] - interval >= window.from - tolerance && time[row] <= window.to + tolerance) {
            rows.push_back(row);
        }
    }
    return rows;
}

/// Velocities of a block of windows from the difference of the sums before and behind it.
FieldBlock block_of(const FieldSums& sums) {
    FieldBlock block;
    const std::size_t cells = sums.cells();
    block.u.reserve(cells);
    block.v.reserve(cells);
    block.w.reserve(cells);
    for (std::size_t cell = 0; cell < cells; ++cell) {
        block.u.push_back(static_cast<float>(sums.mean(FieldQuantity::velocity, cell)));
        block.v.push_back(static_cast<float>(sums.mean(FieldQuantity::spanwise_velocity, cell)));
        block.w.push_back(static_cast<float>(sums.mean(FieldQuantity::vertical_velocity, cell)));
    }
    return block;
}

/// Sums of one window, cell by cell.
FieldSums read_window(const RunResults& results, std::size_t row, std::size_t cells, double samples) {
    std::array<std::vector<double>, field_quantities> values;
    for (std::size_t q = 0; q < field_quantities; ++q) {
        const Field& field = field_of(static_cast<FieldQuantity>(q));
        if (!results.has(field)) continue;
        values[q] = results.rows(field, row, 1);
        if (values[q].size() != cells) fail(field, "/mean_field/x, y and z");
    }
    FieldSums sums(cells);
    for (std::size_t cell = 0; cell < cells; ++cell) {
        FieldValues here{};
        for (std::size_t q = 0; q < field_quantities; ++q) {
            here[q] = values[q].empty() ? not_a_number : values[q][cell];
        }
        sums.add_window(cell, here, samples);
    }
    return sums;
}

}  // namespace

MeanFlow read_mean_field(const RunResults& results, const Case& c, const TimeWindow& window,
                         std::vector<std::string>& warnings) {
    MeanFlow field;
    const auto& axes = fields::mean_field_axes;
    const Field& count = fields::mean_field.count;
    if (!results.has(axes.time) || !results.has(count)) return field;
    const std::vector<double> time = results.values(axes.time);
    const std::vector<double> samples = results.values(axes.samples);
    field.x = results.values(axes.x);
    field.y = results.values(axes.y);
    field.z = results.values(axes.z);
    const std::size_t cells = field.x.size() * field.y.size() * field.z.size();
    const std::vector<std::size_t> shape = results.shape(count);
    if (shape.size() != 4 || shape[1] * shape[2] * shape[3] != cells) fail(count, "/mean_field/x, y and z");
    if (shape[0] < time.size() || samples.size() < time.size()) fail(count, "/mean_field/time");
    if (time.empty() || cells == 0) return field;
    field.interval = c.output.mean_field_interval;
    const std::vector<std::size_t> rows = windows_within(time, field.interval, window);
    if (rows.empty()) {
        warnings.push_back(fmt::format(
            "none of the {} windows of {:.3g} s of the mean field lies within the averaging window {:.4g} s "
            "to {:.4g} s: the cross-section is not analysed; give another --window, or run longer",
            time.size(), field.interval, window.from, window.to));
        return field;
    }
    field.box = FieldSums(cells);
    const std::size_t blocks = std::min(rows.size(), MeanFlow::most_blocks);
    const std::size_t section_cells = field.z.size() * field.y.size();
    FieldSums block(cells);
    FieldSums block_section(section_cells);
    for (std::size_t i = 0; i < rows.size(); ++i) {
        const FieldSums sums = read_window(results, rows[i], cells, samples[rows[i]]);
        FieldSums section(section_cells);
        for (std::size_t cell = 0; cell < cells; ++cell) section.add(cell / field.x.size(), sums, cell);
        field.box.add(sums);
        block.add(sums);
        block_section.add(section);
        field.time.push_back(time[rows[i]]);
        field.sections.push_back(std::move(section));
        const bool last_of_block = (i + 1) * blocks / rows.size() > i * blocks / rows.size();
        if (!last_of_block) continue;
        field.blocks.push_back(block_of(block));
        field.block_sections.push_back(std::move(block_section));
        block = FieldSums(cells);
        block_section = FieldSums(section_cells);
    }
    if (blocks < 5) {
        warnings.push_back(
            fmt::format("the averaging window holds {} window{} of {:.3g} s of the mean field: {}",
                        rows.size(), rows.size() == 1 ? "" : "s", field.interval,
                        blocks < 2 ? "values of the cross-section have no intervals; run longer, or set "
                                     "output.mean_field_interval shorter"
                                   : "intervals of the cross-section are rough; run longer, or set "
                                     "output.mean_field_interval shorter"));
    }
    return field;
}

SurfaceMaps read_surface_maps(const RunResults& results, const TimeWindow& window, std::size_t most_values,
                              std::vector<std::string>& warnings) {
    SurfaceMaps maps;
    const auto& of = fields::surface_map;
    if (!results.has(of.elevation) || !results.has(of.time)) return maps;
    const std::vector<double> time = results.values(of.time);
    maps.x = results.values(of.x);
    maps.y = results.values(of.y);
    const std::vector<std::size_t> shape = results.shape(of.elevation);
    const std::size_t points = maps.x.size() * maps.y.size();
    if (shape.size() != 3 || shape[1] * shape[2] != points) fail(of.elevation, "/surface_map/x and y");
    std::size_t first = 0;
    while (first < time.size() && time[first] < window.from - 1e-9) ++first;
    std::size_t end = first;
    while (end < std::min(time.size(), shape[0]) && time[end] <= window.to + 1e-9) ++end;
    const std::size_t most = std::max<std::size_t>(2, most_values / std::max<std::size_t>(1, points));
    if (end - first > most) {
        warnings.push_back(fmt::format(
            "of {} plan maps of the surface in the window the last {} were analysed", end - first, most));
        first = end - most;
    }
    if (points == 0 || first == end) return maps;
    maps.time.assign(time.begin() + static_cast<std::ptrdiff_t>(first),
                     time.begin() + static_cast<std::ptrdiff_t>(end));
    maps.elevation = results.rows(of.elevation, first, end - first);
    return maps;
}

SectionTwin read_section_twin(const RunResults& results) {
    SectionTwin twin;
    const auto& of = fields::section;
    if (!results.has(of.velocity) || !results.has(of.y) || !results.has(of.z)) return twin;
    twin.y = results.values(of.y);
    twin.z = results.values(of.z);
    const auto read = [&](const Field& field) {
        std::vector<double> values = results.values(field);
        if (!values.empty() && values.size() != twin.y.size() * twin.z.size()) {
            fail(field, "/section/y and z");
        }
        return values;
    };
    twin.velocity = read(of.velocity);
    twin.shear_stress = read(of.shear_stress);
    twin.numbers = results.numbers(fields::groups::section);
    return twin;
}

}  // namespace riffle::inline analysis
