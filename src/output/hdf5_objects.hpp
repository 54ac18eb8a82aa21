#pragma once

#include <optional>
#include <string>
#include <vector>

#include "output/dataset.hpp"
#include "output/hdf5_handle.hpp"

namespace riffle::inline output {

/// How the values of a new dataset lie in the file.
struct Hdf5Storage {
    bool chunked = false;  ///< large arrays in chunks, not only those that grow
    int compression = 4;   ///< deflate level of chunks; 0: none
};

/// Write a dataset as it asks for: add its rows behind those in the file, or replace what the path holds (in
/// place where shape and type are the same). Makes the groups on the way, and the attributes `units` and
/// `long_name`. Throws Hdf5Failure, and std::invalid_argument when the values do not fit the shape, or
/// the rows do not fit those in the file.
void write_hdf5_dataset(const Hdf5Handle& file, const Dataset& dataset, Hdf5Storage storage);

/// Set an attribute; makes the group it belongs to if there is nothing at its path. Throws Hdf5Failure.
void write_hdf5_attribute(const Hdf5Handle& file, const Attribute& attribute);

/// Cut a dataset to so many rows. Throws Hdf5Failure, also when it has fewer.
void cut_hdf5_rows(const Hdf5Handle& file, const std::string& path, std::size_t rows);

/// Remove a dataset or a group with all in it. Throws Hdf5Failure.
void remove_hdf5_object(const Hdf5Handle& file, const std::string& path);

/// Copy everything from one file to an empty other one, leaving behind the space no longer used.
void copy_hdf5_content(const Hdf5Handle& from, const Hdf5Handle& to);

[[nodiscard]] bool hdf5_has(const Hdf5Handle& file, const std::string& path);
[[nodiscard]] bool hdf5_is_group(const Hdf5Handle& file, const std::string& path);

/// Names in a group, sorted.
[[nodiscard]] std::vector<std::string> hdf5_children(const Hdf5Handle& file, const std::string& group);

/// Names of the attributes of a group or dataset, sorted.
[[nodiscard]] std::vector<std::string> hdf5_attribute_names(const Hdf5Handle& file, const std::string& path);

/// Read a dataset. Floating-point types come as double or float, whole numbers as std::int64_t, std::int32_t
/// or std::uint8_t: the type of that size, or the next one that holds them. Throws Hdf5Failure.
[[nodiscard]] Dataset read_hdf5_dataset(const Hdf5Handle& file, const std::string& path);

/// Read a dataset of numbers of any type as doubles. Throws Hdf5Failure.
[[nodiscard]] std::vector<double> read_hdf5_doubles(const Hdf5Handle& file, const std::string& path);

/// Lengths of the axes of a dataset; empty for a scalar. Throws Hdf5Failure.
[[nodiscard]] std::vector<std::size_t> hdf5_shape(const Hdf5Handle& file, const std::string& path);

/// Read the rows `first`, `first + stride`, ... along the first axis, `count` of them, of a dataset of
/// numbers as doubles. Throws Hdf5Failure, also for rows beyond the last, a scalar, or a stride of zero.
[[nodiscard]] std::vector<double> read_hdf5_rows(const Hdf5Handle& file, const std::string& path,
                                                 std::size_t first, std::size_t count, std::size_t stride);

/// Read an attribute; nothing if there is none of this name. Throws Hdf5Failure.
[[nodiscard]] std::optional<AttributeValue> read_hdf5_attribute(const Hdf5Handle& file,
                                                                const std::string& path,
                                                                const std::string& name);

}  // namespace riffle::inline output
