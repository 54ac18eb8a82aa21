#include "cli/analysis_tables.hpp"

#include <fmt/format.h>

#include <fstream>
#include <set>
#include <system_error>
#include <utility>

#include "analysis/figure_csv.hpp"
#include "base/error.hpp"
#include "output/atomic_file.hpp"

namespace riffle::inline cli {

namespace {

namespace fs = std::filesystem;

/// Where the tables of the figures of one of several analyses stand.
fs::path place_of(const fs::path& folder, std::size_t number, std::size_t of) {
    return of == 1 ? folder : folder / fmt::format("{}", number + 1);
}

/// An empty file and a device may be written to.
void refuse_to_lose(const fs::path& file) {
    std::error_code error;
    if (!fs::is_regular_file(file, error) || fs::file_size(file, error) == 0) return;
    std::ifstream content(file, std::ios::binary);
    if (!begins_like_analysis_csv(content)) {
        throw InputError(fmt::format(
            "{}: the file exists and is no table by riffle analyse; it would be lost. Give another "
            "folder, or remove it first",
            file.string()));
    }
}

}  // namespace

void refuse_to_lose_tables(const fs::path& folder, std::size_t inputs, const std::string& chapter) {
    std::set<fs::path> places = {folder};  // where findings.csv goes in any case
    for (std::size_t i = 0; i < inputs; ++i) places.insert(place_of(folder, i, inputs));
    for (const fs::path& place : places) {
        const bool of_figures = inputs == 1 || place != folder;
        std::error_code error;
        for (const auto& entry : fs::directory_iterator(place, error)) {
            const std::string name = entry.path().filename().string();
            if (name == findings_file ? place == folder : of_figures && is_figure_csv_name(name, chapter)) {
                refuse_to_lose(entry.path());
            }
        }
    }
}

std::size_t write_tables(const std::vector<Analysis>& analyses, const fs::path& folder) {
    std::vector<std::pair<fs::path, std::string>> tables;
    for (std::size_t i = 0; i < analyses.size(); ++i) {
        const fs::path place = place_of(folder, i, analyses.size());
        for (const Figure& figure : analyses[i].figures) {
            for (CsvFile& file : figure_to_csv(figure)) {
                tables.emplace_back(place / file.name, std::move(file.content));
            }
        }
    }
    tables.emplace_back(folder / findings_file, findings_to_csv(analyses));
    for (const auto& [path, content] : tables) refuse_to_lose(path);
    for (const auto& [path, content] : tables) {
        std::error_code error;
        fs::create_directories(path.parent_path(), error);
        if (error) {
            throw FileError(fmt::format("{}: the folder cannot be made: {}", path.parent_path().string(),
                                        error.message()));
        }
        write_text_atomically(path, content);
    }
    return tables.size() - 1;
}

}  // namespace riffle::inline cli
