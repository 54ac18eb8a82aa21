#include "cli/case_argument.hpp"

#include <fmt/format.h>

#include "base/error.hpp"

namespace riffle {

void CaseArgument::add_to(CLI::App& verb) {
    verb.add_option("case", file, "Case file (TOML)")->required()->type_name("CASE");
    verb.add_option("--set", settings, "Set a key of the case for this call: section.key=value")
        ->type_name("KEY=VALUE")
        ->allow_extra_args(false);
}

std::vector<Override> CaseArgument::overrides() const {
    std::vector<Override> result;
    for (const std::string& setting : settings) {
        const std::size_t equals = setting.find('=');
        if (equals == std::string::npos || equals == 0) {
            throw InputError(fmt::format(
                "--set {}: expected section.key=value, for example --set bed.drag_coefficient=0.9", setting));
        }
        result.push_back({setting.substr(0, equals), setting.substr(equals + 1)});
    }
    return result;
}

Case CaseArgument::read() const { return read_case(file, overrides()); }

}  // namespace riffle
