// What a valid case is warned of.

#include "case/warnings.hpp"

#include <set>
#include <string>
#include <vector>

#include "case/flow_conditions.hpp"
#include "case/presets.hpp"
#include "changed_cases.hpp"

namespace riffle::warnings_test {
namespace {

using test::between_side_walls;
using test::cell;
using test::flume;
using test::gravel;
using test::open_channel_with_solid;
using test::smallest;
using test::tank;
using test::with_keys;
using test::with_porous;
using test::with_solid;
using test::with_vegetation;
using test::with_water;
using testing::Contains;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::Not;

std::vector<std::string> warnings_with(const std::vector<Override>& overrides) {
    return case_warnings(parse_case(smallest, "case.toml", {}, overrides));
}

TEST(Warnings, NoneForTheDefaults) { EXPECT_THAT(warnings_with({}), IsEmpty()); }

struct Warned {
    const char* key;
    const char* value;
    const char* about;
};

class WarnsOf : public testing::TestWithParam<Warned> {};

TEST_P(WarnsOf, TheKey) {
    const auto warnings = warnings_with({{GetParam().key, GetParam().value}});
    EXPECT_THAT(warnings, Contains(HasSubstr(GetParam().about))) << GetParam().key;
}

INSTANTIATE_TEST_SUITE_P(
    Choices, WarnsOf,
    testing::Values(
        Warned{"numerics.spacing", "3 mm", "rows in the roughness zone"},
        Warned{"numerics.spacing", "3 mm", "rows over the depth"},
        Warned{"numerics.kernel", "cubic-spline", "numerics.kernel"},
        Warned{"numerics.smoothing_ratio", "1.3", "verified with 1.5 and 2.0"},
        Warned{"numerics.wall_layers", "3", "do not fill the kernel"},
        Warned{"numerics.pressure_form", "symmetric", "shear stress as large as the flow's own friction"},
        Warned{"numerics.kernel_correction", "kernel", "spurious shear stress of the symmetric form"},
        Warned{"numerics.density_diffusion", "none", "free of noise"},
        Warned{"numerics.density_diffusion_coefficient", "0.5", "from 0.02 to 0.1"},
        Warned{"numerics.sound_speed", "2", "compresses it by 13.7 %"},
        Warned{"numerics.viscosity", "monaghan-gingold", "too weak"},
        Warned{"numerics.eddy_stress", "stress-divergence", "zigzags"},
        Warned{"numerics.courant_number", "1.2", "numerics.courant_number"},
        Warned{"numerics.stepping", "predictor-corrector", "more than 0.4"},
        Warned{"numerics.wall", "dynamic", "numerics.wall"}, Warned{"turbulence.closure", "sps", "far below"},
        Warned{"turbulence.closure", "none", "without a closure"},
        Warned{"bed.drag_form", "thesis", "scales as 1 / spacing"},
        Warned{"start.jitter", "0.4", "start.jitter"},
        Warned{"start.exponent", "4", "has no effect: it is used only with start.kind = \"power-law\""},
        Warned{"turbulence.filter_width", "1 mm", "has no effect"}));

// Rows are few where the water is shallow: at an inflow or outflow that the case makes so.
TEST(Warnings, TooFewRowsOverAShallowEnd) {
    const auto warned = [](const std::string& ends) {
        return case_warnings(parse_case(
            "[channel]\nslope = 0\ndepth = \"70 mm\"\nlength = \"1 m\"\nends = \"open\"\n[bed]\nkind = \"roughness\"\n"
            "equivalent_roughness = \"1 mm\"\n[numerics]\nspacing = \"2 mm\"\n[start]\nkind = \"uniform\"\n[run]\n"
            "until = \"5 s\"\n" +
                ends,
            "test"));
    };
    const std::string shallow =
        "[inflow]\nunit_discharge = \"0.0266 m2/s\"\ndepth = \"20 mm\"\n[outflow]\nkind = \"free\"\n";
    EXPECT_THAT(warned(shallow), Contains(HasSubstr("only 10 rows over the depth of the inflow, 20 mm")));
    EXPECT_THAT(
        warned("[inflow]\nunit_discharge = \"0.004 m2/s\"\n[outflow]\nkind = \"depth\"\ndepth = \"18 mm\"\n"),
        Contains(HasSubstr("only 9 rows over the depth of the outflow, 18 mm")));
    EXPECT_THAT(
        warned(
            "[inflow]\nunit_discharge = \"0.0266 m2/s\"\n[outflow]\nkind = \"depth\"\ndepth = \"70 mm\"\n"),
        Not(Contains(HasSubstr("rows over"))));
}

/// A level channel with open ends over a slip bed, with a weir.
std::vector<std::string> warnings_of_weir(const std::string& more) {
    return case_warnings(parse_case(
        "[channel]\nslope = 0\ndepth = \"120 mm\"\nlength = \"1 m\"\nends = \"open\"\n[bed]\nkind = \"slip\"\n"
        "[turbulence]\nclosure = \"none\"\n[numerics]\nspacing = \"5 mm\"\n[run]\nuntil = \"5 s\"\n[[solid]]\nname = "
        "\"weir\"\nx = [\"400 mm\", \"430 mm\", \"430 mm\", \"400 mm\"]\nz = [\"0 mm\", \"0 mm\", \"60 mm\", \"60 mm\"]\n" +
            more,
        "test"));
}

// A slip bed has rows as well.
TEST(Warnings, TooFewRowsOverAnyBed) {
    EXPECT_THAT(
        warnings_of_weir(
            "[inflow]\nunit_discharge = \"0.01 m2/s\"\nprofile = \"uniform\"\ndepth = \"8 mm\"\n[outflow]\nkind = "
            "\"free\"\n[start]\nkind = \"uniform\"\n"),
        Contains(HasSubstr("only 2 rows over the depth of the inflow, 8 mm")));
}

TEST(Warnings, AStartOfVariedFlowKnowsNoSolids) {
    const std::string ends =
        "[inflow]\nunit_discharge = \"0.01 m2/s\"\nprofile = \"uniform\"\n[outflow]\nkind = \"depth\"\ndepth = \"120 mm\"\n";
    EXPECT_THAT(warnings_of_weir(ends + "[start]\nkind = \"backwater\"\n"),
                Contains(HasSubstr("knows the bed alone")));
    EXPECT_THAT(warnings_of_weir(ends + "[start]\nkind = \"uniform\"\n"),
                Not(Contains(HasSubstr("knows the bed"))));
}

TEST(Warnings, SmoothedMotion) {
    EXPECT_THAT(warnings_with({{"numerics.xsph", "0.5"}, {"numerics.stepping", "semi-implicit-euler"}}),
                Contains(HasSubstr("numerics.xsph")));
}

TEST(Warnings, SmoothingRatiosThatLetALatticeRest) {
    const auto with = [](const std::string& ratio, const std::string& lattice) {
        return warnings_with({{"numerics.smoothing_ratio", ratio}, {"start.lattice", lattice}});
    };
    EXPECT_THAT(with("1.83", "hexagonal"), Not(Contains(HasSubstr("is not verified"))));
    EXPECT_THAT(with("1.83", "square"), Contains(HasSubstr("1.83 is not verified")));
    EXPECT_THAT(with("1.65", "square"), Contains(HasSubstr("1.65 is not verified")));
}

TEST(Warnings, LittleDensityDiffusionIsForAWideKernel) {
    const auto with_ratio = [](const std::string& ratio) {
        return warnings_with(
            {{"numerics.smoothing_ratio", ratio}, {"numerics.density_diffusion_coefficient", "0.02"}});
    };
    EXPECT_THAT(with_ratio("1.5"), Contains(HasSubstr("with h = 1.5 dx use 0.1")));
    EXPECT_THAT(with_ratio("2"), IsEmpty());
}

TEST(Warnings, WallsThatNeedMoreOrGiveLess) {
    const auto modified = [](const std::string& diffusion) {
        return warnings_with(
            {{"numerics.wall", "modified-dynamic"}, {"numerics.density_diffusion", diffusion}});
    };
    EXPECT_THAT(modified("none"), Contains(HasSubstr("carry the noise of the density")));
    const std::vector<std::string> rough = modified("fourtakas");
    ASSERT_EQ(rough.size(), 1U);
    EXPECT_THAT(rough.front(), HasSubstr("runs over a rough bed fail with them"));
    EXPECT_THAT(warnings_with({{"numerics.wall", "repulsive"}, {"numerics.pressure_form", "symmetric"}}),
                Contains(HasSubstr("\"repulsive\" walls hold the water and give no more")));
}

TEST(Warnings, WaterThatBreaksAsksForItsPreset) {
    const Case dam = builtin_case("dam-break");
    EXPECT_THAT(case_warnings(dam), IsEmpty());
    Case plain = dam;
    plain.numerics = preset_numerics(Preset::riffle);
    plain.numerics.spacing = 0.005;
    EXPECT_THAT(case_warnings(plain), Contains(HasSubstr("preset = \"violent\"")));
    plain.run.time = 0.2;  // over before the front has come to the wall
    EXPECT_THAT(case_warnings(plain), IsEmpty());
    plain.run.time = 3.0;
    plain.start.water_x = {0.0, 1.61, 1.61, 0.0};  // fills the tank
    EXPECT_THAT(case_warnings(plain), IsEmpty());
    plain.start.water_x = {0.1, 1.61, 1.61, 0.1};  // but for what a piston takes
    Solid piston;
    piston.x = {0.0, 0.1, 0.1, 0.0};
    piston.z = {0.0, 0.0, 0.5, 0.5};
    plain.solids.push_back(piston);
    EXPECT_THAT(case_warnings(plain), IsEmpty());
    plain.solids.front().velocity_z = 0.1;  // which is lifted
    EXPECT_THAT(case_warnings(plain), Contains(HasSubstr("preset = \"violent\"")));
    plain.solids.clear();
    plain.start.water_x = {0.0, 1.61, 1.61, 0.0};
    plain.start.water_z = {0.1, 0.1, 0.3, 0.3};  // and falls
    EXPECT_THAT(case_warnings(plain), Contains(HasSubstr("preset = \"violent\"")));
}

TEST(Warnings, SoundSpeedAgainstTheMeasuredVelocity) {
    EXPECT_THAT(warnings_with({{"numerics.sound_speed", "7.5"}}), IsEmpty());
    EXPECT_THAT(warnings_with({{"numerics.sound_speed", "7.5"}, {"measured.depth_mean_velocity", "0.9"}}),
                Contains(HasSubstr("less than 10 times the largest velocity")));
}

TEST(Warnings, PresetsOfTheLiteratureAreForStudy) {
    for (const char* const preset : {"thesis", "paper"}) {
        EXPECT_THAT(warnings_with({{"numerics.preset", preset}}),
                    Contains(HasSubstr("numerics.pressure_form")));
    }
}

std::vector<std::string> warnings_about(const Case& c, const char* word) {
    std::vector<std::string> all = case_warnings(c);
    std::erase_if(all, [&](const std::string& warning) { return warning.find(word) == std::string::npos; });
    return all;
}

// Shapes may be put together from solids that overlap or touch; one that no water reaches is a slip.
TEST(Warnings, OfSolidsThatStandInOthers) {
    const auto with_stone = [](const std::string& place) {
        return with_keys(with_solid(), "solid[1].name = stone; " + place);
    };
    const auto warned = [&](const std::string& place) {
        return warnings_about(with_stone(place), "no water touches it");
    };
    const auto inside = warned("solid[1].x = [0.09, 0.11, 0.11, 0.09]; solid[1].z = [0, 0, 0.02, 0.02]");
    ASSERT_EQ(inside.size(), 1U);
    EXPECT_THAT(inside[0], HasSubstr("solid.name: stone: stands in the solid \"weir\""));
    EXPECT_THAT(warned("solid[1].x = [0.09, 0.11, 0.11, 0.09]; solid[1].z = [0, 0, 0.04, 0.04]"), IsEmpty());
    EXPECT_THAT(warned("solid[1].x = [0.12, 0.14, 0.14, 0.12]; solid[1].z = [0, 0, 0.03, 0.03]"), IsEmpty());
    EXPECT_THAT(warned("solid[1].x = [0.09, 0.11, 0.11, 0.09]; solid[1].z = [0.03, 0.03, 0.04, 0.04]"),
                IsEmpty());
}

// Spheres of 10 mm among those of 20 mm stand in them; lifted onto them they do not.
TEST(Warnings, OfLayersOfSpheresInEachOther) {
    const auto warned = [](const char* level) {
        return warnings_about(
            with_keys(
                test::with_shape(SolidShape::spheres),
                std::string("solid[1].name = sand; solid[1].shape = spheres; solid[1].diameter = 10 mm; "
                            "solid[1].level = ") +
                    level),
            "stand in them");
    };
    const auto among = warned("5 mm");
    ASSERT_EQ(among.size(), 1U);
    EXPECT_THAT(among[0], HasSubstr("sand: spheres of \"s\" stand in them, one of them at x = "));
    EXPECT_THAT(warned("25 mm"), IsEmpty());
}

// Gauges in a weir of 0.08 to 0.12 m, 30 mm high, on its faces and over it.
TEST(Warnings, GaugesInASolid) {
    const auto warned = [](const std::string& probe) {
        return warnings_about(
            with_keys(with_solid(), "probe[0].name = gauge; probe[0].sampling_frequency = 50; " + probe),
            "no water comes there");
    };
    EXPECT_THAT(warned("probe[0].kind = velocity; probe[0].x = [0.1]; probe[0].z = [0.01]"), Not(IsEmpty()));
    EXPECT_THAT(warned("probe[0].kind = pressure; probe[0].x = [0.1]; probe[0].z = [0.01]"), Not(IsEmpty()));
    EXPECT_THAT(warned("probe[0].kind = pressure; probe[0].x = [0.08]; probe[0].z = [0.01]"), IsEmpty());
    // On the bed, under the solid and beside it.
    EXPECT_THAT(warned("probe[0].kind = pressure; probe[0].x = [0.1]; probe[0].z = [0]"),
                Contains(HasSubstr("the point of \"gauge\" at x = 100 mm, z = 0 m stands")));
    EXPECT_THAT(warned("probe[0].kind = pressure; probe[0].x = [0.05]; probe[0].z = [0]"), IsEmpty());
    EXPECT_THAT(warned("probe[0].kind = pressure; probe[0].x = [0.1]; probe[0].z = [0.03]"), IsEmpty());
    // The water covers the weir, but not a pier.
    EXPECT_THAT(warned("probe[0].kind = wave; probe[0].x = [0.1]"), IsEmpty());
    EXPECT_THAT(warned("probe[0].kind = wave; probe[0].x = [0.1]; solid[0].z = [0, 0, 0.3, 0.3]"),
                Not(IsEmpty()));
}

TEST(Warnings, EachRowHasACase) {
    const std::string noisy = "numerics.density_diffusion = none; ";
    const std::vector<Case> cases = {
        with_keys(flume(), "numerics.spacing = 3 mm; measured.uniform = false"),
        with_keys(flume(), "numerics.kernel = cubic-spline; numerics.kernel_correction = kernel"),
        with_keys(flume(), "numerics.kernel = quintic-spline; numerics.smoothing_ratio = 1.75"),
        with_keys(flume(), "numerics.pressure_form = symmetric; numerics.wall = repulsive"),
        with_keys(flume(), "numerics.pressure_form = riemann; numerics.density_diffusion = molteni"),
        with_keys(flume(), "numerics.density_diffusion = antuono"),
        with_keys(flume(), noisy + "numerics.wall = modified-dynamic; numerics.courant_number = 1"),
        with_keys(flume(), "numerics.density_diffusion_coefficient = 0.01; numerics.smoothing_ratio = 1.5"),
        with_keys(flume(),
                  "numerics.xsph = 0.1; numerics.stepping = semi-implicit-euler; start.jitter = 0.3"),
        with_keys(flume(), "numerics.sound_speed = 2; measured.depth_mean_velocity = 1"),
        with_keys(flume(), "numerics.viscosity = monaghan-gingold; numerics.eddy_stress = stress-divergence"),
        with_keys(flume(), "numerics.viscosity = artificial; turbulence.closure = none"),
        with_keys(flume(), "numerics.wall_layers = 2; bed.drag_form = thesis"),
        with_keys(flume(), "numerics.wall = dynamic; turbulence.closure = sps"),
        with_keys(tank(), "bed.kind = no-slip"),
        with_keys(tank(), "bed.kind = slip; numerics.wall = dynamic"),
        with_keys(cell(), "bed.kind = no-slip; turbulence.closure = wale"),
        with_keys(with_water(), "run.until = 3"),
        with_keys(gravel(), "bed.equivalent_roughness = 20 mm; numerics.spacing = 0.5 mm"),
        with_keys(gravel(), "numerics.spacing = 5 mm"),
        with_keys(open_channel_with_solid(), "solid[0].z = [0.012, 0.012, 0.3, 0.3]"),
        with_keys(with_vegetation(), "vegetation[0].stem_diameter = 25 mm"),
        with_keys(with_vegetation(),
                  "bed.kind = slip; turbulence.closure = none; vegetation[0].height = 5 mm"),
        with_keys(with_porous(), "porous[0].edge = 60 mm"),
        with_keys(
            gravel(),
            "porous[0].name = p; porous[0].porosity = 0.4; porous[0].grain_size = 2 mm; porous[0].z_to = 20 mm"),
        with_keys(cell(), "start.lattice = body-centred"),
        with_keys(between_side_walls(), "turbulence.closure = sps; numerics.stepping = semi-implicit-euler"),
        with_keys(
            with_solid(),
            "solid[1].name = stone; solid[1].x = [0.09, 0.11, 0.11, 0.09]; solid[1].z = [0, 0, 0.02, 0.02]"),
        with_keys(
            with_solid(),
            "probe[0].name = adv; probe[0].x = [0.1]; probe[0].z = [0.01]; probe[0].sampling_frequency = 50"),
        with_keys(test::with_shape(SolidShape::spheres),
                  "solid[1].name = sand; solid[1].shape = spheres; solid[1].diameter = 10 mm"),
        with_keys(
            with_solid(),
            "channel.ends = open; channel.slope = 0; inflow.unit_discharge = 0.01; outflow.kind = depth; "
            "outflow.depth = 50 mm; start.kind = backwater"),
        with_keys(with_solid(),
                  "channel.dimensions = 3; solid[0].motion = constant; solid[0].velocity_z = 3"),
        with_keys(with_solid(), "solid[0].z = [2, 2, 2.1, 2.1]"),
        with_keys(test::with_shape(SolidShape::trapezoid), "bed_patch[0].name = strip"),
    };
    std::set<const CaseCheck*> met;
    for (const Case& c : cases) {
        for_each_finding(warnings(), c,
                         [&](const CaseCheck& check, const CaseFinding&) { met.insert(&check); });
    }
    for (const CaseCheck& check : warnings().checks) {
        EXPECT_TRUE(met.contains(&check)) << "no case has " << check.what;
    }
}

}  // namespace
}  // namespace riffle::warnings_test
