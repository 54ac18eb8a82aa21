#include "output/checkpoint_file.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <array>
#include <cmath>
#include <cstring>
#include <optional>
#include <utility>

#include "base/error.hpp"
#include "output/content_reader_impl.hpp"
#include "output/file_update.hpp"
#include "output/hdf5_driver.hpp"
#include "output/hdf5_objects.hpp"
#include "output/sealed_reader.hpp"

namespace riffle::inline output {
namespace {

constexpr const char* previous_suffix = "-previous";

using OpenFile = std::unique_ptr<ContentReader::Impl>;

/// Open a checkpoint of which every byte has been verified. Throws NotWhole, also when the file is missing or
/// unreadable.
OpenFile open_whole(const std::filesystem::path& path) {
    try {
        auto store = std::make_unique<SealedReader>(path, checkpoint_seal);
        const std::vector<std::uint64_t> damaged = store->content().damaged_pages();
        if (!damaged.empty()) throw DamagedPage(damaged.front());
        if (!store->content().ends_with_table()) {
            throw NotWhole("has been altered or damaged: it does not end where it should");
        }
        auto open = std::make_unique<ContentReader::Impl>();
        open->path = path;
        open->store = std::move(store);
        open->file = open_hdf5(*open->store, false);
        return open;
    } catch (const NotSealed&) {
        throw NotWhole("is not a checkpoint of Riffle, or its first line is damaged");
    } catch (const std::system_error& error) {
        if (error.code() == std::errc::no_such_file_or_directory) throw NotWhole("does not exist");
        throw NotWhole(fmt::format("cannot be read: {}", error.code().message()));
    } catch (const Hdf5Failure& failure) {
        throw NotWhole(fmt::format("cannot be read: {}", failure.what()));
    }
}

std::string folder_text(const std::filesystem::path& path) {
    return path.has_parent_path() ? path.parent_path().string() : ".";
}

/// The path whose previous checkpoint this is.
std::filesystem::path newest(const std::filesystem::path& previous) {
    const std::string stem = previous.stem().string();
    const std::string name = stem.substr(0, stem.size() - std::strlen(previous_suffix));
    return previous.parent_path() / (name + previous.extension().string());
}

std::string time_text(const OpenFile& open) {
    const auto time = read_hdf5_attribute(open->file, "/", "time");
    const auto* const seconds = time ? std::get_if<double>(&*time) : nullptr;
    return seconds != nullptr ? fmt::format(" (simulated time {:.6g} s)", *seconds) : "";
}

/// What the user can do without the checkpoint at `path`.
std::string way_on(const std::filesystem::path& path) {
    const bool is_previous = path.stem().string().ends_with(previous_suffix);
    const std::filesystem::path other = is_previous ? newest(path) : CheckpointFile::previous(path);
    const char* which = is_previous ? "newest" : "previous";
    std::string reason;
    try {
        const std::string time = time_text(open_whole(other));
        const std::string from = is_previous ? "" : " --from " + other.filename().string();
        return fmt::format("The {} checkpoint {}{} is whole; continue from it with: riffle resume {}{}",
                           which, other.string(), time, folder_text(path), from);
    } catch (const NotWhole& not_whole) {
        reason = not_whole.what();
    }
    return fmt::format(
        "The {} checkpoint {} is of no help either: it {}. Run the case again from its start: "
        "riffle run CASE -o {} --force",
        which, other.string(), reason, folder_text(path));
}

/// The same, telling what is wrong and how to go on.
OpenFile open_checkpoint(const std::filesystem::path& path) {
    try {
        OpenFile open = open_whole(path);
        open->way_on = [path] { return way_on(path); };
        return open;
    } catch (const NotWhole& not_whole) {
        throw FileError(
            fmt::format("{}: the checkpoint {}. {}", path.string(), not_whole.what(), way_on(path)));
    }
}

void collect(const CheckpointReader& file, const std::string& group, Content& content) {
    const auto collect_attributes = [&](const std::string& path, bool is_group) {
        for (const std::string& name : file.attribute_names(path)) {
            if (!is_group && (name == "units" || name == "long_name")) continue;  // members of Dataset
            if (const auto value = file.attribute(path, name)) {
                content.attributes.push_back({path, name, *value});
            }
        }
    };
    collect_attributes(group, true);
    for (const std::string& name : file.children(group)) {
        const std::string path = (group == "/" ? "" : group) + "/" + name;
        if (file.is_group(path)) {
            collect(file, path, content);
        } else {
            content.datasets.push_back(file.read(path));
            collect_attributes(path, false);
        }
    }
}

}  // namespace

std::filesystem::path CheckpointFile::previous(const std::filesystem::path& path) {
    return path.parent_path() / (path.stem().string() + previous_suffix + path.extension().string());
}

void CheckpointFile::write(const std::filesystem::path& path, const Content& content) {
    std::size_t size = 0;
    try {
        const auto update = FileUpdate::create(path, checkpoint_seal, previous(path));
        Hdf5Handle file = create_hdf5(*update, seal_bytes);
        for (const Dataset& dataset : content.datasets) write_hdf5_dataset(file, dataset, {});
        for (const Attribute& attribute : content.attributes) write_hdf5_attribute(file, attribute);
        size = update->size();
        close_hdf5(file, *update);
        update->commit();
    } catch (const std::system_error& error) {
        std::error_code ignored;
        const bool earlier = std::filesystem::exists(path, ignored);
        throw FileError(fmt::format(
            "{}: the checkpoint cannot be written: {}{}", path.string(), explain(error.code(), path, size),
            earlier ? fmt::format(
                          " The earlier checkpoint in this file is untouched; continue from it with: riffle "
                          "resume {}",
                          folder_text(path))
                    : std::string()));
    } catch (const Hdf5Failure& failure) {
        throw FileError(
            fmt::format("{}: the checkpoint cannot be written: {}.", path.string(), failure.what()));
    }
}

void CheckpointFile::adopt(const std::filesystem::path& path, const std::filesystem::path& other) {
    std::error_code ignored;
    if (std::filesystem::equivalent(path, other, ignored)) return;
    try {
        const std::vector<std::byte> bytes = read_file_bytes(other);
        const std::array<std::span<const std::byte>, 1> parts = {bytes};
        replace_file(path, parts);
    } catch (const std::system_error& error) {
        throw FileError(fmt::format("{}: the checkpoint {} cannot be put in its place: {}", path.string(),
                                    other.string(), explain(error.code(), path)));
    }
}

Content CheckpointFile::read(const std::filesystem::path& path) {
    Content content;
    collect(CheckpointReader(path), "/", content);
    return content;
}

CheckpointReader::CheckpointReader(const std::filesystem::path& path)
    : ContentReader(open_checkpoint(path)) {}

double CheckpointReader::number(const std::string& group, const std::string& name) const {
    const auto value = attribute(group, name);
    if (value) {
        if (const auto* real = std::get_if<double>(&*value)) return *real;
        if (const auto* whole = std::get_if<std::int64_t>(&*value)) return static_cast<double>(*whole);
    }
    throw FileError(
        fmt::format("{}: the checkpoint lacks `{}` of {}: it was written by another build; start "
                    "the run again",
                    path().string(), name, group));
}

std::size_t CheckpointReader::count(const std::string& group, const std::string& name,
                                    std::size_t most) const {
    const double value = number(group, name);
    if (!(value >= 0.0 && value <= static_cast<double>(most)) || value != std::floor(value)) {
        throw FileError(
            fmt::format("{}: `{}` of {} is {}, expected a whole number from 0 to {}: the "
                        "checkpoint does not belong to this run",
                        path().string(), name, group, value, most));
    }
    return static_cast<std::size_t>(value);
}

std::vector<double> CheckpointReader::doubles(const std::string& dataset, std::size_t length) const {
    if (!has(dataset)) {
        throw FileError(
            fmt::format("{}: the checkpoint lacks {}: it was written by another build; start the run again",
                        path().string(), dataset));
    }
    const std::vector<std::size_t> there = shape(dataset);
    if (there != std::vector<std::size_t>{length}) {
        throw FileError(
            fmt::format("{}: {} has the shape [{}], expected [{}]: the checkpoint does not belong "
                        "to this case",
                        path().string(), dataset, fmt::join(there, ", "), length));
    }
    return read_doubles(dataset);
}

}  // namespace riffle::inline output
