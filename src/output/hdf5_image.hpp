#pragma once

#include <cstddef>
#include <filesystem>
#include <span>

#include "output/hdf5_handle.hpp"

namespace riffle {

/// A new HDF5 file in memory; the library never touches the disk, so that a full disk cannot leave it with
/// objects that it can neither write nor close. `user_block`: bytes before the file proper, 0 or a power of
/// two from 512. Throws Hdf5Failure.
[[nodiscard]] Hdf5Handle create_hdf5_in_memory(std::size_t user_block = 0);

/// A copy in memory, to be changed, of an HDF5 file on the disk. Throws Hdf5Failure.
[[nodiscard]] Hdf5Handle load_hdf5_into_memory(const std::filesystem::path& path);

/// The HDF5 file made of these bytes (user block included), for reading. Throws Hdf5Failure.
[[nodiscard]] Hdf5Handle open_hdf5_bytes(std::span<const std::byte> bytes);

/// An HDF5 file on the disk for reading; another process may rename a newer one over it. Throws Hdf5Failure.
[[nodiscard]] Hdf5Handle open_hdf5_for_reading(const std::filesystem::path& path);

/// The content of a file in memory as it has to stand on the disk, without the user block. All its objects
/// must be closed. Valid until the file is changed or closed. Throws Hdf5Failure.
[[nodiscard]] std::span<const std::byte> hdf5_image(const Hdf5Handle& file);

}  // namespace riffle
