#include "output/results_file.hpp"

#include <fmt/format.h>

#include <array>
#include <charconv>

#include "base/error.hpp"
#include "output/file_replace.hpp"
#include "output/hdf5_image.hpp"
#include "output/hdf5_objects.hpp"
#include "output/results_format.hpp"

namespace riffle {
namespace {

/// Attribute of "/": bytes that replaced objects have left unused in the file so far.
constexpr const char* unused_bytes = "unused_bytes";
constexpr std::int64_t tolerated_unused_bytes = std::int64_t{1} << 20U;

void apply(const Hdf5Handle& file, const Content& content) {
    for (const Dataset& dataset : content.datasets)
        write_hdf5_dataset(file, dataset, {.chunked = true, .compression = content.compression});
    for (const Attribute& attribute : content.attributes) write_hdf5_attribute(file, attribute);
}

void remove_snapshots(const Hdf5Handle& file, std::size_t kept) {
    if (!hdf5_has(file, "/snapshots")) return;
    for (const std::string& name : hdf5_children(file, "/snapshots")) {
        std::size_t index = 0;
        const auto [end, error] = std::from_chars(name.data(), name.data() + name.size(), index);
        if (error != std::errc() || end != name.data() + name.size()) continue;  // not a snapshot
        if (index >= kept) remove_hdf5_object(file, "/snapshots/" + name);
    }
}

/// HDF5 forgets the free space of a file when it is closed. Count it, and write the file anew without it when
/// it has become more than a quarter.
void limit_unused_space(Hdf5Handle& file) {
    const auto free_now = hdf5_check(H5Fget_freespace(file.get()), "measure the free space");
    const std::optional<AttributeValue> before = read_hdf5_attribute(file, "/", unused_bytes);
    const auto* counted = before ? std::get_if<std::int64_t>(&*before) : nullptr;
    const std::int64_t unused = (counted == nullptr ? 0 : *counted) + static_cast<std::int64_t>(free_now);
    hsize_t size = 0;
    hdf5_check(H5Fget_filesize(file.get(), &size), "measure the file");
    if (unused > tolerated_unused_bytes && unused > static_cast<std::int64_t>(size / 4)) {
        Hdf5Handle compact = create_hdf5_in_memory();
        copy_hdf5_content(file, compact);
        write_hdf5_attribute(compact, {"/", unused_bytes, std::int64_t{0}});
        file = std::move(compact);
    } else {
        write_hdf5_attribute(file, {"/", unused_bytes, unused});
    }
}

void save(const Hdf5Handle& file, const std::filesystem::path& path, const char* action, const char* intact) {
    const std::span<const std::byte> image = hdf5_image(file);
    const std::array<std::span<const std::byte>, 1> parts = {image};
    try {
        replace_file(path, parts);
    } catch (const std::system_error& error) {
        throw FileError(fmt::format("{}: cannot be {}: {}{}", path.string(), action,
                                    explain(error.code(), path, image.size()), intact));
    }
}

constexpr const char* earlier_results_intact =
    " The earlier results in this file are untouched; `riffle resume` continues the run from its last "
    "checkpoint.";

}  // namespace

std::string snapshot_group(std::size_t index) { return fmt::format("/snapshots/{:05}", index); }

void ResultsFile::create(const std::filesystem::path& path, const Content& content, bool overwrite) {
    std::error_code ignored;
    const bool exists = std::filesystem::exists(std::filesystem::symlink_status(path, ignored));
    if (exists && !overwrite) {
        throw FileError(
            fmt::format("{}: exists already, and would be lost. Continue that run with `riffle resume {}`, "
                        "or choose another "
                        "folder for this one.",
                        path.string(), path.has_parent_path() ? path.parent_path().string() : "."));
    }
    try {
        const Hdf5Handle file = create_hdf5_in_memory();
        apply(file, content);
        write_hdf5_attribute(file, {"/", "format", "riffle-results"});
        write_hdf5_attribute(file, {"/", "format_version", std::int64_t{results_format_version}});
        write_hdf5_attribute(file, {"/", unused_bytes, std::int64_t{0}});
        save(file, path, "created", exists ? earlier_results_intact : "");
    } catch (const Hdf5Failure& failure) {
        throw FileError(fmt::format("{}: cannot be created: {}.{}", path.string(), failure.what(),
                                    exists ? earlier_results_intact : ""));
    }
}

void ResultsFile::update(const std::filesystem::path& path, const Content& content,
                         const std::map<std::string, std::size_t>& rows,
                         std::optional<std::size_t> snapshots) {
    Hdf5Handle file = open_results(path, ResultsAccess::copy_to_change);
    try {
        if (snapshots) remove_snapshots(file, *snapshots);
        for (const auto& [dataset, count] : rows) cut_hdf5_rows(file, dataset, count);
        apply(file, content);
        limit_unused_space(file);
        save(file, path, "updated", earlier_results_intact);
    } catch (const Hdf5Failure& failure) {
        throw FileError(fmt::format("{}: cannot be updated: {}.{}", path.string(), failure.what(),
                                    earlier_results_intact));
    }
}

}  // namespace riffle
