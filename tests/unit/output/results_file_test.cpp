#include "output/results_file.hpp"

#include <fcntl.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <hdf5.h>
#include <sys/file.h>
#include <unistd.h>

#include <chrono>
#include <filesystem>
#include <random>
#include <stdexcept>
#include <string>
#include <thread>

#include "contents.hpp"
#include "messages.hpp"
#include "temporary_folder.hpp"

namespace riffle::results_file_test {
namespace {

using test::bytes_of;
using test::file_error_of;
using test::TemporaryFolder;
using test::wave;
using testing::ElementsAre;
using testing::HasSubstr;

Dataset series(const std::string& path, std::vector<double> values) {
    return {path, {values.size()}, std::move(values), "m/s", "a series", true};
}

Content snapshots(std::size_t first, std::size_t end) {
    Content content;
    for (std::size_t index = first; index < end; ++index) {
        const std::vector<float> pressure(5000, static_cast<float>(index));
        content.datasets.push_back({snapshot_group(index) + "/pressure", {5000}, pressure, "Pa", "pressure"});
        content.attributes.push_back({snapshot_group(index), "time", 0.5 * static_cast<double>(index)});
    }
    return content;
}

TEST(ResultsFile, IsCompressedAsAsked) {
    const TemporaryFolder folder;
    const std::vector<float> values(20000, 1.5F);
    std::vector<std::size_t> sizes;
    for (const int level : {0, 1, 9}) {
        Content content;
        content.compression = level;
        content.datasets.push_back({"/field", {2, 100, 100}, values, "1", "field", true});
        const auto path = folder / (std::to_string(level) + ".h5");
        ResultsFile::create(path, content, false);
        ResultsFile::update(path, content);
        sizes.push_back(std::filesystem::file_size(path));
        const ResultsReader reader(path);
        EXPECT_THAT(reader.shape("/field"), ElementsAre(4, 100, 100));
        EXPECT_EQ(reader.read_doubles("/field"), std::vector<double>(40000, 1.5));
    }
    EXPECT_GT(sizes[0], 40000 * sizeof(float));
    EXPECT_LT(sizes[1], sizes[0] / 10);  // of equal numbers little is left
    EXPECT_LE(sizes[2], sizes[1]);
}

TEST(ResultsFile, ReadsSomeOfTheRows) {
    const TemporaryFolder folder;
    std::vector<float> values(5000 * 3);
    for (std::size_t i = 0; i < values.size(); ++i) values[i] = static_cast<float>(i);
    Content content;
    content.datasets.push_back({"/surface/elevation", {5000, 3}, values, "m", "elevation", true});
    content.datasets.push_back({"/case/text", {}, std::string("title"), "1", "text"});
    ResultsFile::create(folder / "r.h5", content, false);
    const ResultsReader reader(folder / "r.h5");
    EXPECT_THAT(reader.shape("/surface/elevation"), ElementsAre(5000, 3));
    EXPECT_THAT(reader.read_rows("/surface/elevation", 4998, 2),
                ElementsAre(14994, 14995, 14996, 14997, 14998, 14999));
    EXPECT_THAT(reader.read_rows("/surface/elevation", 1, 3, 2), ElementsAre(3, 4, 5, 9, 10, 11, 15, 16, 17));
    EXPECT_THAT(reader.read_rows("/surface/elevation", 4999, 1, 100), ElementsAre(14997, 14998, 14999));
    EXPECT_TRUE(reader.read_rows("/surface/elevation", 5000, 0).empty());
    EXPECT_THAT(file_error_of([&] { static_cast<void>(reader.read_rows("/surface/elevation", 4999, 2)); }),
                HasSubstr("rows"));
    EXPECT_THAT(file_error_of([&] { static_cast<void>(reader.read_rows("/case/text", 0, 1)); }),
                HasSubstr("not made of numbers"));
    EXPECT_THAT(file_error_of([&] { static_cast<void>(reader.shape("/nothing")); }), HasSubstr("has no"));
}

TEST(ResultsFile, GivesBackEachTypeShapeAndAttribute) {
    const TemporaryFolder folder;
    const Content content = test::state(3000, 1.0 / 3.0);
    ResultsFile::create(folder / "r.h5", content, false);
    const ResultsReader reader(folder / "r.h5");
    for (const Dataset& dataset : content.datasets) {
        EXPECT_TRUE(test::same(reader.read(dataset.path), dataset)) << dataset.path;
        EXPECT_EQ(reader.attribute(dataset.path, "units"), AttributeValue(dataset.unit));
        EXPECT_EQ(reader.attribute(dataset.path, "long_name"), AttributeValue(dataset.long_name));
    }
    for (const Attribute& attribute : content.attributes) {
        EXPECT_EQ(reader.attribute(attribute.path, attribute.name), attribute.value) << attribute.name;
    }
    EXPECT_EQ(reader.attribute("/", "format"), AttributeValue("riffle-results"));
    EXPECT_EQ(reader.attribute("/", "format_version"), AttributeValue(std::int64_t{results_format_version}));
    EXPECT_EQ(reader.attribute("/", "nothing"), std::nullopt);
    EXPECT_EQ(reader.attribute("/nowhere", "nothing"), std::nullopt);
    EXPECT_THAT(reader.children("/particles"), ElementsAre("density_deviation", "id", "position"));
    EXPECT_TRUE(reader.has("/particles/id"));
    EXPECT_FALSE(reader.has("/particles/id/deeper"));
    EXPECT_FALSE(reader.has("/nowhere/at/all"));
    EXPECT_THAT(reader.read_doubles("/random/state"), ElementsAre(0, 1, 254, 255));
    EXPECT_EQ(reader.read_string("/case/text"), "[channel]\nslope = 0.004 # ‰\n");
    EXPECT_THAT(test::names_in(folder.path()), ElementsAre("r.h5"));
}

TEST(ResultsFile, KeepsEmptyDatasetsTextsAndNotANumber) {
    const TemporaryFolder folder;
    const std::vector<double> odd = {std::nan(""), -0.0, std::numeric_limits<double>::infinity(), 5e-324};
    const Content content = {{{"/none", {0}, std::vector<double>{}, "1", ""},
                              {"/none3", {0, 3}, std::vector<float>{}, "1", ""},
                              {"/odd", {4}, odd, "", "odd"},
                              {"/series", {0, 2}, std::vector<double>{}, "1", "", true},
                              {"/text", {}, "", "", ""}},
                             {{"/", "empty", ""}}};
    ResultsFile::create(folder / "r.h5", content, false);
    ResultsFile::update(folder / "r.h5",
                        {{{"/series", {1, 2}, std::vector<double>{3, 4}, "1", "", true}}, {}});
    const ResultsReader reader(folder / "r.h5");
    for (const char* path : {"/none", "/none3", "/odd", "/text"}) {
        const auto expected = std::find_if(content.datasets.begin(), content.datasets.end(),
                                           [&](const Dataset& dataset) { return dataset.path == path; });
        EXPECT_TRUE(test::same(reader.read(path), *expected)) << path;
    }
    EXPECT_EQ(reader.read("/series").shape, (std::vector<std::size_t>{1, 2}));
    EXPECT_THAT(reader.read_doubles("/series"), ElementsAre(3, 4));
    EXPECT_EQ(reader.attribute("/", "empty"), AttributeValue(""));
}

TEST(ResultsFile, AppendsRowsInTheOrderOfTheUpdates) {
    const TemporaryFolder folder;
    ResultsFile::create(folder / "r.h5", {}, false);
    std::vector<double> all;
    std::vector<double> rows;
    for (const std::size_t count : {3U, 0U, 1U, 5000U, 7U}) {
        const std::vector<double> values = wave(count, static_cast<double>(all.size()));
        const std::vector<double> row_values = wave(count * 40, static_cast<double>(rows.size()));
        all.insert(all.end(), values.begin(), values.end());
        rows.insert(rows.end(), row_values.begin(), row_values.end());
        ResultsFile::update(folder / "r.h5",
                            {{series("/time_series/velocity", values),
                              {"/surface/elevation", {count, 40}, row_values, "m", "level", true}},
                             {}});
    }
    const ResultsReader reader(folder / "r.h5");
    EXPECT_EQ(reader.read_doubles("/time_series/velocity"), all);
    EXPECT_EQ(reader.read_doubles("/surface/elevation"), rows);
    EXPECT_EQ(reader.read("/surface/elevation").shape, (std::vector<std::size_t>{all.size(), 40}));
}

TEST(ResultsFile, ReplacesDatasetsAndAttributesWhateverTheyWere) {
    const TemporaryFolder folder;
    ResultsFile::create(folder / "r.h5",
                        {{{"/profiles/z", {10}, wave(10), "m", "height"}, {"/a", {}, "text", "1", "a"}},
                         {{"/summary", "converged", std::int64_t{0}}}},
                        false);
    ResultsFile::update(folder / "r.h5", {{{"/profiles/z", {10}, wave(10, 2), "mm", "new height"},
                                           {"/a", {2, 2}, std::vector<std::int32_t>{1, 2, 3, 4}, "m", "b"}},
                                          {{"/summary", "converged", "yes"}}});
    {
        const ResultsReader reader(folder / "r.h5");
        EXPECT_EQ(reader.read_doubles("/profiles/z"), wave(10, 2));
        EXPECT_EQ(reader.attribute("/profiles/z", "units"), AttributeValue("mm"));
        EXPECT_EQ(reader.attribute("/profiles/z", "long_name"), AttributeValue("new height"));
        EXPECT_EQ(reader.read("/a").shape, (std::vector<std::size_t>{2, 2}));
        EXPECT_EQ(reader.attribute("/summary", "converged"), AttributeValue("yes"));
    }
    ResultsFile::update(folder / "r.h5", {{{"/profiles/z", {3}, wave(3), "m", "height"}}, {}});
    EXPECT_EQ(ResultsReader(folder / "r.h5").read_doubles("/profiles/z"), wave(3));
}

TEST(ResultsFile, CutsRowsAndSnapshotsBeforeAppending) {
    const TemporaryFolder folder;
    Content content = snapshots(0, 12);
    content.datasets.push_back(series("/time_series/time", wave(5000)));
    content.datasets.push_back({"/surface/elevation", {6, 2}, wave(12), "m", "level", true});
    ResultsFile::create(folder / "r.h5", content, false);

    Content resumed = snapshots(9, 11);
    resumed.datasets.push_back(series("/time_series/time", {7, 8}));
    ResultsFile::update(folder / "r.h5", resumed,
                        {{"/time_series/time", 4100}, {"/surface/elevation", 2}, {"/time_series/new", 0}}, 9);
    const ResultsReader reader(folder / "r.h5");
    std::vector<double> expected = wave(5000);
    expected.resize(4100);
    expected.insert(expected.end(), {7, 8});
    EXPECT_EQ(reader.read_doubles("/time_series/time"), expected);
    EXPECT_EQ(reader.read_doubles("/surface/elevation"), wave(4));
    EXPECT_EQ(reader.children("/snapshots").size(), 11U);
    EXPECT_EQ(reader.attribute("/snapshots/00010", "time"), AttributeValue(5.0));
    EXPECT_FALSE(reader.has("/snapshots/00011"));
}

TEST(ResultsFile, RefusesToContinueWhereRowsAreMissing) {
    const TemporaryFolder folder;
    ResultsFile::create(folder / "r.h5", {{series("/time_series/time", wave(5))}, {}}, false);
    const std::string before = bytes_of(folder / "r.h5");
    const std::string message = file_error_of([&] {
        ResultsFile::update(folder / "r.h5", {}, {{"/time_series/time", 6}});
    });
    EXPECT_THAT(message, HasSubstr("r.h5"));
    EXPECT_THAT(message, HasSubstr("/time_series/time has only 5 rows, of which 6 are to be kept"));
    EXPECT_THAT(message, HasSubstr("untouched"));
    EXPECT_THAT(file_error_of([&] {
                    ResultsFile::update(folder / "r.h5", {}, {{"/time_series/none", 6}});
                }),
                HasSubstr("/time_series/none"));
    EXPECT_EQ(bytes_of(folder / "r.h5"), before);
}

TEST(ResultsFile, LeavesTheFileAsItWasWhenTheContentDoesNotFit) {
    const TemporaryFolder folder;
    ResultsFile::create(folder / "r.h5", {{series("/t", wave(5))}, {}}, false);
    const std::string before = bytes_of(folder / "r.h5");
    const std::vector<Dataset> wrong = {
        {"/t", {1}, std::vector<float>{1}, "m/s", "another type", true},
        {"/t", {1, 2}, std::vector<double>{1, 2}, "m/s", "wider rows", true},
        {"/a", {3}, std::vector<double>{1, 2}, "m/s", "too few values"},
        {"/a", {}, std::vector<double>{1}, "m/s", "no rows", true},
        {"/a", {}, "text", "m/s", "rows of text", true},
        {"/a", {}, std::string("a\0b", 3), "m/s", "zero byte"},
    };
    for (const Dataset& dataset : wrong) {
        const Content content = {{{"/fits", {1}, std::vector<double>{1}, "1", "fits"}, dataset}, {}};
        EXPECT_THROW(ResultsFile::update(folder / "r.h5", content), std::invalid_argument)
            << dataset.long_name;
    }
    EXPECT_EQ(bytes_of(folder / "r.h5"), before);
    EXPECT_THAT(test::names_in(folder.path()), ElementsAre("r.h5"));
}

TEST(ResultsFile, ReplacesAnExistingFileOnlyWhenAllowed) {
    const TemporaryFolder folder;
    ResultsFile::create(folder / "r.h5", {{{"/a", {}, "first", "", ""}}, {}}, false);
    const std::string message = file_error_of([&] { ResultsFile::create(folder / "r.h5", {}, false); });
    EXPECT_THAT(message, HasSubstr("exists already"));
    EXPECT_THAT(message, HasSubstr("riffle resume " + folder.path().string()));
    EXPECT_EQ(ResultsReader(folder / "r.h5").read_string("/a"), "first");
    ResultsFile::create(folder / "r.h5", {{{"/a", {}, "second", "", ""}}, {}}, true);
    EXPECT_EQ(ResultsReader(folder / "r.h5").read_string("/a"), "second");
}

TEST(ResultsFile, AReaderKeepsWhatItOpenedWhileTheFileIsUpdated) {
    const TemporaryFolder folder;
    ResultsFile::create(folder / "r.h5", {{series("/t", wave(5))}, {}}, false);
    const ResultsReader before(folder / "r.h5");
    ResultsFile::update(folder / "r.h5", {{series("/t", wave(7))}, {}});
    EXPECT_EQ(before.read_doubles("/t").size(), 5U);
    EXPECT_EQ(ResultsReader(folder / "r.h5").read_doubles("/t").size(), 12U);
}

TEST(ResultsFile, IsUpdatedAndReadWhileAnotherProgramHoldsALockOnIt) {
    const TemporaryFolder folder;
    ResultsFile::create(folder / "r.h5", {{series("/t", wave(5))}, {}}, false);
    const int other = ::open((folder / "r.h5").c_str(), O_RDONLY | O_CLOEXEC);
    ASSERT_EQ(::flock(other, LOCK_EX | LOCK_NB), 0);
    EXPECT_EQ(ResultsReader(folder / "r.h5").read_doubles("/t").size(), 5U);
    ResultsFile::update(folder / "r.h5", {{series("/t", wave(7))}, {}});
    EXPECT_EQ(ResultsReader(folder / "r.h5").read_doubles("/t").size(), 12U);
    ::close(other);
}

// At another second, too: HDF5 keeps times of creation in seconds unless told not to.
TEST(ResultsFile, EqualContentMakesEqualFiles) {
    const TemporaryFolder folder;
    for (const char* name : {"a.h5", "b.h5"}) {
        ResultsFile::create(folder / name, test::state(3000, 2.0), false);
        ResultsFile::update(folder / name, {{series("/on/the/way/t", wave(5))}, {}});
        std::this_thread::sleep_for(std::chrono::milliseconds(1100));
    }
    EXPECT_EQ(bytes_of(folder / "a.h5"), bytes_of(folder / "b.h5"));
}

TEST(ResultsFile, DoesNotGrowWithEachReplacement) {
    const TemporaryFolder folder;
    std::mt19937_64 random(1);
    const auto content = [&](std::size_t rows) {
        // Noise of varying roughness, so that the compressed size differs from update to update.
        std::vector<double> values(rows);
        const std::uint64_t mask = ~std::uint64_t{0} << (random() % 50);
        for (double& value : values) value = static_cast<double>(random() & mask);
        return Content{{{"/state", {rows}, values, "1", "state"}, series("/t", {1.0})}, {}};
    };
    ResultsFile::create(folder / "r.h5", content(40000), false);
    // So many that HDF5 stores them in another way, texts among them.
    Content attributes;
    for (int i = 0; i < 12; ++i) {
        attributes.attributes.push_back({"/group/inner", "number_" + std::to_string(i), 0.5 * i});
        attributes.attributes.push_back({"/group/inner", "text_" + std::to_string(i), std::string(i, 'x')});
    }
    ResultsFile::update(folder / "r.h5", attributes);
    for (int i = 0; i < 100; ++i) ResultsFile::update(folder / "r.h5", content(40000));
    // At most 320 kB of state, 1 MiB of unused space tolerated before the file is written anew, and what one
    // more update leaves unused. Without writing anew, 100 updates leave 5 MB.
    EXPECT_LT(std::filesystem::file_size(folder / "r.h5"), 320'000U * 2 + 1'100'000U);
    const ResultsReader reader(folder / "r.h5");
    EXPECT_EQ(reader.read_doubles("/t"), std::vector<double>(101, 1.0));
    for (const Attribute& attribute : attributes.attributes) {
        EXPECT_EQ(reader.attribute(attribute.path, attribute.name), attribute.value) << attribute.name;
    }
}

/// Properties of the storage, as HDF5 itself sees them.
TEST(ResultsFile, CompressesLargeArraysInChunksOfASensibleSize) {
    const TemporaryFolder folder;
    const std::vector<float> smooth(300'000 * 3, 1.5F);
    ResultsFile::create(folder / "r.h5",
                        {{series("/series", {1.0}),
                          {"/surface", {1, 5000}, wave(5000), "m", "level", true},
                          {"/wide", {1, 300'000}, wave(300'000), "m", "very wide", true},
                          {"/large", {300'000, 3}, smooth, "m", "position"},
                          {"/small", {10}, wave(10), "m", "profile"}},
                         {}},
                        false);
    const hid_t file = H5Fopen((folder / "r.h5").c_str(), H5F_ACC_RDONLY, H5P_DEFAULT);
    ASSERT_GE(file, 0);
    const auto chunk_of = [&](const char* path) {
        const hid_t dataset = H5Dopen2(file, path, H5P_DEFAULT);
        const hid_t properties = H5Dget_create_plist(dataset);
        std::vector<hsize_t> chunk(2, 0);
        if (H5Pget_layout(properties) == H5D_CHUNKED) {
            chunk.resize(static_cast<std::size_t>(H5Pget_chunk(properties, 2, chunk.data())));
            EXPECT_EQ(H5Pget_nfilters(properties), 2) << path;
            unsigned level = 0;
            std::size_t count = 1;
            unsigned flags = 0;
            EXPECT_GE(H5Pget_filter_by_id2(properties, H5Z_FILTER_DEFLATE, &flags, &count, &level, 0, nullptr,
                                           nullptr),
                      0);
            EXPECT_EQ(level, 4U);
        }
        H5Pclose(properties);
        H5Dclose(dataset);
        return chunk;
    };
    EXPECT_THAT(chunk_of("/series"), ElementsAre(2048));
    EXPECT_THAT(chunk_of("/surface"), ElementsAre(1, 2048));
    EXPECT_THAT(chunk_of("/wide"), ElementsAre(1, 2048));
    EXPECT_THAT(chunk_of("/large"), ElementsAre(21845, 3));
    EXPECT_THAT(chunk_of("/small"), ElementsAre(0, 0));  // not chunked
    H5Fclose(file);
    EXPECT_LT(std::filesystem::file_size(folder / "r.h5"), 300'000U * 8 + 500'000U);
}

}  // namespace
}  // namespace riffle::results_file_test
