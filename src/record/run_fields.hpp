#pragma once

#include "record/field.hpp"

namespace riffle::inline record::fields {

namespace groups {
inline constexpr Group file{"/", "The file"};
inline constexpr Group stored_case{"/case", "The case"};
inline constexpr Group summary{
    "/summary", "Summary", every_run, "",
    "Results of the run. Means are over the averaging window; \"crest\" is the level `crest`, below which the "
    "bed's drag acts."};
}  // namespace groups

struct File {
    Field format = make_attribute(groups::file, "format", "", "\"riffle-results\"");
    Field format_version = make_attribute(groups::file, "format_version", "1", "version of the format");
    Field unused_bytes =
        make_attribute(groups::file, "unused_bytes", "1", "bytes left in the file by replaced objects",
                       {.reader = Reader::simulation, .note = "the file is written anew when they get many"});
    Field riffle_version = make_attribute(groups::file, "riffle_version", "", "version that wrote the file");
    Field build = make_attribute(groups::file, "build", "", "how it was built");
    Field instruction_set =
        make_attribute(groups::file, "instruction_set", "", "instruction set of the last part of the run",
                       {.reader = Reader::simulation});
    Field run =
        make_attribute(groups::file, "run", "", "16 digits that results and checkpoints of one run share",
                       {.reader = Reader::simulation});
    Field title = make_attribute(groups::file, "title", "", "title of the case");
    Field dimension = make_attribute(groups::file, "dimension", "1", "2 or 3", {.reader = Reader::users});
    Field created = make_attribute(groups::file, "created", "", "when the run began, UTC");
    Field complete =
        make_attribute(groups::file, "complete", "1", "1: the run has come to its end, 0: not (yet)");
    Field failure =
        make_attribute(groups::file, "failure", "", "what the simulation failed with, else empty");
};
inline constexpr File file;

struct StoredCase {
    Field text = make_field(groups::stored_case, "text", "1", "complete case (TOML)", {}, "");
    Field inputs = make_field(
        groups::stored_case, "inputs", "1", "files that the case reads: checksum, bytes, key, path",
        {.reader = Reader::users, .note = "as they were at the start; CRC-64; a line each"}, "");
};
inline constexpr StoredCase stored_case;

consteval Field outcome(const char* name, Wording unit, Wording meaning, const FieldRule& rule = {}) {
    return make_attribute(groups::summary, name, unit, meaning, rule);
}
consteval Field departure(const char* name, Wording meaning) {
    return outcome(name, "1", meaning, {.written = with_profiles | column_twin});
}
constexpr unsigned stress_known = with_profiles | on_a_slope | with_periodic_ends;
struct Summary {
    Field converged = outcome("converged", "1", "1: converged, 0: not");
    Field window_start = outcome("window_start", "s", "start of the averaging window");
    Field window_end = outcome("window_end", "s", "its end");
    Field depth_mean_velocity = outcome("depth_mean_velocity", "m/s", "mean over the water above the datum");
    Field depth_mean_velocity_effective_samples =
        outcome("depth_mean_velocity_effective_samples", "1", "independent samples of its record",
                {.reader = Reader::users});
    Field depth_mean_velocity_half_width =
        outcome("depth_mean_velocity_half_width", "m/s", "half-width of its 95 % interval",
                {.written = with_samples});
    Field depth_mean_velocity_integral_time =
        outcome("depth_mean_velocity_integral_time", "s", "integral time scale of its record",
                {.reader = Reader::users});
    Field remaining_drift =
        outcome("remaining_drift", "1", "bound of the drift still to come, over the mean");
    Field velocity_fluctuation_growth =
        outcome("velocity_fluctuation_growth", "1", "growth of the velocity fluctuation over the window",
                {.reader = Reader::users});
    Field velocity_fluctuation_growth_least =
        outcome("velocity_fluctuation_growth_least", "1", "lower end of its 95 % interval",
                {.reader = Reader::users});
    Field relaxation_time =
        outcome("relaxation_time", "s",
                "relaxation time that the run is tested by, of the twin, or of what passes "
                "between open ends",
                {.written = relaxation_known});
    Field total_mean_velocity = outcome("total_mean_velocity", "m/s", "mass mean over all water");
    Field drag_over_gravity = outcome("drag_over_gravity", "1", "bed drag over the weight component");
    Field wall_over_gravity = outcome("wall_over_gravity", "1", "wall force over the weight component");
    Field vegetation_over_gravity = outcome("vegetation_over_gravity", "1", "mean of the series of this name",
                                            {.written = with_vegetation});
    Field porous_over_gravity = outcome("porous_over_gravity", "1", "mean of the series of this name",
                                        {.written = with_porous_zones});
    Field mean_level = outcome("mean_level", "m", "mean surface level above the bed level");
    Field velocity_fluctuation = outcome("velocity_fluctuation", "m/s", "mean of the series of this name");
    Field particle_order = outcome("particle_order", "1", "mean of the series of this name");
    Field density_deviation_minimum = outcome("density_deviation_minimum", "1",
                                              "mean of the series of this name", {.reader = Reader::users});
    Field density_deviation_maximum = outcome("density_deviation_maximum", "1",
                                              "mean of the series of this name", {.reader = Reader::users});
    Field centreline_velocity = outcome("centreline_velocity", "m/s", "mean of the series of this name",
                                        {.written = three_dimensions});
    Field centreline_velocity_half_width =
        outcome("centreline_velocity_half_width", "m/s", "half-width of its 95 % interval",
                {.written = three_dimensions | with_samples});
    Field side_wall_over_gravity = outcome("side_wall_over_gravity", "1", "mean of the series of this name",
                                           {.written = three_dimensions});
    Field secondary_velocity = outcome("secondary_velocity", "m/s", "mean of the series of this name",
                                       {.written = three_dimensions});
    Field level_trend = outcome("level_trend", "m/s", "slope of the line through the record of the level",
                                {.reader = Reader::users});
    Field level_drift =
        outcome("level_drift", "m", "last second's mean level less the first's", {.reader = Reader::users});
    Field surface_velocity = outcome(
        "surface_velocity", "m/s", "u of the topmost layer",
        {.written = with_profiles | level_surface,
         .note = "left out around bodies, and where the depths at open ends differ by a spacing: the topmost "
                 "layer is not at the surface everywhere"});
    Field velocity_error_above_rms = departure(
        "velocity_error_above_rms", "rms departure of u from the twin over the twin's u, above the crest");
    Field velocity_error_above_maximum = departure("velocity_error_above_maximum", "the largest of these");
    Field velocity_error_below_rms = departure("velocity_error_below_rms", "the same below the crest");
    Field velocity_error_below_maximum = departure("velocity_error_below_maximum", "the largest of these");
    Field depth_mean_velocity_error = departure(
        "depth_mean_velocity_error", "relative departure of the depth-mean velocity from the twin's");
    Field total_mean_velocity_error =
        departure("total_mean_velocity_error", "relative departure of the mass mean from the twin's");
    Field spurious_stress_rms =
        outcome("spurious_stress_rms", "1",
                "rms stress of the pressure forces above the crest and all solids, without the four top "
                "layers, over the stress at the crest",
                {.written = stress_known});
    Field spurious_stress_maximum = outcome("spurious_stress_maximum", "1", "the largest of these",
                                            {.written = stress_known, .reader = Reader::users});
    Field stress_error_rms = outcome("stress_error_rms", "1",
                                     "departure of the total stress from the momentum balance, the same way",
                                     {.written = stress_known});
    Field friction_velocity = outcome(
        "friction_velocity", "m/s", "sqrt(stress at the crest / rho), from the line of total stress above it",
        {.written = with_profiles | on_a_slope | where_fitted,
         .note =
             "without solids and vegetation; between side walls of the mean over the width; between open ends "
             "from the force of the bed"});
    Field log_law_friction_velocity =
        outcome("log_law_friction_velocity", "m/s", "friction velocity of the rough log law fitted to u",
                {.written = with_profiles | where_fitted});
    Field log_law_friction_velocity_half_width =
        outcome("log_law_friction_velocity_half_width", "m/s", "half-width of its 95 % interval",
                {.written = with_profiles | where_fitted});
    Field equivalent_roughness = outcome("equivalent_roughness", "m", "equivalent roughness of the same fit",
                                         {.written = with_profiles | where_fitted});
    Field equivalent_roughness_half_width =
        outcome("equivalent_roughness_half_width", "m", "half-width of its 95 % interval",
                {.written = with_profiles | where_fitted});
    Field zero_plane = outcome("zero_plane", "m", "zero plane of the same fit, above the bed level",
                               {.written = with_profiles | where_fitted, .reader = Reader::users});
    Field convergence = outcome("convergence", "", "the finding of the convergence test in words");
    Field particles = outcome("particles", "1", "particles of the water");
    Field wall_particles =
        outcome("wall_particles", "1", "particles of the walls", {.reader = Reader::users});
    Field lost_particles = outcome("lost_particles", "1", "particles that left the domain");
    Field lost_mass = outcome("lost_mass", {"kg/m", "kg"}, {"their mass per unit width", "their mass"},
                              {.reader = Reader::users});
    Field lost_share = outcome("lost_share", "1", "their share of all water");
    Field lost_ways = outcome("lost_ways", "", "their ways out in words", {.reader = Reader::users});
    Field steps = outcome("steps", "1", "steps");
    Field simulated_time = outcome("simulated_time", "s", "simulated time");
    Field sound_speed = outcome("sound_speed", "m/s", "speed of sound");
    Field crest = outcome("crest", "m", "level of the crests above the bed level", {.reader = Reader::users});
    Field datum = outcome("datum", "m", "level of the datum above the bed level", {.reader = Reader::users});
    Field total_depth =
        outcome("total_depth", "m", "depth of the water above the bed level", {.reader = Reader::users});
    Field wall_clock_seconds =
        outcome("wall_clock_seconds", "s", "computing time, over all parts of the run");
    Field threads = outcome("threads", "1", "threads of the last part of the run");
    Field instruction_set = outcome("instruction_set", "", "instruction set of the last part of the run");
    Field particle_updates_per_second =
        outcome("particle_updates_per_second", "1/s", "particles times evaluations per second");
};
inline constexpr Summary summary;

}  // namespace riffle::inline record::fields
