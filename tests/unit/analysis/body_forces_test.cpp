// Coefficients of bodies in a stream, and the budgets of momentum and energy between open ends.

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <string>
#include <vector>

#include "analysis/body_coefficients.hpp"
#include "analysis/chapters.hpp"
#include "analysis/figure_tools.hpp"
#include "analysis/momentum_budget.hpp"
#include "case/solid_mesh.hpp"
#include "record/flow_fields.hpp"
#include "record/probe_fields.hpp"
#include "simulated_record.hpp"

namespace riffle::body_forces_test {
namespace {

constexpr double interval = 0.01;  // s, of 10 s

/// A duct with a cylinder of 0.1 m in a stream of 0.2 m/s.
Case duct() {
    Case c;
    c.channel.slope = 0.0;
    c.channel.depth = 0.4;
    c.channel.length = 2.0;
    c.channel.ends = Ends::open;
    c.channel.top = Top::wall;
    c.bed.kind = BedKind::no_slip;
    c.bed.datum_below_crest = 0.0;
    c.bed.roughness_height = 0.0;
    c.numerics.spacing = 0.005;
    c.inflow.unit_discharge = 0.08;
    Solid cylinder;
    cylinder.name = "pile";
    cylinder.x = {0.15, 0.2, 0.25, 0.2};
    cylinder.z = {0.2, 0.15, 0.2, 0.25};
    c.solids = {cylinder};
    return c;
}

class Record : public test::SimulatedRecord {
  public:
    explicit Record(const Case& c) : SimulatedRecord({0.0, 10.0}, c) {
        std::vector<double> time;
        for (int i = 0; i < 1000; ++i) time.push_back(interval * i);
        series_.set(fields::time_series.time, time);
        set(fields::time_series.inflow_discharge, 0.08);
        set(fields::time_series.inflow_depth, 0.4);
        set(fields::time_series.momentum_stored, 7.0);
    }
    void set(const Field& field, double value) { series_.set(field, std::vector<double>(1000, value)); }
    /// A momentum that grows, and in which rows of particles come in and go out at once.
    void store(double rate, double of_a_row, double frequency) {
        std::vector<double> momentum;
        for (int i = 0; i < 1000; ++i) {
            const double rows = frequency * interval * i;
            momentum.push_back(rate * interval * i + of_a_row * (rows - std::floor(rows)));
        }
        series_.set(fields::time_series.momentum_stored, momentum);
    }
    void store(const std::vector<double>& momentum) {
        series_.set(fields::time_series.momentum_stored, momentum);
    }
    void add(const std::string& instrument, const std::string& kind, const std::string& quantity, double mean,
             double amplitude = 0.0, double frequency = 1.0) {
        std::vector<double> values;
        for (int i = 0; i < 1000; ++i) {
            values.push_back(mean + amplitude * std::sin(2.0 * std::numbers::pi * frequency * interval * i));
        }
        add(instrument, kind, quantity, values);
    }
    /// Samples that are even over the ten seconds.
    void add(const std::string& instrument, const std::string& kind, const std::string& quantity,
             const std::vector<double>& values) {
        ScalarProbe probe{.name = instrument,
                          .kind = kind,
                          .quantity = quantity,
                          .label = quantity,
                          .unit = "N/m",
                          .time = {},
                          .value = values};
        for (std::size_t i = 0; i < values.size(); ++i) {
            probe.time.push_back(1000.0 * interval * static_cast<double>(i) /
                                 static_cast<double>(values.size()));
        }
        probes_.push_back(std::move(probe));
    }
    [[nodiscard]] const SeriesTable& series() const override { return series_; }
    [[nodiscard]] const std::vector<ScalarProbe>& scalar_probes() const override { return probes_; }

