#include "output/sealed_content.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cstring>
#include <utility>

#include "base/parallel.hpp"
#include "output/checksum.hpp"

namespace riffle::inline output {

SealedContent::SealedContent(FileDescriptor file, const std::filesystem::path& path, SealKind kind)
    : file_(std::move(file)) {
    find_journal(path, kind);
    SealBlock block = {};
    const std::size_t there = read_unchecked(0, block);
    seal_ = read_seal(kind, std::span(block).first(there));
    if (file_size() < seal_.file_size()) {
        throw NotWhole(fmt::format("is truncated: {} of {} bytes", file_size(), seal_.file_size()));
    }
    table_.resize(seal_.pages());
    const std::span<std::byte> bytes = std::as_writable_bytes(std::span(table_));
    if (read_unchecked(seal_.size, bytes) != bytes.size() || crc64(bytes) != seal_.table) {
        throw NotWhole("has been altered or damaged: its table of checksums does not fit its first line");
    }
    checked_.resize(table_.size());
}

void SealedContent::find_journal(const std::filesystem::path& path, SealKind kind) {
    std::optional<Journal> found = read_journal(path);
    if (!found) return;
    SealBlock block = {};
    const std::size_t there = read_unchecked(0, block);
    try {
        const Seal now = read_seal(kind, std::span(block).first(there));
        // Else it is left from another file of this name.
        if (now.identity != found->from && now.identity != found->to) return;
    } catch (const NotWhole&) {
        // Interrupted in the midst of the seal.
    }
    journal_ = std::move(found);
}

std::uint64_t SealedContent::file_size() const {
    return journal_ ? std::min(file_.size(), journal_->file_size) : file_.size();
}

std::size_t SealedContent::read_unchecked(std::uint64_t at, std::span<std::byte> bytes) const {
    const std::size_t there = file_.read_at(at, bytes);
    if (journal_) lay_over(journal_->patches, at, bytes.first(there));
    return there;
}

bool SealedContent::load(std::uint64_t page, std::span<std::byte> buffer) const {
    const std::uint64_t begin = page * page_bytes;
    const std::size_t size = page_end(page, seal_.size) - begin;
    if (read_unchecked(begin, buffer.first(size)) != size) return false;
    return crc64(buffer.first(size).subspan(page_begin(page) - begin)) == table_[page];
}

void SealedContent::read(std::uint64_t at, std::span<std::byte> bytes) {
    while (!bytes.empty() && at < seal_.size) {
        const std::uint64_t page = at / page_bytes;
        const std::uint64_t begin = page * page_bytes;
        const std::uint64_t end = page_end(page, seal_.size);
        const std::size_t count = std::min<std::uint64_t>(bytes.size(), end - at);
        if (checked_[page] && page_number_ != page) {
            if (read_unchecked(at, bytes.first(count)) != count) {
                throw NotWhole("has been truncated meanwhile");
            }
        } else {
            if (page_number_ != page) {
                page_number_.reset();
                page_.resize(page_bytes);
                if (!load(page, page_)) throw DamagedPage(page);
                page_number_ = page;
                checked_[page] = true;
            }
            std::memcpy(bytes.data(), &page_[at - begin], count);
        }
        bytes = bytes.subspan(count);
        at += count;
    }
    std::fill(bytes.begin(), bytes.end(), std::byte{0});
}

std::vector<std::uint64_t> SealedContent::damaged_pages() const {
    constexpr std::size_t pages_per_task = 64;
    std::vector<char> damaged(table_.size(), 0);
    parallel_blocks(table_.size(), pages_per_task, [&](std::size_t begin, std::size_t end) {
        std::vector<std::byte> buffer(page_bytes);
        for (std::size_t page = begin; page < end; ++page) damaged[page] = load(page, buffer) ? 0 : 1;
    });
    std::vector<std::uint64_t> pages;
    for (std::size_t page = 0; page < damaged.size(); ++page) {
        if (damaged[page] != 0) pages.push_back(page);
    }
    return pages;
}

}  // namespace riffle::inline output
