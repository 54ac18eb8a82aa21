#include "cli/case_argument.hpp"

#include <fmt/format.h>

#include "base/error.hpp"
#include "base/machine.hpp"
#include "column/velocity_measurements.hpp"
#include "particles/case_size.hpp"

namespace riffle::inline cli {

void CaseArgument::add_to(CLI::App& verb) {
    verb.add_option("case", file, "Case file (TOML)")->required()->type_name("CASE");
    verb.add_option("--set", settings,
                    "Set a key of the case for this call: section.key=value; of one of several sections "
                    "section.name.key=value")
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

Case CaseArgument::read() const {
    Case c = read_case(file, overrides());
    check_velocity_measurements(c);
    return c;
}

void CaseArgument::add_large_to(CLI::App& verb) {
    verb.add_flag("--large", large,
                  "Build the case although it is larger than the free memory, or a length looks like a slip "
                  "of units");
}

void CaseArgument::check_size_of(const Case& c) const { check_size(c, large, available_memory()); }

}  // namespace riffle::inline cli
