#pragma once

#include <string>
#include <vector>

#include "record/field.hpp"
#include "record/profiles.hpp"

namespace riffle::inline record::fields {

namespace groups {
inline constexpr Group time_series{"/time_series", "Time series", every_run, "",
                                   "Quantities of the whole flow, a row every `output.series_interval`."};
inline constexpr Group profiles{"/profiles", "Profiles", with_profiles, "",
                                "Time means of the layers over the averaging window."};
inline constexpr Group profile_blocks{
    "/profile_blocks", "Blocks of the profiles", every_run, "",
    "Sums over blocks of 0.1 s, from which profiles over any window follow."};
inline constexpr Group surface{"/surface", "Free surface", free_surface, "",
                               "In three dimensions over the centreline."};
inline constexpr Group surface_map{"/surface_map", "Maps of the free surface",
                                   three_dimensions | free_surface, "",
                                   "A map every `output.surface_map_interval`."};
inline constexpr Group mean_field{
    "/mean_field", "Mean field", three_dimensions, "",
    "Time means in cells, a row for each window of `output.mean_field_interval`. A window that the run did "
    "not finish is not written. Cells are as high as the rows of the lattice, and "
    "`output.mean_field_spacing` long and wide; each particle counts in one of them."};
}  // namespace groups

consteval Field series(const char* name, Wording unit, Wording meaning, const FieldRule& rule = {}) {
    return make_field(groups::time_series, name, unit, meaning, rule, "time", Averaging::over_rows);
}
consteval Field end_series(const char* name, Wording unit, Wording meaning,
                           Reader reader = Reader::analysis) {
    return series(name, unit, meaning, {.written = with_open_ends, .reader = reader});
}
struct TimeSeries {
    Field time = series("time", "s", "simulated time", {.averaging = Averaging::none});
    Field depth_mean_velocity =
        series("depth_mean_velocity", "m/s", "mean streamwise velocity over the water above the datum");
    Field total_mean_velocity =
        series("total_mean_velocity", "m/s", "mass-mean streamwise velocity of all fluid");
    Field drag_over_gravity = series("drag_over_gravity", "1", "bed drag over the weight component");
    Field wall_over_gravity =
        series("wall_over_gravity", "1", "streamwise wall force over the weight component");
    Field acceleration_over_gravity = series(
        "acceleration_over_gravity", "1", "rate of change of streamwise momentum over the weight component");
    Field vegetation_over_gravity =
        series("vegetation_over_gravity", "1", "drag of the vegetation over the weight component",
               {.written = with_vegetation});
    Field vegetation_power =
        series("vegetation_power", {"W/m", "W"}, "work of the vegetation's drag on the water",
               {.written = with_vegetation});
    Field porous_over_gravity =
        series("porous_over_gravity", "1", "resistance of porous zones over the weight component",
               {.written = with_porous_zones});
    Field porous_power =
        series("porous_power", {"W/m", "W"}, "work of the resistance of porous zones on the water",
               {.written = with_porous_zones});
    Field mean_level = series("mean_level", "m", "mean surface level above the bed level");
    Field maximum_velocity =
        series("maximum_velocity", "m/s", "largest particle speed", {.averaging = Averaging::none});
    Field density_deviation_minimum = series("density_deviation_minimum", "1", "smallest rho/rho0 - 1");
    Field density_deviation_maximum = series("density_deviation_maximum", "1", "largest rho/rho0 - 1");
    Field velocity_fluctuation = series("velocity_fluctuation", "m/s",
                                        "rms departure of the particle velocities from their layer means");
    Field particle_order =
        series("particle_order", "1", "layering of the particles, 1: perfect rows, 0: none");
    Field kinetic_energy =
        series("kinetic_energy", {"J/m", "J"}, {"kinetic energy per unit width", "kinetic energy"});
    Field time_step = series("time_step", "s", "time step", {.reader = Reader::users});
    Field potential_energy = series(
        "potential_energy", {"J/m", "J"},
        {"potential energy above the bed level per unit width", "potential energy above the bed level"},
        {.note = "between closed ends also down the slope"});
    Field elastic_energy = series("elastic_energy", {"J/m", "J"},
                                  {"energy of the compression per unit width", "energy of the compression"});
    Field water_volume = series("water_volume", {"m2", "m3"},
                                {"volume of the water per unit width: mass over density of the particles",
                                 "volume of the water: mass over density of the particles"});
    Field first_particle = series("first_particle", "m", "place along the channel of the first particle",
                                  {.averaging = Averaging::none, .reader = Reader::users});
    Field last_particle = series("last_particle", "m", "place along the channel of the last particle",
                                 {.averaging = Averaging::none, .reader = Reader::users});
    Field front_upstream =
        series("front_upstream", "m", "place along the channel of the water's upstream end",
               {.averaging = Averaging::none, .note = "of the third particle: two drops do not count"});
    Field front_downstream =
        series("front_downstream", "m", "place along the channel of the water's downstream end",
               {.averaging = Averaging::none, .note = "of the third particle: two drops do not count"});
    Field gravity_power =
        series("gravity_power", {"W/m", "W"}, "work of the weight along a channel without ends");
    Field bed_drag_power = series("bed_drag_power", {"W/m", "W"}, "work of the bed's drag on the water");
    Field closure_power = series("closure_power", {"W/m", "W"}, "work of the eddy stresses on the water",
                                 {.note = "negative: what goes into turbulence that is not resolved"});
    Field viscosity_power =
        series("viscosity_power", {"W/m", "W"},
               "work of the molecular viscosity on the water, with that of friction on walls");
    Field density_diffusion_power =
        series("density_diffusion_power", {"W/m", "W"},
               "rate at which density diffusion changes the energy of the compression");
    Field pressure_power =
        series("pressure_power", {"W/m", "W"},
               "what the pressure gives to the motion and the continuity does not take from the compression",
               {.note = "nothing in the exact equations: a part of the scheme's own"});
    Field further_power = series("further_power", {"W/m", "W"}, "work of stirring and of repulsive walls");
    Field solids_power = series("solids_power", {"W/m", "W"}, "work of moving solids on the water");
    Field inflow_discharge = end_series("inflow_discharge", {"m2/s", "m3/s"},
                                        {"discharge that enters, per unit width", "discharge that enters"});
    Field inflow_depth =
        end_series("inflow_depth", "m", "depth of the water that enters, from the bed level");
    Field outflow_discharge = end_series("outflow_discharge", {"m2/s", "m3/s"},
                                         {"discharge of the section at the outflow, per unit width",
                                          "discharge of the section at the outflow"});
    Field outflow_depth =
        end_series("outflow_depth", "m", "depth of the section at the outflow, from the bed level");
    Field particles_stored = end_series("particles_stored", "1", "particles, those beyond the ends included");
    Field particles_entered = end_series(
        "particles_entered", "1",
        "particles that have entered so far, those that wait before the inflow included, but for the ones of the start");
    Field particles_left = end_series("particles_left", "1", "particles that have left by the ends so far");
    Field particles_lost =
        end_series("particles_lost", "1", "particles that have left the domain otherwise so far");
    Field mass_stored = end_series("mass_stored", {"kg/m", "kg"},
                                   {"mass of these particles per unit width", "mass of these particles"});
    Field mass_entered =
        end_series("mass_entered", {"kg/m", "kg"},
                   {"mass that has entered per unit width", "mass that has entered"}, Reader::users);
    Field mass_left = end_series("mass_left", {"kg/m", "kg"},
                                 {"mass that has left per unit width", "mass that has left"}, Reader::users);
    Field momentum_stored = end_series(
        "momentum_stored", {"kg/s", "kg m/s"},
        {"momentum along the channel per unit width", "momentum along the channel"}, Reader::users);
    Field momentum_between_sections =
        end_series("momentum_between_sections", {"kg/s", "kg m/s"},
                   {"momentum along the channel per unit width of the water between the sections of the "
                    "instrument `standard_momentum_sections`",
                    "momentum along the channel of the water between the sections of the instrument "
                    "`standard_momentum_sections`"});
    Field momentum_entered =
        end_series("momentum_entered", {"kg/s", "kg m/s"},
                   {"momentum that has entered per unit width", "momentum that has entered"}, Reader::users);
    Field momentum_left =
        end_series("momentum_left", {"kg/s", "kg m/s"},
                   {"momentum that has left per unit width", "momentum that has left"}, Reader::users);
    Field side_wall_power = series("side_wall_power", "W", "work of the side walls' drag on the water",
                                   {.written = three_dimensions});
    Field side_wall_over_gravity =
        series("side_wall_over_gravity", "1", "drag of the side walls' layers over the weight component",
               {.written = three_dimensions, .note = "`drag_over_gravity` is the bed's alone"});
    Field centreline_velocity = series(
        "centreline_velocity", "m/s",
        "mean streamwise velocity above the datum in a strip along the centreline",
        {.written = three_dimensions,
         .note = "within half a period of the spheres' lattice on either side, on smooth beds a twentieth of "
                 "the width"});
    Field secondary_velocity = series("secondary_velocity", "m/s", "rms of the velocity in the cross-section",
                                      {.written = three_dimensions});
};
inline constexpr TimeSeries time_series;

/// A field of the profiles, with its values in memory.
struct ProfileField : Field {
    std::vector<double> Profiles::*values;
};
consteval ProfileField profile(const char* name, Wording unit, Wording meaning,
                               std::vector<double> Profiles::*values, const FieldRule& rule = {}) {
    return {make_field(groups::profiles, name, unit, meaning, rule, "layer"), values};
}
struct ProfileFields {
    ProfileField z =
        profile("z", "m", "mean height of the particles in the layer above the bed level", &Profiles::z);
    ProfileField bin_lower = profile("bin_lower", "m", "lower edge of the layer", &Profiles::bin_lower);
    ProfileField bin_upper = profile("bin_upper", "m", "upper edge of the layer", &Profiles::bin_upper);
    ProfileField velocity = profile("velocity", "m/s", "time-mean streamwise velocity", &Profiles::velocity);
    ProfileField velocity_half_width =
        profile("velocity_half_width", "m/s",
                "half-width of its 95 % interval; NaN from fewer than ten independent samples",
                &Profiles::velocity_half_width);
    ProfileField vertical_velocity = profile("vertical_velocity", "m/s", "time-mean vertical velocity",
                                             &Profiles::vertical_velocity, {.reader = Reader::users});
    ProfileField column_velocity =
        profile("column_velocity", "m/s", "column velocity at the particles' heights",
                &Profiles::column_velocity, {.written = column_twin | no_section_twin});
    ProfileField section_velocity =
        profile("column_velocity", "m/s", "velocity of the section at the particles' places",
                &Profiles::column_velocity, {.written = column_twin | section_twin});
    ProfileField velocity_deviation =
        profile("velocity_deviation", "m/s", "departure from the column at the particles' heights",
                &Profiles::velocity_deviation, {.written = column_twin | no_section_twin});
    ProfileField section_deviation =
        profile("velocity_deviation", "m/s", "departure from the section at the particles' places",
                &Profiles::velocity_deviation, {.written = column_twin | section_twin});
    ProfileField velocity_gradient =
        profile("velocity_gradient", "1/s", "time-mean du/dz", &Profiles::velocity_gradient);
    ProfileField eddy_viscosity =
        profile("eddy_viscosity", "m2/s", "time-mean eddy viscosity", &Profiles::eddy_viscosity);
    ProfileField pressure = profile("pressure", "Pa", "time-mean pressure", &Profiles::pressure);
    ProfileField density =
        profile("density", "kg/m3", "time-mean density", &Profiles::density, {.reader = Reader::users});
    ProfileField viscous_stress =
        profile("viscous_stress", "Pa", "viscous and closure shear stress at the upper edge",
                &Profiles::viscous_stress);
    ProfileField pair_stress =
        profile("pair_stress", "Pa", "shear stress carried by pressure forces at the upper edge",
                &Profiles::pair_stress, {.written = with_periodic_ends});
    ProfileField reynolds_stress = profile(
        "reynolds_stress", "Pa", "resolved Reynolds stress at the upper edge", &Profiles::reynolds_stress);
    ProfileField total_stress = profile("total_stress", "Pa", "total shear stress at the upper edge",
                                        &Profiles::total_stress, {.note = "the sum of the three"});
    ProfileField analytic_stress =
        profile("analytic_stress", "Pa", "shear stress of the momentum balance at the upper edge",
                &Profiles::analytic_stress,
                {.written = with_periodic_ends,
                 .note = "rho g S0 (H - z) less the drag below the crest; between side walls the section's, "
                         "its mean across the channel; none there without a section twin"});
    ProfileField velocity_rms =
        profile("velocity_rms", "m/s", "rms fluctuation of u", &Profiles::velocity_rms);
    ProfileField vertical_velocity_rms =
        profile("vertical_velocity_rms", "m/s", "rms fluctuation of w", &Profiles::vertical_velocity_rms);
    ProfileField drag =
        profile("drag", "N/m3", "drag of bed, vegetation and porous zones per unit volume", &Profiles::drag);
    ProfileField spanwise_velocity =
        profile("spanwise_velocity", "m/s", "time-mean spanwise velocity", &Profiles::spanwise_velocity,
                {.written = three_dimensions, .reader = Reader::users});
    ProfileField spanwise_velocity_rms =
        profile("spanwise_velocity_rms", "m/s", "rms fluctuation of v", &Profiles::spanwise_velocity_rms,
                {.written = three_dimensions});
    ProfileField side_wall_drag = profile(
        "side_wall_drag", "N/m3", "drag of the side walls' layers per unit volume", &Profiles::side_wall_drag,
        {.written = three_dimensions, .reader = Reader::users, .note = "negative: against the flow"});
};
inline constexpr ProfileFields profiles;

struct ProfileWindow {
    Field start = make_attribute(groups::profiles, "window_start", "s", "start of the averaging window");
    Field end = make_attribute(groups::profiles, "window_end", "s", "end of the averaging window");
    Field samples = make_attribute(groups::profiles, "samples", "1", "samples in the window");
};
inline constexpr ProfileWindow profile_window;

struct ProfileBlocks {
    Field time = make_field(groups::profile_blocks, "time", "s", "end of the block", {}, "time");
    Field samples = make_field(groups::profile_blocks, "samples", "1", "samples in the block", {}, "time");
    Field sums = make_field(groups::profile_blocks, "sums", "1",
                            "sums over particles and samples, SI, by layer and quantity", {},
                            "time layer quantity", Averaging::sums);
    Field quantities = make_attribute(groups::profile_blocks, "quantities", "",
                                      "names of the quantities, in the order of the last axis of `sums`",
                                      {.written = with_profiles, .reader = Reader::users});
};
inline constexpr ProfileBlocks profile_blocks;

struct Surface {
    Field time = make_field(groups::surface, "time", "s", "time", {}, "time");
    Field elevation = make_field(groups::surface, "elevation", "m", "surface elevation above the bed level",
                                 {}, "time x", Averaging::over_rows);
    Field x = make_field(groups::surface, "x", "m", "distance along the channel", {}, "x");
};
inline constexpr Surface surface;

struct SurfaceMap {
    Field time = make_field(groups::surface_map, "time", "s", "time", {}, "time");
    Field elevation =
        make_field(groups::surface_map, "elevation", "m", "surface elevation above the bed level", {},
                   "time y x", Averaging::over_rows);
    Field x = make_field(groups::surface_map, "x", "m", "distance along the channel",
                         {.note = "two particle spacings apart"}, "x");
    Field y = make_field(groups::surface_map, "y", "m", "distance across the channel", {}, "y");
};
inline constexpr SurfaceMap surface_map;

consteval Field cell(const char* name, Wording unit, Wording meaning, Averaging averaging,
                     const FieldRule& rule = {}) {
    return make_field(groups::mean_field, name, unit, meaning, rule, "time z y x", averaging);
}
/// Axes and weights of the mean field.
struct MeanFieldAxes {
    Field time = make_field(groups::mean_field, "time", "s", "end of the averaging window", {}, "time");
    Field samples = make_field(groups::mean_field, "samples", "1", "samples in the window", {}, "time");
    Field x = make_field(groups::mean_field, "x", "m", "distance along the channel, cell centres", {}, "x");
    Field y = make_field(groups::mean_field, "y", "m", "distance across the channel, cell centres", {}, "y");
    Field z = make_field(groups::mean_field, "z", "m", "height above the bed level, cell centres", {}, "z");
};
inline constexpr MeanFieldAxes mean_field_axes;
/// What it holds of each cell. Means are NaN where no particle was.
struct MeanField {
    Field count = cell("count", "1", "mean number of particles in the cell", Averaging::by_samples);
    Field velocity = cell("velocity", "m/s", "mean streamwise velocity", Averaging::by_particles,
                          {.note = "NaN where no particle was, as all means"});
    Field spanwise_velocity =
        cell("spanwise_velocity", "m/s", "mean spanwise velocity", Averaging::by_particles);
    Field vertical_velocity =
        cell("vertical_velocity", "m/s", "mean vertical velocity", Averaging::by_particles);
    Field velocity_variance =
        cell("velocity_variance", "m2/s2", "mean square of u'", Averaging::moments,
             {.reader = Reader::users, .note = "within cell and window, as all moments"});
    Field spanwise_velocity_variance = cell("spanwise_velocity_variance", "m2/s2", "mean square of v'",
                                            Averaging::moments, {.reader = Reader::users});
    Field vertical_velocity_variance = cell("vertical_velocity_variance", "m2/s2", "mean square of w'",
                                            Averaging::moments, {.reader = Reader::users});
    Field velocity_covariance = cell("velocity_covariance", "m2/s2", "mean of u'w'", Averaging::moments);
    Field velocity_spanwise_covariance =
        cell("velocity_spanwise_covariance", "m2/s2", "mean of u'v'", Averaging::moments);
    Field spanwise_vertical_covariance = cell("spanwise_vertical_covariance", "m2/s2", "mean of v'w'",
                                              Averaging::moments, {.reader = Reader::users});
    Field shear_stress =
        cell("shear_stress", "Pa", "stress tau_xz of viscosity and closure", Averaging::by_particles);
    Field lateral_shear_stress =
        cell("lateral_shear_stress", "Pa", "stress tau_xy of viscosity and closure", Averaging::by_particles);
    Field pressure = cell("pressure", "Pa", "mean pressure", Averaging::by_particles);
    Field eddy_viscosity = cell("eddy_viscosity", "m2/s", "mean eddy viscosity", Averaging::by_particles,
                                {.reader = Reader::users});
    Field drag = cell("drag", "N/m3", "streamwise force of the bed on the water, per volume",
                      Averaging::by_samples, {.note = "negative: against the flow; 0 where none"});
    Field spanwise_drag = cell("spanwise_drag", "N/m3", "spanwise force of the bed on the water, per volume",
                               Averaging::by_samples);
    Field side_wall_drag =
        cell("side_wall_drag", "N/m3", "streamwise force of the side walls' layers on the water, per volume",
             Averaging::by_samples);
};
inline constexpr MeanField mean_field;

}  // namespace riffle::inline record::fields
