#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <unistd.h>

#include <filesystem>
#include <fstream>
#include <nlohmann/json.hpp>
#include <set>
#include <sstream>
#include <string>
#include <system_error>
#include <utility>

#include "base/error.hpp"
#include "column/column.hpp"
#include "report/report.hpp"
#include "report/report_data.hpp"
#include "report/report_json.hpp"
#include "report/summary_json.hpp"
#include "sample_analysis.hpp"
#include "sample_results.hpp"

namespace riffle::report_test {
namespace {

using nlohmann::json;
using ::testing::HasSubstr;
using testing::sample_case;
using testing::SampleOptions;
using testing::write_sample_results;

class Report : public ::testing::Test {
  protected:
    void SetUp() override {
        const auto* const test = ::testing::UnitTest::GetInstance()->current_test_info();
        folder_ = std::filesystem::path(::testing::TempDir()) /
                  ("riffle-report-" + std::to_string(getpid()) + "-" + test->name());
        std::filesystem::create_directories(folder_);
    }
    void TearDown() override {
        std::error_code error;
        std::filesystem::permissions(folder_, std::filesystem::perms::owner_all, error);
        std::filesystem::remove_all(folder_, error);
    }

    std::filesystem::path sample(const SampleOptions& options = {}) {
        const auto path = folder_ / "results.h5";
        write_sample_results(path, options);
        return path;
    }
    static json page(const std::filesystem::path& results) {
        return json::parse(page_json(collect_report_data(results)));
    }
    static json summary(const std::filesystem::path& results) {
        return json::parse(report_summary_json(results));
    }
    static std::string text_of(const std::filesystem::path& path) {
        std::ostringstream text;
        text << std::ifstream(path, std::ios::binary).rdbuf();
        return text.str();
    }
    static std::string data_block(const std::string& html) {
        const std::string open = R"(<script type="application/json" id="report-data">)";
        const std::size_t from = html.find(open) + open.size();
        return html.substr(from, html.find("</script>", from) - from);
    }

