#include "output/results_format.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <fstream>

#include "base/error.hpp"
#include "output/file_replace.hpp"
#include "output/hdf5_driver.hpp"
#include "output/hdf5_objects.hpp"
#include "output/results_file.hpp"
#include "output/sealed_reader.hpp"

namespace riffle::inline output {
namespace {

template <class T>
std::optional<T> root_attribute(const Hdf5Handle& file, const char* name) {
    const std::optional<AttributeValue> value = read_hdf5_attribute(file, "/", name);
    if (!value || !std::holds_alternative<T>(*value)) return {};
    return std::get<T>(*value);
}

}  // namespace

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

void require_results_format(const Hdf5Handle& file, const std::filesystem::path& path) {
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
                    "case again with this one: the case is in the file's dataset /case/text.",
                    path.string(), found, written_by, results_format_version,
                    version.value_or(0) > results_format_version ? newer : older));
}

std::unique_ptr<ContentReader::Impl> open_results(const std::filesystem::path& path) {
    require_readable(path);
    auto open = std::make_unique<ContentReader::Impl>();
    open->path = path;
    open->way_on = [] { return std::string(after_damage); };
    try {
        open->store = open_for_reading(path, results_seal);
    } catch (const NotSealed&) {
        throw FileError(fmt::format(
            "{}: is not an HDF5 file of results (or its beginning is damaged). Give the results.h5 of a run.",
            path.string()));
    } catch (const NotWhole& not_whole) {
        throw FileError(fmt::format("{}: {}. {}", path.string(), not_whole.what(), after_loss));
    } catch (const std::system_error& error) {
        throw FileError(fmt::format("{}: cannot be read: {}", path.string(), explain(error.code(), path)));
    }
    open->told([&] { open->file = open_hdf5(*open->store, false); });
    open->told([&] { require_results_format(open->file, path); });
    return open;
}

}  // namespace riffle::inline output
