#include "column/velocity_measurements.hpp"

#include <fmt/format.h>

#include <charconv>
#include <cstddef>
#include <fstream>
#include <optional>
#include <string>
#include <string_view>
#include <system_error>

#include "base/error.hpp"
#include "hydraulics/channel_laws.hpp"

namespace riffle {

namespace {

std::string_view trimmed(std::string_view text) {
    constexpr std::string_view blank = " \t\r";
    const std::size_t first = text.find_first_not_of(blank);
    if (first == std::string_view::npos) return {};
    return text.substr(first, text.find_last_not_of(blank) - first + 1);
}

std::vector<std::string_view> fields(std::string_view line) {
    std::vector<std::string_view> result;
    for (;;) {
        const std::size_t comma = line.find(',');
        result.push_back(trimmed(line.substr(0, comma)));
        if (comma == std::string_view::npos) return result;
        line.remove_prefix(comma + 1);
    }
}

std::optional<double> number(std::string_view text) {
    double value = 0;
    const char* const end = text.data() + text.size();
    const auto [stop, error] = std::from_chars(text.data(), end, value);
    if (error != std::errc{} || stop != end) return std::nullopt;
    return value;
}

}  // namespace

VelocityMeasurements read_velocity_measurements(const Case& c) {
    const std::filesystem::path& path = c.measured.velocity_profile;
    std::ifstream file(path);
    if (!file) {
        throw FileError(fmt::format(
            "{}: cannot be read (measured.velocity_profile): give an existing CSV file", path.string()));
    }
    VelocityMeasurements result;
    std::string line;
    bool heading_allowed = true;
    std::size_t columns = 0;
    for (int number_of_line = 1; std::getline(file, line); ++number_of_line) {
        const std::string_view text = trimmed(line);
        if (text.empty() || text.front() == '#') continue;
        const auto fail = [&](std::string_view problem) {
            throw FileError(
                fmt::format("{}:{}: {}, got \"{}\"", path.string(), number_of_line, problem, text));
        };
        std::vector<double> values;
        bool all_numbers = true;
        for (const std::string_view field : fields(text)) {
            const std::optional<double> value = number(field);
            all_numbers = all_numbers && value.has_value();
            values.push_back(value.value_or(0.0));
        }
        if (!all_numbers && heading_allowed) {
            heading_allowed = false;
            continue;
        }
        heading_allowed = false;
        if (columns == 0) columns = values.size();
        if (!all_numbers || values.size() != columns || columns < 2 || columns > 3) {
            fail(
                "expected the numbers z (m above the datum), u (m/s) and, on all lines or none, the "
                "uncertainty "
                "of u (m/s), separated by commas");
        }
        const double height = c.datum() + values[0];
        if (!(height > 0.0) || height > c.total_depth()) {
            fail(fmt::format("expected z within the water, {:.6g} to {:.6g} m above the datum", -c.datum(),
                             c.channel.depth));
        }
        result.height.push_back(height);
        result.velocity.push_back(values[1]);
        if (columns == 3) {
            if (!(values[2] > 0.0)) fail("expected an uncertainty of u greater than 0");
            result.uncertainty.push_back(values[2]);
        }
    }
    if (result.height.empty()) {
        throw FileError(fmt::format("{}: no line with numbers z, u in this measured profile", path.string()));
    }
    return result;
}

VelocityMeasurements measured_log_law(const Case& c, int points) {
    VelocityMeasurements result;
    if (!c.measured.friction_velocity || !c.measured.equivalent_roughness) return result;
    for (int i = 0; i < points; ++i) {
        const double z = c.crest() + (c.total_depth() - c.crest()) * (i + 0.5) / points;
        result.height.push_back(z);
        result.velocity.push_back(
            rough_log_law(z - c.datum(), *c.measured.friction_velocity, *c.measured.equivalent_roughness));
    }
    return result;
}

}  // namespace riffle
