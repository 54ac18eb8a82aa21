#pragma once

#include <gtest/gtest.h>

#include <string>

#include "base/error.hpp"

namespace riffle::test {

/// The message of the FileError that `action` throws; a test failure if it throws none.
template <class Action>
std::string file_error_of(const Action& action) {
    try {
        action();
    } catch (const FileError& error) {
        EXPECT_EQ(error.code(), ExitCode::file_error);
        return error.what();
    }
    ADD_FAILURE() << "no FileError";
    return "";
}

}  // namespace riffle::test
