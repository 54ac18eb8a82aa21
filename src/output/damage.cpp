#include "output/damage.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <functional>
#include <memory>
#include <optional>

#include "output/hdf5_driver.hpp"
#include "output/hdf5_objects.hpp"
#include "output/hdf5_types.hpp"
#include "output/sealed_reader.hpp"

namespace riffle::inline output {
namespace {

/// A sealed file that is looked through although parts of it cannot be read.
class Survey {
  public:
    Survey(std::filesystem::path path, SealKind kind, const std::vector<std::uint64_t>& pages)
        : path_(std::move(path)), kind_(kind), pages_(pages) {}

    /// The damaged parts, in words.
    std::vector<std::string> parts() {
        if (open()) look_into("/");
        return std::move(parts_);
    }

  private:
    bool open() {
        file_.reset();
        store_ = std::make_unique<SealedReader>(path_, kind_);
        try {
            file_ = open_hdf5(*store_, false);
            return true;
        } catch (const Hdf5Failure&) {
            parts_.emplace_back("the head of the file, and with it the way to all of its content");
            return false;
        }
    }

    /// Do something with the file; whether it could be done. A store with a fault is of no more use.
    bool attempt(const std::function<void()>& f) {
        try {
            f();
            if (!store_->has_fault()) return true;
        } catch (const Hdf5Failure&) {
        }
        open();
        return false;
    }

    void look_into(const std::string& group) {
        std::vector<std::string> names;
        if (!attempt([&] { names = hdf5_children(file_, group); })) {
            parts_.push_back(fmt::format("all of {}", group));
            return;
        }
        if (!attempt([&] { read_attributes(group); })) parts_.push_back("attributes of " + group);
        for (const std::string& name : names) {
            const std::string path = (group == "/" ? "" : group) + "/" + name;
            bool is_group = false;
            if (!attempt([&] { is_group = hdf5_is_group(file_, path); })) {
                parts_.push_back(path);
            } else if (is_group) {
                look_into(path);
            } else if (!attempt([&] { look_at(path); })) {
                parts_.push_back(path);
            }
        }
    }

    void read_attributes(const std::string& path) {
        for (const std::string& name : hdf5_attribute_names(file_, path)) {
            (void)read_hdf5_attribute(file_, path, name);
        }
    }

    /// Whether bytes of the file lie in damaged pages.
    [[nodiscard]] bool is_damaged(haddr_t at, hsize_t size) const {
        // The library leaves the seal out of the places of chunks, or does not (HDF5 1.10 to 1.14).
        const std::uint64_t first = at / page_bytes;
        const std::uint64_t last = (at + size + seal_bytes) / page_bytes;
        const auto page = std::lower_bound(pages_.begin(), pages_.end(), first);
        return page != pages_.end() && *page <= last;
    }

    void look_at(const std::string& path) {
        const Hdf5Handle dataset(H5Dopen2(file_.get(), path.c_str(), H5P_DEFAULT), H5Dclose, "open " + path);
        const Hdf5Handle properties(H5Dget_create_plist(dataset.get()), H5Pclose,
                                    "read the layout of " + path);
        read_attributes(path);
        if (H5Pget_layout(properties.get()) == H5D_CHUNKED) {
            look_at_chunks(dataset, properties, path);
            return;
        }
        const haddr_t at = H5Dget_offset(dataset.get());
        if (at != HADDR_UNDEF && is_damaged(at, H5Dget_storage_size(dataset.get()))) parts_.push_back(path);
    }

    void look_at_chunks(const Hdf5Handle& dataset, const Hdf5Handle& properties, const std::string& path) {
        const std::vector<std::size_t> shape = hdf5_shape(file_, path);
        std::vector<hsize_t> chunk(shape.size());
        hdf5_check(H5Pget_chunk(properties.get(), static_cast<int>(chunk.size()), chunk.data()),
                   "read the chunks of " + path);
        std::optional<std::pair<std::size_t, std::size_t>> rows;  // damaged, not yet told
        const auto tell = [&] {
            if (rows) parts_.push_back(fmt::format("rows {} to {} of {}", rows->first, rows->second, path));
        };
        std::vector<hsize_t> place(shape.size(), 0);
        for (place[0] = 0; place[0] < shape[0]; place[0] += chunk[0]) {
            if (!has_damaged_chunk(dataset, place, shape, chunk)) continue;
            const std::size_t last = std::min<std::size_t>(place[0] + chunk[0], shape[0]) - 1;
            if (rows && rows->second + 1 == place[0]) {
                rows->second = last;
            } else {
                tell();
                rows.emplace(place[0], last);
            }
        }
        tell();
    }

    /// Whether one of the chunks that begin at this row is damaged.
    bool has_damaged_chunk(const Hdf5Handle& dataset, std::vector<hsize_t> place,
                           const std::vector<std::size_t>& shape, const std::vector<hsize_t>& chunk) const {
        while (true) {
            unsigned filters = 0;
            haddr_t at = HADDR_UNDEF;
            hsize_t size = 0;
            hdf5_check(H5Dget_chunk_info_by_coord(dataset.get(), place.data(), &filters, &at, &size),
                       "find a chunk");
            if (at != HADDR_UNDEF && is_damaged(at, size)) return true;
            std::size_t axis = place.size() - 1;
            while (axis > 0 && (place[axis] += chunk[axis]) >= shape[axis]) place[axis--] = 0;
            if (axis == 0) return false;
        }
    }

    std::filesystem::path path_;
    SealKind kind_;
    const std::vector<std::uint64_t>& pages_;
    std::unique_ptr<SealedReader> store_;
    Hdf5Handle file_;
    std::vector<std::string> parts_;
};

}  // namespace

std::string damage_text(const std::filesystem::path& path, SealKind kind,
                        const std::vector<std::uint64_t>& pages) {
    std::vector<std::string> parts = Survey(path, kind, pages).parts();
    std::string text = fmt::format("{} of its pages of {} KiB {} not fit {} checksum{}.", pages.size(),
                                   page_bytes >> 10U, pages.size() == 1 ? "does" : "do",
                                   pages.size() == 1 ? "its" : "their", pages.size() == 1 ? "" : "s");
    if (parts.empty()) return text + " All datasets are whole; what is damaged is unused space or an index.";
    constexpr std::size_t most = 12;
    const std::size_t more = parts.size() > most ? parts.size() - most : 0;
    parts.resize(parts.size() - more);
    return text + fmt::format(" Lost: {}{}; the rest is whole.", fmt::join(parts, ", "),
                              more > 0 ? fmt::format(" and {} more", more) : "");
}

}  // namespace riffle::inline output
