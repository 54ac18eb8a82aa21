#pragma once

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <string>
#include <string_view>

#include "base/error.hpp"

namespace riffle::testing {

/// A file that lives as long as the object.
class LaboratoryFile {
  public:
    explicit LaboratoryFile(std::string_view text) {
        const auto* const test = ::testing::UnitTest::GetInstance()->current_test_info();
        static int count = 0;
        path_ =
            std::filesystem::path(::testing::TempDir()) /
            (std::string(test->test_suite_name()) + "." + test->name() + std::to_string(count++) + ".csv");
        std::ofstream(path_, std::ios::binary) << text;
    }
    ~LaboratoryFile() {
        std::error_code error;
        std::filesystem::remove(path_, error);
    }
    LaboratoryFile(const LaboratoryFile&) = delete;
    LaboratoryFile& operator=(const LaboratoryFile&) = delete;
    [[nodiscard]] const std::filesystem::path& path() const { return path_; }

  private:
    std::filesystem::path path_;
};

/// The message of the Error that a call throws; empty if it throws none.
template <class Call>
std::string message_of(Call call) {
    try {
        (void)call();
    } catch (const Error& error) {
        return error.what();
    }
    return {};
}

/// A file of cases/laboratory.
inline std::filesystem::path example(std::string_view name) {
    return std::filesystem::path(RIFFLE_SOURCE_DIR) / "cases" / "laboratory" / name;
}

}  // namespace riffle::testing
