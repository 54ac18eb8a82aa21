#pragma once

#include <string>

#include "record/field.hpp"

namespace riffle::inline record {

/// The group of all instruments, and of one.
inline constexpr const char* probes_group = "/probes";
[[nodiscard]] inline std::string probe_group(const std::string& name) {
    return std::string(probes_group) + "/" + name;
}

}  // namespace riffle::inline record

namespace riffle::inline record::fields {

namespace groups {
inline constexpr const char* probes = "/probes/NAME";
inline constexpr Group probe{probes, "Instruments", when_asked, "",
                             "The instruments of the case (`[[probe]]`) and the standard ones, whose names "
                             "begin with `standard_`. Values at points are in single precision; times, "
                             "positions and forces in double."};
inline constexpr Group velocity_points{
    probes, "Velocity at points", when_asked, "velocity",
    "A first-order kernel fit to the particles around the point, exact for a linear field; NaN where less "
    "than half of the kernel's support is water."};
inline constexpr Group elevations{probes, "Surface at points and along lines", when_asked,
                                  "wave, surface_line",
                                  "Found as `output.surface_detection` says; NaN without water."};
inline constexpr Group velocity_grid{
    probes, "Means on a grid", when_asked, "grid",
    "Over windows of `averaging_time`, which end at its multiples. Moments are divided by the number of samples "
    "in which the point was wet; NaN where that is less than half of `samples`."};
inline constexpr Group velocity_plane{probes, "Velocity on a grid, sample by sample", when_asked, "grid",
                                      "With `averaging_time` = 0."};
inline constexpr Group flow_rate{
    probes, "Discharge", when_asked, "flow_rate",
    "Sums over the particles weighted along x with the one-dimensional kernel: flow rate over depth is the "
    "mean velocity there, and the difference of momentum flux and pressure force between two sections is what "
    "the forces on the water between them take."};
inline constexpr Group pressure_gauges{
    probes, "Pressure gauges", when_asked, "pressure",
    "The mean of the particles' pressures with the kernel's weights, carried to the height of the point with "
    "the weight of the water, as walls are given theirs. The pressure of a gauge that water fills to less than "
    "0.1 is smaller in proportion."};
inline constexpr Group forces{
    probes, "Forces", when_asked, "force",
    "On the whole channel, and the sums over the pairs of particles with each solid alone, in the order of the "
    "case; the motion of those that are free."};
}  // namespace groups

struct Probe {
    Field kind = make_attribute(groups::probe, "kind", "", "kind of the instrument");
    Field sampling_frequency = make_attribute(groups::probe, "sampling_frequency", "Hz", "samples per second",
                                              {.reader = Reader::users});
    Field standard =
        make_attribute(groups::probe, "standard", "1", "1: a standard instrument, 0: one of the case",
                       {.reader = Reader::users});
};
inline constexpr Probe probe;

/// Values of an instrument sample by sample, one for each of its points.
consteval Field at_points(const Group& group, const char* name, Wording unit, Wording meaning,
                          const FieldRule& rule = {}) {
    return make_field(group, name, unit, meaning, rule, "time point", Averaging::over_rows);
}
consteval Field probe_time(const Group& group) {
    return make_field(group, "time", "s", "simulated time", {}, "time");
}
consteval Field probe_x(const Group& group, const char* axes = "point") {
    return make_field(group, "x", "m", "distance along the channel", {}, axes);
}
consteval Field probe_y(const Group& group, const char* meaning = "distance across the channel",
                        const char* axes = "point") {
    return make_field(group, "y", "m", meaning, {.written = three_dimensions}, axes);
}
consteval Field probe_z(const Group& group, const char* axes = "point") {
    return make_field(group, "z", "m", "height above the bed level", {}, axes);
}

struct VelocityPoints {
    Field x = probe_x(groups::velocity_points);
    Field y = probe_y(groups::velocity_points);
    Field z = probe_z(groups::velocity_points);
    Field time = probe_time(groups::velocity_points);
    Field velocity = at_points(groups::velocity_points, "velocity", "m/s", "streamwise velocity");
    Field vertical_velocity =
        at_points(groups::velocity_points, "vertical_velocity", "m/s", "vertical velocity");
    Field spanwise_velocity = at_points(groups::velocity_points, "spanwise_velocity", "m/s",
                                        "spanwise velocity", {.written = three_dimensions});
};
inline constexpr VelocityPoints velocity_points;

struct Elevations {
    Field x = probe_x(groups::elevations);
    Field y = probe_y(groups::elevations);
    Field time = probe_time(groups::elevations);
    Field elevation =
        at_points(groups::elevations, "elevation", "m", "surface elevation above the bed level");
};
inline constexpr Elevations elevations;

struct VelocityPlane {
    Field x = probe_x(groups::velocity_plane, "x");
    Field y = probe_y(groups::velocity_plane, "distance of the plane across the channel", "y");
    Field z = probe_z(groups::velocity_plane, "z");
    Field time = probe_time(groups::velocity_plane);
    Field velocity =
        at_points(groups::velocity_plane, "velocity", "m/s", "streamwise velocity", {.axes = "time z x"});
    Field vertical_velocity = at_points(groups::velocity_plane, "vertical_velocity", "m/s",
                                        "vertical velocity", {.axes = "time z x"});
};
inline constexpr VelocityPlane velocity_plane;

consteval Field on_grid(const char* name, Wording unit, Wording meaning, Averaging averaging,
                        const FieldRule& rule = {}) {
    return make_field(groups::velocity_grid, name, unit, meaning, rule, "time z x", averaging);
}
struct VelocityGrid {
    Field x = probe_x(groups::velocity_grid, "x");
    Field y = probe_y(groups::velocity_grid, "distance of the grid across the channel", "y");
    Field z = probe_z(groups::velocity_grid, "z");
    Field time = make_field(groups::velocity_grid, "time", "s", "end of the averaging window", {}, "time");
    Field samples = make_field(groups::velocity_grid, "samples", "1", "samples in the window", {}, "time");
    Field velocity =
        on_grid("velocity", "m/s", "mean streamwise velocity of the window", Averaging::by_samples);
    Field vertical_velocity =
        on_grid("vertical_velocity", "m/s", "mean vertical velocity of the window", Averaging::by_samples);
    Field velocity_variance = on_grid("velocity_variance", "m2/s2", "mean square of u'", Averaging::moments,
                                      {.reader = Reader::users});
    Field vertical_velocity_variance = on_grid("vertical_velocity_variance", "m2/s2", "mean square of w'",
                                               Averaging::moments, {.reader = Reader::users});
    Field velocity_covariance = on_grid("velocity_covariance", "m2/s2", "mean of u'w'", Averaging::moments);
    Field spanwise_velocity =
        on_grid("spanwise_velocity", "m/s", "mean spanwise velocity of the window", Averaging::by_samples,
                {.written = three_dimensions, .reader = Reader::users});
    Field spanwise_velocity_variance =
        on_grid("spanwise_velocity_variance", "m2/s2", "mean square of v'", Averaging::moments,
                {.written = three_dimensions, .reader = Reader::users});
    Field pressure = on_grid("pressure", "Pa", "mean pressure of the window", Averaging::by_samples);
    Field shear_stress =
        on_grid("shear_stress", "Pa", "mean stress tau_xz of viscosity and closure of the window",
                Averaging::by_samples, {.written = with_closure});
};
inline constexpr VelocityGrid velocity_grid;

struct FlowRate {
    Field x = probe_x(groups::flow_rate);
    Field time = probe_time(groups::flow_rate);
    Field flow_rate =
        at_points(groups::flow_rate, "flow_rate", {"m2/s", "m3/s"},
                  {"discharge per unit width through the section", "discharge through the section"});
    Field depth = at_points(groups::flow_rate, "depth", "m", "depth of the water over what it stands on",
                            {.reader = Reader::users});
    Field momentum_flux = at_points(groups::flow_rate, "momentum_flux", {"N/m", "N"},
                                    {"flux of momentum along the channel through the section per unit width",
                                     "flux of momentum along the channel through the section"},
                                    {.written = with_open_ends});
    Field pressure_force = at_points(
        groups::flow_rate, "pressure_force", {"N/m", "N"},
        {"force of the pressure on the section per unit width", "force of the pressure on the section"},
        {.written = with_open_ends});
    Field energy_flux =
        at_points(groups::flow_rate, "energy_flux", {"W/m", "W"},
                  {"flux of energy through the section per unit width: of motion, of height over "
                   "the bed level, and work of the pressure",
                   "flux of energy through the section: of motion, of height over the bed level, "
                   "and work of the pressure"},
                  {.written = with_open_ends});
};
inline constexpr FlowRate flow_rate;

struct PressureGauges {
    Field x = probe_x(groups::pressure_gauges);
    Field y = probe_y(groups::pressure_gauges);
    Field z = probe_z(groups::pressure_gauges);
    Field time = probe_time(groups::pressure_gauges);
    Field pressure = at_points(groups::pressure_gauges, "pressure", "Pa",
                               "pressure over that of the air; 0 at a dry point");
    Field wet_share =
        at_points(groups::pressure_gauges, "wet_share", "1", "share of the kernel's support that is water",
                  {.reader = Reader::users,
                   .note = "the sum of the weights: 1 in the water, 1/2 on a wall, 0 where dry"});
};
inline constexpr PressureGauges pressure_gauges;

consteval Field force(const char* name, Wording meaning, const FieldRule& rule = {}) {
    return make_field(groups::forces, name, {"N/m", "N"}, meaning, rule, "time", Averaging::over_rows);
}
struct Forces {
    Field time = probe_time(groups::forces);
    Field bed_drag =
        force("bed_drag", {"drag of the water on the bed's roughness, downstream, per unit width",
                           "drag of the water on the bed's roughness, downstream"});
    Field wall_force =
        force("wall_force", {"force of the water on walls and solids, downstream, per unit width",
                             "force of the water on walls and solids, downstream"});
    Field wall_normal_force =
        force("wall_normal_force",
              {"force of the water on walls and solids, normal to the bed and downward, per unit width",
               "force of the water on walls and solids, normal to the bed and downward"});
    Field weight_component =
        force("weight_component", {"component of the water's weight down the bed, per unit width",
                                   "component of the water's weight down the bed"});
    Field side_wall_drag = force("side_wall_drag", "drag of the water on the side walls' layers, downstream",
                                 {.written = three_dimensions});
    Field vegetation_drag = force("vegetation_drag",
                                  {"drag of the water on the vegetation, downstream, per unit width",
                                   "drag of the water on the vegetation, downstream"},
                                  {.written = with_vegetation});
    Field porous_drag = force("porous_drag",
                              {"resistance of porous zones to the water, downstream, per unit width",
                               "resistance of porous zones to the water, downstream"},
                              {.written = with_porous_zones});
};
inline constexpr Forces forces;

consteval Field moment(const char* name, Wording meaning, const FieldRule& rule) {
    return make_field(groups::forces, name, {"N", "N m"}, meaning, rule, "time", Averaging::over_rows);
}
/// Forces on a solid and their moments about a point of it (`moment_about`): their names end in its number,
/// and their meanings name it.
struct SolidForces {
    Field force = fields::force("solid_force_N",
                                {"force of the water on the solid, downstream, per unit width",
                                 "force of the water on the solid, downstream"},
                                {.written = with_solids});
    Field form_drag = fields::force("solid_form_drag_N",
                                    {"force of the pressure on the solid, downstream, per unit width",
                                     "force of the pressure on the solid, downstream"},
                                    {.written = with_solids});
    Field lift = fields::force("solid_lift_N",
                               {"force of the water on the solid, away from the bed, per unit width",
                                "force of the water on the solid, away from the bed"},
                               {.written = with_solids});
    Field side_force = fields::force("solid_side_force_N", "force of the water on the solid, along y",
                                     {.written = with_solids | three_dimensions});
    Field moment_y = moment("solid_moment_y_N",
                            {"moment of the water on the solid about y, per unit width",
                             "moment of the water on the solid about y"},
                            {.written = with_solids, .note = "positive: it turns z towards x"});
    Field pressure_moment_y = moment("solid_pressure_moment_y_N",
                                     {"moment of the pressure on the solid about y, per unit width",
                                      "moment of the pressure on the solid about y"},
                                     {.written = with_solids});
    Field moment_x = moment("solid_moment_x_N", "moment of the water on the solid about x",
                            {.written = with_solids | three_dimensions});
    Field pressure_moment_x =
        moment("solid_pressure_moment_x_N", "moment of the pressure on the solid about x",
               {.written = with_solids | three_dimensions});
    Field moment_z = moment("solid_moment_z_N", "moment of the water on the solid about z",
                            {.written = with_solids | three_dimensions});
    Field pressure_moment_z =
        moment("solid_pressure_moment_z_N", "moment of the pressure on the solid about z",
               {.written = with_solids | three_dimensions});
};
inline constexpr SolidForces solid_forces;

consteval Field motion(const char* name, const char* unit, const char* meaning,
                       unsigned written = every_run) {
    return make_field(groups::forces, name, unit, meaning, {.written = with_free_bodies | written}, "time",
                      Averaging::over_rows);
}
/// Where a free body is and how it moves: their names end in the number of its solid, and their meanings name
/// it.
struct BodyMotion {
    Field x = motion("body_x_N", "m", "place along x of the centre of mass of the solid");
    Field z = motion("body_z_N", "m", "place along z of the centre of mass of the solid");
    Field velocity_x = motion("body_velocity_x_N", "m/s", "velocity along x of the solid");
    Field velocity_z = motion("body_velocity_z_N", "m/s", "velocity along z of the solid");
    Field angle_y = motion("body_angle_y_N", "rad", "angle by which the solid has turned about y");
    Field angular_velocity_y =
        motion("body_angular_velocity_y_N", "rad/s", "angular velocity about y of the solid");
    Field y = motion("body_y_N", "m", "place along y of the centre of mass of the solid", three_dimensions);
    Field velocity_y = motion("body_velocity_y_N", "m/s", "velocity along y of the solid", three_dimensions);
    Field angle_x = motion("body_angle_x_N", "rad", "sum of the angles by which the solid has turned about x",
                           three_dimensions);
    Field angular_velocity_x = motion("body_angular_velocity_x_N", "rad/s",
                                      "angular velocity about x of the solid", three_dimensions);
    Field angle_z = motion("body_angle_z_N", "rad", "sum of the angles by which the solid has turned about z",
                           three_dimensions);
    Field angular_velocity_z = motion("body_angular_velocity_z_N", "rad/s",
                                      "angular velocity about z of the solid", three_dimensions);
};
inline constexpr BodyMotion body_motion;

}  // namespace riffle::inline record::fields
