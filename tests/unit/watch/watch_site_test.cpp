#include "watch/watch_site.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <unistd.h>

#include <filesystem>
#include <fstream>
#include <nlohmann/json.hpp>
#include <string>

#include "case/case.hpp"
#include "output/results_file.hpp"

namespace riffle::watch_site_test {
namespace {

using nlohmann::json;
using ::testing::HasSubstr;
using ::testing::StartsWith;

constexpr const char* case_text = R"(title = "A <b>flume</b>"
[channel]
slope = 0.004
depth = 0.05
[bed]
sphere_diameter = 0.025
roughness_height = 0.01
)";

class Site : public ::testing::Test {
  protected:
    Site() {
        const auto* const test = ::testing::UnitTest::GetInstance()->current_test_info();
        folder_ = std::filesystem::path(::testing::TempDir()) /
                  ("riffle-watch-" + std::to_string(getpid()) + "-" + test->name());
        std::filesystem::create_directories(folder_);
        site_ = std::make_unique<WatchSite>(results(), "127.0.0.1");
    }
    ~Site() override { std::filesystem::remove_all(folder_); }
    Site(const Site&) = delete;
    Site& operator=(const Site&) = delete;
    Site(Site&&) = delete;
    Site& operator=(Site&&) = delete;

    [[nodiscard]] std::filesystem::path results() const { return folder_ / "results.h5"; }

    /// A results file as a run has it after so many steps.
    void write(std::int64_t steps) {
        Content content;
        content.datasets.push_back({.path = "/case/text",
                                    .shape = {},
                                    .values = std::string(case_text),
                                    .unit = "1",
                                    .long_name = "case"});
        const auto number = [&](const char* name, AttributeValue value) {
            content.attributes.push_back({.path = "/summary", .name = name, .value = value});
        };
        content.attributes.push_back({.path = "/", .name = "complete", .value = std::int64_t{0}});
        number("steps", steps);
        number("simulated_time", 0.001 * static_cast<double>(steps));
        number("wall_clock_seconds", 0.01 * static_cast<double>(steps));
        number("particle_updates_per_second", 1e5);
        number("particles", std::int64_t{500});
        number("convergence", std::string("not yet tested for convergence"));
        ResultsFile::create(results(), content, true);
    }

    [[nodiscard]] PageAnswer get(std::string_view path, std::string_view known = {}) {
        return site_->answer({"GET", path, "localhost:8437", known});
    }
    [[nodiscard]] json data() { return json::parse(get("/data.json").body); }
    [[nodiscard]] json status() { return json::parse(get("/status.json").body); }

    std::filesystem::path folder_;
    std::unique_ptr<WatchSite> site_;
};

TEST_F(Site, ServesItsPageAndNothingElse) {
    EXPECT_THAT(std::string(get("/").body), StartsWith("<!DOCTYPE html>"));
    for (const char* path :
         {"/report.css", "/watch.css", "/plotly.js", "/shared.js", "/field.js", "/watch.js"}) {
        EXPECT_EQ(get(path).status, 200) << path;
        EXPECT_THAT(std::string(get("/").body), HasSubstr(path));
    }
    for (const char* path :
         {"", "//", "/results.h5", "/../run.log", "/./watch.js", "/watch.js/", "/WATCH.JS", "/data.json "}) {
        EXPECT_EQ(get(path).status, 404) << path;
    }
}

TEST_F(Site, RefusesForeignHostsAndOtherMethods) {
    EXPECT_EQ(site_->answer({"GET", "/data.json", "example.org", ""}).status, 403);
    EXPECT_EQ(site_->answer({"GET", "/", "", ""}).status, 403);
    for (const char* method : {"HEAD", "POST", "PUT", "DELETE", "get"}) {
        EXPECT_EQ(site_->answer({method, "/", "localhost", ""}).status, 405) << method;
    }
}

TEST_F(Site, WaitsForResults) {
    EXPECT_EQ(status()["state"], "waiting");
    EXPECT_EQ(data(), json::object());
    write(10);
    EXPECT_NE(status()["state"], "waiting");
    EXPECT_EQ(data()["progress"]["steps"], 10);
    EXPECT_EQ(data()["title"], "A <b>flume</b>");
    EXPECT_EQ(data()["progress"]["convergence"], "not yet tested for convergence");
}

TEST_F(Site, SendsAVersionOnce) {
    write(10);
    const PageAnswer first = get("/data.json");
    EXPECT_EQ(first.status, 200);
    EXPECT_EQ(first.revision, "\"" + status()["revision"].get<std::string>() + "\"");
    const PageAnswer again = get("/data.json", "W/\"other\", " + first.revision);
    EXPECT_EQ(again.status, 304);
    EXPECT_TRUE(again.body.empty());
    // Unchanged results are not read again: the very same text is at hand.
    EXPECT_EQ(get("/data.json").body.data(), first.body.data());
    EXPECT_EQ(get("/data.json", "\"other\"").status, 200);
}

TEST_F(Site, SaysWhyAFileCannotBeRead) {
    std::ofstream(results()) << "no HDF5";
    EXPECT_THAT(data()["error"].get<std::string>(), HasSubstr("not an HDF5 file"));
    EXPECT_TRUE(status().contains("state"));
}

}  // namespace
}  // namespace riffle::watch_site_test
