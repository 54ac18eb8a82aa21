#include "analysis/run_profiles.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <utility>
#include <variant>

#include "base/error.hpp"
#include "column/section.hpp"

namespace riffle {

namespace {

using Member = std::vector<double> Profiles::*;

const std::array<std::pair<const char*, Member>, 22> members = {{
    {"bin_lower", &Profiles::bin_lower},
    {"bin_upper", &Profiles::bin_upper},
    {"velocity", &Profiles::velocity},
    {"velocity_half_width", &Profiles::velocity_half_width},
    {"vertical_velocity", &Profiles::vertical_velocity},
    {"velocity_deviation", &Profiles::velocity_deviation},
    {"column_velocity", &Profiles::column_velocity},
    {"velocity_gradient", &Profiles::velocity_gradient},
    {"eddy_viscosity", &Profiles::eddy_viscosity},
    {"pressure", &Profiles::pressure},
    {"density", &Profiles::density},
    {"viscous_stress", &Profiles::viscous_stress},
    {"pair_stress", &Profiles::pair_stress},
    {"reynolds_stress", &Profiles::reynolds_stress},
    {"total_stress", &Profiles::total_stress},
    {"analytic_stress", &Profiles::analytic_stress},
    {"velocity_rms", &Profiles::velocity_rms},
    {"vertical_velocity_rms", &Profiles::vertical_velocity_rms},
    {"drag", &Profiles::drag},
    {"spanwise_velocity", &Profiles::spanwise_velocity},
    {"spanwise_velocity_rms", &Profiles::spanwise_velocity_rms},
    {"side_wall_drag", &Profiles::side_wall_drag},
}};

double attribute(const ResultsReader& reader, const char* name) {
    const std::optional<AttributeValue> value = reader.attribute("/profiles", name);
    if (!value) return 0.0;
    if (const auto* real = std::get_if<double>(&*value)) return *real;
    if (const auto* integer = std::get_if<std::int64_t>(&*value)) return static_cast<double>(*integer);
    return 0.0;
}

}  // namespace

Profiles read_profiles_group(const ResultsReader& reader) {
    Profiles profiles;
    if (!reader.has("/profiles/z")) return profiles;
    const std::vector<double> z = reader.read_doubles("/profiles/z");
    const auto keep = [&](const std::vector<double>& values) {
        std::vector<double> kept;
        for (std::size_t i = 0; i < z.size(); ++i) {
            if (std::isfinite(z[i])) kept.push_back(values[i]);
        }
        return kept;
    };
    profiles.z = keep(z);
    for (const auto& [name, member] : members) {
        const std::string path = std::string("/profiles/") + name;
        if (!reader.has(path)) continue;
        const std::vector<double> values = reader.read_doubles(path);
        if (values.size() == z.size()) profiles.*member = keep(values);
    }
    profiles.window_start = attribute(reader, "window_start");
    profiles.window_end = attribute(reader, "window_end");
    profiles.samples = attribute(reader, "samples");
    return profiles;
}

Profiles average_profile_blocks(const ResultsReader& reader, const Case& c, const ColumnResult* column,
                                const TimeWindow& window) {
    if (!reader.has("/profile_blocks/sums")) return {};
    const std::vector<double> time = reader.read_doubles("/profile_blocks/time");
    const std::vector<double> samples = reader.read_doubles("/profile_blocks/samples");
    const std::vector<std::size_t> shape = reader.shape("/profile_blocks/sums");
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
        blocks.push_back({time[row], samples[row], reader.read_rows("/profile_blocks/sums", row, 1)});
        if (blocks.back().sums.size() != width) return {};
    }
    sampler.restore(std::move(blocks), {});
    return sampler.average(window.from, window.to);
}

}  // namespace riffle
