#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <nlohmann/json.hpp>
#include <sstream>
#include <string>
#include <vector>

#include "analysis/analysis_json.hpp"
#include "analysis/figure_csv.hpp"

namespace riffle::export_test {
namespace {

constexpr double nan = std::numeric_limits<double>::quiet_NaN();

Figure sample_figure() {
    Figure figure;
    figure.key = "velocity_profile";
    figure.chapter = "profiles";
    figure.title = "Velocity";
    figure.caption = "Time-mean velocity.\nSecond line.";
    figure.source = "thesis Fig. 4.6";
    figure.x = {"velocity u", "m/s", false, false, 0.0, {}};
    figure.y = {"height z", "m", false, false, {}, {}};
    Curve run;
    run.name = "simulated, \"smooth\"";
    run.x = {0.1, 0.2, nan};
    run.y = {0.01, 0.02, 0.03};
    run.x_half_width = {0.001, 0.002, 0.003};
    Curve law;
    law.name = "law";
    law.origin = Origin::theory;
    law.mark = Mark::bars;
    law.x = {1.0 / 3.0};
    law.y = {0.5};
    figure.curves = {run, law};
    figure.maps = {
        {{0.0, 1.0}, {5.0}, {0.25F, std::numeric_limits<float>::quiet_NaN()}, "eta", "m", true, false, "a"}};
    return figure;
}

Analysis sample_analysis() {
    Analysis analysis;
    analysis.name = "run, one";
    analysis.source = "results.h5";
    analysis.warnings = {"short"};
    analysis.findings = {{"a", "profiles", "label", "m", 1.5, 0.1, {}, "", "because"},
                         {"b", "fits", "other", "1", nan, {}, 2.0, "measured", ""}};
    analysis.figures = {sample_figure()};
    return analysis;
}

TEST(AnalysisJson, HoldsTheBoundsOfLopsidedIntervals) {
    Analysis analysis = sample_analysis();
    Figure& figure = analysis.figures.front();
    figure.curves[1].y_lower = {0.25};
    figure.curves[1].y_upper = {1.5};
    const auto json = nlohmann::json::parse(analysis_to_json({analysis}));
    const auto& curves = json.at("analyses").at(0).at("figures").at(0).at("curves");
    EXPECT_TRUE(curves.at(0).at("y_lower").empty());
    EXPECT_EQ(curves.at(1).at("y_lower").at(0), 0.25);
    EXPECT_EQ(curves.at(1).at("y_upper").at(0), 1.5);
    const std::string csv = curves_to_csv(figure);
    EXPECT_NE(csv.find("lower bound of height z [m],upper bound of height z [m]"), std::string::npos);
    EXPECT_NE(csv.find(",0.25,1.5\n"), std::string::npos);
}

TEST(AnalysisJson, HoldsEveryMemberAndNullForWhatIsNotFinite) {
    const auto json = nlohmann::json::parse(analysis_to_json({sample_analysis()}));
    EXPECT_EQ(json.at("format"), "riffle-analysis");
    EXPECT_EQ(json.at("format_version"), analysis_json_version);
    const auto& analysis = json.at("analyses").at(0);
    EXPECT_EQ(analysis.at("name"), "run, one");
    EXPECT_EQ(analysis.at("warnings").at(0), "short");
    const auto& first = analysis.at("findings").at(0);
    EXPECT_EQ(first.at("key"), "a");
    EXPECT_EQ(first.at("value"), 1.5);
    EXPECT_EQ(first.at("half_width"), 0.1);
    EXPECT_TRUE(first.at("reference").is_null());
    EXPECT_EQ(first.at("remark"), "because");
    EXPECT_TRUE(analysis.at("findings").at(1).at("value").is_null());
    EXPECT_EQ(analysis.at("findings").at(1).at("reference"), 2.0);
    const auto& figure = analysis.at("figures").at(0);
    EXPECT_EQ(figure.at("x").at("from"), 0.0);
    EXPECT_TRUE(figure.at("x").at("to").is_null());
    EXPECT_TRUE(figure.at("curves").at(0).at("x").at(2).is_null());
    EXPECT_EQ(figure.at("curves").at(0).at("x_half_width").at(1), 0.002);
    EXPECT_EQ(figure.at("curves").at(1).at("origin"), "theory");
    EXPECT_EQ(figure.at("curves").at(1).at("mark"), "bars");
    EXPECT_NEAR(figure.at("curves").at(1).at("x").at(0).get<double>(), 1.0 / 3.0, 1e-9);
    EXPECT_EQ(figure.at("maps").at(0).at("values").at(0), 0.25);
    EXPECT_TRUE(figure.at("maps").at(0).at("values").at(1).is_null());
    EXPECT_EQ(nlohmann::json::parse(figure_to_json(sample_figure())), figure);
}

TEST(AnalysisJson, WritesTextsThatAreNotUtf8) {
    Analysis analysis;
    analysis.name = "bad \xff byte";
    EXPECT_TRUE(nlohmann::json::accept(analysis_to_json({analysis})));
}

TEST(FigureCsv, HasOneLinePerPointWithUnitsInTheHeading) {
    EXPECT_EQ(curves_to_csv(sample_figure()),
              "# Velocity\n# thesis Fig. 4.6\n# Time-mean velocity.\n# Second line.\n"
              "curve,run,origin,velocity u [m/s],height z [m],half-width of velocity u [m/s]\n"
              "\"simulated, \"\"smooth\"\"\",,simulated,0.1,0.01,0.001\n"
              "\"simulated, \"\"smooth\"\"\",,simulated,0.2,0.02,0.002\n"
              "\"simulated, \"\"smooth\"\"\",,simulated,,0.03,0.003\n"
              "law,,theory,0.333333333,0.5,\n");
}

TEST(FigureCsv, WritesMapsBesideCurves) {
    const std::vector<CsvFile> files = figure_to_csv(sample_figure());
    ASSERT_EQ(files.size(), 2U);
    EXPECT_EQ(files[0].name, "velocity_profile.csv");
    EXPECT_EQ(files[1].name, "velocity_profile_map.csv");
    EXPECT_NE(files[1].content.find("velocity u [m/s],height z [m],eta [m]\n0,5,0.25\n1,5,\n"),
              std::string::npos);
    Figure nothing;
    nothing.missing = "why";
    EXPECT_TRUE(figure_to_csv(nothing).empty());
}

TEST(FigureCsv, KnowsItsOwnTables) {
    const auto begins = [](const std::string& text) {
        std::istringstream file(text);
        return begins_like_analysis_csv(file);
    };
    for (const CsvFile& file : figure_to_csv(sample_figure())) {
        EXPECT_TRUE(begins(file.content)) << file.name;
        EXPECT_TRUE(is_figure_csv_name(file.name)) << file.name;
        EXPECT_TRUE(is_figure_csv_name(file.name, "profiles")) << file.name;
        EXPECT_FALSE(is_figure_csv_name(file.name, "surface")) << file.name;
    }
    EXPECT_TRUE(begins(findings_to_csv({sample_analysis()})));
    for (const char* text : {"", "z,u\n", "# my flume\nz,u\n", "# my flume", "# my flume\nz [m],u [m/s]\n",
                             "x [m],y [m],u [m/s]\n", "# my flume\nx [m],y [m],u\n"}) {
        EXPECT_FALSE(begins(text)) << text;
    }
    EXPECT_TRUE(begins("# a map\n\"x, along [m]\",y [m],u [m/s]\n1,2,3\n"));
    EXPECT_TRUE(is_figure_csv_name("surface_map_map_12.csv"));
    for (const char* name :
         {"my-profile.csv", "velocity_profile.txt", "velocity_profile_map_.csv",
          "velocity_profile_map_of_mine.csv", "velocity_profile_2.csv", "map.csv", ".csv"}) {
        EXPECT_FALSE(is_figure_csv_name(name)) << name;
    }
}

TEST(FigureCsv, WritesFindingsWithEmptyCellsForWhatIsUnknown) {
    EXPECT_EQ(findings_to_csv({sample_analysis()}),
              "run,chapter,key,label,value,half_width,reference,reference_name,unit,remark\n"
              "\"run, one\",profiles,a,label,1.5,0.1,,,m,because\n"
              "\"run, one\",fits,b,other,,,2,measured,1,\n");
}

}  // namespace
}  // namespace riffle::export_test
