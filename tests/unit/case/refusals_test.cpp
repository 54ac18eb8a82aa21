// Each row of the tables of checks finds something in a case that a file can hold, and its message says so.

#include "case/refusals.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <regex>
#include <set>

#include "case/case_text.hpp"
#include "case/solid_mesh.hpp"
#include "case/solid_shapes.hpp"
#include "case/warnings.hpp"
#include "changed_cases.hpp"

namespace riffle::refusals_test {
namespace {

using test::between_side_walls;
using test::cell;
using test::duct;
using test::duct_with_step;
using test::earth;
using test::flume;
using test::glass;
using test::gravel;
using test::open_canal;
using test::open_channel;
using test::open_channel_in_file;
using test::open_channel_over_step;
using test::open_channel_with_solid;
using test::periodic_box;
using test::plates;
using test::tank;
using test::with_bed_patches;
using test::with_keys;
using test::with_mesh;
using test::with_porous;
using test::with_porous_in_plan;
using test::with_porous_outline;
using test::with_probe;
using test::with_shape;
using test::with_solid;
using test::with_two_solids;
using test::with_vegetation;
using test::with_water;
using testing::HasSubstr;
using testing::Not;

Case with_free_body() {
    Case c = with_solid();
    c.solids[0].motion = SolidMotion::free;
    c.solids[0].density = 700.0;
    return c;
}

/// A case that is right, and keys that make it wrong.
struct Wrong {
    Case right;
    std::string keys;
};

std::vector<Wrong> wrong_geometry() {
    return {
        {flume(), "bed.kind = slip"},
        {gravel(), "bed.manning = 0.02"},
        {gravel(), "bed.equivalent_roughness = 30 mm"},
        {earth(), "bed.manning = 0.2"},
        {earth(), "bed.manning = 0.002"},
        {gravel(), "turbulence.closure = none"},
        {gravel(), "turbulence.zero = 1 mm"},
        {gravel(), "numerics.wall = dynamic"},
        {gravel(), "channel.top = wall"},
        {gravel(), "numerics.spacing = 7 mm"},
        {glass(), "fluid.kinematic_viscosity = 0"},
        {flume(), "bed.roughness_height = 0"},
        {flume(), "bed.roughness_height = 30 mm"},
        {flume(), "bed.datum_below_crest = 11 mm"},
        {flume(), "numerics.spacing = 12 mm"},
        {flume(), "channel.length = 10 mm"},
        {flume(), "channel.length = 100 m"},
        {flume(), "channel.depth = 5 mm; numerics.spacing = 5 mm"},
        {flume(), "fluid.gravity = 0"},
        {flume(), "channel.top = wall"},
        {periodic_box(), "channel.ends = walls"},
        {periodic_box(), "bed.kind = no-slip"},
        {periodic_box(), "fluid.gravity = 9.81"},
        {plates(), "channel.ends = walls; channel.wall_height = 0.1"},
        {tank(), "channel.wall_height = 40 mm"},
        {plates(), "channel.lid_velocity = 1; bed.kind = slip"},
        {plates(), "channel.lid_velocity = 1; numerics.wall = dynamic"},
        {flume(), "bed.drag_form = slice"},
        {flume(), "start.lattice = body-centred"},
        {flume(), "start.kind = section"},
        {periodic_box(), "channel.dimensions = 3; channel.width = 50 mm; channel.sides = walls"},
        {cell(), "bed.drag_form = paper"},
        {cell(),
         "turbulence.closure = czernuszenko-rylov; turbulence.spanwise_ratio = 0.5; numerics.viscosity = lo-shao"},
        {cell(), "turbulence.stress_terms = shear"},
        {cell(), "channel.width = 10 mm"},
        {cell(), "start.kind = section"},
        {cell(), "bed.sphere_diameter = 50 mm"},
        {cell(), "channel.length = 60 mm"},
        {cell(), "channel.width = 60 mm"},
        {cell(), "numerics.spacing = 7 mm"},
        {cell(), "bed.sphere_ramp = 30 mm"},
        {between_side_walls(), "bed.kind = slip"},
        {between_side_walls(), "bed.kind = slip; side_walls.drag_form = thesis"},
        {between_side_walls(), "bed.kind = no-slip; side_walls.drag_form = log-law"},
        {between_side_walls(), "side_walls.drag_form = log-law; turbulence.closure = none"},
        {between_side_walls(), "side_walls.drag_form = log-law; fluid.kinematic_viscosity = 0"},
        {between_side_walls(), "side_walls.drag_form = log-law; side_walls.equivalent_roughness = 40 mm"},
        {between_side_walls(), "side_walls.layer = 1 mm"},
        {between_side_walls(), "side_walls.layer = 30 mm; turbulence.closure = czernuszenko-rylov"},
        {between_side_walls(), "side_walls.layer = 60 mm"},
    };
}

std::vector<Wrong> wrong_open_ends() {
    return {
        {open_channel(), "inflow.unit_discharge = none"},
        {open_channel(), "inflow.discharge = 8 l/s"},
        {open_channel(), "inflow.depth = 20 mm; inflow.depth_file = stage.csv"},
        {open_channel(), "inflow.depth = 50 mm"},
        {open_channel(), "inflow.profile = log-law"},
        {open_channel(), "inflow.profile = file"},
        {open_channel(), "inflow.profile = results"},
        {open_channel(), "bed.drag_coefficient = 0; outflow.kind = critical-depth"},
        {open_channel(),
         "channel.dimensions = 3; channel.width = 50 mm; channel.sides = periodic; turbulence.closure = wale"},
        {open_channel(), "outflow.kind = depth"},
        {open_channel(), "outflow.kind = depth; outflow.depth = 60 mm; outflow.depth_file = tide.csv"},
        {open_channel(), "outflow.kind = depth; outflow.depth = 10 mm"},
        {open_channel(), "channel.slope = 0"},
        {open_channel(), "inflow.unit_discharge = 0"},
        {open_channel(), "inflow.unit_discharge = 0; outflow.kind = free; start.kind = backwater"},
        {open_channel(), "inflow.unit_discharge = 0.2; outflow.kind = critical-depth"},
        {open_channel(),
         "run.until = converged; inflow.unit_discharge = none; inflow.discharge_file = q.csv; "
         "outflow.kind = free"},
        {open_channel(), "run.until = converged; outflow.kind = depth; outflow.depth_file = tide.csv"},
        {open_channel(), "outflow.kind = rating-curve"},
        {open_channel(), "outflow.kind = weir"},
        {open_channel_in_file(),
         "inflow.unit_discharge = none; inflow.discharge_file = /nowhere/q.csv; outflow.kind = free"},
        {open_channel_in_file(), "inflow.depth_file = /nowhere/h.csv"},
        {open_channel_in_file(), "inflow.profile = file; inflow.profile_file = /nowhere/u.csv"},
        {open_channel_in_file(), "inflow.profile = results; inflow.results = /nowhere/results.h5"},
        {open_channel_in_file(), "outflow.kind = depth; outflow.depth_file = /nowhere/h.csv"},
        {open_channel_in_file(), "outflow.kind = rating-curve; outflow.rating_file = /nowhere/q.csv"},
        {open_channel(), "channel.length = 20 mm"},
        {open_channel(), "channel.top = periodic"},
        {open_channel(), "channel.top = wall; bed.kind = no-slip"},
        {open_channel(), "outflow.kind = pressure"},
        {duct(), "inflow.unit_discharge = none"},
        {duct(), "inflow.depth = 10 mm"},
        {duct(), "channel.lid_velocity = 0.1"},
        {duct(), "start.kind = backwater"},
        {duct_with_step(), "solid[0].x = [-0.001, 0.1, 0.1, -0.001]"},
        {duct_with_step(), "solid[0].z = [0, 0, 0.006, 0.01]"},
        {duct_with_step(), "solid[0].z = [0.002, 0.002, 0.01, 0.01]"},
        {open_channel_over_step(), "inflow.profile = column"},
        {open_channel_over_step(), "inflow.unit_discharge = none; inflow.depth = 3 mm"},
        {open_channel_over_step(), "channel.depth = 3 mm"},
        {open_channel_over_step(), "start.kind = backwater"},
        {open_channel_over_step(),
         "solid[0].x = [0.2, 0.5, 0.5, 0.2]; outflow.kind = depth; outflow.depth = 3 mm"},
        {open_channel_over_step(), "solid[0].x = [0.2, 0.5, 0.5, 0.2]; outflow.kind = normal-depth"},
        {open_channel(), "numerics.stepping = verlet; numerics.courant_number = 0.1"},
        {open_channel(), "numerics.wall = dynamic; numerics.pressure_form = symmetric"},
        {open_channel(), "numerics.xsph = 0.1; numerics.stepping = semi-implicit-euler"},
        {open_channel(), "start.lattice = hexagonal"},
        {open_channel(), "start.kind = standing-wave; start.amplitude = 1 mm"},
        {open_channel(),
         "inflow.unit_discharge = none; inflow.depth = 50 mm; outflow.kind = free; start.kind = backwater"},
        {open_channel(),
         "start.kind = rest; start.water_x = [0, 0.1, 0.1, 0]; start.water_z = [0.02, 0.02, 0.05, 0.05]"},
        {open_channel_with_solid(),
         "solid[0].motion = free; solid[0].density = 700; solid[0].x = [0.001, 0.041, 0.041, 0.001]"},
        {open_channel_with_solid(), "solid[0].x = [0.005, 0.045, 0.045, 0.005]"},
        {open_channel_with_solid(), "solid[0].motion = constant; solid[0].velocity_x = 0.5"},
        {with_porous(), "channel.top = wall; bed.kind = no-slip; channel.lid_velocity = 0.1"},
        {flume(), "start.kind = backwater"},
    };
}

std::vector<Wrong> wrong_methods() {
    return {
        {flume(), "turbulence.eddy_rate = rotation; turbulence.stress_terms = shear"},
        {flume(), "numerics.tensile_correction = 0.2; numerics.kernel = cubic-spline"},
        {flume(), "numerics.tensile_correction = 0.2; numerics.pressure_form = symmetric"},
        {flume(), "turbulence.closure = wale"},
        {flume(),
         "numerics.kernel_correction = kernel; numerics.pressure_form = symmetric; turbulence.closure = none"},
        {flume(), "numerics.viscosity = artificial"},
        {flume(),
         "numerics.viscosity = artificial; turbulence.closure = none; numerics.pressure_form = riemann"},
        {flume(), "numerics.impact_dissipation = 3; numerics.pressure_form = riemann"},
        {flume(),
         "numerics.density_relaxation = 0.3; turbulence.closure = none; numerics.pressure_form = symmetric"},
        {flume(),
         "numerics.impact_dissipation = 3; turbulence.closure = none; numerics.viscosity = artificial"},
        {flume(), "numerics.stepping = verlet; numerics.courant_number = 0.21"},
        {flume(), "numerics.xsph = 0.1"},
        {flume(), "numerics.pressure_form = riemann-non-conservative"},
        {with_solid(), "solid[0].surface = log-law; turbulence.closure = none"},
        {with_shape(SolidShape::section),
         "solid[0].surface = log-law; bed.kind = smooth; turbulence.closure = nezu-rodi"},
        {with_solid(), "solid[0].surface = log-law; fluid.kinematic_viscosity = 0"},
        {with_solid(), "solid[0].surface = log-law; solid[0].equivalent_roughness = 20 mm"},
        {with_solid(), "numerics.wall = dynamic"},
        {with_solid(), "numerics.wall = modified-dynamic"},
        {flume(), "numerics.wall = repulsive"},
        {plates(), "numerics.wall = repulsive; numerics.pressure_form = symmetric; bed.kind = slip"},
        {tank(), "numerics.wall = repulsive; numerics.pressure_form = symmetric; bed.kind = no-slip"},
        {between_side_walls(), "numerics.wall = dynamic; channel.sides = half"},
        {plates(), "numerics.reference_pressure = hydrostatic"},
        {open_channel(), "numerics.reference_pressure = hydrostatic; outflow.kind = free"},
        {flume(), "numerics.reference_pressure = hydrostatic; numerics.wall = modified-dynamic"},
        {with_free_body(), "numerics.reference_pressure = hydrostatic"},
        {with_porous(), "numerics.reference_pressure = hydrostatic"},
    };
}

std::vector<Wrong> wrong_starts_and_runs() {
    return {
        {flume(), "turbulence.zero = 0.1"},
        {flume(), "channel.ends = walls"},
        {flume(), "channel.ends = walls; start.kind = uniform"},
        {flume(), "start.kind = results"},
        {open_channel(), "start.kind = rest; start.packed = true; start.jitter = 0.1"},
        {duct_with_step(), "start.packed = true"},
        {tank(), "start.packed = true"},
        {tank(), "start.packed = true; start.jitter = 0.1; numerics.wall = dynamic"},
        {with_mesh(), "start.kind = results; start.file = /nowhere/results.h5"},
        {with_mesh(), "measured.velocity_profile = /nowhere/u.csv"},
        {tank(), "start.kind = standing-wave"},
        {tank(), "start.kind = standing-wave; start.amplitude = 0.1"},
        {periodic_box(), "start.kind = taylor-green"},
        {tank(), "start.kind = taylor-green; start.velocity = 1"},
        {periodic_box(), "channel.dimensions = 3; channel.width = 50 mm; start.kind = isotropic"},
        {periodic_box(), "start.kind = isotropic; start.file = /nowhere/spectrum.csv"},
        {with_water(), "start.water_x = [0, 0.05, 0.05]"},
        {with_water(), "start.water_x = [0, 0.05]; start.water_z = [0, 0.05]"},
        {with_water(), "start.water_x = [0.05, 0, 0.05, 0]"},
        {with_water(), "channel.top = wall"},
        {with_water(), "start.water_x = [-0.01, 0.05, 0.05, 0]"},
        {with_water(), "start.water_z = [0, 0, 0.1, 0.1]"},
        {with_water(), "start.water_z = [0, 0, 0.002, 0.002]"},
        {with_solid(), "start.water_x = [0, 0.1, 0.1, 0]; start.water_z = [0, 0, 0.02, 0.02]"},
        {flume(), "run.average_from = 1 h"},
        {flume(), "channel.slope = 0; start.kind = rest"},
        {flume(), "output.surface_threshold = 1"},
        {flume(), "output.snapshot_fields = velocity speed"},
        {flume(), "output.snapshot_fields = velocity velocity"},
        {flume(), "output.snapshot_x = 0.1"},
        {flume(), "output.snapshot_z = [0.2, 0.3]"},
    };
}

std::vector<Wrong> wrong_solids() {
    std::string many = "[0.1";
    for (int corner = 1; corner < 7000; ++corner) many += ", 0.1";
    many += "]";
    return {
        {with_two_solids(), fmt::format("solid[0].x = {0}; solid[1].x = {0}; solid[2].x = {0}", many)},
        {with_solid(), "solid[0].name = \"\""},
        {with_two_solids(), "solid[1].name = weir"},
        {with_solid(), "channel.top = periodic; channel.ends = periodic; fluid.gravity = 0"},
        {with_solid(), "solid[0].x = []"},
        {with_solid(), "solid[0].x = [0.08, 0.12, 0.12]"},
        {with_solid(), "solid[0].x = [0.08, 0.12]; solid[0].z = [0, 0]"},
        {with_solid(), "solid[0].x = [0.08, 0.08, 0.12, 0.12]"},
        {with_solid(), "channel.length = 70 mm"},
        {with_solid(), "channel.ends = periodic; solid[0].x = [0, 0.2, 0.2, 0]"},
        {with_solid(), "solid[0].x = [0, 0.2, 0.2, 0]; solid[0].z = [0, 0, 0.2, 0.2]"},
        {with_solid(), "numerics.spacing = 5 mm; numerics.wall_layers = 10"},
        {with_solid(), "solid[0].motion = constant"},
        {with_solid(), "solid[0].motion = oscillating; solid[0].amplitude_x = 10 mm"},
        {with_two_solids(), "solid[1].start = 5"},
        {with_two_solids(), "solid[1].start = 2; solid[1].stop = 1"},
        {with_two_solids(), "solid[1].velocity_x = 1"},
        {with_two_solids(), "solid[1].velocity_z = -0.01"},
        {with_two_solids(), "solid[1].velocity_x = -0.02; solid[1].velocity_z = 0"},
        {with_two_solids(), "solid[1].x = [0.08, 0.12, 0.12, 0.08]"},
        {with_solid(),
         "solid[0].motion = constant; solid[0].velocity_x = 1 mm/s; solid[0].velocity_y = 1 mm/s"},
        {with_free_body(), "solid[0].turns_x = false"},
        {with_solid(), "solid[0].motion = table; solid[0].times = [0, 1]; solid[0].shifts_x = [0.01, 0.02]"},
        {with_shape(SolidShape::box),
         "solid[0].motion = constant; solid[0].angular_velocity = 1; solid[0].rotation_axis = [0, 0, 0]"},
        {with_free_body(),
         "solid[0].motion = constant; solid[0].density = auto; solid[0].angular_velocity = 1; "
         "solid[0].rotation_about = 0.1"},
        {with_free_body(), "solid[0].centre_of_mass = 0.1"},
        {with_free_body(), "solid[0].inertia = [1, 1]"},
        {with_free_body(), "solid[0].density = auto"},
        {with_free_body(), "solid[0].mass = 1"},
        {with_free_body(), "solid[0].restitution = 0.1"},
        {with_free_body(), "solid[0].moves_x = false; solid[0].moves_z = false; solid[0].turns_y = false"},
        {with_free_body(), "solid[0].moves_z = false; solid[0].spring_z = 100"},
        {with_free_body(), "solid[0].centre_of_mass = [1, 1]"},
        {with_free_body(), "solid[0].inertia = 1e-12"},
        {with_free_body(), "numerics.stepping = verlet"},
        {with_free_body(), "solid[0].z = [-0.002, -0.002, 0.03, 0.03]"},
        {with_free_body(), "channel.ends = periodic; solid[0].x = [0.001, 0.199, 0.199, 0.001]"},
        {open_channel_with_solid(), "solid[0].z = [0, 0, 0.3, 0.3]"},
        {open_channel_with_solid(),
         "solid[0].z = [0, 0, 0.2, 0.2]; channel.ends = periodic; inflow.unit_discharge = none; outflow.kind = normal-depth"},
        {with_mesh(), "channel.slope = 0.001; solid[0].scale = 0.01; solid[0].place = [0.05, -0.1, 0]"},
        {with_mesh(), "solid[0].file = \"\""},
        {with_mesh(), "solid[0].place = 50 mm"},
        {with_mesh(), "solid[0].place = [0.19, 0.02, 0]"},
        {with_mesh(), "solid[0].scale = 0.1; solid[0].place = [-0.1, -0.1, -0.1]"},
        {with_mesh(), "solid[0].scale = 0.1 mm"},
    };
}

std::vector<Wrong> wrong_shapes() {
    using enum SolidShape;
    const Case on_spheres = with_shape(spheres);
    return {
        {with_shape(box), "channel.dimensions = 2"},
        {with_shape(circle), "channel.dimensions = 3; channel.ends = walls"},
        {with_shape(sphere), "solid[0].centre = [0.1, 0.05]"},
        {with_shape(rectangle), "solid[0].centre = []"},
        {with_shape(box), "solid[0].size = []"},
        {with_shape(box), "solid[0].size = [0.03, 0, 0.03]"},
        {with_shape(cylinder), "solid[0].diameter = 0"},
        {with_shape(box), "solid[0].moment_about = [0.1, 0.05]"},
        {with_shape(cylinder), "solid[0].length = 0"},
        {with_shape(cylinder), "solid[0].centre = [0.01, 0.05, 0.02]"},
        {with_shape(bed), "solid[0].heights = \"\""},
        {with_shape(bed), "solid[0].origin = [1, 2]"},
        {with_shape(bed), "channel.ends = walls; channel.sides = walls; solid[0].blend = 10 mm"},
        {with_shape(bed), "solid[0].blend = 60 mm"},
        {with_shape(section),
         "channel.ends = open; inflow.unit_discharge = 0.01; inflow.profile = uniform; outflow.kind = free"},
        {open_canal(), "outflow.kind = weir; outflow.weir_height = 30 mm"},
        {open_canal(), "inflow.profile = column"},
        {with_shape(SolidShape::spheres),
         "solid[0].smaller_diameters = [0.005]; solid[0].packing = hexagonal"},
        {open_canal(), "solid[0].surface = slip"},
        {open_canal(), "channel.top = wall; outflow.kind = pressure"},
        {open_canal(), "solid[0].shape = section; solid[0].y = [0, 0.2]; solid[0].levels = [0.01, 0.01]"},
        {with_shape(section), "solid[0].levels = 0"},
        {with_shape(section), "solid[0].y = [0, 0.1, 0.05]; solid[0].levels = [0.01, 0.01, 0.01]"},
        {with_shape(section), "solid[0].y = [0, 0.08]"},
        {with_shape(section), "solid[0].levels = [0.01, -0.01]"},
        {with_shape(section), "solid[0].levels = [0.01, 0.02]"},
        {with_shape(trapezoid), "solid[0].bottom_width = 0.2"},
        {with_shape(trapezoid), "solid[0].bank_slope = 0"},
        {with_shape(trapezoid), "solid[0].bank_height = 60 mm"},
        {with_shape(compound), "solid[0].bank_height = 60 mm"},
        {with_shape(compound),
         "solid[0].bank_height = 10 mm; solid[0].bank_slope = 0; solid[0].floodplain_width = 10 mm"},
        {with_shape(pipe), "solid[0].diameter = 0.2"},
        {with_shape(pipe), "solid[0].diameter = 40 mm"},
        {on_spheres, "channel.length = 0.21"},
        {with_shape(section), "solid[0].motion = constant; solid[0].velocity_z = 0.01"},
        {with_solid(),
         "solid[0].part_of_bed = true; solid[0].motion = constant; solid[0].velocity_x = 1 mm/s"},
        {with_solid(), "solid[0].part_of_bed = true; channel.ends = walls"},
        {with_shape(section), "solid[0].part_of_bed = true; bed.roughness_height = 1 m"},
    };
}

/// The keys of an outline of 1001 corners.
std::string many_corners(const std::string& section) {
    std::string x;
    std::string y;
    for (int i = 0; i < 1001; ++i) {
        const double angle = 2.0 * 3.14159265358979 * i / 1001;
        x += fmt::format("{}{:.9g}", i > 0 ? ", " : "", 0.02 + 0.004 * std::cos(angle));
        y += fmt::format("{}{:.9g}", i > 0 ? ", " : "", 0.0045 + 0.004 * std::sin(angle));
    }
    return fmt::format("{0}.x = [{1}]; {0}.y = [{2}]", section, x, y);
}

/// A channel in space with a triangle of gravel or of stems.
Case with_outlined_bed() {
    return with_keys(with_bed_patches(),
                     "bed_patch[0].y_from = auto; bed_patch[0].y_to = auto; "
                     "bed_patch[0].x = [0.005, 0.04, 0.02]; bed_patch[0].y = [0, 0, 0.009]");
}

Case with_outlined_vegetation() {
    Case c = with_bed_patches();
    c.bed_patches.clear();
    c.vegetation = {with_vegetation().vegetation[0]};
    return with_keys(c,
                     "vegetation[0].x_from = auto; vegetation[0].x_to = auto; "
                     "vegetation[0].x = [0.005, 0.04, 0.02]; vegetation[0].y = [0, 0, 0.009]");
}

std::vector<Wrong> wrong_bed_patches() {
    Case among_stems = with_vegetation();
    among_stems.bed_patches = {with_bed_patches().bed_patches[0]};
    among_stems.bed_patches[0].y_from.reset();
    among_stems.bed_patches[0].y_to.reset();
    among_stems.bed_patches[0].x_from = 0.15;
    among_stems.vegetation.pop_back();
    Case open = with_bed_patches();
    open.channel.ends = Ends::open;
    open.channel.length = 0.3;
    open.inflow.unit_discharge = 0.0174;
    open.inflow.profile = InflowProfile::uniform;
    open.outflow.kind = OutflowKind::critical_depth;
    Case walled = with_bed_patches();
    walled.channel.sides = Sides::walls;
    walled.side_walls.drag_form = SideDragForm::log_law;
    return {
        {with_bed_patches(), "bed_patch[0].name = \"\""},
        {with_bed_patches(), "bed_patch[1].name = cobbles"},
        {with_bed_patches(), "bed_patch[0].equivalent_roughness = none; bed_patch[0].kind = no-slip"},
        {with_bed_patches(), "channel.top = wall"},
        {with_bed_patches(), "bed_patch[0].equivalent_roughness = none; bed_patch[0].kind = spheres"},
        {with_bed_patches(), "bed_patch[0].manning = 0.02"},
        {with_bed_patches(), "bed_patch[0].equivalent_roughness = 40 mm"},
        {with_bed_patches(), "bed_patch[1].y_to = 1 m"},
        {with_bed_patches(), "bed_patch[1].y_from = 19 mm"},
        {with_bed_patches(), "bed_patch[1].y_from = 0; bed_patch[1].y_to = 43.3 mm"},
        {with_bed_patches(), "bed_patch[1].y_from = 5 mm"},
        {among_stems, "bed_patch[0].x_from = 50 mm"},
        {walled, "side_walls.drag_form = consistent"},
        {with_outlined_bed(), "bed_patch[0].x_from = 1 mm"},
        {with_outlined_bed(), "bed_patch[0].y = [0, 0]"},
        {with_outlined_bed(), "bed_patch[0].x = [0, 0.01]; bed_patch[0].y = [0, 0.01]"},
        {with_outlined_bed(), "bed_patch[0].x = [0, 0.02, 0.02, 0]; bed_patch[0].y = [0, 0.009, 0, 0.009]"},
        {with_outlined_bed(), many_corners("bed_patch[0]")},
        {with_outlined_bed(), "bed_patch[0].x = [-0.005, 0.04, 0.02]"},
        {with_outlined_bed(), "bed_patch[0].y = [0, 0, 0.012]"},
        {with_outlined_bed(), "bed_patch[0].x = [0.005, 0.06, 0.02]"},
        {open, "inflow.profile = twin"},
        {open, "outflow.kind = normal-depth"},
    };
}

/// An open canal whose bottom is smoother than its banks.
Case with_surface_patches() {
    Case c = open_canal();
    SurfacePatch bottom;
    bottom.name = "bottom";
    bottom.solid = "canal";
    bottom.equivalent_roughness = 0.0005;
    bottom.y_from = 0.05;
    bottom.y_to = 0.1;
    SurfacePatch other = bottom;
    other.name = "other";
    other.y_from = 0.1;
    other.y_to = 0.15;
    c.surface_patches = {bottom, other};
    return c;
}

Case with_outlined_surface() {
    return with_keys(
        with_surface_patches(),
        "surface_patch[0].y_from = auto; surface_patch[0].y_to = auto; inflow.profile = uniform; "
        "outflow.kind = critical-depth; surface_patch[0].x = [0.05, 0.2, 0.1]; "
        "surface_patch[0].y = [0, 0, 0.09]");
}

std::vector<Wrong> wrong_surface_patches() {
    Case moving = with_solid();
    moving.solids[0].surface = SolidSurface::log_law;
    SurfacePatch patch;
    patch.name = "part";
    patch.solid = moving.solids[0].name;
    patch.equivalent_roughness = 0.001;
    patch.x_from = 0.01;
    patch.x_to = 0.05;
    moving.surface_patches = {patch};
    return {
        {with_solid(),
         "solid[0].surface = log-law; solid[0].equivalent_roughness = 1 mm; solid[0].manning = 0.01"},
        {with_solid(), "solid[0].surface = log-law; solid[0].manning = 0.9"},
        {with_surface_patches(), "surface_patch[0].name = \"\""},
        {with_surface_patches(), "surface_patch[1].name = bottom"},
        {with_surface_patches(), "surface_patch[0].solid = pier"},
        {with_surface_patches(), "solid[0].surface = no-slip; solid[0].equivalent_roughness = 0"},
        {moving, "solid[0].motion = constant; solid[0].velocity_x = 0.01"},
        {with_surface_patches(), "surface_patch[0].equivalent_roughness = none"},
        {with_surface_patches(), "surface_patch[0].manning = 0.01"},
        {with_surface_patches(),
         "surface_patch[0].equivalent_roughness = none; surface_patch[0].manning = 0.9"},
        {with_surface_patches(), "surface_patch[0].equivalent_roughness = 0; fluid.kinematic_viscosity = 0"},
        {with_surface_patches(), "surface_patch[0].equivalent_roughness = 90 mm"},
        {with_surface_patches(), "surface_patch[1].y_to = 1 m"},
        {with_surface_patches(), "surface_patch[1].y_from = 0.1499"},
        {with_surface_patches(), "surface_patch[0].y_from = auto; surface_patch[0].y_to = auto"},
        {with_surface_patches(), "surface_patch[1].y_from = 0.09"},
        {with_outlined_surface(), "surface_patch[0].x_from = 10 mm"},
        {with_outlined_surface(), "surface_patch[0].y = [0, 0]"},
        {with_outlined_surface(), "surface_patch[0].x = [0, 0.1]; surface_patch[0].y = [0, 0.05]"},
        {with_outlined_surface(),
         "surface_patch[0].x = [0, 0.1, 0.1, 0]; surface_patch[0].y = [0, 0.09, 0, 0.09]"},
        {with_outlined_surface(), many_corners("surface_patch[0]")},
    };
}

std::vector<Wrong> wrong_vegetation() {
    return {
        {with_vegetation(),
         "bed.kind = slip; bed.equivalent_roughness = none; channel.top = periodic; channel.slope = 0; fluid.gravity = 0"},
        {with_outlined_vegetation(), "vegetation[0].y_to = 9 mm"},
        {with_outlined_vegetation(), "vegetation[0].x = [0, 0.02]"},
        {with_outlined_vegetation(), "vegetation[0].x = [0, 0.01]; vegetation[0].y = [0, 0.01]"},
        {with_outlined_vegetation(),
         "vegetation[0].x = [0, 0.02, 0.02, 0]; vegetation[0].y = [0, 0.009, 0, 0.009]"},
        {with_outlined_vegetation(), many_corners("vegetation[0]")},
        {with_outlined_vegetation(), "vegetation[0].x = [-2, -1, -1]"},
        {with_outlined_vegetation(),
         "vegetation[0].x = [0, 0.03, 0.031, 0.001]; vegetation[0].y = [0, 0.03, 0.03, 0]"},
        {with_outlined_vegetation(), "vegetation[0].y = [0, 0, 0.05]"},
        {with_vegetation(), "vegetation[1].name = \"\""},
        {with_vegetation(), "vegetation[1].name = reeds"},
        {with_vegetation(), "vegetation[0].stem_diameter = 60 mm"},
        {with_vegetation(), "vegetation[0].vogel_exponent = -0.7"},
        {with_vegetation(), "vegetation[0].reference_velocity = 0.1"},
        {with_vegetation(), "vegetation[0].vogel_exponent = -1.8; vegetation[0].reference_velocity = 0.1"},
        {with_vegetation(), "bed.kind = no-slip; channel.top = wall"},
        {with_vegetation(), "vegetation[1].x_to = 0.3"},
        {with_vegetation(), "vegetation[0].x_from = 0.2"},
        {with_vegetation(), "vegetation[0].height = 1 mm"},
        {with_vegetation(), "vegetation[0].x_to = 120 mm"},
        {with_vegetation(),
         "solid[0].name = terrace; solid[0].x = [0.02, 0.18, 0.18, 0.02]; solid[0].z = [0, 0, 0.02, 0.02]; vegetation[0].x_from = 0.03; vegetation[0].height = 15 mm"},
        {with_vegetation(), "vegetation[0].stands_on = terrace"},
        {with_vegetation(),
         "solid[0].name = terrace; solid[0].x = [0.02, 0.08, 0.08, 0.02]; solid[0].z = [0, 0, 0.02, 0.02]; solid[0].motion = constant; solid[0].velocity_x = 0.01; vegetation[0].stands_on = terrace"},
        {with_vegetation(),
         "solid[0].name = terrace; solid[0].x = [0.12, 0.18, 0.18, 0.12]; solid[0].z = [0, 0, 0.02, 0.02]; vegetation[0].stands_on = terrace"},
    };
}

std::vector<Wrong> wrong_porous() {
    Case beside_solid = with_solid();
    beside_solid.porous = with_porous().porous;
    beside_solid.porous.pop_back();
    beside_solid.porous.front().x_from = 0.12;
    beside_solid.porous.front().x_to = 0.16;
    // One may reach into the other by less than the lattice of places shows.
    Case side_by_side = with_porous_in_plan();
    side_by_side.channel.length = 0.5;
    side_by_side.porous.front().x = {0.0, 0.25, 0.25, 0.0};
    side_by_side.porous.push_back(side_by_side.porous.front());
    side_by_side.porous.back().name = "sand";
    side_by_side.porous.back().x = {0.25, 0.5, 0.5, 0.25};
    Case between_ends = open_channel();
    between_ends.porous = with_porous().porous;
    return {
        {with_porous(), "channel.ends = periodic; channel.top = periodic; fluid.gravity = 0"},
        {with_porous(),
         "vegetation[0].name = reeds; vegetation[0].stems_per_area = 400; vegetation[0].stem_diameter = 6 mm; vegetation[0].height = 30 mm"},
        {with_porous(), "numerics.pressure_form = symmetric"},
        {with_porous(), "numerics.stepping = verlet"},
        {with_porous(), "numerics.wall = dynamic"},
        {with_porous(), "numerics.viscosity = lo-shao"},
        {with_porous(), "turbulence.closure = nezu-rodi; numerics.eddy_stress = stress-divergence"},
        {with_porous(), "numerics.xsph = 0.1; numerics.stepping = semi-implicit-euler"},
        {with_porous(), "numerics.density_filter = shepard"},
        {with_porous(), "porous[1].name = \"\""},
        {with_porous(), "porous[1].name = gravel"},
        {with_porous(), "porous[0].permeability = 1e-9"},
        {with_porous(), "porous[1].permeability = none"},
        {with_porous(), "porous[0].forchheimer = 0.5"},
        {with_porous(), "porous[1].laminar_coefficient = 180"},
        {with_porous(), "porous[0].x = [0.05, 0.1, 0.1]; porous[0].z = [0, 0, 0.03]"},
        {with_porous_outline(), "porous[0].x = [0.05, 0.1, 0.1]"},
        {with_porous_outline(), "porous[0].x = [0.05, 0.1]; porous[0].z = [0, 0.03]"},
        {with_porous_outline(), "porous[0].z = [0, 0.03, 0, 0.03]"},
        {with_porous_in_plan(), "porous[0].z = [0, 0, 0.03, 0.03]"},
        {with_porous_in_plan(), "porous[0].y_to = 15 mm"},
        {with_porous_in_plan(), "porous[0].x = [0.005, 0.045, 0.045]"},
        {with_porous_in_plan(), "porous[0].y = [0.01, 0.035, 0.01, 0.035]"},
        {with_porous_in_plan(), "porous[0].x = [0.005, 0.2, 0.045, 0.005]"},
        {with_porous_in_plan(), "porous[0].y = [0.01, 0.01, 0.015, 0.015]"},
        {side_by_side, "porous[0].x = [0, 0.251, 0.251, 0]"},
        {with_porous(), "porous[0].top_x = [0.05, 0.1]; porous[0].top_z = 0.03"},
        {with_porous(), "porous[0].top_x = [0.1, 0.05]; porous[0].top_z = [0.03, 0.03]"},
        {with_porous(), "porous[1].x_to = 0.3"},
        {with_porous(), "porous[0].z_from = 0.02; porous[0].z_to = 0.01"},
        {with_porous(), "porous[0].z_from = 2; porous[0].z_to = 3"},
        {beside_solid, "solid[0].motion = constant; solid[0].velocity_x = 5 mm/s"},
        {beside_solid, "solid[0].motion = free; solid[0].density = 700"},
        {with_porous(), "porous[0].x_from = 99 mm"},
        {with_porous(), "porous[0].grain_size = 60 mm"},
        {between_ends, "porous[0].x_from = 10 mm"},
        {beside_solid, "porous[0].x_from = 0.1"},
        {beside_solid,
         "channel.ends = periodic; solid[0].x = [0.18, 0.22, 0.22, 0.18]; porous[0].x_from = 0; porous[0].x_to = 0.05"},
        {with_porous(), "porous[0].x_to = 120 mm"},
    };
}

std::vector<Wrong> wrong_probes() {
    using enum ProbeKind;
    Case on_circle = with_shape(SolidShape::circle);
    on_circle.probes = with_probe(ProbeKind::pressure).probes;
    on_circle.probes[0].solid = on_circle.solids[0].name;
    on_circle.probes[0].x = {on_circle.solids[0].centre[0]};
    on_circle.probes[0].z = {on_circle.solids[0].centre[1] + 0.5 * on_circle.solids[0].diameter};
    return {
        {with_probe(force), "probe[0].name = a/b"},
        {with_probe(force), "probe[0].name = standard_force"},
        {with_probe(force), "probe[1].name = p; probe[1].kind = force; probe[1].sampling_frequency = 50 Hz"},
        {with_probe(force), "probe[0].start = 1 h"},
        {with_probe(wave), "channel.top = wall"},
        {with_probe(wave), "probe[0].x = []"},
        {with_probe(wave), "probe[0].x = [0.1, 0.3]"},
        {with_probe(wave), "probe[0].y = 0.01"},
        {with_probe(wave), "channel.dimensions = 3; probe[0].y = [0.01, 0.02]"},
        {with_probe(wave), "channel.dimensions = 3; probe[0].y = 1"},
        {with_probe(velocity), "probe[0].z = []"},
        {with_probe(velocity), "probe[0].z = 0.1"},
        {with_probe(velocity), "probe[0].x = [0.1, 0.15]; probe[0].z = [0.01, 0.02, 0.03]"},
        {on_circle, "probe[0].solid = squere"},
        {on_circle, "probe[0].z = 0.04"},
        {on_circle, "probe[0].diameter = 5"},
        {with_probe(velocity), "probe[0].kind = pressure; probe[0].diameter = 5 mm"},
        {on_circle,
         "probe[0].solid = \"\"; probe[0].x = 0; probe[0].z = 0.002; channel.ends = walls; probe[0].diameter = 8 mm"},
        {with_probe(velocity), "probe[0].sampling_length = 0.1"},
        {with_probe(grid), "probe[0].spacing = 0.5 mm"},
        {with_probe(surface_line), "probe[0].spacing = 1"},
        {with_probe(grid), "probe[0].z_to = 1"},
        {with_probe(grid), "probe[0].x_from = 0.15; probe[0].x_to = 0.1"},
        {with_probe(grid), "probe[0].z_from = 0.03; probe[0].z_to = 0.02"},
        {with_probe(grid), "channel.length = 50; probe[0].spacing = 0.8 mm"},
        {with_probe(grid), "probe[0].averaging_time = 10 ms"},
        {with_probe(grid), "probe[0].averaging_time = 1 h"},
        {with_probe(flow_rate), "channel.ends = walls; probe[0].x = 0"},
    };
}

std::vector<Wrong> all_wrongs() {
    std::vector<Wrong> all;
    for (auto* const wrongs :
         {wrong_geometry, wrong_open_ends, wrong_methods, wrong_starts_and_runs, wrong_solids, wrong_shapes,
          wrong_surface_patches, wrong_bed_patches, wrong_vegetation, wrong_porous, wrong_probes}) {
        for (Wrong& wrong : wrongs()) all.push_back(std::move(wrong));
    }
    return all;
}

/// The file of a case; lists that are empty are not given.
std::string file_text(const Case& c) {
    return std::regex_replace(case_text(c), std::regex("\n[a-z_]+ = \\[\\](?=\n)"), "");
}

/// Message of the refusal of the file of a case; empty where it is right.
std::string refusal_of(const Case& c) { return test::error_of(file_text(c), {}, c.path); }

void load_shapes(Case& c) {
    const bool complete = std::all_of(c.solids.begin(), c.solids.end(),
                                      [&](const Solid& s) { return shape_is_complete(c, s); });
    if (c.channel.dimensions == 3 && complete) c.meshes = meshes_of(c);
    for (Solid& solid : c.solids) {
        if (c.channel.dimensions == 2 && complete && solid.shape != SolidShape::free_form) {
            const Outline outline = shape_outline(c, solid);
            solid.x = outline.x;
            solid.z = outline.z;
        }
    }
}

TEST(Refusals, RightCasesAreTaken) {
    for (const Wrong& wrong : all_wrongs()) EXPECT_EQ(refusal_of(wrong.right), "");
}

TEST(Refusals, EachRowHasACaseThatItRefusesAndSaysSo) {
    std::set<const CaseCheck*> broken;
    for (const Wrong& wrong : all_wrongs()) {
        Case c = with_keys(wrong.right, wrong.keys);
        load_shapes(c);
        const std::string message = refusal_of(c);
        EXPECT_NE(message, "") << wrong.keys << " is taken";
        EXPECT_THAT(message, Not(HasSubstr(": :"))) << wrong.keys;
        for (const CheckList& list : refusals()) {
            for_each_finding(list, c, [&](const CaseCheck& check, const CaseFinding& finding) {
                broken.insert(&check);
                EXPECT_THAT(message, HasSubstr(refusal_text(check, finding, c))) << wrong.keys;
            });
        }
    }
    for (const CheckList& list : refusals()) {
        for (const CaseCheck& check : list.checks) {
            EXPECT_TRUE(broken.contains(&check)) << "no case has " << check.what;
        }
    }
}

// Stems on a terrace reach out of it; those that end in it see no water.
TEST(Refusals, StemsMayStandOnASolid) {
    const auto said = [](const std::string& height) {
        return refusal_of(with_keys(with_vegetation(),
                                    "solid[0].name = terrace; solid[0].x = [0.02, 0.18, 0.18, "
                                    "0.02]; solid[0].z = [0, 0, 0.02, 0.02]; "
                                    "vegetation[0].x_from = 0.03; vegetation[0].height = " +
                                        height));
    };
    EXPECT_EQ(said("30 mm"), "");
    EXPECT_THAT(said("15 mm"),
                HasSubstr("reeds: up to the tops of its stems it stands in the solid \"terrace\""));
}

// Water may stand higher than the depth of the case: at open ends, behind walls, in an outline of its own.
TEST(Refusals, InstrumentsMayStandWhereTheCaseHasWater) {
    const std::string probe =
        "probe[0].name = p; probe[0].kind = velocity; probe[0].sampling_frequency = 10; probe[0].x = 0.1; probe[0].z = 0.1; ";
    EXPECT_THAT(refusal_of(with_keys(flume(), probe)), HasSubstr("outside of the water"));
    const std::string deep =
        "outflow.kind = depth; outflow.depth = 120 mm; output.snapshot_z = [0.08, 0.12]; ";
    EXPECT_EQ(refusal_of(with_keys(open_channel(), deep + probe)), "");
    const std::string tall = "channel.ends = walls; start.kind = rest; channel.wall_height = 400 mm; ";
    EXPECT_EQ(refusal_of(with_keys(flume(), tall + probe)), "");
}

TEST(Refusals, RunsUntilConvergedNeedASteadyFlow) {
    for (const CaseCheck& check : start_of_run_refusals().checks) {
        const Case c = with_keys(flume(), "channel.ends = walls; start.kind = rest");
        EXPECT_EQ(refusal_of(c), "");
        try {
            refuse_to_run(c);
            ADD_FAILURE() << check.what;
        } catch (const InputError& error) {
            EXPECT_THAT(error.what(), HasSubstr("walls close the channel at its ends"));
        }
    }
    EXPECT_NO_THROW(refuse_to_run(flume()));
    // What enters and leaves constantly becomes steady too, on a level bed as well.
    for (const char* const keys : {"run.until = converged",
                                   "run.until = converged; channel.slope = 0; "
                                   "outflow.kind = depth; outflow.depth = 60 mm"}) {
        const Case open = with_keys(open_channel(), keys);
        EXPECT_EQ(refusal_of(open), "");
        EXPECT_NO_THROW(refuse_to_run(open));
    }
}

/// All tables.
std::vector<const CaseCheck*> all_checks() {
    std::vector<const CaseCheck*> all;
    const auto add = [&](const CheckList& list) {
        for (const CaseCheck& check : list.checks) all.push_back(&check);
    };
    std::for_each(refusals().begin(), refusals().end(), add);
    add(start_of_run_refusals());
    add(warnings());
    return all;
}

TEST(Checks, NameKeysThatExistAndSayWhatToDo) {
    std::set<std::string> rows;
    for (const CaseCheck* const check : all_checks()) {
        for (const std::string& id : check->keys) EXPECT_NE(find_key(id), nullptr) << id;
        EXPECT_FALSE(check->what.empty());
        EXPECT_FALSE(check->cure.empty()) << check->what;
        EXPECT_TRUE(rows.insert(check->keys.front() + " " + std::string(check->what)).second) << check->what;
    }
}

/// What was measured stands in the documents, with the command that measures it.
TEST(Checks, QuoteNoMeasurement) {
    for (const CaseCheck* const check : all_checks()) {
        if (check->keys.front() == "numerics.sound_speed") {
            continue;  // a share of the water's own weight, and the rule of ten
        }
        EXPECT_THAT(finding_text(std::string(check->what), *check, {}), Not(HasSubstr(" %"))) << check->what;
    }
}

}  // namespace
}  // namespace riffle::refusals_test
