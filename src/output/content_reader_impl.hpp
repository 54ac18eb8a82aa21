#pragma once

#include <fmt/format.h>

#include <functional>
#include <memory>
#include <stdexcept>
#include <system_error>
#include <type_traits>

#include "base/error.hpp"
#include "output/byte_store.hpp"
#include "output/content_reader.hpp"
#include "output/hdf5_handle.hpp"
#include "output/seal.hpp"

namespace riffle::inline output {

/// An open file.
struct ContentReader::Impl {
    std::filesystem::path path;
    std::unique_ptr<ByteStore> store;  ///< outlives `file`
    Hdf5Handle file;
    /// What to do where the file turns out to be damaged.
    std::function<std::string()> way_on;

    /// Do `read`, telling its failure with the name of the file.
    template <class Read>
    auto told(const Read& read) const -> std::invoke_result_t<Read> {
        try {
            try {
                return read();
            } catch (const Hdf5Failure&) {
                store->rethrow_fault();
                throw;
            }
        } catch (const NotWhole& not_whole) {
            throw FileError(fmt::format("{}: {}. {}", path.string(), not_whole.what(), way_on()));
        } catch (const Hdf5Failure& failure) {
            throw FileError(fmt::format("{}: {}. The file is damaged, or not as this Riffle writes it.",
                                        path.string(), failure.what()));
        } catch (const std::length_error&) {  // of a vector
            throw FileError(fmt::format("{}: an array in it claims to be larger than any memory. {}",
                                        path.string(), way_on()));
        } catch (const std::system_error& error) {
            throw FileError(fmt::format("{}: cannot be read: {}.", path.string(), error.code().message()));
        }
    }

    [[nodiscard]] bool has(const std::string& object) const;
    void require(const std::string& object) const;
};

}  // namespace riffle::inline output
