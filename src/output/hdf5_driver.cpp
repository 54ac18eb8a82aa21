// A virtual file driver of the HDF5 library (H5FD_class_t).

#include "output/hdf5_driver.hpp"

#include <memory>
#include <string>

namespace riffle::inline output {

/// An open file, as the library has it.
struct Hdf5DriverFile {
    H5FD_t base = {};  ///< the library's part, which must be the first
    std::weak_ptr<ByteStore*> store;
    haddr_t end_of_allocation = 0;

    /// Do something with the store while it lives.
    template <class F>
    bool with_store(const F& f) const noexcept {
        const std::shared_ptr<ByteStore*> alive = store.lock();
        return alive != nullptr && (*alive)->attempt([&] { f(**alive); });
    }
};

namespace {

constexpr haddr_t largest_address = ~haddr_t{0} >> 1U;

/// What the file access properties hold.
struct DriverProperties {
    ByteStore* store;
};

Hdf5DriverFile& file_of(H5FD_t* file) { return *reinterpret_cast<Hdf5DriverFile*>(file); }
const Hdf5DriverFile& file_of(const H5FD_t* file) { return *reinterpret_cast<const Hdf5DriverFile*>(file); }

H5FD_t* driver_open(const char* /*name*/, unsigned flags, hid_t access, haddr_t /*limit*/) {
    const auto* const properties = static_cast<const DriverProperties*>(H5Pget_driver_info(access));
    if (properties == nullptr || properties->store == nullptr) return nullptr;
    auto file = std::make_unique<Hdf5DriverFile>();
    file->store = properties->store->reference();
    const bool made =
        (flags & H5F_ACC_TRUNC) == 0 || properties->store->attempt([&] { properties->store->resize(0); });
    return made ? &file.release()->base : nullptr;
}

herr_t driver_close(H5FD_t* file) {
    const std::unique_ptr<Hdf5DriverFile> closed(&file_of(file));
    return 0;
}

int driver_compare(const H5FD_t* a, const H5FD_t* b) { return a < b ? -1 : (a > b ? 1 : 0); }

herr_t driver_query(const H5FD_t* /*file*/, unsigned long* flags) {
    *flags = H5FD_FEAT_AGGREGATE_METADATA | H5FD_FEAT_ACCUMULATE_METADATA | H5FD_FEAT_DATA_SIEVE |
             H5FD_FEAT_AGGREGATE_SMALLDATA | H5FD_FEAT_DEFAULT_VFD_COMPATIBLE;
    return 0;
}

haddr_t driver_allocated(const H5FD_t* file, H5FD_mem_t /*type*/) { return file_of(file).end_of_allocation; }

herr_t driver_set_allocated(H5FD_t* file, H5FD_mem_t /*type*/, haddr_t end) {
    file_of(file).end_of_allocation = end;
    return 0;
}

haddr_t driver_end(const H5FD_t* file, H5FD_mem_t /*type*/) {
    haddr_t end = 0;
    file_of(file).with_store([&](const ByteStore& store) { end = store.size(); });
    return end;
}

herr_t driver_read(H5FD_t* file, H5FD_mem_t /*type*/, hid_t /*transfer*/, haddr_t at, std::size_t size,
                   void* buffer) {
    const bool done = file_of(file).with_store([&](ByteStore& store) {
        store.read(at, {static_cast<std::byte*>(buffer), size});
    });
    return done ? 0 : -1;
}

// What cannot be written fails when the store is committed: the library can neither write nor close a file
// after a failed write.
herr_t driver_write(H5FD_t* file, H5FD_mem_t /*type*/, hid_t /*transfer*/, haddr_t at, std::size_t size,
                    const void* buffer) {
    file_of(file).with_store([&](ByteStore& store) {
        store.write(at, {static_cast<const std::byte*>(buffer), size});
    });
    return 0;
}

herr_t driver_truncate(H5FD_t* file, hid_t /*transfer*/, hbool_t /*closing*/) {
    const haddr_t end = file_of(file).end_of_allocation;
    file_of(file).with_store([&](ByteStore& store) {
        if (store.size() != end) store.resize(end);
    });
    return 0;
}

hid_t driver() {
    static const hid_t registered = [] {
        static H5FD_class_t functions = {};
        functions.name = "riffle";
        functions.maxaddr = largest_address;
        functions.fc_degree = H5F_CLOSE_WEAK;
        functions.fapl_size = sizeof(DriverProperties);
        functions.open = driver_open;
        functions.close = driver_close;
        functions.cmp = driver_compare;
        functions.query = driver_query;
        functions.get_eoa = driver_allocated;
        functions.set_eoa = driver_set_allocated;
        functions.get_eof = driver_end;
        functions.read = driver_read;
        functions.write = driver_write;
        functions.truncate = driver_truncate;
        constexpr H5FD_mem_t map[] = H5FD_FLMAP_DICHOTOMY;
        std::copy(std::begin(map), std::end(map), functions.fl_map);
        return H5FDregister(&functions);
    }();
    return hdf5_check(registered, "set up Riffle's way to files");
}

Hdf5Handle access_properties(ByteStore& store) {
    silence_hdf5();
    Hdf5Handle access(H5Pcreate(H5P_FILE_ACCESS), H5Pclose, "make file access properties");
    // Objects with checksummed metadata; readable by HDF5 1.8 and later.
    hdf5_check(H5Pset_libver_bounds(access.get(), H5F_LIBVER_V18, H5F_LIBVER_V18), "set the HDF5 version");
    // The store looks after locks.
    hdf5_check(H5Pset_file_locking(access.get(), false, true), "switch off file locking");
    const DriverProperties properties{&store};
    hdf5_check(H5Pset_driver(access.get(), driver(), &properties), "choose Riffle's way to files");
    return access;
}

constexpr const char* file_name = "riffle";

}  // namespace

Hdf5Handle create_hdf5(ByteStore& store, std::size_t user_block) {
    const Hdf5Handle access = access_properties(store);
    const Hdf5Handle creation(H5Pcreate(H5P_FILE_CREATE), H5Pclose, "make file creation properties");
    hdf5_check(H5Pset_userblock(creation.get(), user_block), "set the size of the user block");
    // Of the root group; without times of creation, equal content makes equal files.
    hdf5_check(H5Pset_obj_track_times(creation.get(), false), "leave out times");
    return {H5Fcreate(file_name, H5F_ACC_TRUNC, creation.get(), access.get()), H5Fclose,
            "create an HDF5 file"};
}

Hdf5Handle open_hdf5(ByteStore& store, bool to_change) {
    const Hdf5Handle access = access_properties(store);
    return {H5Fopen(file_name, to_change ? H5F_ACC_RDWR : H5F_ACC_RDONLY, access.get()), H5Fclose,
            "open as HDF5"};
}

void close_hdf5(Hdf5Handle& file, const ByteStore& store) {
    const herr_t closed = file.close_now();
    store.rethrow_fault();
    hdf5_check(closed, "complete the HDF5 file");
}

}  // namespace riffle::inline output
