#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <type_traits>

#include "output/hdf5_handle.hpp"

namespace riffle::inline output {

/// The type of an array element in memory.
template <class T>
hid_t hdf5_memory_type() {
    if constexpr (std::is_same_v<T, double>) return H5T_NATIVE_DOUBLE;
    if constexpr (std::is_same_v<T, float>) return H5T_NATIVE_FLOAT;
    if constexpr (std::is_same_v<T, std::int64_t>) return H5T_NATIVE_INT64;
    if constexpr (std::is_same_v<T, std::int32_t>) return H5T_NATIVE_INT32;
    if constexpr (std::is_same_v<T, std::uint8_t>) return H5T_NATIVE_UINT8;
}

/// The type of an array element in the file: the same on every machine.
template <class T>
hid_t hdf5_file_type() {
    if constexpr (std::is_same_v<T, double>) return H5T_IEEE_F64LE;
    if constexpr (std::is_same_v<T, float>) return H5T_IEEE_F32LE;
    if constexpr (std::is_same_v<T, std::int64_t>) return H5T_STD_I64LE;
    if constexpr (std::is_same_v<T, std::int32_t>) return H5T_STD_I32LE;
    if constexpr (std::is_same_v<T, std::uint8_t>) return H5T_STD_U8LE;
}

/// UTF-8 text of so many bytes. Texts of variable length lie apart in the file, where damage can lead the
/// library astray.
Hdf5Handle hdf5_text_type(std::size_t bytes);
/// UTF-8 text of variable length, as earlier files have it.
Hdf5Handle hdf5_variable_text_type();

/// Read a text of fixed or variable length by `read(memory type, buffer)`. Throws Hdf5Failure.
template <class Read>
std::string read_hdf5_text(const Hdf5Handle& type, const Hdf5Handle& space, const Read& read) {
    if (H5Tis_variable_str(type.get()) > 0) {
        const Hdf5Handle memory = hdf5_variable_text_type();
        char* text = nullptr;
        hdf5_check(read(memory.get(), &text), "read a text");
        std::string result = text == nullptr ? "" : text;
        H5Dvlen_reclaim(memory.get(), space.get(), H5P_DEFAULT, &text);
        return result;
    }
    std::string result(H5Tget_size(type.get()), '\0');
    hdf5_check(read(type.get(), result.data()), "read a text");
    return result.substr(0, result.find('\0'));
}

}  // namespace riffle::inline output
