// Reading HDF5 objects.

#include <algorithm>
#include <type_traits>

#include "output/hdf5_objects.hpp"
#include "output/hdf5_types.hpp"

namespace riffle::inline output {
namespace {

/// An open dataset with its type and shape.
struct OpenDataset {
    OpenDataset(const Hdf5Handle& file, const std::string& path)
        : dataset(H5Dopen2(file.get(), path.c_str(), H5P_DEFAULT), H5Dclose, "open the dataset " + path),
          type(H5Dget_type(dataset.get()), H5Tclose, "read the type of " + path),
          space(H5Dget_space(dataset.get()), H5Sclose, "read the shape of " + path) {}

    [[nodiscard]] std::vector<std::size_t> shape(const std::string& path) const {
        const int rank = hdf5_check(H5Sget_simple_extent_ndims(space.get()), "read the shape of " + path);
        std::vector<hsize_t> lengths(static_cast<std::size_t>(rank));
        hdf5_check(H5Sget_simple_extent_dims(space.get(), lengths.data(), nullptr),
                   "read the shape of " + path);
        return {lengths.begin(), lengths.end()};
    }

    void require_numbers(const std::string& path) const {
        const H5T_class_t kind = H5Tget_class(type.get());
        if (kind != H5T_FLOAT && kind != H5T_INTEGER) {
            throw Hdf5Failure("the dataset " + path + " is not made of numbers");
        }
    }

    [[nodiscard]] std::size_t count() const {
        return static_cast<std::size_t>(
            hdf5_check(H5Sget_simple_extent_npoints(space.get()), "count the values"));
    }

    template <class T>
    [[nodiscard]] std::vector<T> values(const std::string& path) const {
        std::vector<T> result(count());
        if (result.empty()) return result;
        hdf5_check(
            H5Dread(dataset.get(), hdf5_memory_type<T>(), H5S_ALL, H5S_ALL, H5P_DEFAULT, result.data()),
            "read the dataset " + path);
        return result;
    }

