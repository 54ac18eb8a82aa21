#include "output/checkpoint_file.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <hdf5.h>
#include <rapidcheck.h>

#include "contents.hpp"
#include "messages.hpp"
#include "temporary_folder.hpp"

namespace riffle::checkpoint_file_test {
namespace {

using test::bytes_of;
using test::file_error_of;
using test::put_bytes;
using test::TemporaryFolder;
using testing::AllOf;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::Not;

class Checkpoint : public testing::Test {
  protected:
    std::string error_of_reading(const std::filesystem::path& file) const {
        const std::string message = file_error_of([&] { (void)CheckpointFile::read(file); });
        EXPECT_THAT(message, HasSubstr(file.string()));
        return message;
    }
    TemporaryFolder folder;
    std::filesystem::path path = folder / "checkpoint.h5";
    std::filesystem::path previous = folder / "checkpoint-previous.h5";
};

TEST_F(Checkpoint, GivesBackTheStateToTheBit) {
    Content content = test::state(5000, 1.0 / 3.0);
    std::get<std::vector<double>>(content.datasets[1].values)[7] = -0.0;
    std::get<std::vector<double>>(content.datasets[1].values)[8] = std::nan("");
    std::get<std::vector<double>>(content.datasets[1].values)[9] = 5e-324;
    CheckpointFile::write(path, content);
    EXPECT_TRUE(test::same(CheckpointFile::read(path), content));
    EXPECT_THAT(test::names_in(folder.path()), ElementsAre("checkpoint.h5"));
}

TEST_F(Checkpoint, IsAnHdf5FileThatSaysWhatItIs) {
    CheckpointFile::write(path, test::state(10, 1.0));
    const std::string bytes = bytes_of(path);
    EXPECT_EQ(bytes.substr(0, 25), "riffle-checkpoint 2 size ");
    // Behind the HDF5 file, of one page of 64 KiB, stands its checksum.
    EXPECT_EQ(std::stoul(bytes.substr(25)), bytes.size() - 8);
    const hid_t file = H5Fopen(path.c_str(), H5F_ACC_RDONLY, H5P_DEFAULT);
    EXPECT_GE(file, 0);
    EXPECT_GT(H5Lexists(file, "/particles", H5P_DEFAULT), 0);
    H5Fclose(file);
}

TEST_F(Checkpoint, KeepsTheOneBefore) {
    EXPECT_EQ(CheckpointFile::previous(path), previous);
    EXPECT_EQ(CheckpointFile::previous("checkpoint.h5"), "checkpoint-previous.h5");
    for (const double time : {1.0, 2.0, 3.0}) CheckpointFile::write(path, test::state(10, time));
    EXPECT_TRUE(test::same(CheckpointFile::read(path), test::state(10, 3.0)));
    EXPECT_TRUE(test::same(CheckpointFile::read(previous), test::state(10, 2.0)));
    EXPECT_THAT(test::names_in(folder.path()), ElementsAre("checkpoint-previous.h5", "checkpoint.h5"));
}

TEST_F(Checkpoint, NamesThePreviousOneWhenTheNewestIsDamaged) {
    CheckpointFile::write(path, test::state(10, 12.5));
    CheckpointFile::write(path, test::state(10, 13.0));
    const std::string whole = bytes_of(path);
    const std::string way_on =
        "checkpoint-previous.h5 (simulated time 12.5 s) is whole; continue from it with: riffle resume " +
        folder.path().string() + " --from checkpoint-previous.h5";

    put_bytes(path, whole.substr(0, whole.size() - 1));
    EXPECT_THAT(error_of_reading(path), AllOf(HasSubstr("is truncated: " + std::to_string(whole.size() - 1) +
                                                        " of " + std::to_string(whole.size()) + " bytes"),
                                              HasSubstr(way_on)));
    put_bytes(path, whole.substr(0, 100));
    EXPECT_THAT(error_of_reading(path), AllOf(HasSubstr("is truncated"), HasSubstr(way_on)));
    put_bytes(path, "");
    EXPECT_THAT(error_of_reading(path), AllOf(HasSubstr("is truncated"), HasSubstr(way_on)));
    put_bytes(path, whole + "x");
    EXPECT_THAT(error_of_reading(path), AllOf(HasSubstr("altered or damaged"), HasSubstr(way_on)));
    std::string altered = whole;
    altered[whole.size() / 2] = static_cast<char>(altered[whole.size() / 2] ^ 1);
    put_bytes(path, altered);
    EXPECT_THAT(error_of_reading(path), AllOf(HasSubstr("altered or damaged"), HasSubstr(way_on)));
    put_bytes(path, std::string(2000, 'x'));
    EXPECT_THAT(error_of_reading(path), AllOf(HasSubstr("not a checkpoint of Riffle"), HasSubstr(way_on)));
    std::filesystem::remove(path);
    EXPECT_THAT(error_of_reading(path), AllOf(HasSubstr("does not exist"), HasSubstr(way_on)));
    std::filesystem::create_directory(path);
    EXPECT_THAT(error_of_reading(path), AllOf(HasSubstr("Is a directory"), HasSubstr(way_on)));
}

TEST_F(Checkpoint, DoesNotNameAPreviousOneThatIsDamagedToo) {
    CheckpointFile::write(path, test::state(10, 12.5));
    CheckpointFile::write(path, test::state(10, 13.0));
    put_bytes(path, bytes_of(path).substr(0, 1000));
    put_bytes(previous, bytes_of(previous).substr(0, 1000));
    EXPECT_THAT(error_of_reading(path),
                AllOf(HasSubstr("previous checkpoint"), HasSubstr("of no help either"),
                      HasSubstr("riffle run"), Not(HasSubstr("--from"))));
    std::filesystem::remove(previous);
    EXPECT_THAT(error_of_reading(path), AllOf(HasSubstr("it does not exist"), HasSubstr("riffle run")));
}

TEST_F(Checkpoint, NamesTheNewestWhenThePreviousOneIsDamaged) {
    CheckpointFile::write(path, test::state(10, 12.5));
    CheckpointFile::write(path, test::state(10, 13.0));
    put_bytes(previous, bytes_of(previous).substr(0, 1000));
    EXPECT_THAT(error_of_reading(previous),
                AllOf(HasSubstr("newest checkpoint"), HasSubstr("(simulated time 13 s) is whole"),
                      HasSubstr("riffle resume " + folder.path().string()), Not(HasSubstr("--from"))));
}

TEST_F(Checkpoint, NamesBothVersionsOfAnotherFormat) {
    CheckpointFile::write(path, test::state(10, 1.0));
    std::string bytes = bytes_of(path);
    put_bytes(path, bytes.replace(bytes.find(" 2 "), 3, " 4 "));
    EXPECT_THAT(error_of_reading(path), AllOf(HasSubstr("format version 4"), HasSubstr("reads version 2"),
                                              HasSubstr("use the Riffle that wrote it")));
}

TEST_F(Checkpoint, RefusesAnyAlteredBit) {
    CheckpointFile::write(path, test::state(50, 1.0));
    const std::string whole = bytes_of(path);
    EXPECT_TRUE(rc::check([&] {
        std::string altered = whole;
        const auto place = *rc::gen::inRange<std::size_t>(0, whole.size());
        const auto bit = *rc::gen::inRange(0, 8);
        altered[place] = static_cast<char>(altered[place] ^ (1 << bit));
        put_bytes(path, altered);
        RC_ASSERT_THROWS_AS((void)CheckpointFile::read(path), FileError);
    }));
    put_bytes(path, whole);
    EXPECT_TRUE(test::same(CheckpointFile::read(path), test::state(50, 1.0)));
}

TEST_F(Checkpoint, RefusesAnyAlteredBitOfItsFirstLineAndOfItsPadding) {
    CheckpointFile::write(path, test::state(5, 1.0));
    const std::string whole = bytes_of(path);
    for (std::size_t place = 0; place < 560; ++place) {
        for (int bit = 0; bit < 8; ++bit) {
            std::string altered = whole;
            altered[place] = static_cast<char>(altered[place] ^ (1 << bit));
            put_bytes(path, altered);
            ASSERT_THROW((void)CheckpointFile::read(path), FileError) << "byte " << place << ", bit " << bit;
        }
    }
}

TEST_F(Checkpoint, RefusesAnyCut) {
    CheckpointFile::write(path, test::state(50, 1.0));
    const std::string whole = bytes_of(path);
    EXPECT_TRUE(rc::check([&] {
        put_bytes(path, whole.substr(0, *rc::gen::inRange<std::size_t>(0, whole.size())));
        RC_ASSERT_THROWS_AS((void)CheckpointFile::read(path), FileError);
    }));
}

TEST_F(Checkpoint, GivesBackAnyState) {
    EXPECT_TRUE(rc::check([&] {
        const auto words =
            *rc::gen::container<std::vector<std::uint64_t>>(rc::gen::arbitrary<std::uint64_t>());
        const auto id = *rc::gen::arbitrary<std::vector<std::int64_t>>();
        const auto text = *rc::gen::container<std::string>(rc::gen::nonZero<char>());
        std::vector<double> values(words.size());
        for (std::size_t i = 0; i < words.size(); ++i) values[i] = std::bit_cast<double>(words[i]);
        const Content content = {{{"/a/id", {id.size()}, id, "1", "number"},
                                  {"/a/values", {values.size(), 1}, values, "m", "any bits"},
                                  {"/text", {}, text, "1", text}},
                                 {{"/", "time", 1.0}, {"/a", "text", text}}};
        CheckpointFile::write(path, content);
        RC_ASSERT(test::same(CheckpointFile::read(path), content));
    }));
}

}  // namespace
}  // namespace riffle::checkpoint_file_test
