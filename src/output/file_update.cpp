#include "output/file_update.hpp"

#include <fcntl.h>
#include <sys/stat.h>

#include <algorithm>
#include <chrono>
#include <cstdlib>
#include <cstring>
#include <utility>

#include "output/checksum.hpp"
#include "output/journal.hpp"

namespace riffle::inline output {
namespace {

/// What a change in place takes to the journal is counted in blocks.
constexpr std::uint64_t block_bytes = 4096;
static_assert(page_bytes / block_bytes <= 32, "the blocks of a page are counted in 32 bits");

/// How long a change waits for those who read the file, before it makes a new one.
constexpr std::chrono::seconds patience = std::chrono::seconds(1);

constexpr std::size_t copied_at_once = std::size_t{1} << 20U;

/// Complete a change of the file that was interrupted.
void complete_journal(const FileDescriptor& file, const std::filesystem::path& path, SealKind kind) {
    {
        const SealedContent content(FileDescriptor(path, O_RDONLY), path, kind);
        if (content.journal()) {
            const bool locked =
                file.lock(FileDescriptor::Lock::exclusive, patience) == FileDescriptor::Locked::yes;
            apply_journal(file, *content.journal());
            if (locked) file.unlock();
            file.sync();
        }
    }
    remove_journal(path);
}

/// A file that takes this one's name and happens to begin alike, as the same run from its start does, must
/// not be taken for the one that an interrupted change has left a journal of.
void complete_journal_before_replacement(const std::filesystem::path& path, SealKind kind) {
    if (!std::filesystem::exists(journal_of(path))) return;
    try {
        complete_journal(FileDescriptor(path, O_RDWR), path, kind);
    } catch (const NotWhole&) {
        remove_journal(path);  // it makes nothing whole
    } catch (const std::system_error& error) {
        if (error.code() != std::errc::no_such_file_or_directory) throw;
        remove_journal(path);  // of a file that is gone
    }
}

}  // namespace

std::uint64_t chosen_change_in_place_from() {
    const char* const text = std::getenv("RIFFLE_CHANGE_IN_PLACE_FROM");  // NOLINT(concurrency-mt-unsafe)
    return text != nullptr ? std::strtoull(text, nullptr, 10) : change_in_place_from;
}

std::unique_ptr<FileUpdate> FileUpdate::create(const std::filesystem::path& path, SealKind kind,
                                               const std::filesystem::path& keep_as) {
    std::unique_ptr<FileUpdate> update(new FileUpdate(behind_links(path), kind));
    complete_journal_before_replacement(update->path_, kind);
    update->fresh_ = std::make_unique<FileReplacement>(path, keep_as);
    return update;
}

std::unique_ptr<FileUpdate> FileUpdate::change(const std::filesystem::path& path, SealKind kind,
                                               std::uint64_t in_place_from) {
    std::unique_ptr<FileUpdate> update(new FileUpdate(behind_links(path), kind));
    FileDescriptor file(update->path_, O_RDWR);
    complete_journal(file, update->path_, kind);
    update->old_.emplace(std::move(file), update->path_, kind);
    const SealedContent& old = *update->old_;
    update->old_size_ = old.seal().file_size();
    update->size_ = old.seal().size;
    if (!update->changes_in_place(in_place_from)) {
        update->fresh_ = std::make_unique<FileReplacement>(update->path_);
    } else if (!old.ends_with_table()) {
        old.file().resize(update->old_size_);  // the tail of a change that did not come to its end
    }
    return update;
}

FileUpdate::~FileUpdate() {
    if (committed_ || fresh_ || !old_) return;
    try {
        old_->file().resize(old_size_);
    } catch (const std::system_error&) {
        // The tail stays where it hurts nobody, until the next change.
    }
}

bool FileUpdate::changes_in_place(std::uint64_t in_place_from) const {
    if (old_size_ < in_place_from) return false;
    const FileDescriptor& file = old_->file();
    struct stat status = {};
    if (::fstat(file.get(), &status) != 0 || status.st_nlink != 1) return false;
    const auto locked = file.lock(FileDescriptor::Lock::exclusive, std::chrono::milliseconds(0));
    if (locked == FileDescriptor::Locked::yes) file.unlock();
    return locked != FileDescriptor::Locked::impossible;
}

const FileDescriptor& FileUpdate::tail() const { return fresh_ ? fresh_->file() : old_->file(); }

void FileUpdate::read_old(std::uint64_t at, std::span<std::byte> bytes) {
    while (!bytes.empty()) {
        const std::uint64_t number = at / page_bytes;
        const std::uint64_t begin = number * page_bytes;
        const std::size_t count = std::min<std::uint64_t>(bytes.size(), begin + page_bytes - at);
        const auto page = pages_.find(number);
        if (page != pages_.end()) {
            std::memcpy(bytes.data(), &page->second.bytes[at - begin], count);
        } else {
            old_->read(at, bytes.first(count));
        }
        bytes = bytes.subspan(count);
        at += count;
    }
}

void FileUpdate::read(std::uint64_t at, std::span<std::byte> bytes) {
    if (at < old_size_) {
        const std::size_t count = std::min<std::uint64_t>(bytes.size(), old_size_ - at);
        read_old(at, bytes.first(count));
        bytes = bytes.subspan(count);
        at += count;
    }
    const std::size_t there = bytes.empty() ? 0 : tail().read_at(at, bytes);
    std::fill(bytes.begin() + static_cast<std::ptrdiff_t>(there), bytes.end(), std::byte{0});
}

FileUpdate::Page& FileUpdate::page_to_change(std::uint64_t number) {
    const auto [place, is_new] = pages_.try_emplace(number);
    Page& page = place->second;
    if (is_new) {
        try {
            page.bytes.resize(page_bytes);
            old_->read(number * page_bytes, page.bytes);
        } catch (...) {
            pages_.erase(place);
            throw;
        }
    }
    return page;
}

void FileUpdate::write(std::uint64_t at, std::span<const std::byte> bytes) {
    size_ = std::max(size_, at + bytes.size());
    put(at, bytes);
}

void FileUpdate::put(std::uint64_t at, std::span<const std::byte> bytes) {
    while (!bytes.empty() && at < old_size_) {
        const std::uint64_t number = at / page_bytes;
        const std::uint64_t begin = number * page_bytes;
        const std::size_t count =
            std::min<std::uint64_t>(bytes.size(), std::min(begin + page_bytes, old_size_) - at);
        Page& page = page_to_change(number);
        std::memcpy(&page.bytes[at - begin], bytes.data(), count);
        for (std::uint64_t block = (at - begin) / block_bytes; block * block_bytes < at - begin + count;
             ++block) {
            page.changed |= 1U << block;
        }
        bytes = bytes.subspan(count);
        at += count;
    }
    if (!bytes.empty()) tail().write_at(at, bytes);
}

// Space that the library has taken and left empty is zero, also where the old table stood.
void FileUpdate::clear_old_table() {
    const std::uint64_t begin = old_->seal().size;
    const std::uint64_t end = std::min(old_size_, size_);
    std::vector<std::byte> content(end > begin ? end - begin : 0);
    read_old(begin, content);
    put(begin, content);
}

PageTable FileUpdate::new_table() {
    PageTable table;
    std::vector<std::byte> buffer(page_bytes);
    for (std::uint64_t begin = 0; begin < size_; begin += page_bytes) {
        const std::uint64_t page = table.size();
        const std::uint64_t end = page_end(page, size_);
        if (old_ && end == page_end(page, old_->seal().size) && pages_.count(page) == 0) {
            table.push_back(old_->table()[page]);
            continue;
        }
        const std::span<std::byte> bytes = std::span(buffer).first(end - begin);
        read(begin, bytes);
        table.push_back(crc64(bytes.subspan(page_begin(page) - begin)));
    }
    return table;
}

std::vector<Patch> FileUpdate::patches() const {
    std::vector<Patch> patches;
    for (const auto& [number, page] : pages_) {
        const std::uint64_t begin = number * page_bytes;
        const std::uint64_t size = page_end(number, old_size_) - begin;
        for (std::uint64_t at = 0; at < size; at += block_bytes) {
            if ((page.changed >> (at / block_bytes) & 1U) == 0) continue;
            const std::uint64_t count = std::min(block_bytes, size - at);
            patches.push_back({begin + at, std::span(page.bytes).subspan(at, count)});
        }
    }
    return patches;
}

std::uint64_t FileUpdate::bytes_to_write() const {
    if (fresh_) return size_;
    return (size_ > old_size_ ? size_ - old_size_ : 0) + pages_.size() * page_bytes;
}

void FileUpdate::commit() {
    rethrow_fault();
    if (old_) clear_old_table();
    const PageTable table = new_table();
    const Seal seal = make_seal(kind_, size_, table);
    file_size_ = seal.file_size();
    put(size_, std::as_bytes(std::span(table)));
    put(0, seal_block(kind_, seal));
    if (fresh_) {
        copy(fresh_->file(), std::min(old_size_, file_size_));
        fresh_->file().resize(file_size_);
        fresh_->commit();
    } else {
        commit_in_place(seal.identity);
    }
    committed_ = true;
}

void FileUpdate::commit_in_place(std::uint64_t identity) {
    const FileDescriptor& file = old_->file();
    file.sync();
    const Journal journal{
        .from = old_->seal().identity, .to = identity, .file_size = file_size_, .patches = patches()};
    write_journal(path_, journal);
    if (file.lock(FileDescriptor::Lock::exclusive, patience) == FileDescriptor::Locked::yes) {
        committed_ = true;  // from here on the journal leads to the new content, not back
        apply_journal(file, journal);
        file.unlock();
        file.sync();
    } else {
        try {
            FileReplacement fresh(path_);
            copy(fresh.file(), file_size_);
            fresh.commit();
        } catch (...) {
            remove_journal(path_);
            throw;
        }
    }
    remove_journal(path_);
}

void FileUpdate::copy(const FileDescriptor& to, std::uint64_t end) {
    std::vector<std::byte> buffer(copied_at_once);
    for (std::uint64_t at = 0; at < end; at += copied_at_once) {
        const std::span<std::byte> bytes =
            std::span(buffer).first(std::min<std::uint64_t>(copied_at_once, end - at));
        read(at, bytes);
        to.write_at(at, bytes);
    }
}

}  // namespace riffle::inline output
