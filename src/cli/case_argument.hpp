#pragma once

#include <CLI/CLI.hpp>
#include <string>
#include <vector>

#include "case/case.hpp"

namespace riffle {

/// The case of a verb as given on its command line: the file and the `--set section.key=value` options.
struct CaseArgument {
    std::string file;
    std::vector<std::string> settings;

    /// Add the positional argument CASE and the option `--set` to a verb.
    void add_to(CLI::App& verb);

    /// The settings as overrides. Throws InputError where one is not section.key=value.
    [[nodiscard]] std::vector<Override> overrides() const;

    /// Read the case with its overrides. Throws as read_case().
    [[nodiscard]] Case read() const;
};

}  // namespace riffle
