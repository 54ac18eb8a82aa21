#include "output/content_reader.hpp"

#include <fmt/format.h>

#include <utility>

#include "output/content_reader_impl.hpp"
#include "output/hdf5_objects.hpp"

namespace riffle::inline output {

bool ContentReader::Impl::has(const std::string& object) const {
    return told([&] {
        const bool found = hdf5_has(file, object);
        store->rethrow_fault();
        return found;
    });
}

void ContentReader::Impl::require(const std::string& object) const {
    if (has(object)) return;
    throw FileError(fmt::format("{}: has no {}. `h5ls -r` lists what it has.", path.string(), object));
}

ContentReader::ContentReader(std::unique_ptr<Impl> impl) : impl_(std::move(impl)) {}
ContentReader::~ContentReader() = default;
ContentReader::ContentReader(ContentReader&&) noexcept = default;
ContentReader& ContentReader::operator=(ContentReader&&) noexcept = default;

const std::filesystem::path& ContentReader::path() const { return impl_->path; }

bool ContentReader::has(const std::string& path) const { return impl_->has(path); }

std::vector<std::string> ContentReader::children(const std::string& group) const {
    impl_->require(group);
    return impl_->told([&] { return hdf5_children(impl_->file, group); });
}

bool ContentReader::is_group(const std::string& path) const {
    impl_->require(path);
    return impl_->told([&] { return hdf5_is_group(impl_->file, path); });
}

Dataset ContentReader::read(const std::string& path) const {
    impl_->require(path);
    return impl_->told([&] { return read_hdf5_dataset(impl_->file, path); });
}

std::vector<double> ContentReader::read_doubles(const std::string& path) const {
    impl_->require(path);
    return impl_->told([&] { return read_hdf5_doubles(impl_->file, path); });
}

std::string ContentReader::read_string(const std::string& path) const {
    Dataset dataset = read(path);
    if (auto* text = std::get_if<std::string>(&dataset.values)) return std::move(*text);
    throw FileError(fmt::format("{}: {} is not a text.", impl_->path.string(), path));
}

std::vector<std::size_t> ContentReader::shape(const std::string& path) const {
    impl_->require(path);
    return impl_->told([&] { return hdf5_shape(impl_->file, path); });
}

std::vector<double> ContentReader::read_rows(const std::string& path, std::size_t first, std::size_t count,
                                             std::size_t stride) const {
    impl_->require(path);
    return impl_->told([&] { return read_hdf5_rows(impl_->file, path, first, count, stride); });
}

std::optional<AttributeValue> ContentReader::attribute(const std::string& path,
                                                       const std::string& name) const {
    if (!has(path)) return {};
    return impl_->told([&] { return read_hdf5_attribute(impl_->file, path, name); });
}

std::vector<std::string> ContentReader::attribute_names(const std::string& path) const {
    impl_->require(path);
    return impl_->told([&] { return hdf5_attribute_names(impl_->file, path); });
}

}  // namespace riffle::inline output
