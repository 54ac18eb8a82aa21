#include "output/checkpoint_file.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <cstring>
#include <optional>

#include "base/error.hpp"
#include "output/checkpoint_write.hpp"
#include "output/checksum.hpp"
#include "output/hdf5_image.hpp"
#include "output/hdf5_objects.hpp"

namespace riffle {
namespace {

constexpr const char* previous_suffix = "-previous";
constexpr std::size_t user_block_size = 512;
using UserBlock = std::array<std::byte, user_block_size>;

/// Why a file is no whole checkpoint, as the end of a sentence that begins with its name.
class NotWhole : public std::runtime_error {
  public:
    using std::runtime_error::runtime_error;
};

/// The line of text that is the user block, filled up with zeros.
UserBlock make_user_block(std::span<const std::byte> rest) {
    const std::string line = fmt::format("riffle-checkpoint {} size {} crc64 {:016x}\n",
                                         checkpoint_format_version, rest.size(), crc64(rest));
    UserBlock block = {};
    std::memcpy(block.data(), line.data(), line.size());
    return block;
}

template <class Number>
std::optional<Number> number_after(std::string_view line, std::string_view word) {
    const std::size_t found = line.find(word);
    if (found == std::string_view::npos) return {};
    Number number = 0;
    const char* start = line.data() + found + word.size();
    const auto [end, error] = std::from_chars(start, line.data() + line.size(), number);
    if (error != std::errc() || end == start) return {};
    return number;
}

/// Throws NotWhole unless the file's user block is exactly what belongs to the rest of the file.
void verify(std::span<const std::byte> bytes) {
    if (bytes.size() < user_block_size) {
        throw NotWhole(fmt::format("is truncated: it has only {} bytes", bytes.size()));
    }
    const auto block = bytes.first(user_block_size);
    const auto rest = bytes.subspan(user_block_size);
    const UserBlock expected = make_user_block(rest);
    if (std::equal(block.begin(), block.end(), expected.begin())) return;

    std::string line(user_block_size, '\0');
    std::memcpy(line.data(), block.data(), block.size());
    line = line.substr(0, line.find('\n'));
    const auto version = number_after<int>(line, "riffle-checkpoint ");
    const auto size = number_after<std::size_t>(line, " size ");
    if (!version || !size) throw NotWhole("is not a checkpoint of Riffle, or its first line is damaged");
    if (*version != checkpoint_format_version) {
        throw NotWhole(
            fmt::format("has the checkpoint format version {}, this Riffle reads version {} (use the Riffle "
                        "that wrote it)",
                        *version, checkpoint_format_version));
    }
    if (rest.size() < *size) {
        throw NotWhole(fmt::format("is truncated: {} of {} bytes", bytes.size(), *size + user_block_size));
    }
    throw NotWhole("has been altered or damaged: its checksum does not fit its content");
}

void collect(const Hdf5Handle& file, const std::string& group, Content& content) {
    const auto collect_attributes = [&](const std::string& path, bool is_group) {
        for (const std::string& name : hdf5_attribute_names(file, path)) {
            if (!is_group && (name == "units" || name == "long_name")) continue;  // members of Dataset
            if (const auto value = read_hdf5_attribute(file, path, name)) {
                content.attributes.push_back({path, name, *value});
            }
        }
    };
    collect_attributes(group, true);
    for (const std::string& name : hdf5_children(file, group)) {
        const std::string path = (group == "/" ? "" : group) + "/" + name;
        if (hdf5_is_group(file, path)) {
            collect(file, path, content);
        } else {
            content.datasets.push_back(read_hdf5_dataset(file, path));
            collect_attributes(path, false);
        }
    }
}

/// Throws NotWhole, also when the file is missing or unreadable.
Content read_whole(const std::filesystem::path& path) {
    try {
        const std::vector<std::byte> bytes = read_file_bytes(path);
        verify(bytes);
        // The bytes that have been verified are the ones that are read.
        const Hdf5Handle file = open_hdf5_bytes(bytes);
        Content content;
        collect(file, "/", content);
        return content;
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

std::string time_text(const Content& content) {
    for (const Attribute& attribute : content.attributes) {
        const auto* time = std::get_if<double>(&attribute.value);
        if (attribute.path == "/" && attribute.name == "time" && time != nullptr) {
            return fmt::format(" (simulated time {:.6g} s)", *time);
        }
    }
    return "";
}

/// What the user can do without the checkpoint at `path`.
std::string way_on(const std::filesystem::path& path) {
    const bool is_previous = path.stem().string().ends_with(previous_suffix);
    const std::filesystem::path other = is_previous ? newest(path) : CheckpointFile::previous(path);
    const char* which = is_previous ? "newest" : "previous";
    std::string reason;
    try {
        const std::string time = time_text(read_whole(other));
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

}  // namespace

std::filesystem::path CheckpointFile::previous(const std::filesystem::path& path) {
    return path.parent_path() / (path.stem().string() + previous_suffix + path.extension().string());
}

void write_checkpoint(const std::filesystem::path& path, const Content& content,
                      const StepObserver& observer) {
    std::size_t size = 0;
    try {
        const Hdf5Handle file = create_hdf5_in_memory(user_block_size);
        for (const Dataset& dataset : content.datasets) write_hdf5_dataset(file, dataset, {});
        for (const Attribute& attribute : content.attributes) write_hdf5_attribute(file, attribute);
        const std::span<const std::byte> image = hdf5_image(file);
        const UserBlock block = make_user_block(image);
        size = block.size() + image.size();
        const std::array<std::span<const std::byte>, 2> parts = {block, image};
        replace_file(path, parts, {.keep_as = CheckpointFile::previous(path), .observer = observer});
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

void CheckpointFile::write(const std::filesystem::path& path, const Content& content) {
    write_checkpoint(path, content, {});
}

Content CheckpointFile::read(const std::filesystem::path& path) {
    try {
        return read_whole(path);
    } catch (const NotWhole& not_whole) {
        throw FileError(
            fmt::format("{}: the checkpoint {}. {}", path.string(), not_whole.what(), way_on(path)));
    }
}

}  // namespace riffle
