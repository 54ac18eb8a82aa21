// What a case file says reaches the case: values, units, defaults, presets, options; and back to text.

#include "case_test.hpp"
// RapidCheck's header needs that of GoogleTest before it.
#include <fmt/format.h>
#include <rapidcheck/gtest.h>

#include <cmath>

#include "case/case_documents.hpp"
#include "case/flow_kind.hpp"
#include "case/key_table.hpp"
#include "case/nearest.hpp"
#include "case/presets.hpp"
#include "case/velocity_gradient.hpp"

namespace riffle::reading_test {
namespace {

using test::changed;
using test::error_of;
using test::smallest;
using testing::AllOf;
using testing::HasSubstr;
using testing::StartsWith;

Case parse(const std::string& text, const std::vector<Override>& overrides = {}) {
    return parse_case(text, "case.toml", {}, overrides);
}

TEST(Reading, DefaultsAndDerivedHeights) {
    const Case c = parse(smallest);
    EXPECT_EQ(c.channel.depth, 0.05);
    EXPECT_EQ(c.bed.roughness_height, 0.010);
    EXPECT_DOUBLE_EQ(c.total_depth(), 0.056);
    EXPECT_DOUBLE_EQ(c.datum(), 0.006);
    EXPECT_EQ(c.crest(), c.bed.roughness_height);
    Numerics numerics;
    numerics.spacing = 0.0015;  // 0.06 diameters; H/30 and d_h/5 are more
    numerics.smoothing_ratio = 2.0;
    numerics.wall_layers = 4;
    EXPECT_EQ(c.numerics, numerics);
    EXPECT_EQ(c.turbulence, Turbulence{});
    EXPECT_EQ(c.run.until, RunUntil::converged);
}

TEST(Reading, ResolutionFollowsFromTheBed) {
    EXPECT_EQ(parse(changed("\"50 mm\"", "\"20 mm\"")).numerics.spacing, 0.00086);  // H/30 = 26 mm / 30
    EXPECT_EQ(parse(changed("\"0.4 D\"", "\"5 mm\"")).numerics.spacing, 0.001);
    EXPECT_EQ(parse(changed("\"0.4 D\"", "\"0.32 D\"")).numerics.spacing, 0.0015);
    const auto given = [](const std::string& keys) {
        return parse(smallest + "[numerics]\n" + keys).numerics;
    };
    EXPECT_EQ(given("spacing = \"2 mm\"").smoothing_ratio, 2.0);
    EXPECT_EQ(given("smoothing_ratio = 1.5").wall_layers, 3);
    EXPECT_EQ(given("smoothing_ratio = 1.5").spacing, 0.0015);
    EXPECT_EQ(given("smoothing_ratio = 2.1").wall_layers, 5);
    EXPECT_EQ(given("wall_layers = 3").wall_layers, 3);
    EXPECT_EQ(given("preset = \"thesis\"").smoothing_ratio, 1.5);
    const Case smooth = parse("[channel]\nslope = 0.001\ndepth = \"50 mm\"\n\n[bed]\nkind = \"no-slip\"\n");
    EXPECT_EQ(smooth.numerics, Numerics{});
}

TEST(Reading, GravityInBedAxes) {
    const Case c = parse(changed("0.004", "0.75"));  // 3-4-5 triangle
    EXPECT_DOUBLE_EQ(c.streamwise_gravity(), 9.81 * 0.6);
    EXPECT_DOUBLE_EQ(c.normal_gravity(), 9.81 * 0.8);
}

TEST(Reading, Units) {
    const auto depth = [](const std::string& text) {
        return parse(changed("\"50 mm\"", text)).channel.depth;
    };
    for (const char* const text : {"0.05", "\"50 mm\"", "\"5cm\"", "\"0.05 m\"", "\" +50mm \"", "\"5e1 mm\"",
                                   "\"0.5 dm\"", "\"50000 um\"", "\"0.00005 km\""}) {
        EXPECT_EQ(depth(text), 0.05) << text;
    }
    EXPECT_EQ(depth("1"), 1.0);
    const Case c =
        parse(smallest +
              "[fluid]\nkinematic_viscosity = \"1.2 mm^2/s\"\ngravity = \"981 cm/s2\"\ndensity = \"0.998 "
              "g/cm3\"\n[run]\nuntil = \"2 min\"\n[numerics]\nsound_speed = \"900 cm/s\"\ntime_step = \"50 "
              "us\"\n[measured]\ndischarge = \"11 l/s\"\n");
    EXPECT_EQ(c.fluid.kinematic_viscosity, 1.2e-6);
    EXPECT_EQ(c.fluid.gravity, 9.81);
    EXPECT_EQ(c.fluid.density, 998);
    EXPECT_EQ(c.run.until, RunUntil::time);
    EXPECT_EQ(c.run.time, 120);
    EXPECT_EQ(c.numerics.sound_speed, 9);
    EXPECT_EQ(c.numerics.time_step, 50e-6);
    EXPECT_EQ(c.measured.discharge, 0.011);
}

TEST(Reading, RoughnessHeightFollowsTheDiameterWhicheverComesFirst) {
    const Case c = parse(smallest + "sphere_diameter = \"10 mm\"\n");
    EXPECT_DOUBLE_EQ(c.bed.roughness_height, 0.004);
}

TEST(Reading, UntilConvergedOrATime) {
    const Case converged = parse(smallest + "[run]\nuntil = \"converged\"\nmaximum_time = \"90 s\"\n");
    EXPECT_EQ(converged.run.until, RunUntil::converged);
    EXPECT_EQ(converged.run.time, 90);
    EXPECT_EQ(parse(smallest + "[run]\nuntil = 7\n").run.time, 7);
}

TEST(Reading, SmoothBedsHaveNoRoughnessZone) {
    const Case c = parse("[channel]\nslope = 0.001\ndepth = 1\n[bed]\nkind = \"no-slip\"\n");
    EXPECT_EQ(c.bed.roughness_height, 0);
    EXPECT_EQ(c.bed.datum_below_crest, 0);
    EXPECT_EQ(c.total_depth(), 1);
}

const std::string ribs =
    "[channel]\nslope = 0.001\ndepth = \"100 mm\"\nlength = \"300 mm\"\n[start]\nkind = \"rest\"\n"
    "[numerics]\nspacing = \"5 mm\"\n[[solid]]\nname = \"rib\"\nshape = \"rectangle\"\npart_of_bed = true\n"
    "centre = [\"150 mm\", \"10 mm\"]\nsize = [\"40 mm\", \"30 mm\"]\n";

TEST(Reading, CrestsOfASolidBedAreItsHighestPoints) {
    const Case c = parse(ribs + "[bed]\nkind = \"no-slip\"\ndatum_below_crest = \"4 mm\"\n");
    EXPECT_DOUBLE_EQ(c.crest(), 0.025);
    EXPECT_DOUBLE_EQ(c.datum(), 0.021);
    EXPECT_DOUBLE_EQ(c.total_depth(), 0.121);
    EXPECT_TRUE(parse(c.text).same_parameters(c));
    const Case lower = parse(ribs + "[bed]\nkind = \"no-slip\"\nroughness_height = \"15 mm\"\n");
    EXPECT_DOUBLE_EQ(lower.crest(), 0.015);
    EXPECT_DOUBLE_EQ(lower.datum(), 0.015);
    // Of spheres the highest points are known to the bit, the facets of their surfaces are not them.
    const Case spheres =
        read_case(std::filesystem::path(RIFFLE_SOURCE_DIR) / "cases/rough-bed-3d/resolved-spheres.toml");
    EXPECT_EQ(spheres.crest(), 0.0125);
    EXPECT_DOUBLE_EQ(spheres.total_depth(), 0.0585);
}

TEST(Reading, PresetSetsDefaultsAndGivenKeysWin) {
    const Case c = parse(smallest + "[numerics]\nsound_speed = \"30 m/s\"\npreset = \"thesis\"\n");
    Numerics expected = preset_numerics(Preset::thesis);
    EXPECT_EQ(expected.sound_speed, 60);
    expected.sound_speed = 30;
    EXPECT_EQ(c.numerics, expected);
    EXPECT_EQ(parse(smallest + "[numerics]\npreset = \"paper\"\n").numerics, preset_numerics(Preset::paper));
    // The speed of sound that the thesis took in three dimensions (its Table 6.1).
    EXPECT_EQ(preset_numerics(Preset::thesis, 3).sound_speed, 20);
    EXPECT_EQ(
        parse(smallest + "[numerics]\npreset = \"paper\"\nsound_speed = \"auto\"\n").numerics.sound_speed,
        std::nullopt);
}

TEST(Options, ReplaceAndAdd) {
    const Case c = parse(smallest, {{"channel.depth", "60 mm"},
                                    {"channel.slope", ".002"},
                                    {"turbulence.closure", "nikuradse"},
                                    {"start.seed", "7"},
                                    {"measured.uniform", "false"},
                                    {"bed.roughness_height", "\"0.32 D\""},
                                    {"title", "2026"},
                                    {"run.until", "60 s"}});
    EXPECT_EQ(c.channel.depth, 0.06);
    EXPECT_EQ(c.channel.slope, 0.002);
    EXPECT_EQ(c.turbulence.closure, ClosureKind::nikuradse);
    EXPECT_EQ(c.start.seed, 7);
    EXPECT_FALSE(c.measured.uniform);
    EXPECT_DOUBLE_EQ(c.bed.roughness_height, 0.008);
    EXPECT_EQ(c.title, "2026");
    EXPECT_EQ(c.run.time, 60);
}

TEST(Options, TheLastOfTwoWins) {
    EXPECT_EQ(parse(smallest, {{"channel.depth", "60 mm"}, {"channel.depth", "70 mm"}}).channel.depth, 0.07);
}

TEST(Options, MendAWrongValueOfTheFile) {
    EXPECT_EQ(parse(changed("\"50 mm\"", "-1"), {{"channel.depth", "1 m"}}).channel.depth, 1);
}

TEST(Options, ErrorsNameTheOption) {
    EXPECT_THAT(error_of(smallest, {{"channel.slop", "3"}}),
                StartsWith("--set channel.slop=3: unknown key `slop` in [channel]: did you mean `slope`?"));
    EXPECT_THAT(error_of(smallest, {{"chanel.slope", "3"}}),
                StartsWith("--set chanel.slope=3: unknown section [chanel]"));
    EXPECT_THAT(error_of(smallest, {{"channel.depth", "-3"}}),
                StartsWith("--set channel.depth=-3: [channel] depth = -3: expected a length greater than 0"));
    EXPECT_THAT(
        error_of(smallest, {{"numerics.spacing", "20mm"}}),
        HasSubstr("--set numerics.spacing=20mm: [numerics] spacing is 20 mm, larger than the roughness"));
    EXPECT_THAT(error_of(smallest, {{"bed.kind", "sphere"}}), HasSubstr("did you mean \"spheres\"?"));
    EXPECT_THAT(error_of(smallest, {{"slope", "0.1"}}), HasSubstr("it belongs in [channel]"));
    EXPECT_NE(error_of(smallest, {{"channel.slope", "0.1\nlength = 5"}}), "");
}

TEST(Nearest, EditDistance) {
    EXPECT_EQ(edit_distance("", "abc"), 3);
    EXPECT_EQ(edit_distance("slope", "slope"), 0);
    EXPECT_EQ(edit_distance("slpoe", "slope"), 1);
    EXPECT_EQ(edit_distance("kitten", "sitting"), 3);
}

RC_GTEST_PROP(Nearest, EditDistanceIsAMetricOnNeighbours, (const std::string& a, const std::string& b)) {
    const auto distance = edit_distance(a, b);
    RC_ASSERT(distance == edit_distance(b, a));
    RC_ASSERT((distance == 0) == (a == b));
    RC_ASSERT(distance <= std::max(a.size(), b.size()));
    RC_ASSERT(edit_distance(a + "x", b) <= distance + 1);
}

/// A number as a case may hold it: of any size within `low` to `high`, with all its digits.
rc::Gen<double> number_between(double low, double high) {
    constexpr long long steps = 1LL << 52;
    return rc::gen::map(rc::gen::inRange<long long>(0, steps), [=](long long i) {
        return low + (high - low) * static_cast<double>(i) / static_cast<double>(steps);
    });
}

/// Any value that a key takes by itself.
Value any_value(const Key& key) {
    if (!key.unset_word.empty() && *rc::gen::inRange(0, 3) == 0) {
        return {};
    }
    const double low = std::isfinite(key.range.minimum) ? key.range.minimum : -10.0;
    const double high = std::isfinite(key.range.maximum) ? key.range.maximum : low + 1000.0;
    switch (key.type) {
        case ValueType::number: {
            const double number = *number_between(low, high);
            return key.range.contains(number) ? number : high;
        }
        case ValueType::integer:
            return *rc::gen::inRange(static_cast<long long>(low), static_cast<long long>(high) + 1);
        case ValueType::boolean:
            return *rc::gen::arbitrary<bool>();
        case ValueType::word:
            return std::string(key.words[*rc::gen::inRange<std::size_t>(0, key.words.size())].name);
        case ValueType::text:
        case ValueType::file:
            return *rc::gen::container<std::string>(rc::gen::map(
                rc::gen::inRange(0x20, 0x7f), [](int letter) { return static_cast<char>(letter); }));
    }
    return {};
}

/// A valid probe of any kind in a channel of at least 0.1 m and a depth of at least 0.03 m.
Probe any_probe(const Case& c, const std::string& name) {
    Probe p;
    p.name = name;
    p.kind = static_cast<ProbeKind>(*rc::gen::inRange<std::size_t>(0, Words<ProbeKind>::list.size()));
    p.sampling_frequency = *number_between(10.0, 200.0);
    const auto positions = [](double high) {
        std::vector<double> list(*rc::gen::inRange<std::size_t>(1, 4));
        for (double& value : list) value = *number_between(1e-3, high);
        return list;
    };
    const bool section = p.kind == ProbeKind::flow_rate;
    const bool points = p.kind == ProbeKind::velocity || p.kind == ProbeKind::pressure;
    if (points || p.kind == ProbeKind::wave || section) p.x = positions(c.channel.length);
    if (points) {
        p.x.resize(1);
        p.z = positions(0.02);
    }
    if (p.kind == ProbeKind::velocity) p.sampling_length = *number_between(0.0, 0.01);
    if (p.kind == ProbeKind::surface_line || p.kind == ProbeKind::grid) {
        p.spacing = *number_between(0.02, 0.05);
    }
    if (p.kind == ProbeKind::grid) {
        p.spacing = c.channel.length / 20.0;
        p.x_to = *number_between(0.05, 0.1);
        p.z_from = *number_between(0.0, 0.01);
        p.averaging_time = *number_between(0.2, 0.4) * c.run.time;
        p.sampling_frequency = 100.0 / c.run.time;
    }
    return p;
}

/// A valid case with many of its keys changed.
Case any_case() {
    Case c = parse(smallest);
    c.numerics = preset_numerics(*rc::gen::element(Preset::riffle, Preset::thesis, Preset::paper));
    // Keys with demands on each other keep values that go together.
    const std::vector<std::string> fixed{"channel.length",
                                         "channel.ends",
                                         "channel.top",
                                         "bed.kind",
                                         "numerics.preset",
                                         "numerics.spacing",
                                         "numerics.smoothing_ratio",
                                         "numerics.impact_dissipation",
                                         "bed.sphere_diameter",
                                         "bed.roughness_height",
                                         "bed.datum_below_crest",
                                         "turbulence.zero",
                                         "fluid.gravity",
                                         "start.kind",
                                         "start.velocity",
                                         "start.amplitude",
                                         "channel.depth",
                                         "channel.slope",
                                         "run.average_from",
                                         "channel.dimensions",
                                         "channel.width",
                                         "channel.sides",
                                         "bed.drag_form",
                                         "numerics.wall",
                                         "numerics.stepping",
                                         "numerics.skin",
                                         "start.lattice",
                                         "turbulence.stress_terms",
                                         "output.snapshot_fields",
                                         "output.snapshot_x",
                                         "output.snapshot_y",
                                         "output.snapshot_z"};
    if (*rc::gen::arbitrary<bool>()) {
        c.channel.dimensions = 3;
        c.channel.sides = *rc::gen::element(Sides::periodic, Sides::walls, Sides::half);
    }
    for (const SectionKeys& section : key_table()) {
        for (const Key& key : section.keys) {
            const bool without_place = key.applies.strictly && key.section != "run" && !key_applies(key, c);
            if (!section.repeated() && !without_place &&
                std::find(fixed.begin(), fixed.end(), key.id()) == fixed.end() &&
                *rc::gen::arbitrary<bool>()) {
                key.set(c, any_value(key));
            }
        }
    }
    c.channel.slope = *number_between(1e-5, 1.0);
    c.channel.depth = *number_between(0.03, 3.0);
    c.channel.length = *number_between(0.1, 30.0);
    c.bed.sphere_diameter = *number_between(0.005, 0.1);
    if (c.channel.dimensions == 3) {
        c.numerics.wall = *rc::gen::element(WallKind::dummy, WallKind::modified_dynamic);
        c.start.lattice = *rc::gen::element(StartLattice::square, StartLattice::body_centred);
        // Spheres that tile the channel, and side walls within their edge zones.
        c.bed.sphere_diameter = *number_between(0.01, 0.02);
        c.bed.sphere_ramp = 0.1 * c.bed.sphere_diameter;
        c.bed.packing = Packing::hexagonal;
        c.bed.drag_form = *rc::gen::element(DragForm::consistent, DragForm::slice, DragForm::thesis);
        c.channel.length = c.bed.sphere_diameter * *rc::gen::inRange(10, 20);
        c.channel.width = c.bed.sphere_diameter * std::sqrt(3.0) * *rc::gen::inRange(5, 20);
        c.turbulence.edge_zone = 10.0;
        if (c.has_side_walls()) {
            c.side_walls.layer = *number_between(0.005, 0.01);
            if (c.turbulence.closure == ClosureKind::none &&
                c.side_walls.drag_form == SideDragForm::log_law) {
                c.side_walls.drag_form = SideDragForm::none;
            }
        }
        c.output.snapshot_y = {0.0, 0.01};
    }
    c.side_walls.equivalent_roughness.reset();
    if (c.has_side_walls() && c.side_walls.drag_form == SideDragForm::log_law) {
        c.side_walls.equivalent_roughness = *number_between(0.0, 0.004);
    }
    c.bed.roughness_height = c.bed.sphere_diameter * *number_between(0.5, 1.0);
    c.bed.datum_below_crest = c.bed.roughness_height * *number_between(0.0, 1.0);
    c.turbulence.zero = *number_between(0.0, 0.02);
    c.fluid.gravity = *number_between(0.1, 20.0);
    // Options of the pair sums that go together.
    Numerics& n = c.numerics;
    if (n.pressure_form == PressureForm::riemann_non_conservative) {  // not with a free surface
        n.pressure_form = PressureForm::riemann;
    }
    if (n.tensile_correction > 0.0) {
        n.kernel = KernelKind::cubic_spline;
        n.pressure_form = PressureForm::symmetric;
    }
    if (n.kernel_correction == KernelCorrection::kernel) {
        n.tensile_correction = 0.0;
        n.pressure_form = PressureForm::corrected;
    }
    if (n.viscosity == ViscosityForm::artificial) {
        n.eddy_stress = EddyStress::stress_divergence;
        if (n.has_riemann_problem()) n.pressure_form = PressureForm::corrected;
    }
    if (c.channel.dimensions == 3 && n.viscosity != ViscosityForm::morris) c.turbulence.spanwise_ratio = 1.0;
    if (c.output.surface_threshold) c.output.surface_threshold = *number_between(0.1, 0.9);
    if (n.wall != WallKind::dummy) n.reference_pressure = ReferencePressure::none;
    if (n.stepping == Stepping::verlet) n.density_diffusion = DensityDiffusion::none;
    if (n.stepping == Stepping::leapfrog) n.xsph = 0.0;
    if (!needs_gradients(c)) n.density_relaxation = 0.0;
    if (c.channel.dimensions == 2 && resolves_eddies(c)) c.turbulence.closure = ClosureKind::nezu_rodi;
    // Most cases have nothing to pack, and are refused.
    c.start.packed = false;
    const int probes = *rc::gen::inRange(0, 4);
    for (int i = 0; i < probes; ++i) c.probes.push_back(any_probe(c, "probe-" + std::to_string(i)));
    if (why_no_column(c)) c.start.kind = StartKind::rest;
    return c;
}

RC_GTEST_PROP(RoundTrip, NormalisedTextGivesTheSameCase, ()) {
    const Case c = any_case();
    // The template shows handy units, the normalised text SI: both must mean the same.
    const Case from_template = parse(case_template(c));
    RC_ASSERT(from_template.same_parameters(c));
    const Case again = parse(from_template.text);
    RC_ASSERT(again.same_parameters(c));
    RC_ASSERT(again.text == from_template.text);
}

/// Whether a text is read, or refused by an InputError that names the file or the option.
bool read_or_refused(const std::string& text, const std::vector<Override>& overrides = {}) {
    try {
        const Case c = parse_case(text, "case.toml", {}, overrides);
        return parse(c.text).same_parameters(c);
    } catch (const InputError& error) {
        const std::string message = error.what();
        return message.rfind("case.toml", 0) == 0 || message.rfind("--set ", 0) == 0;
    }
}

RC_GTEST_PROP(Robustness, DamagedTextIsReadOrRefused, ()) {
    std::string text = case_template(any_case());
    const int damages = *rc::gen::inRange(1, 4);
    for (int i = 0; i < damages; ++i) {
        const auto at = *rc::gen::inRange<std::size_t>(0, text.size());
        const auto length = *rc::gen::inRange<std::size_t>(0, 4);
        text.replace(at, length, *rc::gen::arbitrary<std::string>());
    }
    RC_ASSERT(read_or_refused(text));
}

RC_GTEST_PROP(Robustness, AnyOptionIsReadOrRefused, (const std::string& value)) {
    const SectionKeys& section = *rc::gen::elementOf(key_table());
    const Key& key = *rc::gen::elementOf(section.keys);
    RC_ASSERT(read_or_refused(smallest, {{key.id(), value}}));
    RC_ASSERT(read_or_refused(smallest, {{value, "1"}}));
}

RC_GTEST_PROP(RoundTrip, HandyQuantitiesReadBackTheSame, ()) {
    const double value =
        *rc::gen::map(rc::gen::pair(number_between(1.0, 10.0), rc::gen::inRange(-9, 6)),
                      [](const auto& parts) { return parts.first * std::pow(10.0, parts.second); });
    for (const Dimension dimension : {Dimension::length, Dimension::time, Dimension::kinematic_viscosity}) {
        const auto quantity = split_quantity(quantity_text(value, dimension));
        RC_ASSERT(quantity.has_value());
        RC_ASSERT(to_si(*quantity, dimension) == std::optional(value));
    }
}

TEST(RoundTrip, EveryKeyIsBoundToItsOwnMember) {
    // Changing one key changes the case, and no other key.
    for (const SectionKeys& section : key_table()) {
        for (const Key& key : section.keys) {
            Case c = parse(smallest);
            const Case before = c;
            Value value = key.get(c);
            if (auto* const number = std::get_if<double>(&value)) {
                *number += 0.125;
            } else if (auto* const integer = std::get_if<long long>(&value)) {
                *integer += 1;
            } else if (auto* const boolean = std::get_if<bool>(&value)) {
                *boolean = !*boolean;
            } else if (key.type == ValueType::word) {
                value = std::string(key.words.back().name == std::get<std::string>(value)
                                        ? key.words.front().name
                                        : key.words.back().name);
            } else if (auto* const list = std::get_if<std::vector<double>>(&value)) {
                list->push_back(0.125);
            } else if (std::holds_alternative<std::monostate>(value)) {
                value = key.type == ValueType::boolean ? Value(true) : Value(0.125);
            } else {
                value = std::string("other");
            }
            key.set(c, value);
            EXPECT_EQ(key.get(c), value) << key.id();
            EXPECT_FALSE(c.same_parameters(before)) << key.id();
            for (const SectionKeys& other_section : key_table()) {
                for (const Key& other : other_section.keys) {
                    const bool same_member =
                        key.section == "run" && other.section == "run";  // until and maximum_time
                    if (&other != &key && !same_member) {
                        EXPECT_EQ(other.get(c), other.get(before)) << key.id() << " changes " << other.id();
                    }
                }
            }
        }
    }
}

}  // namespace
}  // namespace riffle::reading_test
