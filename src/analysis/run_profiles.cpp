#include "analysis/run_profiles.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <optional>
#include <utility>

#include "base/error.hpp"
#include "column/section.hpp"
#include "record/flow_fields.hpp"
#include "solver/profile_blocks.hpp"

namespace riffle::inline analysis {

Profiles read_profiles_group(const RunResults& results) {
    Profiles profiles;
    const std::vector<double> z = results.values(fields::profiles.z);
    const auto keep = [&](const std::vector<double>& values) {
        std::vector<double> kept;
        for (std::size_t i = 0; i < z.size(); ++i) {
            if (std::isfinite(z[i])) kept.push_back(values[i]);
        }
        return kept;
    };
    for (const fields::ProfileField& field : rows_of<fields::ProfileField>(fields::profiles)) {
        const std::vector<double> values = results.values(field);
        if (values.size() == z.size()) profiles.*field.values = keep(values);
    }
    profiles.window_start = results.number(fields::profile_window.start).value_or(0.0);
    profiles.window_end = results.number(fields::profile_window.end).value_or(0.0);
    profiles.samples = results.number(fields::profile_window.samples).value_or(0.0);
    return profiles;
}

Profiles average_profile_blocks(const RunResults& results, const Case& c, const ColumnResult* column,
                                const TimeWindow& window) {
    const auto& of = fields::profile_blocks;
    if (!results.has(of.sums)) return {};
    const std::vector<double> time = results.values(of.time);
    const std::vector<double> samples = results.values(of.samples);
    const std::vector<std::size_t> shape = results.shape(of.sums);
    const std::optional<SectionResult> section =
        has_section(c) ? std::optional(solve_section(c)) : std::nullopt;
    ProfileSampler sampler(c, column, section ? &*section : nullptr);
    if (shape.size() != 3 || shape[1] != sampler.layers() || shape[2] != sampler.quantities()) {
        throw FileError("/profile_blocks/sums of the results file does not have the layers of its case");
    }
    const std::size_t rows = std::min({time.size(), samples.size(), shape[0]});
    const std::size_t width = shape[1] * shape[2];
    std::vector<ProfileBlock> blocks;
    for (std::size_t row = 0; row < rows; ++row) {
        if (!window.holds(time[row]) || !window.holds(time[row] - profile_block_duration)) continue;
        blocks.push_back({time[row], samples[row], results.rows(of.sums, row, 1)});
        if (blocks.back().sums.size() != width) return {};
    }
    sampler.restore(std::move(blocks), {});
    return sampler.average(window.from, window.to);
}

}  // namespace riffle::inline analysis
