#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <hdf5.h>

#include <random>

#include "contents.hpp"
#include "messages.hpp"
#include "output/results_file.hpp"
#include "temporary_folder.hpp"

namespace riffle::results_errors_test {
namespace {

using test::file_error_of;
using test::TemporaryFolder;
using testing::AllOf;
using testing::HasSubstr;

class ResultsErrors : public testing::Test {
  protected:
    std::string error_of_reading(const std::string& name) const {
        const std::string message = file_error_of([&] { const ResultsReader reader(folder / name); });
        EXPECT_THAT(message, HasSubstr((folder / name).string()));
        return message;
    }
    TemporaryFolder folder;
};

/// An HDF5 file with some attributes, made without Riffle.
void make_foreign(const std::filesystem::path& path, const char* format, int version) {
    const hid_t file = H5Fcreate(path.c_str(), H5F_ACC_TRUNC, H5P_DEFAULT, H5P_DEFAULT);
    const hid_t space = H5Screate(H5S_SCALAR);
    if (format != nullptr) {
        const hid_t type = H5Tcopy(H5T_C_S1);
        H5Tset_size(type, 32);
        char text[32] = {};
        std::string(format).copy(text, 31);
        const hid_t attribute = H5Acreate2(file, "format", type, space, H5P_DEFAULT, H5P_DEFAULT);
        H5Awrite(attribute, type, text);
        H5Aclose(attribute);
        H5Tclose(type);
    }
    if (version > 0) {
        const hid_t attribute =
            H5Acreate2(file, "format_version", H5T_STD_I16BE, space, H5P_DEFAULT, H5P_DEFAULT);
        H5Awrite(attribute, H5T_NATIVE_INT, &version);
        H5Aclose(attribute);
    }
    H5Sclose(space);
    H5Fclose(file);
}

TEST_F(ResultsErrors, MissingFile) {
    EXPECT_THAT(error_of_reading("none.h5"),
                AllOf(HasSubstr("no such results file"), HasSubstr("riffle run")));
    const std::string message = file_error_of([&] { ResultsFile::update(folder / "none.h5", {}); });
    EXPECT_THAT(message, HasSubstr("no such results file"));
}

TEST_F(ResultsErrors, AFolder) {
    const std::string message = file_error_of([&] { const ResultsReader reader(folder.path()); });
    EXPECT_THAT(message, AllOf(HasSubstr("is a folder"), HasSubstr("results.h5")));
}

TEST_F(ResultsErrors, NotHdf5) {
    test::put_bytes(folder / "text.h5", "time,velocity\n0,1\n");
    EXPECT_THAT(error_of_reading("text.h5"), HasSubstr("not an HDF5 file"));
    test::put_bytes(folder / "empty.h5", "");
    EXPECT_THAT(error_of_reading("empty.h5"), HasSubstr("is truncated: it has only 0 bytes"));
}

TEST_F(ResultsErrors, TruncatedAnywhere) {
    ResultsFile::create(folder / "r.h5", test::state(2000, 1.0), false);
    const std::string whole = test::bytes_of(folder / "r.h5");
    for (std::size_t size = 8; size < whole.size(); size += 97) {
        test::put_bytes(folder / "cut.h5", whole.substr(0, size));
        EXPECT_THAT(error_of_reading("cut.h5"), AllOf(HasSubstr("is truncated"), HasSubstr("Restore it")));
    }
}

/// Results of several pages, with all that a file of a run has.
Content large_content() {
    Content content = test::state(20000, 1.0);
    std::vector<double> noise(30000);
    std::mt19937_64 random(1);
    for (double& value : noise) value = static_cast<double>(random());
    content.datasets.push_back({"/time_series/time", {noise.size()}, noise, "s", "time", true});
    content.datasets.push_back({"/surface/elevation", {300, 100}, noise, "m", "level", true});
    return content;
}

TEST_F(ResultsErrors, AnyAlteredBitIsFoundByVerifying) {
    ResultsFile::create(folder / "r.h5", large_content(), false);
    ResultsReader(folder / "r.h5").verify();
    const std::string whole = test::bytes_of(folder / "r.h5");
    std::mt19937_64 random(2);
    for (int trial = 0; trial < 300; ++trial) {
        std::string altered = whole;
        altered[random() % whole.size()] ^= static_cast<char>(1U << random() % 8);
        test::put_bytes(folder / "r.h5", altered);
        const std::string message = file_error_of([&] { ResultsReader(folder / "r.h5").verify(); });
        ASSERT_THAT(message, AllOf(HasSubstr((folder / "r.h5").string()), HasSubstr("damaged")));
        // What can be read without an error is as it was.
        try {
            const ResultsReader reader(folder / "r.h5");
            for (const char* path : {"/time_series/time", "/particles/position", "/case/text"}) {
                (void)reader.read(path);
            }
        } catch (const FileError&) {
        }
    }
}

TEST_F(ResultsErrors, WhatIsReadIsWholeOrAnError) {
    const Content content = large_content();
    ResultsFile::create(folder / "r.h5", content, false);
    const std::string whole = test::bytes_of(folder / "r.h5");
    std::mt19937_64 random(3);
    int refused = 0;
    int given = 0;
    for (int trial = 0; trial < 60; ++trial) {
        std::string altered = whole;
        altered[random() % whole.size()] ^= static_cast<char>(1U << random() % 8);
        test::put_bytes(folder / "r.h5", altered);
        for (const Dataset& expected : content.datasets) {
            try {
                EXPECT_TRUE(test::same(ResultsReader(folder / "r.h5").read(expected.path), expected));
                ++given;
            } catch (const FileError&) {
                ++refused;
            }
        }
    }
    EXPECT_GT(refused, 60);
    EXPECT_GT(given, 60);
}

TEST_F(ResultsErrors, TheDamagedRowsAreNamed) {
    ResultsFile::create(folder / "r.h5", large_content(), false);
    std::string bytes = test::bytes_of(folder / "r.h5");
    // The place of a chunk, as HDF5 itself tells it; the seal stands before it.
    const hid_t file = H5Fopen((folder / "r.h5").c_str(), H5F_ACC_RDONLY, H5P_DEFAULT);
    const hid_t dataset = H5Dopen2(file, "/surface/elevation", H5P_DEFAULT);
    const hsize_t row[2] = {160, 0};  // chunks of 20 rows of 100 values
    unsigned filters = 0;
    haddr_t at = 0;
    hsize_t size = 0;
    ASSERT_GE(H5Dget_chunk_info_by_coord(dataset, row, &filters, &at, &size), 0);
    H5Dclose(dataset);
    H5Fclose(file);
    bytes[at + size / 2 + 512] ^= 1;
    test::put_bytes(folder / "r.h5", bytes);
    const std::string message = file_error_of([&] { ResultsReader(folder / "r.h5").verify(); });
    EXPECT_THAT(message,
                AllOf(HasSubstr("1 of its pages"), HasSubstr("Lost: "), HasSubstr(" of /surface/elevation"),
                      HasSubstr("the rest is whole"), testing::Not(HasSubstr("riffle verify"))));
    EXPECT_THAT(message, testing::Not(HasSubstr("/particles/position")));
}

TEST_F(ResultsErrors, Hdf5ButNotOfRiffle) {
    make_foreign(folder / "foreign.h5", nullptr, 0);
    EXPECT_THAT(error_of_reading("foreign.h5"),
                AllOf(HasSubstr("not a results file of Riffle"), HasSubstr("`format` is missing")));
    make_foreign(folder / "other.h5", "vtkhdf", 1);
    EXPECT_THAT(error_of_reading("other.h5"), HasSubstr("`format` is \"vtkhdf\""));
}

TEST_F(ResultsErrors, AnotherVersion) {
    make_foreign(folder / "new.h5", "riffle-results", results_format_version + 6);
    EXPECT_THAT(error_of_reading("new.h5"), AllOf(HasSubstr("format version 7"), HasSubstr("reads version 1"),
                                                  HasSubstr("newer Riffle")));
    EXPECT_THAT(file_error_of([&] { ResultsFile::update(folder / "new.h5", {}); }),
                HasSubstr("format version 7"));
    make_foreign(folder / "none.h5", "riffle-results", 0);
    EXPECT_THAT(error_of_reading("none.h5"), HasSubstr("format version unknown"));
}

TEST_F(ResultsErrors, ThingsTheFileDoesNotHave) {
    ResultsFile::create(folder / "r.h5", test::state(20, 1.0), false);
    const ResultsReader reader(folder / "r.h5");
    EXPECT_THAT(file_error_of([&] { (void)reader.read("/profiles/z"); }), HasSubstr("has no /profiles/z"));
    EXPECT_THAT(file_error_of([&] { (void)reader.children("/none"); }), HasSubstr("has no /none"));
    EXPECT_THAT(file_error_of([&] { (void)reader.read_string("/step"); }), HasSubstr("/step is not a text"));
    EXPECT_THAT(file_error_of([&] { (void)reader.read_doubles("/case/text"); }), HasSubstr("/case/text"));
    EXPECT_THAT(file_error_of([&] { (void)reader.read("/particles"); }), HasSubstr("/particles"));
    EXPECT_THAT(file_error_of([&] { (void)reader.children("/step"); }), HasSubstr("/step"));
}

TEST_F(ResultsErrors, FolderThatDoesNotExistOrIsNone) {
    EXPECT_THAT(file_error_of([&] { ResultsFile::create(folder / "no/r.h5", {}, false); }),
                AllOf(HasSubstr("cannot be created"), HasSubstr("No such file or directory"),
                      HasSubstr("does not exist")));
    test::put_bytes(folder / "file", "");
    EXPECT_THAT(file_error_of([&] { ResultsFile::create(folder / "file/r.h5", {}, false); }),
                AllOf(HasSubstr("cannot be created"), HasSubstr("Not a directory")));
}

}  // namespace
}  // namespace riffle::results_errors_test