    Hdf5Handle dataset;
    Hdf5Handle type;
    Hdf5Handle space;
};

Dataset::Values read_values(const OpenDataset& open, const std::string& path) {
    const std::size_t size = H5Tget_size(open.type.get());
    switch (H5Tget_class(open.type.get())) {
        case H5T_FLOAT:
            if (size <= sizeof(float)) return open.values<float>(path);
            return open.values<double>(path);
        case H5T_INTEGER:
            if (size == 1 && H5Tget_sign(open.type.get()) == H5T_SGN_NONE) {
                return open.values<std::uint8_t>(path);
            }
            if (size < 4 || (size == 4 && H5Tget_sign(open.type.get()) != H5T_SGN_NONE)) {
                return open.values<std::int32_t>(path);
            }
            return open.values<std::int64_t>(path);
        case H5T_STRING:
            if (open.count() != 1) break;
            return read_hdf5_text(open.type, open.space, [&](hid_t memory, void* buffer) {
                return H5Dread(open.dataset.get(), memory, H5S_ALL, H5S_ALL, H5P_DEFAULT, buffer);
            });
        default:
            break;
    }
    throw Hdf5Failure("the dataset " + path + " is neither numbers nor one text");
}

Hdf5Handle open_object(const Hdf5Handle& file, const std::string& path) {
    return {H5Oopen(file.get(), path.c_str(), H5P_DEFAULT), H5Oclose, "open " + path};
}

std::string text_attribute(const Hdf5Handle& file, const std::string& path, const std::string& name) {
    const std::optional<AttributeValue> value = read_hdf5_attribute(file, path, name);
    if (!value) return {};
    const auto* text = std::get_if<std::string>(&*value);
    return text == nullptr ? std::string() : *text;
}

herr_t collect_link(hid_t /*group*/, const char* name, const H5L_info_t* /*info*/, void* data) {
    static_cast<std::vector<std::string>*>(data)->emplace_back(name);
    return 0;
}

herr_t collect_attribute(hid_t /*object*/, const char* name, const H5A_info_t* /*info*/, void* data) {
    static_cast<std::vector<std::string>*>(data)->emplace_back(name);
    return 0;
}

}  // namespace

bool hdf5_has(const Hdf5Handle& file, const std::string& path) {
    // H5Lexists fails, rather than saying no, where a group on the way is missing: ask for each.
    for (std::size_t end = path.find('/', 1);; end = path.find('/', end + 1)) {
        const std::string part = path.substr(0, end);
        if (part.empty()) return false;
        if (part != "/" && H5Lexists(file.get(), part.c_str(), H5P_DEFAULT) <= 0) return false;
        if (end == std::string::npos) return true;
    }
}

bool hdf5_is_group(const Hdf5Handle& file, const std::string& path) {
    const Hdf5Handle object = open_object(file, path);
    return H5Iget_type(object.get()) == H5I_GROUP;
}

std::vector<std::string> hdf5_children(const Hdf5Handle& file, const std::string& group) {
    const Hdf5Handle open(H5Gopen2(file.get(), group.c_str(), H5P_DEFAULT), H5Gclose,
                          "open the group " + group);
    std::vector<std::string> names;
    hdf5_check(H5Literate(open.get(), H5_INDEX_NAME, H5_ITER_NATIVE, nullptr, collect_link, &names),
               "list the group " + group);
    std::sort(names.begin(), names.end());
    return names;
}

std::vector<std::string> hdf5_attribute_names(const Hdf5Handle& file, const std::string& path) {
    const Hdf5Handle object = open_object(file, path);
    std::vector<std::string> names;
    hdf5_check(H5Aiterate2(object.get(), H5_INDEX_NAME, H5_ITER_NATIVE, nullptr, collect_attribute, &names),
               "list the attributes of " + path);
    std::sort(names.begin(), names.end());
    return names;
}

Dataset read_hdf5_dataset(const Hdf5Handle& file, const std::string& path) {
    const OpenDataset open(file, path);
    Dataset result;
    result.path = path;
    const int rank = hdf5_check(H5Sget_simple_extent_ndims(open.space.get()), "read the shape of " + path);
    std::vector<hsize_t> shape(static_cast<std::size_t>(rank));
    std::vector<hsize_t> maximum(shape.size());
    hdf5_check(H5Sget_simple_extent_dims(open.space.get(), shape.data(), maximum.data()),
               "read the shape of " + path);
    result.shape.assign(shape.begin(), shape.end());
    result.append = !maximum.empty() && maximum[0] == H5S_UNLIMITED;
    result.values = read_values(open, path);
    result.unit = text_attribute(file, path, "units");
    result.long_name = text_attribute(file, path, "long_name");
    return result;
}

std::vector<double> read_hdf5_doubles(const Hdf5Handle& file, const std::string& path) {
    const OpenDataset open(file, path);
    open.require_numbers(path);
    return open.values<double>(path);
}

std::vector<std::size_t> hdf5_shape(const Hdf5Handle& file, const std::string& path) {
    return OpenDataset(file, path).shape(path);
}

std::vector<double> read_hdf5_rows(const Hdf5Handle& file, const std::string& path, std::size_t first,
                                   std::size_t count, std::size_t stride) {
    const OpenDataset open(file, path);
    open.require_numbers(path);
    const std::vector<std::size_t> shape = open.shape(path);
    if (shape.empty() || stride == 0 || (count > 0 && first + (count - 1) * stride >= shape[0])) {
        throw Hdf5Failure("the dataset " + path + " does not have the rows asked for");
    }
    if (count == 0) return {};
    std::vector<hsize_t> start(shape.size(), 0);
    std::vector<hsize_t> steps(shape.size(), 1);
    std::vector<hsize_t> counts(shape.begin(), shape.end());
    start[0] = first;
    steps[0] = stride;
    counts[0] = count;
    std::size_t values = 1;
    for (const hsize_t length : counts) values *= static_cast<std::size_t>(length);
    std::vector<double> result(values);
    if (result.empty()) return result;
    const Hdf5Handle part(H5Scopy(open.space.get()), H5Sclose, "select rows of " + path);
    hdf5_check(
        H5Sselect_hyperslab(part.get(), H5S_SELECT_SET, start.data(), steps.data(), counts.data(), nullptr),
        "select rows of " + path);
    const Hdf5Handle memory(H5Screate_simple(static_cast<int>(counts.size()), counts.data(), nullptr),
                            H5Sclose, "select rows of " + path);
    hdf5_check(
        H5Dread(open.dataset.get(), H5T_NATIVE_DOUBLE, memory.get(), part.get(), H5P_DEFAULT, result.data()),
        "read rows of " + path);
    return result;
}

std::optional<AttributeValue> read_hdf5_attribute(const Hdf5Handle& file, const std::string& path,
                                                  const std::string& name) {
    const std::string where = name + " of " + path;
    const Hdf5Handle object = open_object(file, path);
    if (hdf5_check(H5Aexists(object.get(), name.c_str()), "look for the attribute " + where) == 0) return {};
    const Hdf5Handle attribute(H5Aopen(object.get(), name.c_str(), H5P_DEFAULT), H5Aclose,
                               "open the attribute " + where);
    const Hdf5Handle type(H5Aget_type(attribute.get()), H5Tclose, "read the type of " + where);
    const Hdf5Handle space(H5Aget_space(attribute.get()), H5Sclose, "read the shape of " + where);
    if (H5Sget_simple_extent_npoints(space.get()) != 1) {
        throw Hdf5Failure("the attribute " + where + " is not one value");
    }
    switch (H5Tget_class(type.get())) {
        case H5T_FLOAT: {
            double value = 0;
            hdf5_check(H5Aread(attribute.get(), H5T_NATIVE_DOUBLE, &value), "read the attribute " + where);
            return value;
        }
        case H5T_INTEGER: {
            std::int64_t value = 0;
            hdf5_check(H5Aread(attribute.get(), H5T_NATIVE_INT64, &value), "read the attribute " + where);
            return value;
        }
        case H5T_STRING:
            return read_hdf5_text(type, space, [&](hid_t memory, void* buffer) {
                return H5Aread(attribute.get(), memory, buffer);
            });
        default:
            throw Hdf5Failure("the attribute " + where + " is neither a number nor a text");
    }
}

}  // namespace riffle::inline output
