// Writing HDF5 objects.

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <functional>
#include <numeric>
#include <stdexcept>

#include "output/hdf5_objects.hpp"
#include "output/hdf5_transfer.hpp"
#include "output/hdf5_types.hpp"

namespace riffle::inline output {
namespace {

constexpr std::size_t compress_from_bytes = std::size_t{16}
                                            << 10U;  // below it, compression saves less than it costs
constexpr std::size_t series_chunk_bytes = std::size_t{16}
                                           << 10U;  // 2048 rows of double: rewritten with each update
constexpr std::size_t array_chunk_bytes = std::size_t{256}
                                          << 10U;  // within the library's chunk cache of 1 MiB

std::vector<hsize_t> extents(const std::vector<std::size_t>& shape) { return {shape.begin(), shape.end()}; }

std::size_t count(const std::vector<std::size_t>& shape) {
    return std::accumulate(shape.begin(), shape.end(), std::size_t{1}, std::multiplies<>());
}

/// Chunks of as many whole rows as go into the wanted size; of parts of a row where one is larger than that.
std::vector<hsize_t> chunk_extents(const Dataset& dataset, std::size_t element_size) {
    std::vector<hsize_t> chunk = extents(dataset.shape);
    const std::size_t row =
        dataset.shape.empty() ? 1 : count({dataset.shape.begin() + 1, dataset.shape.end()});
    // Rows that are whole fields are read as such; those of a line grow by small chunks.
    const bool fields = dataset.shape.size() > 2 && row * element_size >= array_chunk_bytes;
    std::size_t room = (dataset.append && !fields ? series_chunk_bytes : array_chunk_bytes) / element_size;
    for (std::size_t axis = chunk.size(); axis-- > 1;) {
        chunk[axis] = std::clamp<hsize_t>(chunk[axis], 1, std::max<std::size_t>(room, 1));
        room /= static_cast<std::size_t>(chunk[axis]);
    }
    room = std::max<std::size_t>(room, 1);
    chunk[0] = dataset.append ? room : std::min<hsize_t>(chunk[0], room);
    return chunk;
}

Hdf5Handle creation_properties(const Dataset& dataset, std::size_t element_size, Hdf5Storage storage) {
    Hdf5Handle properties(H5Pcreate(H5P_DATASET_CREATE), H5Pclose, "make dataset properties");
    // Without times of creation, equal content makes equal files.
    hdf5_check(H5Pset_obj_track_times(properties.get(), false), "leave out times");
    const bool large = count(dataset.shape) * element_size >= compress_from_bytes;
    if (dataset.append || (storage.chunked && large && !dataset.shape.empty())) {
        const std::vector<hsize_t> chunk = chunk_extents(dataset, element_size);
        hdf5_check(H5Pset_chunk(properties.get(), static_cast<int>(chunk.size()), chunk.data()),
                   "set chunks");
        if (storage.compression > 0) {
            hdf5_check(H5Pset_shuffle(properties.get()), "set the shuffle filter");
            hdf5_check(H5Pset_deflate(properties.get(), static_cast<unsigned>(storage.compression)),
                       "set the compression");
        }
    }
    return properties;
}

Hdf5Handle link_properties() {
    Hdf5Handle properties(H5Pcreate(H5P_LINK_CREATE), H5Pclose, "make link properties");
    hdf5_check(H5Pset_char_encoding(properties.get(), H5T_CSET_UTF8), "set UTF-8");
    return properties;
}

/// Make a group, and those above it, where they are not there. Those that HDF5 makes on the way to an object
/// would hold the time of their creation, and equal content would not make equal files.
void make_groups(const Hdf5Handle& file, const std::string& path);

/// The groups that an object stands in.
void make_groups_above(const Hdf5Handle& file, const std::string& path) {
    const std::size_t end = path.rfind('/');
    if (end != std::string::npos) make_groups(file, path.substr(0, end));
}

void make_groups(const Hdf5Handle& file, const std::string& path) {
    if (path.empty() || hdf5_has(file, path)) return;
    make_groups_above(file, path);
    const Hdf5Handle links = link_properties();
    const Hdf5Handle properties(H5Pcreate(H5P_GROUP_CREATE), H5Pclose, "make group properties");
    hdf5_check(H5Pset_obj_track_times(properties.get(), false), "leave out times");
    const Hdf5Handle group(H5Gcreate2(file.get(), path.c_str(), links.get(), properties.get(), H5P_DEFAULT),
                           H5Gclose, "create the group " + path);
}

Hdf5Handle make_space(const Dataset& dataset) {
    if (dataset.shape.empty()) return {H5Screate(H5S_SCALAR), H5Sclose, "make a scalar"};
    const std::vector<hsize_t> shape = extents(dataset.shape);
    std::vector<hsize_t> maximum = shape;
    if (dataset.append) maximum[0] = H5S_UNLIMITED;
    return {H5Screate_simple(static_cast<int>(shape.size()), shape.data(), maximum.data()), H5Sclose,
            "make the shape"};
}

Hdf5Handle open_dataset(const Hdf5Handle& file, const std::string& path) {
    return {H5Dopen2(file.get(), path.c_str(), H5P_DEFAULT), H5Dclose, "open the dataset " + path};
}

std::vector<std::size_t> shape_in_file(const Hdf5Handle& dataset) {
    const Hdf5Handle space(H5Dget_space(dataset.get()), H5Sclose, "read the shape");
    const int rank = hdf5_check(H5Sget_simple_extent_ndims(space.get()), "read the number of axes");
    std::vector<hsize_t> shape(static_cast<std::size_t>(rank));
    hdf5_check(H5Sget_simple_extent_dims(space.get(), shape.data(), nullptr), "read the shape");
    return {shape.begin(), shape.end()};
}

/// The type of the values of a vector or stream.
template <class Values>
struct ElementOf;
template <class T>
struct ElementOf<std::vector<T>> {
    using Type = T;
};
template <class T>
struct ElementOf<StreamedValues<T>> {
    using Type = T;
};

template <class T>
bool has_type(const Hdf5Handle& dataset) {
    const Hdf5Handle type(H5Dget_type(dataset.get()), H5Tclose, "read the type");
    return H5Tequal(type.get(), hdf5_file_type<T>()) > 0;
}

template <class T>
Hdf5Handle create_dataset(const Hdf5Handle& file, const Dataset& dataset, Hdf5Storage storage) {
    make_groups_above(file, dataset.path);
    const Hdf5Handle links = link_properties();
    const Hdf5Handle properties = creation_properties(dataset, sizeof(T), storage);
    const Hdf5Handle space = make_space(dataset);
    return {H5Dcreate2(file.get(), dataset.path.c_str(), hdf5_file_type<T>(), space.get(), links.get(),
                       properties.get(), H5P_DEFAULT),
            H5Dclose, "create the dataset " + dataset.path};
}

template <class T, class Values>
void append_rows(const Hdf5Handle& file, const Dataset& dataset, const Values& values) {
    const Hdf5Handle target = open_dataset(file, dataset.path);
    std::vector<std::size_t> shape = shape_in_file(target);
    const bool rows_match = shape.size() == dataset.shape.size() && !shape.empty() &&
                            std::equal(shape.begin() + 1, shape.end(), dataset.shape.begin() + 1);
    if (!rows_match || !has_type<T>(target)) {
        throw std::invalid_argument(fmt::format(
            "{}: rows of shape [{}] cannot be added to a dataset of shape [{}] of another width or type",
            dataset.path, fmt::join(dataset.shape, ", "), fmt::join(shape, ", ")));
    }
    if (count_of(values) == 0) return;
    const std::size_t first = shape[0];
    shape[0] += dataset.shape[0];
    hdf5_check(H5Dset_extent(target.get(), extents(shape).data()), "lengthen the dataset " + dataset.path);
    write_rows(target, first, dataset.shape, values, dataset.path);
}

/// `Values`: a vector or a stream of T.
template <class T, class Values>
void write_values(const Hdf5Handle& file, const Dataset& dataset, const Values& values, Hdf5Storage storage) {
    if (count(dataset.shape) != count_of(values) || (dataset.append && dataset.shape.empty())) {
        throw std::invalid_argument(fmt::format("{}: {} values do not make the shape [{}]{}", dataset.path,
                                                count_of(values), fmt::join(dataset.shape, ", "),
                                                dataset.append ? " of rows" : ""));
    }
    Hdf5Handle target;
    if (hdf5_has(file, dataset.path)) {
        if (dataset.append) return append_rows<T>(file, dataset, values);
        if (!hdf5_is_group(file, dataset.path)) {
            Hdf5Handle present = open_dataset(file, dataset.path);
            if (has_type<T>(present) && shape_in_file(present) == dataset.shape) target = std::move(present);
        }
        if (target.get() < 0) remove_hdf5_object(file, dataset.path);
    }
    if (target.get() < 0) target = create_dataset<T>(file, dataset, storage);
    if (count_of(values) == 0) return;
    if (!dataset.shape.empty()) return write_rows(target, 0, dataset.shape, values, dataset.path);
    const T value = first_of(values);
    hdf5_check(H5Dwrite(target.get(), hdf5_memory_type<T>(), H5S_ALL, H5S_ALL, H5P_DEFAULT, &value),
               "write the dataset " + dataset.path);
}

/// The number of bytes of a text; an HDF5 text has one at least.
std::size_t text_bytes(const std::string& text, const std::string& where) {
    if (text.find('\0') != std::string::npos) {
        throw std::invalid_argument(where + ": a text must not contain a zero byte");
    }
    return std::max<std::size_t>(text.size(), 1);
}

void write_text(const Hdf5Handle& file, const Dataset& dataset, const std::string& text) {
    if (dataset.append) throw std::invalid_argument(dataset.path + ": a text cannot be appended to");
    const Hdf5Handle type = hdf5_text_type(text_bytes(text, dataset.path));
    if (hdf5_has(file, dataset.path)) remove_hdf5_object(file, dataset.path);
    const Hdf5Handle space(H5Screate(H5S_SCALAR), H5Sclose, "make a scalar");
    make_groups_above(file, dataset.path);
    const Hdf5Handle links = link_properties();
    const Hdf5Handle properties = creation_properties(Dataset(), 1, {});
    const Hdf5Handle target(H5Dcreate2(file.get(), dataset.path.c_str(), type.get(), space.get(), links.get(),
                                       properties.get(), H5P_DEFAULT),
                            H5Dclose, "create the text " + dataset.path);
    hdf5_check(H5Dwrite(target.get(), type.get(), H5S_ALL, H5S_ALL, H5P_DEFAULT, text.c_str()),
               "write the text " + dataset.path);
}

/// The attribute of an object if it is one value of this type, to be written anew in its place.
Hdf5Handle present_attribute(const Hdf5Handle& object, const std::string& name, hid_t file_type) {
    Hdf5Handle present(H5Aopen(object.get(), name.c_str(), H5P_DEFAULT), H5Aclose,
                       "open the attribute " + name);
    const Hdf5Handle type(H5Aget_type(present.get()), H5Tclose, "read the type of " + name);
    const Hdf5Handle space(H5Aget_space(present.get()), H5Sclose, "read the shape of " + name);
    const bool same =
        H5Tequal(type.get(), file_type) > 0 && H5Sget_simple_extent_type(space.get()) == H5S_SCALAR;
    return same ? std::move(present) : Hdf5Handle();
}

void put_attribute(const Hdf5Handle& object, const Attribute& attribute, hid_t file_type, hid_t memory_type,
                   const void* value) {
    const std::string where = attribute.name + " of " + attribute.path;
    Hdf5Handle target;
    if (hdf5_check(H5Aexists(object.get(), attribute.name.c_str()), "look for the attribute " + where) > 0) {
        target = present_attribute(object, attribute.name, file_type);
        if (target.get() < 0) {
            hdf5_check(H5Adelete(object.get(), attribute.name.c_str()), "replace the attribute " + where);
        }
    }
    if (target.get() < 0) {
        const Hdf5Handle space(H5Screate(H5S_SCALAR), H5Sclose, "make a scalar");
        target = {H5Acreate2(object.get(), attribute.name.c_str(), file_type, space.get(), H5P_DEFAULT,
                             H5P_DEFAULT),
                  H5Aclose, "create the attribute " + where};
    }
    hdf5_check(H5Awrite(target.get(), memory_type, value), "write the attribute " + where);
}

/// Copy the attributes of an object, and of all in it.
void copy_attributes(const Hdf5Handle& from, const Hdf5Handle& to, const std::string& path) {
    for (const std::string& name : hdf5_attribute_names(from, path)) {
        write_hdf5_attribute(to, {path, name, read_hdf5_attribute(from, path, name).value()});
    }
    if (!hdf5_is_group(from, path)) return;
    const std::string folder = path == "/" ? path : path + "/";
    for (const std::string& name : hdf5_children(from, path)) {
        std::string child = folder;
        child += name;
        copy_attributes(from, to, child);
    }
}

}  // namespace

Hdf5Handle hdf5_text_type(std::size_t bytes) {
    Hdf5Handle type(H5Tcopy(H5T_C_S1), H5Tclose, "make the text type");
    hdf5_check(H5Tset_size(type.get(), bytes), "set the text length");
    if (bytes != H5T_VARIABLE) hdf5_check(H5Tset_strpad(type.get(), H5T_STR_NULLPAD), "set the text's end");
    hdf5_check(H5Tset_cset(type.get(), H5T_CSET_UTF8), "set UTF-8");
    return type;
}

Hdf5Handle hdf5_variable_text_type() { return hdf5_text_type(H5T_VARIABLE); }

void write_hdf5_dataset(const Hdf5Handle& file, const Dataset& dataset, Hdf5Storage storage) {
    std::visit(
        [&](const auto& values) {
            using Values = std::decay_t<decltype(values)>;
            if constexpr (std::is_same_v<Values, std::string>) {
                write_text(file, dataset, values);
            } else {
                write_values<typename ElementOf<Values>::Type>(file, dataset, values, storage);
            }
        },
        dataset.values);
    write_hdf5_attribute(file, {dataset.path, "units", dataset.unit});
    write_hdf5_attribute(file, {dataset.path, "long_name", dataset.long_name});
}

void write_hdf5_attribute(const Hdf5Handle& file, const Attribute& attribute) {
    if (!hdf5_has(file, attribute.path)) make_groups(file, attribute.path);
    if (read_hdf5_attribute(file, attribute.path, attribute.name) == attribute.value) return;
    const Hdf5Handle object(H5Oopen(file.get(), attribute.path.c_str(), H5P_DEFAULT), H5Oclose,
                            "open " + attribute.path);
    if (const auto* number = std::get_if<double>(&attribute.value)) {
        put_attribute(object, attribute, H5T_IEEE_F64LE, H5T_NATIVE_DOUBLE, number);
    } else if (const auto* whole = std::get_if<std::int64_t>(&attribute.value)) {
        put_attribute(object, attribute, H5T_STD_I64LE, H5T_NATIVE_INT64, whole);
    } else {
        const std::string where = attribute.path + ", attribute " + attribute.name;
        const auto& text = std::get<std::string>(attribute.value);
        const Hdf5Handle type = hdf5_text_type(text_bytes(text, where));
        put_attribute(object, attribute, type.get(), type.get(), text.c_str());
    }
}

void cut_hdf5_rows(const Hdf5Handle& file, const std::string& path, std::size_t rows) {
    if (!hdf5_has(file, path)) {
        if (rows == 0) return;
        throw Hdf5Failure(fmt::format("it has no dataset {}, of which {} rows are to be kept", path, rows));
    }
    const Hdf5Handle dataset = open_dataset(file, path);
    std::vector<std::size_t> shape = shape_in_file(dataset);
    if (shape.empty() || shape[0] < rows) {
        throw Hdf5Failure(fmt::format("{} has only {} rows, of which {} are to be kept", path,
                                      shape.empty() ? 0 : shape[0], rows));
    }
    if (shape[0] == rows) return;
    shape[0] = rows;
    hdf5_check(H5Dset_extent(dataset.get(), extents(shape).data()), "shorten the dataset " + path);
}

void remove_hdf5_object(const Hdf5Handle& file, const std::string& path) {
    hdf5_check(H5Ldelete(file.get(), path.c_str(), H5P_DEFAULT), "remove " + path);
}

void copy_hdf5_content(const Hdf5Handle& from, const Hdf5Handle& to) {
    // H5Ocopy crashes on texts among more than eight attributes (HDF5 1.10 to 1.14.3, issue 2414 of HDF5):
    // the attributes are copied one by one.
    const Hdf5Handle bare(H5Pcreate(H5P_OBJECT_COPY), H5Pclose, "make copy properties");
    hdf5_check(H5Pset_copy_object(bare.get(), H5O_COPY_WITHOUT_ATTR_FLAG), "set copy properties");
    for (const std::string& name : hdf5_children(from, "/")) {
        hdf5_check(H5Ocopy(from.get(), name.c_str(), to.get(), name.c_str(), bare.get(), H5P_DEFAULT),
                   "copy /" + name);
    }
    copy_attributes(from, to, "/");
}

}  // namespace riffle::inline output
