#include "output/hdf5_handle.hpp"

namespace riffle::inline output {

void silence_hdf5() {
    static const herr_t silenced = H5Eset_auto2(H5E_DEFAULT, nullptr, nullptr);
    hdf5_check(silenced, "set up the HDF5 library");
}

void throw_hdf5_failure(const std::string& action) {
    std::string reason;
    const auto keep_first = [](unsigned /*level*/, const H5E_error2_t* entry, void* data) -> herr_t {
        auto& text = *static_cast<std::string*>(data);
        if (text.empty() && entry->desc != nullptr) text = entry->desc;
        return 0;
    };
    H5Ewalk2(H5E_DEFAULT, H5E_WALK_UPWARD, keep_first, &reason);
    throw Hdf5Failure("cannot " + action + (reason.empty() ? "" : ": " + reason));
}

}  // namespace riffle::inline output
