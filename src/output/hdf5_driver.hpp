#pragma once

#include <cstddef>

#include "output/byte_store.hpp"
#include "output/hdf5_handle.hpp"

namespace riffle::inline output {

// HDF5 files whose bytes are those of a store. The store must live at least as long as the handle. Where a
// call of the library fails, the fault of the store is the reason, if it has one.

/// A new HDF5 file; `user_block`: bytes left free before it, 0 or a power of two from 512. Throws
/// Hdf5Failure.
[[nodiscard]] Hdf5Handle create_hdf5(ByteStore& store, std::size_t user_block);

/// An HDF5 file to be read, or changed too. Throws Hdf5Failure.
[[nodiscard]] Hdf5Handle open_hdf5(ByteStore& store, bool to_change);

/// Close a file, all of whose objects must be closed: what the library still holds goes to the store. Throws
/// the fault of the store, and Hdf5Failure.
void close_hdf5(Hdf5Handle& file, const ByteStore& store);

}  // namespace riffle::inline output
