#pragma once

#include <stdexcept>
#include <string>

namespace riffle::inline base {

/// Exit status of the `riffle` command; documented in docs/user-guide.md.
enum class ExitCode : int {
    success = 0,
    run_failed = 1,  ///< the simulation stopped on a fault (a NaN, a particle outside the domain ...)
    bad_input = 2,   ///< command line or case file is wrong
    file_error = 3,  ///< a file is missing, unreadable, damaged, of another version, or the disk is full
};

/// An error with a message for the user: what is wrong, where, what was expected, what to do.
class Error : public std::runtime_error {
  public:
    Error(ExitCode code, const std::string& message) : std::runtime_error(message), code_(code) {}
    [[nodiscard]] ExitCode code() const { return code_; }

  private:
    ExitCode code_;
};

/// Wrong command line or case file.
class InputError : public Error {
  public:
    explicit InputError(const std::string& message) : Error(ExitCode::bad_input, message) {}
};

/// A file that cannot be read or written, or whose content is damaged.
class FileError : public Error {
  public:
    explicit FileError(const std::string& message) : Error(ExitCode::file_error, message) {}
};

/// The simulation cannot go on.
class RunError : public Error {
  public:
    explicit RunError(const std::string& message) : Error(ExitCode::run_failed, message) {}
};

}  // namespace riffle::inline base
