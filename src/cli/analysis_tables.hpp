#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "analysis/figure.hpp"

namespace riffle::inline cli {

/// Refuse to write the tables of the analyses of `inputs` records (of the named chapter, or of all) to a
/// folder where one would take the place of something that is no table of an analysis. Throws InputError.
void refuse_to_lose_tables(const std::filesystem::path& folder, std::size_t inputs,
                           const std::string& chapter);

/// Write the tables of the analyses: to the folder itself, of several analyses to one subfolder each. Returns
/// the number of those of figures; findings.csv is one more. Refuses like the above before the first is
/// written.
std::size_t write_tables(const std::vector<Analysis>& analyses, const std::filesystem::path& folder);

}  // namespace riffle::inline cli
