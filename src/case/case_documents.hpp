#pragma once

#include <string>

#include "case/case.hpp"

namespace riffle::inline case_file {

/// JSON schema (draft 2020-12) of the case file, for editors that complete and check TOML.
[[nodiscard]] std::string case_schema_json();

/// Reference page of the case file in Markdown: docs/case-reference.md.
[[nodiscard]] std::string case_reference_markdown();

/// A commented case file with the values of `c`: every key with its meaning, unit and choices. Keys that are
/// required or differ from their default are set; the others stand commented out with their default.
[[nodiscard]] std::string case_template(const Case& c);

}  // namespace riffle::inline case_file
