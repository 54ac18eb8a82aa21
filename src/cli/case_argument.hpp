#pragma once

#include <CLI/CLI.hpp>
#include <string>
#include <vector>

#include "case/case.hpp"

namespace riffle::inline cli {

/// The case of a verb as given on its command line: the file and the `--set section.key=value` options.
struct CaseArgument {
    std::string file;
    std::vector<std::string> settings;
    bool large = false;

    /// Add the positional argument CASE and the option `--set` to a verb.
    void add_to(CLI::App& verb);

    /// Add the option `--large` to a verb that builds the particles of a case.
    void add_large_to(CLI::App& verb);

    /// The settings as overrides. Throws InputError where one is not section.key=value.
    [[nodiscard]] std::vector<Override> overrides() const;

    /// Read the case with its overrides, and the measured profile that it names. Throws as read_case() and
    /// read_velocity_measurements().
    [[nodiscard]] Case read() const;

    /// Refuse a case that is too large for the memory or by a slip, unless `--large` was given; see
    /// check_size().
    void check_size_of(const Case& c) const;
};

}  // namespace riffle::inline cli
