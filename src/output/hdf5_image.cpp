#include "output/hdf5_image.hpp"

#include <atomic>
#include <string>
#include <vector>

namespace riffle {
namespace {

constexpr std::size_t growth_step = std::size_t{1} << 20U;

Hdf5Handle access_properties() {
    silence_hdf5();
    Hdf5Handle access(H5Pcreate(H5P_FILE_ACCESS), H5Pclose, "make file access properties");
    // Objects with checksummed metadata; readable by HDF5 1.8 and later.
    hdf5_check(H5Pset_libver_bounds(access.get(), H5F_LIBVER_V18, H5F_LIBVER_V18), "set the HDF5 version");
    // A results file is only ever replaced as a whole, so that readers and the writer need no locks.
    hdf5_check(H5Pset_file_locking(access.get(), false, true), "switch off file locking");
    return access;
}

Hdf5Handle memory_properties() {
    Hdf5Handle access = access_properties();
    hdf5_check(H5Pset_fapl_core(access.get(), growth_step, false), "set up a file in memory");
    return access;
}

/// The library takes two files in memory of the same name for one file.
std::string unique_name() {
    static std::atomic<unsigned long> counter = 0;
    return "riffle-in-memory-" + std::to_string(counter++);
}

}  // namespace

Hdf5Handle create_hdf5_in_memory(std::size_t user_block) {
    const Hdf5Handle access = memory_properties();
    const Hdf5Handle creation(H5Pcreate(H5P_FILE_CREATE), H5Pclose, "make file creation properties");
    hdf5_check(H5Pset_userblock(creation.get(), user_block), "set the size of the user block");
    return {H5Fcreate(unique_name().c_str(), H5F_ACC_TRUNC, creation.get(), access.get()), H5Fclose,
            "create an HDF5 file in memory"};
}

Hdf5Handle load_hdf5_into_memory(const std::filesystem::path& path) {
    const Hdf5Handle access = memory_properties();
    return {H5Fopen(path.c_str(), H5F_ACC_RDWR, access.get()), H5Fclose, "open as HDF5"};
}

Hdf5Handle open_hdf5_bytes(std::span<const std::byte> bytes) {
    const Hdf5Handle access = memory_properties();
    std::vector<std::byte> copy(bytes.begin(), bytes.end());
    hdf5_check(H5Pset_file_image(access.get(), copy.data(), copy.size()), "hand over the content");
    return {H5Fopen(unique_name().c_str(), H5F_ACC_RDONLY, access.get()), H5Fclose, "open as HDF5"};
}

Hdf5Handle open_hdf5_for_reading(const std::filesystem::path& path) {
    const Hdf5Handle access = access_properties();
    return {H5Fopen(path.c_str(), H5F_ACC_RDONLY, access.get()), H5Fclose, "open as HDF5"};
}

std::span<const std::byte> hdf5_image(const Hdf5Handle& file) {
    hdf5_check(H5Fflush(file.get(), H5F_SCOPE_GLOBAL), "complete the HDF5 file");
    // H5Fget_file_image serves for the size only: for this version of the format, HDF5 1.10 clears a flag in
    // the copy that it gives, and leaves the checksum of the header as it was.
    const auto size = hdf5_check(H5Fget_file_image(file.get(), nullptr, 0), "size the HDF5 file");
    void* memory = nullptr;
    hdf5_check(H5Fget_vfd_handle(file.get(), memory_properties().get(), &memory), "get the HDF5 file");
    const Hdf5Handle creation(H5Fget_create_plist(file.get()), H5Pclose, "get file creation properties");
    hsize_t user_block = 0;
    hdf5_check(H5Pget_userblock(creation.get(), &user_block), "get the size of the user block");
    const auto* start = *static_cast<const std::byte**>(memory);
    return {start + user_block, static_cast<std::size_t>(size)};
}

}  // namespace riffle
