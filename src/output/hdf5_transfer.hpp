#pragma once

#include <algorithm>
#include <cstddef>
#include <span>
#include <string>
#include <vector>

#include "output/dataset.hpp"
#include "output/hdf5_handle.hpp"
#include "output/hdf5_types.hpp"

namespace riffle::inline output {

/// Bytes of streamed values that are made at a time.
inline constexpr std::size_t stream_block_bytes = std::size_t{1} << 20U;

/// Number of the values.
template <class T>
std::size_t count_of(const std::vector<T>& values) {
    return values.size();
}
template <class T>
std::size_t count_of(const StreamedValues<T>& values) {
    return values.count;
}

/// The first value.
template <class T>
T first_of(const std::vector<T>& values) {
    return values.front();
}
template <class T>
T first_of(const StreamedValues<T>& values) {
    T value = {};
    values.fill(0, {&value, 1});
    return value;
}

/// Write values into a box of a dataset that has at least one axis; they lie one behind the other. Throws
/// Hdf5Failure.
template <class T>
void write_box(const Hdf5Handle& target, const std::vector<hsize_t>& start,
               const std::vector<hsize_t>& lengths, std::span<const T> values, const std::string& path) {
    const Hdf5Handle space(H5Dget_space(target.get()), H5Sclose, "read the shape of " + path);
    hdf5_check(
        H5Sselect_hyperslab(space.get(), H5S_SELECT_SET, start.data(), nullptr, lengths.data(), nullptr),
        "choose the place in the dataset " + path);
    const Hdf5Handle memory(H5Screate_simple(static_cast<int>(lengths.size()), lengths.data(), nullptr),
                            H5Sclose, "make the shape of " + path);
    hdf5_check(
        H5Dwrite(target.get(), hdf5_memory_type<T>(), memory.get(), space.get(), H5P_DEFAULT, values.data()),
        "write the dataset " + path);
}

/// Write the rows of `shape` from row `first` on.
template <class T>
void write_rows(const Hdf5Handle& target, std::size_t first, const std::vector<std::size_t>& shape,
                const std::vector<T>& values, const std::string& path) {
    std::vector<hsize_t> start(shape.size(), 0);
    start[0] = first;
    write_box<T>(target, start, {shape.begin(), shape.end()}, values, path);
}

/// The same with values that are made block by block: boxes of as many whole lines, planes ... as a block
/// holds.
template <class T>
void write_rows(const Hdf5Handle& target, std::size_t first, const std::vector<std::size_t>& shape,
                const StreamedValues<T>& values, const std::string& path) {
    const std::size_t room = stream_block_bytes / sizeof(T);
    std::size_t axis = shape.size() - 1;  // along which a box is cut; those before are taken one by one
    std::size_t line = 1;                 // values of one step along it
    while (axis > 0 && line * shape[axis] <= room) line *= shape[axis--];
    const std::size_t most = std::max<std::size_t>(1, room / line);
    std::vector<hsize_t> start(shape.size(), 0);
    std::vector<hsize_t> lengths(shape.begin(), shape.end());
    std::fill_n(lengths.begin(), axis, 1);
    std::vector<T> block(std::min(values.count, most * line));
    start[0] = first;
    for (std::size_t done = 0; done < values.count; done += lengths[axis] * line) {
        // Where the values go on: the number of the first one, axis by axis.
        std::size_t rest = done / line;
        for (std::size_t k = axis + 1; k-- > 0;) {
            start[k] = rest % shape[k] + (k == 0 ? first : 0);
            rest /= shape[k];
        }
        lengths[axis] = std::min<hsize_t>(most, shape[axis] - (start[axis] - (axis == 0 ? first : 0)));
        const std::span<T> made = std::span(block).first(static_cast<std::size_t>(lengths[axis]) * line);
        values.fill(done, made);
        write_box<T>(target, start, lengths, made, path);
    }
}

}  // namespace riffle::inline output