  private:
    SeriesTable series_;
    std::vector<ScalarProbe> probes_;
};

double value_of(const Analysis& analysis, const std::string& key) {
    const Finding* const found = find_finding(analysis, key);
    EXPECT_NE(found, nullptr) << key;
    return found == nullptr ? std::nan("") : found->value;
}

// Half of rho U^2 D is 2 N/m.
TEST(BodyCoefficients, AreTheForcesOverTheHeadOfTheStream) {
    Record record(duct());
    record.add("standard_force", "force", "solid_force_1", 11.0);
    record.add("standard_force", "force", "solid_lift_1", 0.1, 0.6, 0.45);
    Analysis analysis;
    add_body_coefficients(record, analysis);
    EXPECT_NEAR(value_of(analysis, "drag_coefficient_1"), 5.5, 1e-9);
    EXPECT_NEAR(value_of(analysis, "lift_coefficient_1"), 0.05, 0.03);
    EXPECT_NEAR(value_of(analysis, "strouhal_number_1"), 0.45 * 0.1 / 0.2, 0.002);
    EXPECT_THAT(find_finding(analysis, "strouhal_number_1")->remark, ::testing::HasSubstr("coefficient 0.3"));
}

TEST(BodyCoefficients, TakeNoSoundForVortices) {
    // Cross waves of the duct: many times the shedding's frequency, and at 0.9 U/D.
    for (const double frequency : {9.0, 1.8}) {
        Record record(duct());
        record.add("standard_force", "force", "solid_force_1", 11.0);
        record.add("standard_force", "force", "solid_lift_1", 0.1, 0.6, frequency);
        Analysis analysis;
        add_body_coefficients(record, analysis);
        EXPECT_EQ(find_finding(analysis, "strouhal_number_1"), nullptr) << frequency;
    }
}

TEST(BodyCoefficients, AreNotGivenForWhatStandsOnTheBedOrMoves) {
    for (const bool moves : {false, true}) {
        Case c = duct();
        if (moves) {
            c.solids[0].motion = SolidMotion::constant;
            c.solids[0].velocity_x = 0.1;
        } else {
            c.solids[0].z = {0.1, 0.0, 0.1, 0.2};
        }
        Record record(c);
        record.add("standard_force", "force", "solid_force_1", 11.0);
        Analysis analysis;
        add_body_coefficients(record, analysis);
        EXPECT_TRUE(analysis.findings.empty()) << moves;
    }
}

// A flood: what flows in grows with the square of the time, and the water stores it. The plain mean of what
// flowed in over the window is a third of 300 N/m, the change between means over tenths is not.
TEST(MomentumBudget, ClosesWhereTheFlowChanges) {
    Record record(duct());
    std::vector<double> stored;
    std::vector<double> inflow;
    for (int i = 0; i < 1000; ++i) {
        const double t = interval * i;
        inflow.push_back(3.0 * t * t);
        stored.push_back(t * t * t);
    }
    record.store(stored);
    record.add("standard_end_sections", "flow_rate", "momentum_flux_1", inflow);
    for (const char* quantity : {"momentum_flux_2", "pressure_force_1", "pressure_force_2"}) {
        record.add("standard_end_sections", "flow_rate", quantity, 0.0);
    }
    record.add("standard_force", "force", "solid_force_1", 0.0);
    record.add("standard_force", "force", "solid_form_drag_1", 0.0);
    Analysis analysis;
    add_momentum_budget(record, analysis);
    // To a sample's share of the change, half of 3 N/m by the hundred rows of a tenth; the plain mean
    // leaves 4.5 N/m.
    EXPECT_NEAR(value_of(analysis, "momentum_residual"), 0.0, 0.03);
}

// The instrument with the most samples tells the force, the case's own or the standard one.
TEST(MomentumBudget, TakesTheForceOfTheFinestInstrument) {
    Record record(duct());
    for (const char* quantity :
         {"momentum_flux_1", "momentum_flux_2", "pressure_force_1", "pressure_force_2"}) {
        record.add("standard_end_sections", "flow_rate", quantity, 0.0);
    }
    for (const char* quantity : {"solid_force_1", "solid_form_drag_1"}) {
        record.add("standard_force", "force", quantity, std::vector<double>(100, 9.0));
        record.add("load_cell", "force", quantity, std::vector<double>(1000, 5.0));
    }
    Analysis analysis;
    add_momentum_budget(record, analysis);
    EXPECT_DOUBLE_EQ(value_of(analysis, "momentum_form_drag_1"), -5.0);
}

TEST(MomentumBudget, BooksFormDragAndFrictionApart) {
    Record record(duct());
    const auto add_end = [&](const char* quantity, double value) {
        record.add("standard_end_sections", "flow_rate", quantity, value);
    };
    add_end("momentum_flux_1", 20.0);
    add_end("pressure_force_1", 60.0);
    add_end("momentum_flux_2", 19.0);
    add_end("pressure_force_2", 31.0);
    const auto add_force = [&](const char* quantity, double value) {
        record.add("standard_force", "force", quantity, value);
    };
    add_force("weight_component", 0.0);
    add_force("bed_drag", 0.0);
    add_force("wall_force", 28.0);
    add_force("solid_force_1", 11.0);
    add_force("solid_form_drag_1", 7.0);
    Analysis analysis;
    add_momentum_budget(record, analysis);
    EXPECT_NEAR(value_of(analysis, "momentum_inflow"), 20.0, 1e-9);
    EXPECT_NEAR(value_of(analysis, "momentum_outflow_pressure"), -31.0, 1e-9);
    EXPECT_NEAR(value_of(analysis, "momentum_form_drag_1"), -7.0, 1e-9);
    EXPECT_NEAR(value_of(analysis, "momentum_solid_friction_1"), -4.0, 1e-9);
    EXPECT_NEAR(value_of(analysis, "momentum_walls"), -17.0, 1e-9);
    EXPECT_NEAR(value_of(analysis, "momentum_residual"), 2.0, 1e-9);
    EXPECT_NEAR(value_of(analysis, "momentum_residual_share"), 2.0 / 29.0, 1e-9);
}

// Between ends of different depths the particles of a plane bed push along it, by the pressure that they
// continue: the sections have that part, and a bed without friction has no other.
TEST(MomentumBudget, LeavesOutWhatThePressureOfAPlaneBedDoesAlongIt) {
    for (const BedKind kind : {BedKind::slip, BedKind::roughness, BedKind::spheres, BedKind::no_slip}) {
        Case c = duct();
        c.channel.top = Top::free_surface;
        c.bed.kind = kind;
        c.solids.clear();
        Record record(c);
        for (const char* quantity :
             {"momentum_flux_1", "pressure_force_1", "momentum_flux_2", "pressure_force_2"}) {
            record.add("standard_end_sections", "flow_rate", quantity, 20.0);
        }
        for (const char* quantity : {"weight_component", "bed_drag"}) {
            record.add("standard_force", "force", quantity, 0.0);
        }
        record.add("standard_force", "force", "wall_force", 3.0);
        Analysis analysis;
        add_momentum_budget(record, analysis);
        EXPECT_NEAR(value_of(analysis, "momentum_residual"), kind == BedKind::no_slip ? -3.0 : 0.0, 1e-9);
    }
}

// A row is worth 5 N s, ten times as much as the flow stores in the whole window.
TEST(MomentumBudget, TakesNoRowsOfParticlesForAChangeOfTheFlow) {
    Record record(duct());
    for (const char* quantity :
         {"momentum_flux_1", "pressure_force_1", "momentum_flux_2", "pressure_force_2"}) {
        record.add("standard_end_sections", "flow_rate", quantity, 20.0);
    }
    for (const char* quantity :
         {"weight_component", "bed_drag", "wall_force", "solid_force_1", "solid_form_drag_1"}) {
        record.add("standard_force", "force", quantity, 0.0);
    }
    record.store(0.05, 5.0, 7.35);
    Analysis analysis;
    add_momentum_budget(record, analysis);
    EXPECT_NEAR(value_of(analysis, "momentum_change"), -0.05, 0.05);
}

TEST(MomentumBudget, ClosesNothingWithGrainsWhosePressureIsNotRecorded) {
    Case c = duct();
    c.porous.emplace_back().name = "plug";
    Record record(c);
    for (const char* quantity :
         {"momentum_flux_1", "pressure_force_1", "momentum_flux_2", "pressure_force_2"}) {
        record.add("standard_end_sections", "flow_rate", quantity, 20.0);
    }
    for (const char* quantity : {"weight_component", "bed_drag", "wall_force"}) {
        record.add("standard_force", "force", quantity, 0.0);
    }
    record.add("standard_force", "force", "porous_drag", 5.0);
    Analysis analysis;
    add_momentum_budget(record, analysis);
    EXPECT_NEAR(value_of(analysis, "momentum_porous_zones"), -5.0, 1e-9);
    EXPECT_EQ(find_finding(analysis, "momentum_residual_share"), nullptr);
}

// What flows in with more energy than flows out drives the water, beside its weight.
TEST(EnergyBudget, BooksWhatPassesTheEnds) {
    Record record(duct());
    record.add("standard_end_sections", "flow_rate", "energy_flux_1", 10.0, 0.1);
    record.add("standard_end_sections", "flow_rate", "energy_flux_2", 8.5);
    const auto& of = fields::time_series;
    for (const Field& field : {of.kinetic_energy, of.potential_energy, of.elastic_energy}) {
        record.set(field, 3.0);
    }
    record.set(of.gravity_power, 0.5);
    record.set(of.viscosity_power, -1.9);
    record.set(of.pressure_power, 0.05);
    Analysis analysis;
    analyse_energy(record, analysis);
    EXPECT_NEAR(value_of(analysis, "energy_input"), 2.0 / 2.0, 1e-6);  // over the length
    EXPECT_NEAR(value_of(analysis, "energy_share_ends"), 1.5 / 2.0, 1e-6);
    EXPECT_NEAR(value_of(analysis, "energy_share_gravity"), 0.5 / 2.0, 1e-6);
    EXPECT_NEAR(value_of(analysis, "energy_share_viscosity"), -1.9 / 2.0, 1e-6);
    EXPECT_NEAR(value_of(analysis, "energy_share_residual"), -0.15 / 2.0, 1e-6);
    EXPECT_EQ(find_finding(analysis, "energy_share_scheme"), nullptr);
}

/// One half of a channel that falls by a thousandth, without bodies.
Case half_channel(double width) {
    Case c = duct();
    c.channel.top = Top::free_surface;
    c.channel.ends = Ends::periodic;
    c.channel.dimensions = 3;
    c.channel.sides = Sides::half;
    c.channel.width = width;
    c.channel.slope = 0.001;
    c.solids.clear();
    return c;
}

// The powers are those of the water that is simulated, and so is the plan area.
TEST(EnergyBudget, OfHalfAChannelIsPerAreaOfTheHalf) {
    const Case c = half_channel(0.6);
    Record record(c);
    const auto& of = fields::time_series;
    for (const Field& field : {of.kinetic_energy, of.potential_energy, of.elastic_energy}) {
        record.set(field, 3.0);
    }
    record.set(of.gravity_power, 0.9);
    record.set(of.bed_drag_power, -0.9);
    Analysis analysis;
    analyse_energy(record, analysis);
    EXPECT_NEAR(value_of(analysis, "energy_input"), 0.9 / (2.0 * 0.3), 1e-9);
}

// Half of a pier stands in half of a channel, 0.6 of its width: the same coefficients as of the whole.
TEST(BodyCoefficients, OfHalfAPierAreThoseOfTheWhole) {
    for (const Sides sides : {Sides::walls, Sides::half}) {
        const double part = sides == Sides::half ? 0.5 : 1.0;
        Case c = duct();
        c.channel.dimensions = 3;
        c.channel.sides = sides;
        c.channel.width = 0.2;
        Solid pier;
        pier.name = "pier";
        pier.shape = SolidShape::box;
        pier.centre = {1.0, 0.1, 0.2};
        pier.size = {0.12, 0.12, 0.6};
        c.solids = {pier};
        c.meshes = meshes_of(c);
        Record record(c);
        record.set(fields::time_series.inflow_discharge, 0.08 * 0.2 * part);
        record.add("standard_force", "force", "solid_force_1", 2.0 * part);
        record.add("standard_force", "force", "solid_lift_1", 0.1 * part, 0.6 * part, 0.7);
        Analysis analysis;
        add_body_coefficients(record, analysis);
        const double head = 0.5 * 1000.0 * 0.2 * 0.2 * 0.12 * 0.4;
        EXPECT_NEAR(value_of(analysis, "drag_coefficient_1"), 2.0 / head, 0.02 * 2.0 / head) << part;
        EXPECT_NEAR(value_of(analysis, "strouhal_number_1"), 0.7 * 0.12 / 0.2, 0.01) << part;
    }
}

// A half of a canal: its discharge is twice what the section of the half records.
TEST(Canal, StandsBesideTheLawOfItsHydraulicRadius) {
    Case c = half_channel(0.64);
    c.channel.depth = 0.15;
    c.side_walls.drag_form = SideDragForm::none;
    Solid canal;
    canal.name = "canal";
    canal.shape = SolidShape::trapezoid;
    canal.bottom_width = 0.3;
    canal.surface = SolidSurface::log_law;
    canal.equivalent_roughness = 1e-3;
    c.solids = {canal};
    Record record(c);
    record.set(fields::time_series.total_mean_velocity, 0.54);
    record.add("standard_flow_rate", "flow_rate", "flow_rate_1", 0.018, 1e-4);
    Analysis analysis;
    analyse_along(record, analysis);
    EXPECT_NEAR(value_of(analysis, "canal_velocity"), 0.54, 1e-9);
    EXPECT_NEAR(value_of(analysis, "canal_discharge"), 0.036, 1e-6);
    const Finding* const velocity = find_finding(analysis, "canal_velocity");
    ASSERT_NE(velocity, nullptr);
    EXPECT_NEAR(velocity->reference.value_or(0.0), 0.5295, 2e-4);
    EXPECT_EQ(find_finding(analysis, "unit_discharge"), nullptr);
}

TEST(MomentumBudget, IsThatOfOpenEndsAlone) {
    Case c = duct();
    c.channel.ends = Ends::periodic;
    const Record record(c);
    Analysis analysis;
    add_momentum_budget(record, analysis);
    EXPECT_TRUE(analysis.findings.empty());
}

}  // namespace
}  // namespace riffle::body_forces_test
