#pragma once

#include <hdf5.h>

#include <stdexcept>
#include <string>
#include <utility>

namespace riffle::inline output {

/// A failed call of the HDF5 library; the message says what was tried and the library's own innermost reason.
class Hdf5Failure : public std::runtime_error {
  public:
    using std::runtime_error::runtime_error;
};

/// Stop the library from printing its error stack. To be called before its first use; cheap.
void silence_hdf5();

/// Throw Hdf5Failure saying "cannot <action>: <reason>" with the reason from the library's error stack.
[[noreturn]] void throw_hdf5_failure(const std::string& action);

/// Pass on the status or the identifier that an HDF5 call returned, or throw Hdf5Failure if it is negative.
template <class Result>
Result hdf5_check(Result result, const std::string& action) {
    if (result < 0) throw_hdf5_failure(action);
    return result;
}

/// Owner of an HDF5 identifier.
class Hdf5Handle {
  public:
    using Close = herr_t (*)(hid_t);

    Hdf5Handle() = default;
    Hdf5Handle(hid_t id, Close close, const std::string& action)
        : id_(hdf5_check(id, action)), close_(close) {}
    ~Hdf5Handle() { reset(); }
    Hdf5Handle(Hdf5Handle&& other) noexcept
        : id_(std::exchange(other.id_, H5I_INVALID_HID)), close_(other.close_) {}
    Hdf5Handle& operator=(Hdf5Handle&& other) noexcept {
        if (this != &other) {
            reset();
            id_ = std::exchange(other.id_, H5I_INVALID_HID);
            close_ = other.close_;
        }
        return *this;
    }
    Hdf5Handle(const Hdf5Handle&) = delete;
    Hdf5Handle& operator=(const Hdf5Handle&) = delete;

    [[nodiscard]] hid_t get() const { return id_; }
    void reset() { (void)close_now(); }
    /// Close, and say whether it went well: negative where not.
    herr_t close_now() { return id_ >= 0 ? close_(std::exchange(id_, H5I_INVALID_HID)) : 0; }

  private:
    hid_t id_ = H5I_INVALID_HID;
    Close close_ = nullptr;
};

}  // namespace riffle::inline output
