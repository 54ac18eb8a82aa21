#pragma once

#include <filesystem>
#include <optional>

#include "report/report_data.hpp"

namespace riffle {

/// Read the measured profile that the case names: CSV with columns z (above the datum, m), u (m/s) and, if
/// given, the uncertainty of u (m/s); a heading line and lines that start with # are passed over. A relative
/// name is looked for in `folder` too. Nothing if the file is not found; FileError (file, line, what was
/// expected) if a line is not numbers.
[[nodiscard]] std::optional<MeasuredProfile> read_measured_profile(const Case& c,
                                                                   const std::filesystem::path& folder);

}  // namespace riffle