    std::filesystem::path folder_;
};

TEST_F(Report, PageCarriesTheWholeReportInOneFile) {
    const auto html = folder_ / "report.html";
    write_report(sample(), html);
    const std::string text = text_of(html);
    EXPECT_THAT(text, HasSubstr("<title>Flow condition 2: depth 50 mm, slope 0.004</title>"));
    for (const char* place : {"{{title}}", "{{style}}", "{{data}}", "{{plotly}}", "{{script}}"}) {
        EXPECT_EQ(text.find(place), std::string::npos);
    }
    EXPECT_EQ(text.find("<script src"), std::string::npos);
    EXPECT_EQ(text.find("<link"), std::string::npos);
    const json data = json::parse(data_block(text));
    EXPECT_FALSE(data.at("field").is_null());
    EXPECT_EQ(data.at("flow_kind"), "uniform-channel");
    EXPECT_EQ(data.at("case_text"), sample_case());
}

TEST_F(Report, PageAndSummaryCarryTheAnalysis) {
    const auto html = folder_ / "report.html";
    const auto summary_file = folder_ / "summary.json";
    const Analysis analysis = testing::sample_analysis("sample");
    write_report(sample(), html, summary_file, analysis);
    const std::string text = text_of(html);
    const std::string open = R"(id="analysis-data">)";
    const std::size_t from = text.find(open) + open.size();
    const json block = json::parse(text.substr(from, text.find("</script>", from) - from));
    EXPECT_EQ(block.at("analyses").at(0).at("figures").size(), analysis.figures.size());
    const json findings = json::parse(text_of(summary_file)).at("findings");
    ASSERT_EQ(findings.size(), analysis.findings.size());
    EXPECT_EQ(findings.at(0).at("key"), "depth_mean_velocity");
    EXPECT_DOUBLE_EQ(findings.at(0).at("half_width"), 0.0012);
    EXPECT_DOUBLE_EQ(findings.at(0).at("reference"), 0.35);
    // The present readers of the summary find what they knew.
    EXPECT_TRUE(json::parse(text_of(summary_file)).at("quantities").contains("depth_mean_velocity"));
}

TEST_F(Report, SummaryComparesTheRunWithMeasurementAndColumn) {
    const auto results = sample();
    const ColumnResult column = solve_column(parse_case(sample_case(), "sample"));
    const json quantities = summary(results).at("quantities");
    const json& mean = quantities.at("depth_mean_velocity");
    EXPECT_DOUBLE_EQ(mean.at("measured").at("value"), 0.35);
    EXPECT_NEAR(mean.at("column").at("value").get<double>(), column.depth_mean_velocity, 1e-12);
    EXPECT_NEAR(mean.at("simulated").at("value").get<double>() / column.depth_mean_velocity, 1.002, 1e-9);
    EXPECT_DOUBLE_EQ(mean.at("simulated").at("half_width"), 6e-4);
    // The channel numbers of the twin are those that the column itself gives: one definition of each.
    EXPECT_NEAR(quantities.at("friction_factor").at("column").at("value").get<double>(),
                column.friction_factor, 1e-12);
    EXPECT_NEAR(quantities.at("manning").at("column").at("value").get<double>(), column.manning, 1e-12);
    EXPECT_NEAR(quantities.at("chezy").at("column").at("value").get<double>(), column.chezy, 1e-9);
    EXPECT_NEAR(quantities.at("froude").at("column").at("value").get<double>(), column.froude, 1e-12);
    EXPECT_NEAR(quantities.at("reynolds").at("column").at("value").get<double>(), column.reynolds, 1e-6);
    // Values that the file lacks are solved for.
    EXPECT_NEAR(quantities.at("log_law_friction_velocity").at("column").at("value").get<double>(),
                column.log_law.friction_velocity, 1e-12);
    EXPECT_DOUBLE_EQ(quantities.at("equivalent_roughness").at("measured").at("value"), 0.035);
}

TEST_F(Report, FrictionFactorIntervalFollowsFromTheVelocityInterval) {
    const json quantities = summary(sample()).at("quantities");
    const json& mean = quantities.at("depth_mean_velocity").at("simulated");
    const json& factor = quantities.at("friction_factor").at("simulated");
    // f ~ U^-2: its relative half-width is twice that of U.
    const double expected = 2 * mean.at("half_width").get<double>() / mean.at("value").get<double>();
    EXPECT_NEAR(factor.at("half_width").get<double>() / factor.at("value").get<double>(), expected,
                1e-4 * expected);
}

TEST_F(Report, SoundRunIsCalledConvergedAndHealthy) {
    const json verdict = summary(sample()).at("verdict");
    EXPECT_EQ(verdict.at("status"), "good");
    EXPECT_EQ(verdict.at("headline"), "The run has converged and is healthy.");
    EXPECT_THAT(verdict.at("sentences")[0], HasSubstr("below the measured 0.35 m/s"));
    EXPECT_THAT(verdict.at("sentences")[0], HasSubstr("0.2 % above the column twin's"));
}

TEST_F(Report, RunThatHasNotConvergedIsSaidToBe) {
    SampleOptions options;
    options.converged = false;
    options.complete = false;
    const json verdict = summary(sample(options)).at("verdict");
    EXPECT_EQ(verdict.at("status"), "caution");
    EXPECT_THAT(verdict.at("headline"), HasSubstr("has not converged"));
    EXPECT_THAT(verdict.at("sentences").back(), HasSubstr("had not ended"));
}

TEST_F(Report, UnhealthyRunIsNamedWithWhatIsWrong) {
    SampleOptions options;
    options.summary_overrides = {{"drag_over_gravity", 1.05}, {"spurious_stress_rms", 0.118}};
    const json all = summary(sample(options));
    EXPECT_EQ(all.at("verdict").at("status"), "bad");
    EXPECT_THAT(all.at("verdict").at("headline"), HasSubstr("not healthy"));
    EXPECT_THAT(all.at("verdict").at("sentences").back(),
                HasSubstr("spurious shear stress of the pressure (11.80 %"));
    EXPECT_THAT(all.at("verdict").at("sentences").back(),
                HasSubstr("drag and wall friction over the weight component (105.00 %"));
    for (const json& row : all.at("diagnostics")) {
        if (row.at("key") == "stress_error") {
            EXPECT_EQ(row.at("status"), "good");
        }
        if (row.at("key") == "spurious_stress") {
            EXPECT_EQ(row.at("status"), "bad");
        }
    }
}

TEST_F(Report, SpuriousStressMayBeLargerUnderStirring) {
    const auto status = [&](const std::string& extra) {
        SampleOptions options;
        options.case_text = sample_case() + extra;
        options.summary_overrides = {{"spurious_stress_rms", 0.0096}};
        const json all = summary(sample(options));
        for (const json& row : all.at("diagnostics")) {
            if (row.at("key") == "spurious_stress") return row.at("status").get<std::string>();
        }
        return std::string("missing");
    };
    EXPECT_EQ(status(""), "caution");
    EXPECT_EQ(status("\n[stirring]\nacceleration = 0.3\n"), "good");
}

TEST_F(Report, WithoutSnapshotsThereIsNoPictureOfTheField) {
    SampleOptions options;
    options.without = {"/snapshots"};
    EXPECT_TRUE(page(sample(options)).at("field").is_null());
}

TEST_F(Report, RunThatHasJustStartedHasAReport) {
    SampleOptions options;
    options.without = {"/profiles", "/time_series", "/snapshots", "/surface", "/summary"};
    options.complete = false;
    const auto results = sample(options);
    const json data = page(results);
    EXPECT_EQ(data.at("verdict").at("headline"), "The run has no time averages yet.");
    EXPECT_EQ(data.at("verdict").at("status"), "none");
    EXPECT_NO_THROW(write_report(results, folder_ / "report.html"));
}

TEST_F(Report, SmoothLaminarChannelHasNoRoughnessAndSaysSo) {
    SampleOptions options;
    options.case_text = R"(title = "Laminar channel"
[channel]
slope = 0.001
depth = "20 mm"
length = "40 mm"
[bed]
kind = "no-slip"
roughness_height = 0
datum_below_crest = 0
[turbulence]
closure = "none"
[fluid]
kinematic_viscosity = 1e-3
[numerics]
spacing = "1 mm"
)";
    const json data = page(sample(options));
    EXPECT_FALSE(data.at("geometry").at("rough"));
    EXPECT_TRUE(data.at("geometry").at("periodic"));
    for (const json& row : data.at("quantities")) EXPECT_NE(row.at("key"), "log_law_friction_velocity");
    // Between open ends nothing repeats: the picture has no particles of the inflow at the outflow.
    const std::string ends = "\nends = \"open\"\n[inflow]\nunit_discharge = 0.001";
    options.case_text.insert(options.case_text.find("\n[bed]"), ends);
    EXPECT_FALSE(page(sample(options)).at("geometry").at("periodic"));
}

TEST_F(Report, TankWithoutSlopeIsNotJudgedByItsMeanFlow) {
    SampleOptions options;
    options.case_text = R"(title = "Tank"
[channel]
slope = 0
depth = "50 mm"
length = "0.1 m"
[bed]
kind = "slip"
roughness_height = 0
datum_below_crest = 0
[turbulence]
closure = "none"
[numerics]
spacing = "2 mm"
[start]
kind = "rest"
[run]
until = "5 s"
)";
    options.converged = false;
    options.summary_overrides = {{"depth_mean_velocity", 2e-7}, {"depth_mean_velocity_half_width", 4e-7}};
    const json all = summary(sample(options));
    EXPECT_THAT(all.at("verdict").at("sentences")[0], HasSubstr("nothing drives a steady mean flow"));
    EXPECT_EQ(all.at("flow_kind"), "tank");
    EXPECT_FALSE(all.at("quantities").contains("friction_factor"));
    for (const json& row : all.at("diagnostics")) {
        EXPECT_NE(row.at("key"), "velocity_interval");
        EXPECT_NE(row.at("key"), "force_budget");
    }
    EXPECT_EQ(all.dump().find("inf %"), std::string::npos);
}

