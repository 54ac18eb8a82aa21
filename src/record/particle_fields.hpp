#pragma once

#include <array>

#include "record/field.hpp"

namespace riffle::inline record {

/// The group of all snapshots.
inline constexpr const char* snapshots_group = "/snapshots";

}  // namespace riffle::inline record

namespace riffle::inline record::fields {

namespace groups {
inline constexpr Group snapshot{
    "/snapshots/NNNNN", "Snapshots", when_asked, "",
    "The particles every `output.snapshot_interval`, and those of the state in which the run ended; a run that is "
    "resumed drops these. What they hold beside `position` and `id`, and of which part of the water, "
    "`output.snapshot_fields`, `snapshot_x`, `snapshot_y` and `snapshot_z` say; of a part, the number of "
    "particles changes from one snapshot to the next."};
inline constexpr Group walls{"/boundaries/walls", "Walls"};
inline constexpr Group solids{"/boundaries/solids", "Surfaces of the solids", with_solids};
inline constexpr Group spheres{"/boundaries/spheres", "Spheres of the bed", three_dimensions | with_spheres};
inline constexpr Group lost{"/lost_particles", "Lost particles", every_run, "",
                            "The particles that left the domain, in order of time."};
inline constexpr Group state{
    "/state", "Last state", every_run, "",
    "In double precision, for `[start] kind = \"results\"`; the checkpoints hold the same."};
}  // namespace groups

consteval Field of_particles(const char* name, Wording unit, Wording meaning, const FieldRule& rule = {}) {
    return make_field(groups::snapshot, name, unit, meaning, rule, "particle");
}
struct Snapshot {
    Field position = of_particles("position", "m", "position (x, y, z)",
                                  {.axes = "particle axis", .note = "y = 0 in two dimensions"});
    Field velocity = of_particles("velocity", "m/s", "velocity (u, v, w)",
                                  {.written = when_asked, .axes = "particle axis"});
    Field pressure = of_particles("pressure", "Pa", "pressure", {.written = when_asked});
    Field density =
        of_particles("density", "kg/m3", "density", {.written = when_asked, .reader = Reader::users});
    Field eddy_viscosity = of_particles("eddy_viscosity", "m2/s", "eddy viscosity", {.written = when_asked});
    Field id = of_particles("id", "1", "particle number", {.reader = Reader::simulation});
    Field point = of_particles("point", "1", "rows of the snapshot, for its index",
                               {.written = three_dimensions,
                                .reader = Reader::index_files,
                                .note = "where no snapshot before has as many particles"});
    Field wall_position =
        of_particles("wall_position", "m", "position (x, y, z) of the wall particles",
                     {.written = with_moving_solids, .reader = Reader::index_files, .axes = "wall axis"});
    Field solid_vertices =
        of_particles("solid_vertices", "m", "corners (x, y, z) of the surfaces of the solids",
                     {.written = with_moving_solids,
                      .axes = "vertex axis",
                      .note = "read in three dimensions; in two the case says where they are"});
    Field time = make_attribute(groups::snapshot, "time", "s", "simulated time");
};
inline constexpr Snapshot snapshot;

struct Walls {
    Field position =
        make_field(groups::walls, "position", "m", "position (x, y, z) of the wall particles at t = 0",
                   {.reader = Reader::index_files}, "wall axis");
    Field body = make_field(groups::walls, "body", "1",
                            "0: walls at rest, 1: the lid, 2 and on: the solids of the case",
                            {.reader = Reader::index_files}, "wall");
    Field point = make_field(groups::walls, "point", "1", "rows of the points, for the index",
                             {.reader = Reader::index_files}, "wall");
};
inline constexpr Walls walls;

struct Solids {
    Field vertices = make_field(groups::solids, "vertices", "m",
                                "corners (x, y, z) of the surfaces of the solids at t = 0",
                                {.note = "in two dimensions of the outlines, in order"}, "vertex axis");
    Field body = make_field(groups::solids, "body", "1",
                            "solid that a corner belongs to: 2 is the first one of the case",
                            {.reader = Reader::users}, "vertex");
    Field triangles =
        make_field(groups::solids, "triangles", "1", "triangles of the surfaces: rows of `vertices`",
                   {.written = three_dimensions}, "triangle corner");
    Field names = make_attribute(groups::solids, "names", "", "names of the solids, a line each",
                                 {.reader = Reader::users});
};
inline constexpr Solids solids;

struct Spheres {
    Field centre = make_field(groups::spheres, "centre", "m", "centres (x, y, z) of the spheres of the bed",
                              {.reader = Reader::index_files}, "sphere axis");
    Field point = make_field(groups::spheres, "point", "1", "rows of the points, for the index",
                             {.reader = Reader::index_files}, "sphere");
    Field diameter = make_attribute(groups::spheres, "diameter", "m", "diameter of the spheres",
                                    {.reader = Reader::users});
};
inline constexpr Spheres spheres;

consteval Field of_lost(const char* name, Wording unit, Wording meaning, const char* note = "") {
    return make_field(groups::lost, name, unit, meaning, {.reader = Reader::simulation, .note = note},
                      "particle");
}
struct LostParticles {
    Field id = of_lost("id", "1", "number of the particle");
    Field exit = of_lost("exit", "1", "way out",
                         "0: over the end wall at x = 0, 1: over the far end wall, 2: over a side wall, 3: "
                         "through the top of the domain, 4 to 6: through these walls, 7: through the bed");
    Field time = of_lost("time", "s", "simulated time at which it was taken out");
    Field mass = of_lost("mass", {"kg/m", "kg"}, {"mass per unit width", "mass"});
    std::array<Field, 3> position = {of_lost("position_x", "m", "place where it was taken out"),
                                     of_lost("position_y", "m", "place where it was taken out"),
                                     of_lost("position_z", "m", "place where it was taken out")};
    std::array<Field, 3> velocity = {of_lost("velocity_x", "m/s", "velocity with which it left"),
                                     of_lost("velocity_y", "m/s", "velocity with which it left"),
                                     of_lost("velocity_z", "m/s", "velocity with which it left")};
};
inline constexpr LostParticles lost_particles;

consteval Field of_state(const char* name, Wording unit, Wording meaning, unsigned written = at_the_end,
                         const char* axes = "particle") {
    return make_field(groups::state, name, unit, meaning, {.written = written, .reader = Reader::simulation},
                      axes);
}
constexpr unsigned state_across = at_the_end | three_dimensions;
/// Fields with an axis are in the order x, y, z.
struct State {
    std::array<Field, 3> position = {of_state("position_x", "m", "position x"),
                                     of_state("position_y", "m", "position y", state_across),
                                     of_state("position_z", "m", "position z")};
    std::array<Field, 3> velocity = {of_state("velocity_x", "m/s", "velocity along x"),
                                     of_state("velocity_y", "m/s", "velocity along y", state_across),
                                     of_state("velocity_z", "m/s", "velocity along z")};
    std::array<Field, 3> listed_position = {
        of_state("listed_position_x", "m", "position at the last build of the neighbour lists, x"),
        of_state("listed_position_y", "m", "position at the last build of the neighbour lists, y",
                 state_across),
        of_state("listed_position_z", "m", "position at the last build of the neighbour lists, z")};
    Field density_deviation = of_state("density_deviation", "1", "rho/rho0 - 1");
    std::array<Field, 3> previous_velocity = {
        of_state("previous_motion_x", "m/s", "velocity before the last step along x",
                 at_the_end | verlet_stepping),
        of_state("previous_motion_y", "m/s", "velocity before the last step along y",
                 state_across | verlet_stepping),
        of_state("previous_motion_z", "m/s", "velocity before the last step along z",
                 at_the_end | verlet_stepping)};
    Field previous_density =
        of_state("previous_density", "1", "rho/rho0 - 1 before the last step", at_the_end | verlet_stepping);
    std::array<Field, 3> previous_acceleration = {
        of_state("previous_motion_x", "m/s2", "acceleration of the step before along x",
                 at_the_end | beeman_stepping),
        of_state("previous_motion_y", "m/s2", "acceleration of the step before along y",
                 state_across | beeman_stepping),
        of_state("previous_motion_z", "m/s2", "acceleration of the step before along z",
                 at_the_end | beeman_stepping)};
    Field previous_density_rate =
        of_state("previous_density", "1/s", "rate of change of rho/rho0 of the step before",
                 at_the_end | beeman_stepping);
    Field mass = of_state("mass", {"kg/m", "kg"}, {"mass per unit width", "mass"});
    Field wall_density_deviation =
        of_state("wall_density_deviation", "1", "rho/rho0 - 1 of the wall particles", at_the_end, "wall");
    Field closure_depth =
        of_state("closure_depth", "m", "depth that the mixing length follows", at_the_end | with_local_depth);
    Field volume_surplus =
        of_state("volume_surplus", "1", "how much more volume of particles than room the kernel finds",
                 at_the_end | density_relaxation);
    std::array<Field, 9> correction = {
        of_state("correction_xx", "1", "mean departure of the pressure correction from the identity, xx",
                 at_the_end | slow_correction),
        of_state("correction_xy", "1", "mean departure of the pressure correction from the identity, xy",
                 state_across | slow_correction),
        of_state("correction_xz", "1", "mean departure of the pressure correction from the identity, xz",
                 at_the_end | slow_correction),
        of_state("correction_yx", "1", "mean departure of the pressure correction from the identity, yx",
                 state_across | slow_correction),
        of_state("correction_yy", "1", "mean departure of the pressure correction from the identity, yy",
                 state_across | slow_correction),
        of_state("correction_yz", "1", "mean departure of the pressure correction from the identity, yz",
                 state_across | slow_correction),
        of_state("correction_zx", "1", "mean departure of the pressure correction from the identity, zx",
                 at_the_end | slow_correction),
        of_state("correction_zy", "1", "mean departure of the pressure correction from the identity, zy",
                 state_across | slow_correction),
        of_state("correction_zz", "1", "mean departure of the pressure correction from the identity, zz",
                 at_the_end | slow_correction)};
    Field open_ends =
        of_state("open_ends", "1",
                 "state of the open ends: the sections, the streams that enter and the account of "
                 "what has crossed them, in SI units",
                 at_the_end | with_open_ends, "number");
    Field sound_at_ends = of_state("sound_at_ends", "1",
                                   "sound that leaves through the open ends: pressures over the density in "
                                   "the water beyond them, in SI units",
                                   at_the_end | with_open_ends, "number");
    Field free_bodies =
        of_state("free_bodies", "1",
                 "state of the free bodies: places, velocities and turns now and when the lists were built, "
                 "and the springs of what they touch, in SI units",
                 at_the_end | with_free_bodies, "number");
    Field id = of_state("id", "1", "particle number");
};
inline constexpr State state;

consteval Field of_clock(const char* name, Wording unit, Wording meaning, const FieldRule& rule = {}) {
    return make_attribute(groups::state, name, unit, meaning,
                          {.written = rule.written, .reader = Reader::simulation, .note = rule.note});
}
struct Clock {
    Field time = of_clock("time", "s", "simulated time");
    Field steps = of_clock("steps", "1", "steps so far");
    Field particles_created =
        of_clock("particles_created", "1", "particles made so far: the number that the next one would get");
    Field list_builds = of_clock("list_builds", "1", "neighbour lists built so far");
    Field time_step = make_attribute(groups::state, "time_step", "s", "the last time step");
    Field largest_acceleration =
        of_clock("largest_acceleration", "m/s2", "largest acceleration of a particle");
    Field displacement_bound =
        of_clock("displacement_bound", "m", "most that a particle has moved since the lists were built");
    Field listed_time =
        of_clock("listed_time", "s", "when the lists were built", {.written = with_moving_solids});
    Field side_wall_drag_coefficient =
        of_clock("side_wall_drag_coefficient", "1/m", "that of the side walls' layers in the next step",
                 {.written = three_dimensions});
    Field sound_speed = of_clock("sound_speed", "m/s", "speed of sound");
};
inline constexpr Clock clock;

}  // namespace riffle::inline record::fields
