#pragma once

#include "output/results_file.hpp"

namespace riffle::inline output {

/// The arguments of ResultsFile::update.
struct ResultsChange {
    const Content& content;
    const std::map<std::string, std::size_t>& rows;
    std::optional<std::size_t> snapshots;
    const std::vector<std::string>& removed;
};

/// ResultsFile::update, for files that are changed in place from another size on (file_update.hpp).
void update_results(const std::filesystem::path& path, const ResultsChange& change,
                    std::uint64_t in_place_from);

}  // namespace riffle::inline output
