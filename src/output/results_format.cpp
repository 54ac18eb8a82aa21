#include "output/results_format.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <fstream>

#include "base/error.hpp"
#include "output/file_replace.hpp"
#include "output/hdf5_image.hpp"
#include "output/hdf5_objects.hpp"
#include "output/results_file.hpp"

namespace riffle {
namespace {

bool starts_like_hdf5(const std::filesystem::path& path) {
    constexpr std::array<char, 8> signature = {'\x89', 'H', 'D', 'F', '\r', '\n', '\x1a', '\n'};
    std::array<char, 8> start = {};
    std::ifstream file(path, std::ios::binary);
    file.read(start.data(), start.size());
    return file && start == signature;
}

void require_readable(const std::filesystem::path& path) {
    std::error_code code;
    const auto status = std::filesystem::status(path, code);
    if (status.type() == std::filesystem::file_type::not_found) {
        throw FileError(
            fmt::format("{}: there is no such results file. `riffle run CASE -o DIR` makes DIR/results.h5; "
                        "check the path.",
                        path.string()));
    }
    if (status.type() == std::filesystem::file_type::directory) {
        throw FileError(fmt::format("{}: is a folder; give the results file in it, for example {}.",
                                    path.string(), (path / "results.h5").string()));
    }
    errno = 0;
    if (const std::ifstream file(path, std::ios::binary); !file) {
        throw FileError(fmt::format("{}: cannot be read: {}", path.string(),
                                    explain({errno, std::generic_category()}, path)));
    }
}

template <class T>
std::optional<T> root_attribute(const Hdf5Handle& file, const char* name) {
    const std::optional<AttributeValue> value = read_hdf5_attribute(file, "/", name);
    if (!value || !std::holds_alternative<T>(*value)) return {};
    return std::get<T>(*value);
}

void require_format(const Hdf5Handle& file, const std::filesystem::path& path) {
    const auto format = root_attribute<std::string>(file, "format");
    if (format != "riffle-results") {
        throw FileError(fmt::format(
            "{}: is an HDF5 file, but not a results file of Riffle: its attribute `format` {}, not "
            "\"riffle-results\". Give the results.h5 of a run.",
            path.string(), format ? "is \"" + *format + "\"" : "is missing"));
    }
    const auto version = root_attribute<std::int64_t>(file, "format_version");
    if (version == results_format_version) return;
    const std::string writer = root_attribute<std::string>(file, "riffle_version").value_or("");
    const std::string written_by = writer.empty() ? "" : " (written by Riffle " + writer + ")";
    const std::string found = version ? std::to_string(*version) : "unknown";
    const char* newer = "Read it with that or a newer Riffle";
    const char* older = "Read it with the Riffle that wrote it";
    throw FileError(
        fmt::format("{}: has the results format version {}{}; this Riffle reads version {}. {}, or run the "
                    "case again with "
                    "this one: the case is in the file's dataset /case/text.",
                    path.string(), found, written_by, results_format_version,
                    version.value_or(0) > results_format_version ? newer : older));
}

}  // namespace

Hdf5Handle open_results(const std::filesystem::path& path, ResultsAccess access) {
    require_readable(path);
    Hdf5Handle file;
    try {
        file = access == ResultsAccess::read ? open_hdf5_for_reading(path) : load_hdf5_into_memory(path);
    } catch (const Hdf5Failure& failure) {
        if (!starts_like_hdf5(path)) {
            throw FileError(fmt::format(
                "{}: is not an HDF5 file (or its beginning is damaged). Give the results.h5 of a run.",
                path.string()));
        }
        throw FileError(
            fmt::format("{}: is truncated or damaged: {}. Restore it from a copy, or run the case again.",
                        path.string(), failure.what()));
    }
    try {
        require_format(file, path);
    } catch (const Hdf5Failure& failure) {
        throw FileError(fmt::format("{}: is damaged: {}. Restore it from a copy, or run the case again.",
                                    path.string(), failure.what()));
    }
    return file;
}

}  // namespace riffle
