#include "output/results_file.hpp"

#include <fmt/format.h>

#include <charconv>
#include <functional>

#include "base/error.hpp"
#include "output/damage.hpp"
#include "output/file_update.hpp"
#include "output/hdf5_driver.hpp"
#include "output/hdf5_objects.hpp"
#include "output/results_format.hpp"
#include "output/results_update.hpp"
#include "output/sealed_reader.hpp"

namespace riffle::inline output {
namespace {

/// Attribute of "/": bytes that replaced objects have left unused in the file so far.
constexpr const char* unused_bytes = "unused_bytes";
constexpr std::int64_t tolerated_unused_bytes = std::int64_t{1} << 20U;

void apply(const Hdf5Handle& file, const Content& content) {
    for (const Dataset& dataset : content.datasets) {
        write_hdf5_dataset(file, dataset, {.chunked = true, .compression = content.compression});
    }
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

/// HDF5 forgets the free space of a file when it is closed: count it. Whether so much of the file has become
/// free that it is worth writing it anew.
bool count_unused_space(const Hdf5Handle& file) {
    const auto free_now = hdf5_check(H5Fget_freespace(file.get()), "measure the free space");
    const std::optional<AttributeValue> before = read_hdf5_attribute(file, "/", unused_bytes);
    const auto* counted = before ? std::get_if<std::int64_t>(&*before) : nullptr;
    const std::int64_t unused = (counted == nullptr ? 0 : *counted) + static_cast<std::int64_t>(free_now);
    write_hdf5_attribute(file, {"/", unused_bytes, unused});
    hsize_t size = 0;
    hdf5_check(H5Fget_filesize(file.get(), &size), "measure the file");
    return unused > tolerated_unused_bytes && unused > static_cast<std::int64_t>(size / 4);
}

/// Write the file anew, from what `before` holds of it, without unused space.
void write_anew(const std::filesystem::path& path, ByteStore& before) {
    const Hdf5Handle from = open_hdf5(before, false);
    const auto fresh = FileUpdate::create(path, results_seal);
    Hdf5Handle to = create_hdf5(*fresh, seal_bytes);
    copy_hdf5_content(from, to);
    before.rethrow_fault();
    write_hdf5_attribute(to, {"/", unused_bytes, std::int64_t{0}});
    close_hdf5(to, *fresh);
    fresh->commit();
}

/// The same where there is room for it; the results are whole without it.
void try_to_compact(const std::filesystem::path& path) {
    try {
        SealedReader before(path, results_seal);
        write_anew(path, before);
    } catch (const std::system_error&) {
    }
}

constexpr const char* earlier_results_intact =
    " The earlier results in this file are untouched; `riffle resume` continues the run from its last "
    "checkpoint.";

/// Do something with the file, telling its failure with the name of the file and what is still intact. The
/// change sets the number of bytes that it wants to write, as soon as it is known.
void told(const std::filesystem::path& path, const char* action, const char* intact,
          const std::function<void(std::size_t& bytes)>& change) {
    std::size_t bytes = 0;
    try {
        change(bytes);
    } catch (const std::system_error& error) {
        throw FileError(fmt::format("{}: cannot be {}: {}{}", path.string(), action,
                                    explain(error.code(), path, bytes), intact));
    } catch (const NotWhole& not_whole) {
        throw FileError(fmt::format("{}: {}. {}", path.string(), not_whole.what(), after_loss));
    } catch (const Hdf5Failure& failure) {
        throw FileError(
            fmt::format("{}: cannot be {}: {}.{}", path.string(), action, failure.what(), intact));
    }
}

/// Let `f` work on the HDF5 file of a store; a fault of the store is the reason of what fails. `bytes`: what
/// is to be written.
void with_hdf5(FileUpdate& store, Hdf5Handle file, std::size_t& bytes,
               const std::function<void(const Hdf5Handle&)>& f) {
    try {
        f(file);
        bytes = store.bytes_to_write();
        close_hdf5(file, store);
    } catch (const Hdf5Failure&) {
        store.rethrow_fault();
        throw;
    }
}

/// Changes are made to sealed files of this format only.
void require_changeable(const std::filesystem::path& path) {
    const std::unique_ptr<ContentReader::Impl> open = open_results(path);
    if (dynamic_cast<const SealedReader*>(open->store.get()) == nullptr) {
        throw FileError(fmt::format(
            "{}: has no checksums, so it is of an earlier Riffle or was written by another program: it can "
            "be read, not continued. Resume with the Riffle that wrote it, or run the case again.",
            path.string()));
    }
}

}  // namespace

std::string snapshot_group(std::size_t index) { return fmt::format("/snapshots/{:05}", index); }

void ResultsFile::create(const std::filesystem::path& path, const Content& content, bool overwrite) {
    std::error_code ignored;
    const bool exists = std::filesystem::exists(path, ignored);
    if (exists && !overwrite) {
        throw FileError(
            fmt::format("{}: exists already, and would be lost. Continue that run with `riffle resume {}`, "
                        "or choose another folder for this one.",
                        path.string(), path.has_parent_path() ? path.parent_path().string() : "."));
    }
    told(path, "created", exists ? earlier_results_intact : "", [&](std::size_t& bytes) {
        const auto update = FileUpdate::create(path, results_seal);
        with_hdf5(*update, create_hdf5(*update, seal_bytes), bytes, [&](const Hdf5Handle& file) {
            apply(file, content);
            write_hdf5_attribute(file, {"/", "format", "riffle-results"});
            write_hdf5_attribute(file, {"/", "format_version", std::int64_t{results_format_version}});
            write_hdf5_attribute(file, {"/", unused_bytes, std::int64_t{0}});
        });
        update->commit();
    });
}

void update_results(const std::filesystem::path& path, const ResultsChange& change,
                    std::uint64_t in_place_from) {
    require_changeable(path);
    bool wasteful = false;
    told(path, "updated", earlier_results_intact, [&](std::size_t& bytes) {
        const auto update = FileUpdate::change(path, results_seal, in_place_from);
        with_hdf5(*update, open_hdf5(*update, true), bytes, [&](const Hdf5Handle& file) {
            if (change.snapshots) remove_snapshots(file, *change.snapshots);
            for (const std::string& object : change.removed) {
                if (hdf5_has(file, object)) remove_hdf5_object(file, object);
            }
            for (const auto& [dataset, count] : change.rows) cut_hdf5_rows(file, dataset, count);
            apply(file, change.content);
            wasteful = count_unused_space(file);
        });
        update->commit();
        if (wasteful) try_to_compact(path);
    });
}

void ResultsFile::update(const std::filesystem::path& path, const Content& content,
                         const std::map<std::string, std::size_t>& rows, std::optional<std::size_t> snapshots,
                         const std::vector<std::string>& removed) {
    update_results(path, {content, rows, snapshots, removed}, chosen_change_in_place_from());
}

void ResultsFile::accept(const std::filesystem::path& path) {
    require_readable(path);
    told(path, "read as HDF5 and given checksums", "", [&](std::size_t&) {
        PlainReader before(path);
        require_results_format(open_hdf5(before, false), path);
        write_anew(path, before);
    });
}

ResultsReader::ResultsReader(const std::filesystem::path& path) : ContentReader(open_results(path)) {}

bool ResultsReader::has_checksums() const {
    return dynamic_cast<const SealedReader*>(impl().store.get()) != nullptr;
}

std::uint64_t ResultsReader::verify() const {
    const auto* const sealed = dynamic_cast<const SealedReader*>(impl().store.get());
    if (sealed == nullptr) return 0;
    const std::vector<std::uint64_t> pages = impl().told([&] { return sealed->content().damaged_pages(); });
    if (pages.empty()) return sealed->content().bytes_behind();
    throw FileError(fmt::format("{}: has been altered or damaged: {} {}", path().string(),
                                damage_text(path(), results_seal, pages), after_loss));
}

}  // namespace riffle::inline output
