#pragma once

#include <cstddef>
#include <cstdint>
#include <exception>
#include <memory>
#include <span>

namespace riffle::inline output {

/// What the HDF5 library takes for a file (hdf5_driver.hpp): bytes on the disk that are checked as they are
/// read, or changes that are not yet in their place. The functions throw; the driver keeps the first
/// exception as the fault of the store, since none may pass through the library.
class ByteStore {
  public:
    virtual ~ByteStore() = default;
    ByteStore(const ByteStore&) = delete;
    ByteStore& operator=(const ByteStore&) = delete;

    /// Bytes of the file.
    [[nodiscard]] virtual std::uint64_t size() const = 0;
    /// Read bytes of the file; those behind its end are zero.
    virtual void read(std::uint64_t at, std::span<std::byte> bytes) = 0;
    virtual void write(std::uint64_t at, std::span<const std::byte> bytes) = 0;
    virtual void resize(std::uint64_t size) = 0;

    /// Throw the fault of the store, if it had one. After a fault it reads nothing any more and takes what is
    /// written for nothing, so that the library can close the file.
    void rethrow_fault() const {
        if (fault_) std::rethrow_exception(fault_);
    }
    [[nodiscard]] bool has_fault() const { return fault_ != nullptr; }

    /// Do something with the store, keeping an exception as its fault; whether there is none.
    template <class F>
    bool attempt(const F& f) noexcept {
        if (fault_) return false;
        try {
            f();
        } catch (...) {
            fault_ = std::current_exception();
        }
        return fault_ == nullptr;
    }

  protected:
    ByteStore() = default;

  private:
    friend struct Hdf5DriverFile;
    std::exception_ptr fault_;
    /// Points to the store as long as it lives: the library keeps a file that it could not close.
    std::shared_ptr<ByteStore*> self_ = std::make_shared<ByteStore*>(this);

  public:
    /// For the driver.
    [[nodiscard]] std::weak_ptr<ByteStore*> reference() const { return self_; }
};

}  // namespace riffle::inline output