/// The numbers of a quantity of a frame, as the page unpacks them.
std::vector<double> unpacked(const json& field, std::size_t frame, const std::string& name) {
    const std::string text = field.at("frames").at(frame).at(name);
    const double low = field.at("ranges").at(name).at(0);
    const double high = field.at("ranges").at(name).at(1);
    const std::string letters = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
    std::vector<unsigned> bytes;
    unsigned held = 0;
    int bits = 0;
    for (const char letter : text) {
        if (letter == '=') break;
        held = held << 6U | static_cast<unsigned>(letters.find(letter));
        bits += 6;
        if (bits >= 8) {
            bits -= 8;
            bytes.push_back(held >> static_cast<unsigned>(bits) & 255U);
        }
    }
    std::vector<double> values;
    for (std::size_t i = 0; i + 1 < bytes.size(); i += 2) {
        values.push_back(low + (high - low) * (bytes[i] + 256 * bytes[i + 1]) / 65534);
    }
    return values;
}

TEST_F(Report, LongChannelShowsItsFirstStretch) {
    SampleOptions options;
    options.length = 2.4;  // 33 600 particles
    const json field = page(sample(options)).at("field");
    EXPECT_TRUE(field.at("left_out"));
    const std::vector<double> x = unpacked(field, field.at("frames").size() - 1, "x");
    EXPECT_EQ(x.size(), field.at("frames").back().at("count"));
    EXPECT_LE(x.size(), 20'000U);
    EXPECT_GT(x.size(), 19'000U);
    const double end = field.at("x_end");
    for (const double each : x) EXPECT_LE(each, end * (1 + 1e-4));
    EXPECT_EQ(unpacked(field, 0, "velocity").size(), unpacked(field, 0, "x").size());
}

TEST_F(Report, TextOfTheCaseCannotBreakThePage) {
    SampleOptions options;
    options.case_text = sample_case() + "# </script><script>alert('x')</script>\n";
    const auto html = folder_ / "report.html";
    write_report(sample(options), html);
    const json data = json::parse(data_block(text_of(html)));
    EXPECT_THAT(data.at("case_text"), HasSubstr("</script><script>alert"));
}

TEST_F(Report, TakesTheFolderOfARunOrItsFile) {
    const auto results = sample();
    EXPECT_EQ(find_results_file(folder_), results);
    EXPECT_EQ(find_results_file(results), results);
    std::filesystem::remove(results);
    EXPECT_THROW(static_cast<void>(find_results_file(folder_)), FileError);
    EXPECT_THROW(static_cast<void>(find_results_file(results)), FileError);
}

TEST_F(Report, RefusesAFileThatIsNotResults) {
    const auto path = folder_ / "results.h5";
    std::ofstream(path) << "not HDF5";
    EXPECT_THROW(static_cast<void>(report_html(path)), FileError);
}

TEST_F(Report, RefusesResultsWhoseCaseItCannotRead) {
    SampleOptions options;
    options.stored_case_text = "[channel]\nslop = 1\n";
    try {
        static_cast<void>(report_html(sample(options)));
        FAIL() << "no error";
    } catch (const FileError& error) {
        EXPECT_THAT(error.what(), HasSubstr("results.h5"));
        EXPECT_THAT(error.what(), HasSubstr("slop"));
    }
}

TEST_F(Report, FailedWriteLeavesTheOldReport) {
    const auto results = sample();
    const auto html = folder_ / "missing-folder" / "report.html";
    EXPECT_THROW(write_report(results, html), FileError);
    EXPECT_FALSE(std::filesystem::exists(html));
}

}  // namespace
}  // namespace riffle::report_test
