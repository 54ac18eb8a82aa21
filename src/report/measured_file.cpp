#include "report/measured_file.hpp"

#include <charconv>
#include <fstream>
#include <string>
#include <string_view>
#include <system_error>
#include <vector>

#include "base/error.hpp"

namespace riffle {

namespace {

std::vector<std::string_view> fields_of(std::string_view line) {
    std::vector<std::string_view> fields;
    while (true) {
        const std::size_t comma = line.find(',');
        std::string_view field = line.substr(0, comma);
        const std::size_t first = field.find_first_not_of(" \t\r\"");
        const std::size_t last = field.find_last_not_of(" \t\r\"");
        fields.push_back(first == std::string_view::npos ? std::string_view{}
                                                         : field.substr(first, last - first + 1));
        if (comma == std::string_view::npos) return fields;
        line.remove_prefix(comma + 1);
    }
}

std::optional<double> number_of(std::string_view field) {
    double value = 0;
    const char* const end = field.data() + field.size();
    const auto [stop, error] = std::from_chars(field.data(), end, value);
    if (error != std::errc{} || stop != end) return std::nullopt;
    return value;
}

}  // namespace

std::optional<MeasuredProfile> read_measured_profile(const Case& c, const std::filesystem::path& folder) {
    std::filesystem::path path = c.measured.velocity_profile;
    std::error_code error;
    if (!std::filesystem::is_regular_file(path, error) && path.is_relative()) path = folder / path;
    if (!std::filesystem::is_regular_file(path, error)) return std::nullopt;
    std::ifstream file(path);
    MeasuredProfile profile;
    std::string line;
    for (int count = 1; std::getline(file, line); ++count) {
        const std::vector<std::string_view> fields = fields_of(line);
        if (fields.front().empty() || fields.front().front() == '#') continue;
        const auto z = number_of(fields.front());
        const auto velocity = fields.size() > 1 ? number_of(fields[1]) : std::nullopt;
        if (!z && profile.z.empty()) continue;  // the heading
        const bool wants_uncertainty = !profile.uncertainty.empty();
        const auto uncertainty = fields.size() > 2 ? number_of(fields[2]) : std::nullopt;
        if (!z || !velocity || (wants_uncertainty && !uncertainty)) {
            throw FileError(
                path.string() + ":" + std::to_string(count) +
                ": expected numbers for z (m above the datum), u (m/s) and, if the lines before have it, "
                "the uncertainty of u (m/s), separated by commas; got \"" +
                line + "\"");
        }
        if (uncertainty && (wants_uncertainty || profile.z.empty()))
            profile.uncertainty.push_back(*uncertainty);
        profile.z.push_back(c.datum() + *z);
        profile.velocity.push_back(*velocity);
    }
    if (profile.z.empty())
        throw FileError(path.string() + ": no line with numbers z, u in this measured profile");
    return profile;
}

}  // namespace riffle
