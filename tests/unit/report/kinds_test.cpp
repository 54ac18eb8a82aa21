// What a run is judged by follows from the kind of its flow, and no verdict is better than what the page
// knows.

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <utility>
#include <vector>

#include "record/flow_fields.hpp"
#include "record/run_fields.hpp"
#include "record/twin_fields.hpp"
#include "report/diagnostics.hpp"
#include "report/quantities.hpp"
#include "report/references.hpp"
#include "report/verdict.hpp"

namespace riffle::kinds_test {
namespace {

using testing::HasSubstr;
using testing::Not;

ReportData channel() {
    ReportData data;
    data.complete = true;
    data.flow.channel.slope = 0.004;
    data.flow.channel.depth = 0.05;
    data.flow.bed.roughness_height = 0.010;
    const auto& of = fields::summary;
    for (const auto& [field, value] : {std::pair{of.depth_mean_velocity, 0.33},
                                       {of.depth_mean_velocity_half_width, 3e-4},
                                       {of.drag_over_gravity, 1.0},
                                       {of.wall_over_gravity, 0.0},
                                       {of.converged, 1.0},
                                       {of.spurious_stress_rms, 3e-5},
                                       {of.stress_error_rms, 1e-3},
                                       {of.simulated_time, 18.0}}) {
        data.summary.set(field, value);
    }
    data.column.set(fields::column_numbers.depth_mean_velocity, 0.335);
    data.window_start = 10;
    data.window_end = 18;
    std::vector<double> time;
    for (int i = 0; i <= 900; ++i) time.push_back(0.02 * i);
    data.series.set(fields::time_series.mean_level, std::vector<double>(time.size(), 0.056));
    data.series.set(fields::time_series.maximum_velocity, std::vector<double>(time.size(), 0.4));
    data.series.set(fields::time_series.time, std::move(time));
    return data;
}

Finding finding(const char* key, double value, const char* unit = "1") {
    Finding result;
    result.key = key;
    result.label = key;
    result.unit = unit;
    result.value = value;
    return result;
}

Verdict verdict_of(const ReportData& data, const Analysis& analysis = {}) {
    return judge(data, summarize(data, analysis), diagnose(data, analysis));
}

const Diagnostic* row(const std::vector<Diagnostic>& rows, const std::string& key) {
    const auto found =
        std::find_if(rows.begin(), rows.end(), [&](const Diagnostic& d) { return d.key == key; });
    return found == rows.end() ? nullptr : &*found;
}

std::string text_of(const Verdict& verdict) {
    std::string text = verdict.headline;
    for (const std::string& sentence : verdict.sentences) text += " " + sentence;
    return text;
}

TEST(Kinds, ASteadyUniformChannelIsGood) {
    Analysis analysis;
    analysis.findings = {finding("effective_samples", 42), finding("velocity_range_in_window", 0.004),
                         finding("velocity_fluctuation_growth", 0.1)};
    const Verdict verdict = verdict_of(channel(), analysis);
    EXPECT_EQ(verdict.mark, Health::good);
    EXPECT_EQ(verdict.headline, "The run has converged and is healthy.");
    // No interval of one run is better than what other starts tell.
    EXPECT_THAT(text_of(verdict), HasSubstr("known to 0.2 %"));
    ReportData wide = channel();
    wide.summary.set(fields::summary.depth_mean_velocity_half_width, 3e-3);
    EXPECT_THAT(text_of(verdict_of(wide, analysis)), Not(HasSubstr("known to 0.2 %")));
}

TEST(Kinds, AFluctuationThatGrowsOrTooFewSamplesAreNotGood) {
    Analysis growing;
    growing.findings = {finding("effective_samples", 42), finding("velocity_fluctuation_growth", 33)};
    EXPECT_EQ(verdict_of(channel(), growing).mark, Health::bad);
    EXPECT_THAT(text_of(verdict_of(channel(), growing)), HasSubstr("growth of the particles' fluctuation"));
    Analysis brief;
    brief.findings = {finding("effective_samples", 1.6), finding("velocity_range_in_window", 0.002)};
    EXPECT_NE(verdict_of(channel(), brief).mark, Health::good);
    EXPECT_THAT(text_of(verdict_of(channel(), brief)), HasSubstr("independent samples"));
    // A laminar flow that does not vary has few independent samples, and needs none.
    Analysis laminar;
    laminar.findings = {finding("effective_samples", 1.2), finding("velocity_range_in_window", 1e-5)};
    EXPECT_EQ(verdict_of(channel(), laminar).mark, Health::good);
}

// Water that swells before the window and is steady in it: the drift knows nothing of it, the volume does.
TEST(Kinds, WaterThatHasSwollenBeforeTheWindowIsNotGood) {
    for (const auto& [swelling, mark] :
         {std::pair{0.001, Health::good}, {0.008, Health::caution}, {-0.03, Health::bad}}) {
        ReportData data = channel();
        std::vector<double> level;
        for (const double time : data.series[fields::time_series.time]) {
            level.push_back(0.056 * (1.0 + swelling * std::min(time / 5.0, 1.0)));
        }
        data.series.set(fields::time_series.mean_level, std::move(level));
        const std::vector<Diagnostic> rows = diagnose(data, {});
        ASSERT_NE(row(rows, "volume"), nullptr);
        EXPECT_EQ(row(rows, "volume")->mark, mark) << swelling;
        ASSERT_NE(row(rows, "depth_drift"), nullptr);
        EXPECT_EQ(row(rows, "depth_drift")->mark, Health::good) << swelling;
    }
}

// The pressure pushes the grains at the ends of a zone as well, which no run records: what is missing there
// is no fault, and what the stones take is not the bed's.
TEST(Kinds, StonesThatEndAlongTheChannelAreNotMissedByTheBudget) {
    for (const auto& [end, mark] : {std::pair{0.06, Health::none}, {0.12, Health::bad}}) {
        ReportData data = channel();
        data.flow.channel.length = 0.12;
        Porous& stones = data.flow.porous.emplace_back();
        stones.name = "stones";
        stones.x_from = 0.0;
        stones.x_to = end;
        stones.z_to = 0.02;
        data.summary.set(fields::summary.drag_over_gravity, 0.2);
        data.summary.set(fields::summary.porous_over_gravity, 0.5);
        data.column.set(fields::column_numbers.friction_velocity, 0.031);
        const std::vector<Diagnostic> rows = diagnose(data, {});
        ASSERT_NE(row(rows, "force_budget"), nullptr);
        EXPECT_EQ(row(rows, "force_budget")->value, "70.00 %");
        EXPECT_EQ(row(rows, "force_budget")->mark, mark) << end;
    }
}

TEST(Kinds, AGrowthThatItsIntervalDoesNotKnowFromNoneIsNotShownAsANumber) {
    Analysis analysis;
    analysis.findings = {finding("effective_samples", 42), finding("velocity_fluctuation_growth", 18545.0),
                         finding("velocity_fluctuation_growth_least", -0.9)};
    const std::vector<Diagnostic> unknown = diagnose(channel(), analysis);
    ASSERT_NE(row(unknown, "fluctuation_growth"), nullptr);
    EXPECT_THAT(row(unknown, "fluctuation_growth")->value, HasSubstr("not told apart"));
    EXPECT_EQ(row(unknown, "fluctuation_growth")->mark, Health::good);
    analysis.findings.back().value = 18000.0;
    EXPECT_EQ(row(diagnose(channel(), analysis), "fluctuation_growth")->mark, Health::bad);
    EXPECT_EQ(row(diagnose(channel(), analysis), "fluctuation_growth")->value, "1.85e+04-fold");
}

TEST(Kinds, BodiesBookTheirDragAndHaveNoTwin) {
    ReportData data = channel();
    Solid& step = data.flow.solids.emplace_back();
    step.name = "step";
    step.x = {0.03, 0.05, 0.05, 0.03};
    step.z = {0.0, 0.0, 0.01, 0.01};
    data.column = {};
    data.summary.set(fields::summary.drag_over_gravity, 0.3);
    data.summary.set(fields::summary.wall_over_gravity, 0.7);
    data.summary.set(fields::summary.spurious_stress_rms, 2.45);  // form drag, to a flow without bodies
    Analysis analysis;
    analysis.findings = {finding("unit_discharge", 0.017, "m2/s"), finding("solid_force_share", 0.7),
                         finding("solid_form_drag_share", 0.66)};
    const Verdict verdict = verdict_of(data, analysis);
    EXPECT_EQ(verdict.mark, Health::good) << text_of(verdict);
    EXPECT_THAT(text_of(verdict), HasSubstr("\"step\""));
    EXPECT_THAT(text_of(verdict), Not(HasSubstr("converged")));
    EXPECT_THAT(text_of(verdict), HasSubstr("70.0 % of the water's weight component"));
    const std::vector<Diagnostic> rows = diagnose(data, analysis);
    ASSERT_NE(row(rows, "force_budget"), nullptr);
    EXPECT_EQ(row(rows, "force_budget")->mark, Health::good);
    EXPECT_EQ(row(rows, "spurious_stress")->mark, Health::none);
    EXPECT_EQ(row(rows, "velocity_error_above"), nullptr);
    for (const SummaryRow& quantity : summarize(data, analysis)) {
        EXPECT_FALSE(quantity.column) << quantity.key;
    }
}

// The same solid as a part of the bed: its drag is the bed's, and the laws of a uniform channel are asked
// for.
TEST(Kinds, SolidsOfTheBedAreJudgedAsARoughBed) {
    ReportData data = channel();
    data.flow.bed.kind = BedKind::no_slip;
    Solid& rib = data.flow.solids.emplace_back();
    rib.name = "rib";
    rib.part_of_bed = true;
    data.column = {};
    data.summary.set(fields::summary.drag_over_gravity, 0.0);
    data.summary.set(fields::summary.wall_over_gravity, 1.0);
    data.summary.set(fields::summary.friction_velocity, 0.044);
    data.summary.set(fields::summary.spurious_stress_rms, 0.05);
    Analysis analysis;
    analysis.findings = {finding("solid_force_share", 0.9)};
    const std::vector<Diagnostic> rows = diagnose(data, analysis);
    ASSERT_NE(row(rows, "spurious_stress"), nullptr);
    EXPECT_EQ(row(rows, "spurious_stress")->mark, Health::bad);
    ASSERT_NE(row(rows, "form_drag"), nullptr);
    EXPECT_THAT(row(rows, "form_drag")->label, HasSubstr("solids of the bed"));
    const std::string text = text_of(verdict_of(data, analysis));
    EXPECT_THAT(text, HasSubstr("The friction velocity is 0.044 m/s"));
    EXPECT_THAT(text, HasSubstr("the bed is made of solids"));
    const std::vector<SummaryRow> quantities = summarize(data, analysis);
    ASSERT_NE(find_quantity(quantities, "friction_velocity"), nullptr);
    EXPECT_THAT(find_quantity(quantities, "friction_velocity")->label, HasSubstr("at the crests"));
    EXPECT_EQ(find_quantity(quantities, "unit_discharge"), nullptr);
}

// A flood through an open channel that strikes a deck: no mean is asked for, and impacts compress water.
TEST(Kinds, AFloodIsJudgedByItsAccountAndNotByAMean) {
    ReportData data = channel();
    data.flow.channel.ends = Ends::open;
    data.flow.inflow.discharge_file = "flood.csv";
    data.flow.numerics.impact_dissipation = 3.0;
    data.column = {};
    const std::size_t rows_of_series = data.series[fields::time_series.time].size();
    data.series.set(fields::time_series.density_deviation_minimum,
                    std::vector<double>(rows_of_series, -0.01));
    data.series.set(fields::time_series.density_deviation_maximum,
                    std::vector<double>(rows_of_series, 0.025));
    Analysis analysis;
    analysis.findings = {finding("effective_samples", 1.7), finding("velocity_range_in_window", 0.8)};
    std::vector<Diagnostic> rows = diagnose(data, analysis);
    ASSERT_NE(row(rows, "independent_samples"), nullptr);
    ASSERT_NE(row(rows, "density_range"), nullptr);
    EXPECT_EQ(row(rows, "independent_samples")->mark, Health::none);
    EXPECT_EQ(row(rows, "density_range")->mark, Health::good);
    data.flow.inflow.discharge_file.clear();
    data.flow.numerics.impact_dissipation = 0.0;
    rows = diagnose(data, analysis);
    EXPECT_EQ(row(rows, "independent_samples")->mark, Health::bad);
    EXPECT_NE(row(rows, "density_range")->mark, Health::good);
}

// A gate that the case lowers changes the flow: no mean is asked for.
TEST(Kinds, AGateThatMovesIsNotJudgedByAMean) {
    ReportData data = channel();
    data.flow.channel.ends = Ends::open;
    data.flow.inflow.unit_discharge = 0.02;
    data.column = {};
    Solid gate;
    gate.name = "gate";
    data.flow.solids = {gate};
    Analysis analysis;
    analysis.findings = {finding("effective_samples", 1.7), finding("velocity_range_in_window", 0.8),
                         finding("momentum_residual_share", 0.2), finding("velocity_fluctuation_growth", 9)};
    const auto marks = [&] {
        std::vector<Health> found;
        const std::vector<Diagnostic> rows = diagnose(data, analysis);
        for (const char* key : {"independent_samples", "momentum_budget", "fluctuation_growth"}) {
            found.push_back(row(rows, key)->mark);
        }
        return found;
    };
    EXPECT_THAT(marks(), testing::Each(Health::bad));
    data.flow.solids[0].motion = SolidMotion::constant;
    EXPECT_THAT(marks(), testing::Each(Health::none));
}

// The section at the outflow may miss what gaps between the particles carry; their account does not.
TEST(Kinds, WhatLeavesIsJudgedByTheParticles) {
    ReportData data = channel();
    data.flow.channel.ends = Ends::open;
    data.flow.inflow.unit_discharge = 0.02;
    data.column = {};
    const std::vector<double>& time = data.series[fields::time_series.time];
    data.series.set(fields::time_series.inflow_discharge, std::vector<double>(time.size(), 0.02));
    data.series.set(fields::time_series.outflow_discharge, std::vector<double>(time.size(), 0.0193));
    const auto stored_at = [&](double share_kept) {
        std::vector<double> mass;
        for (std::size_t i = 0; i < time.size(); ++i) {
            // Particles leave in bunches.
            mass.push_back(50.0 + share_kept * 1000.0 * 0.02 * time[i] + 1e-3 * static_cast<double>(i % 7));
        }
        data.series.set(fields::time_series.mass_stored, std::move(mass));
        return *row(diagnose(data, {}), "throughput");
    };
    EXPECT_EQ(stored_at(0.0).mark, Health::good);
    const Diagnostic filling = stored_at(0.03);
    EXPECT_NE(filling.mark, Health::good);
    EXPECT_THAT(filling.value, HasSubstr("3.00"));
}

TEST(Kinds, AClosedFlowIsJudgedByWhatItMustKeep) {
    ReportData data = channel();
    data.flow.channel.slope = 0.0;
    data.flow.channel.ends = Ends::walls;
    data.flow.bed.kind = BedKind::slip;
    data.column = {};
    // A dam break: the mean level of the wet places falls by a half, which is no loss of water.
    std::vector<double> level;
    for (int i = 0; i <= 900; ++i) level.push_back(0.05 * (1.0 - 0.5 * i / 900));
    data.series.set(fields::time_series.mean_level, std::move(level));
    Analysis analysis;
    Finding front = finding("front_speed", 1.9, "m/s");
    front.reference = 1.98;
    front.reference_name = "Ritter 1892, 2 sqrt(g h0)";
    analysis.findings = {finding("kinetic_energy_largest", 11.0, "J/m"), finding("energy_gain", 0.001),
                         finding("energy_change", -0.2), finding("volume_change_largest", 0.002), front};
    const std::vector<Diagnostic> rows = diagnose(data, analysis);
    EXPECT_EQ(row(rows, "depth_drift"), nullptr);
    EXPECT_EQ(row(rows, "front")->mark, Health::good);
    EXPECT_EQ(row(rows, "energy")->mark, Health::good);
    EXPECT_EQ(verdict_of(data, analysis).mark, Health::good);
    EXPECT_EQ(verdict_of(data, analysis).headline, "The run is complete and is healthy.");
    analysis.findings[1].value = 0.3;  // energy from nowhere
    EXPECT_EQ(verdict_of(data, analysis).mark, Health::bad);
    analysis.findings[1].value = 0.0;
    analysis.findings[3].value = -0.04;  // water lost
    EXPECT_EQ(verdict_of(data, analysis).mark, Health::bad);
    data.summary.set(fields::summary.lost_particles, 30);
    data.summary.set(fields::summary.lost_share, 0.03);
    EXPECT_EQ(row(diagnose(data, analysis), "lost_water")->mark, Health::bad);
}

// Of a tide the page tells how the water went up and down, and no drift is bad.
TEST(Kinds, ATideIsToldByItsRange) {
    ReportData data = channel();
    data.flow.channel.ends = Ends::open;
    data.flow.channel.length = 4.0;
    data.flow.outflow.kind = OutflowKind::depth;
    data.flow.outflow.depth_file = "tide.csv";
    data.column = {};
    Analysis analysis;
    for (const auto& [key, value, unit] : {std::tuple{"tailwater_high_1", 0.094, "m"},
                                           {"tailwater_low_1", 0.067, "m"},
                                           {"tailwater_range_1", 0.027, "m"},
                                           {"tailwater_largest_discharge_1", 0.0065, "m2/s"},
                                           {"tailwater_smallest_discharge_1", 0.0055, "m2/s"},
                                           {"tailwater_high_2", 0.086, "m"},
                                           {"tailwater_low_2", 0.074, "m"},
                                           {"tailwater_range_2", 0.012, "m"},
                                           {"tailwater_largest_discharge_2", 0.019, "m2/s"},
                                           {"tailwater_smallest_discharge_2", -0.006, "m2/s"}}) {
        analysis.findings.push_back(finding(key, value, unit));
    }
    const std::string text = text_of(verdict_of(data, analysis));
    EXPECT_THAT(text,
                HasSubstr("the depth goes from 74 to 86 mm and the discharge from -0.006 to 0.019 m²/s"));
    EXPECT_THAT(text, HasSubstr("less than zero where the flow turns"));
    EXPECT_THAT(text, HasSubstr("225 % of that range of the depth arrive at the section furthest upstream"));
    EXPECT_EQ(row(diagnose(data, analysis), "depth_drift")->mark, Health::none);
    analysis.findings.clear();
    EXPECT_THAT(text_of(verdict_of(data, analysis)), Not(HasSubstr("tailwater")));
}

TEST(Kinds, VorticesAreJudgedByTheirDecay) {
    ReportData data = channel();
    data.flow.channel.slope = 0.0;
    data.flow.channel.top = Top::periodic;
    data.flow.start.kind = StartKind::taylor_green;
    data.flow.start.velocity = 1.0;
    data.column = {};
    data.series.set(fields::time_series.total_mean_velocity, std::vector<double>(901, 1e-5));
    Analysis analysis;
    Finding rate = finding("velocity_decay_rate", 0.79, "1/s");
    rate.reference = 0.7896;
    analysis.findings = {finding("kinetic_energy_largest", 240.0, "J/m"), rate};
    EXPECT_EQ(verdict_of(data, analysis).mark, Health::good);
    EXPECT_NE(row(diagnose(data, analysis), "momentum"), nullptr);
    analysis.findings[1].value = 0.70;
    EXPECT_EQ(verdict_of(data, analysis).mark, Health::bad);
}

TEST(References, AreThoseThatAPageNames) {
    Analysis analysis;
    analysis.findings = {finding("front_speed", 1.9, "m/s")};
    analysis.findings.front().reference_name = "Ritter 1892, 2 sqrt(g h0)";
    const auto cited = cited_references({analysis});
    ASSERT_EQ(cited.size(), 1U);
    EXPECT_THAT(cited.front().citation, HasSubstr("Fortpflanzung der Wasserwellen"));
    const auto thesis = cited_references({}, {"thesis, Table 3.1"});
    ASSERT_EQ(thesis.size(), 1U);
    EXPECT_THAT(thesis.front().citation, HasSubstr("Gabreil, E. (2017)"));
}

}  // namespace
}  // namespace riffle::kinds_test
