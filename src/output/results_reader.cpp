#include <fmt/format.h>

#include <type_traits>
#include <utility>

#include "base/error.hpp"
#include "output/hdf5_objects.hpp"
#include "output/results_file.hpp"
#include "output/results_format.hpp"

namespace riffle {

struct ResultsReader::Impl {
    Impl(std::filesystem::path file_path, Hdf5Handle open_file)
        : path(std::move(file_path)), file(std::move(open_file)) {}

    std::filesystem::path path;
    Hdf5Handle file;

    /// Do `read`, telling its failure with the name of the file.
    template <class Read>
    auto told(const Read& read) const -> std::invoke_result_t<Read> {
        try {
            return read();
        } catch (const Hdf5Failure& failure) {
            throw FileError(fmt::format("{}: {}. The file is damaged, or not as this Riffle writes it.",
                                        path.string(), failure.what()));
        }
    }

    void require(const std::string& object) const {
        if (hdf5_has(file, object)) return;
        throw FileError(fmt::format("{}: has no {}. `h5ls -r` lists what it has.", path.string(), object));
    }
};

ResultsReader::ResultsReader(const std::filesystem::path& path)
    : impl_(std::make_unique<Impl>(path, open_results(path, ResultsAccess::read))) {}
ResultsReader::~ResultsReader() = default;
ResultsReader::ResultsReader(ResultsReader&&) noexcept = default;
ResultsReader& ResultsReader::operator=(ResultsReader&&) noexcept = default;

bool ResultsReader::has(const std::string& path) const { return hdf5_has(impl_->file, path); }

std::vector<std::string> ResultsReader::children(const std::string& group) const {
    impl_->require(group);
    return impl_->told([&] { return hdf5_children(impl_->file, group); });
}

Dataset ResultsReader::read(const std::string& path) const {
    impl_->require(path);
    return impl_->told([&] { return read_hdf5_dataset(impl_->file, path); });
}

std::vector<double> ResultsReader::read_doubles(const std::string& path) const {
    impl_->require(path);
    return impl_->told([&] { return read_hdf5_doubles(impl_->file, path); });
}

std::string ResultsReader::read_string(const std::string& path) const {
    Dataset dataset = read(path);
    if (auto* text = std::get_if<std::string>(&dataset.values)) return std::move(*text);
    throw FileError(fmt::format("{}: {} is not a text.", impl_->path.string(), path));
}

std::vector<std::size_t> ResultsReader::shape(const std::string& path) const {
    impl_->require(path);
    return impl_->told([&] { return hdf5_shape(impl_->file, path); });
}

std::vector<double> ResultsReader::read_rows(const std::string& path, std::size_t first, std::size_t count,
                                             std::size_t stride) const {
    impl_->require(path);
    return impl_->told([&] { return read_hdf5_rows(impl_->file, path, first, count, stride); });
}

std::optional<AttributeValue> ResultsReader::attribute(const std::string& path,
                                                       const std::string& name) const {
    if (!has(path)) return {};
    return impl_->told([&] { return read_hdf5_attribute(impl_->file, path, name); });
}

}  // namespace riffle
