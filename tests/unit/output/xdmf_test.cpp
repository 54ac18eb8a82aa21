#include "output/xdmf.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <sys/wait.h>

#include <cmath>
#include <cstdlib>
#include <limits>
#include <stdexcept>

#include "messages.hpp"
#include "output/results_file.hpp"
#include "temporary_folder.hpp"

namespace riffle::xdmf_test {
namespace {

using test::TemporaryFolder;
using testing::HasSubstr;

const std::vector<SnapshotField> fields = {
    {"position", 3, ElementType::float64},       {"velocity", 3, ElementType::float32},
    {"pressure", 1, ElementType::float32},       {"density", 1, ElementType::float64},
    {"eddy_viscosity", 1, ElementType::float32}, {"id", 1, ElementType::int64}};

template <class T>
std::vector<T> some_values(std::size_t count, double scale) {
    std::vector<T> values(count);
    for (std::size_t i = 0; i < count; ++i) {
        values[i] = static_cast<T>(scale * std::sin(1.0 + 0.7 * static_cast<double>(i)));
    }
    return values;
}

void add_snapshot(const SnapshotEntry& entry, Content& content) {
    const std::string group = snapshot_group(entry.index);
    const std::size_t n = entry.particles;
    const auto s = static_cast<double>(entry.index + 1);
    std::vector<std::int64_t> id(n);
    for (std::size_t i = 0; i < n; ++i) id[i] = static_cast<std::int64_t>((i * 7919) % n) + 5'000'000'000;
    content.datasets.push_back({group + "/position", {n, 3}, some_values<double>(3 * n, s), "m", "position"});
    content.datasets.push_back(
        {group + "/velocity", {n, 3}, some_values<float>(3 * n, s), "m/s", "velocity"});
    content.datasets.push_back({group + "/pressure", {n}, some_values<float>(n, 100 * s), "Pa", "pressure"});
    content.datasets.push_back({group + "/density", {n}, some_values<double>(n, s), "kg/m3", "density"});
    content.datasets.push_back(
        {group + "/eddy_viscosity", {n}, some_values<float>(n, s), "m2/s", "viscosity"});
    content.datasets.push_back({group + "/id", {n}, id, "1", "number"});
    content.attributes.push_back({group, "time", entry.time});
}

TEST(Xdmf, ParaviewReadersShowEachSnapshotAsItIsInTheResults) {
    const TemporaryFolder folder;
    // A number of particles that changes, times that are no short decimals, a first snapshot that is not 0,
    // and snapshots small and large enough to be stored plain and compressed.
    const std::vector<SnapshotEntry> snapshots = {
        {2, 1.0 / 3.0, 40}, {3, 0.7, 1}, {4, 0.8, 4001}, {5, 0.9, 40}, {12, 130.0 + 1e-9, 4001}};
    Content content;
    for (const SnapshotEntry& entry : snapshots) add_snapshot(entry, content);
    ResultsFile::create(folder / "results.h5", content, false);
    write_xdmf(folder / "results.xdmf", "results.h5", snapshots, fields);

    const std::string command =
        "/usr/bin/python3 " RIFFLE_SOURCE_DIR "/tests/end_to_end/check_xdmf.py " + folder.path().string();
    const int status = std::system(command.c_str());
    ASSERT_TRUE(WIFEXITED(status));
    if (WEXITSTATUS(status) == 77 || WEXITSTATUS(status) == 127) {
        GTEST_SKIP() << "needs the Debian packages python3-paraview and python3-h5py";
    }
    EXPECT_EQ(WEXITSTATUS(status), 0);
}

TEST(Xdmf, NamesTheDatasetsOfEachSnapshot) {
    const TemporaryFolder folder;
    write_xdmf(folder / "a.xdmf", "a<b>&.h5", {{7, 0.1, 3}}, fields);
    const std::string text = test::bytes_of(folder / "a.xdmf");
    for (const SnapshotField& field : fields) {
        EXPECT_THAT(text, HasSubstr("a&lt;b&gt;&amp;.h5:/snapshots/00007/" + field.name + "<"));
    }
    EXPECT_THAT(text, HasSubstr("Time Value=\"0.10000000000000001\""));
    EXPECT_THAT(text, HasSubstr("Dimensions=\"3 3\""));
}

// Where there was no water at first a topology is that of the first grid, not of the first snapshot.
TEST(Xdmf, CountsTheGridsThatAreThere) {
    const TemporaryFolder folder;
    write_xdmf(folder / "a.xdmf", "a.h5", {{0, 0.0, 0}, {1, 0.1, 0}, {2, 0.2, 3}, {3, 0.3, 3}}, fields);
    const std::string text = test::bytes_of(folder / "a.xdmf");
    EXPECT_THAT(text, HasSubstr("/Xdmf/Domain/Grid/Grid[1]/Topology"));
    EXPECT_THAT(text, ::testing::Not(HasSubstr("Grid[3]/Topology")));
}

TEST(Xdmf, RefusesFieldsThatMakeNoPoints) {
    const TemporaryFolder folder;
    EXPECT_THROW(write_xdmf(folder / "a", "r.h5", {}, {{"pressure", 1}}), std::invalid_argument);
    EXPECT_THROW(write_xdmf(folder / "a", "r.h5", {}, {{"position", 2}}), std::invalid_argument);
    EXPECT_THROW(write_xdmf(folder / "a", "r.h5", {}, {{"position", 3}, {"stress", 6}}),
                 std::invalid_argument);
    EXPECT_TRUE(test::names_in(folder.path()).empty());
}

TEST(Xdmf, SaysWhyItCannotBeWritten) {
    const TemporaryFolder folder;
    const std::string message =
        test::file_error_of([&] { write_xdmf(folder / "no/a.xdmf", "r.h5", {}, fields); });
    EXPECT_THAT(message, HasSubstr("a.xdmf"));
    EXPECT_THAT(message, HasSubstr("No such file or directory"));
    EXPECT_THAT(message, HasSubstr("does not exist"));
}

}  // namespace
}  // namespace riffle::xdmf_test
