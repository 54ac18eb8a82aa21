#include "case/key_table.hpp"

#include <algorithm>
#include <utility>

#include "case/channel_keys.hpp"
#include "case/open_end_keys.hpp"
#include "case/porous_keys.hpp"
#include "case/probe_keys.hpp"
#include "case/solid_keys.hpp"
#include "case/units.hpp"
#include "case/vegetation_keys.hpp"

namespace riffle {

namespace {

using enum Dimension;

SectionKeys numerics() {
    SectionKeys s{"numerics", "The numerical scheme. `preset` sets the defaults of the other keys.", {}};
    const auto key = [](const char* name, auto member, const char* meaning) {
        return make_key("numerics", name, &Case::numerics, member, meaning);
    };
    s.keys.push_back(
        key("preset", &Numerics::preset, "Scheme that the other keys of this section start from."));
    s.keys.push_back(
        key("spacing", &Numerics::spacing, "Particle spacing dx.")
            .measured_in(length)
            .greater_than(0)
            .with_default_note(
                "over spheres the smallest of 0.06 diameters, 1/5 of the roughness height "
                "and 1/30 of the depth; twice that in three dimensions; over beds by roughness and smooth "
                "ones 1/20 of the depth"));
    s.keys.push_back(key("kernel", &Numerics::kernel, "Smoothing kernel."));
    s.keys.push_back(
        key("smoothing_ratio", &Numerics::smoothing_ratio,
            "Smoothing length over spacing, h / dx; the kernel reaches 2 h.")
            .at_least(1)
            .at_most(4)
            .with_default_note(
                "2 in two dimensions over spheres, beds by roughness and smooth ones, and with vegetation; with porous "
                "zones 2.5 in two dimensions and 2 in three")
            .because("fewer neighbours do not sum up, more are not worth their time"));
    s.keys.push_back(
        key("sound_speed", &Numerics::sound_speed, "Artificial speed of sound c0.")
            .measured_in(velocity)
            .greater_than(0)
            .unset_by("auto",
                      "max(20 U_max, 10 sqrt(g H)); U_max of water that starts with an outline: that of its "
                      "fall over half of its height, of isotropic turbulence four times its rms"));
    s.keys.push_back(key("equation_of_state", &Numerics::equation_of_state, "Pressure from density."));
    s.keys.push_back(key("pressure_form", &Numerics::pressure_form, "Form of the pressure force."));
    s.keys.push_back(
        key("reference_pressure", &Numerics::reference_pressure,
            "Part of the pressure that acts as a function of the height instead of through the pairs.")
            .applies_with("numerics.pressure_form", {"corrected"}));
    s.keys.push_back(
        key("reference_depth_ratio", &Numerics::reference_depth_ratio,
            "Depth below the still surface, over the spacing, whose weight the pairs still carry.")
            .at_least(2)
            .at_most(1000)
            .because("nearer to the surface its onset stiffens waves, and the surface must stay above it")
            .applies_with("numerics.reference_pressure", {"hydrostatic"}));
    s.keys.push_back(key("velocity_gradient", &Numerics::velocity_gradient,
                         "Velocity gradient that the closure is given."));
    s.keys.push_back(key("kernel_correction", &Numerics::kernel_correction,
                         "What corrects the corrected forms of pressure and velocity gradient."));
    s.keys.push_back(key("pressure_correction_time", &Numerics::pressure_correction_time,
                         "Time over which the correction of the pressure form is averaged for each particle; "
                         "0: the correction of each moment, which keeps disordered water in motion.")
                         .measured_in(time)
                         .at_least(0)
                         .applies_with("numerics.pressure_form", {"corrected"}));
    s.keys.push_back(key("density_diffusion", &Numerics::density_diffusion,
                         "Diffusion in the continuity equation, against noise in the pressure."));
    s.keys.push_back(key("density_diffusion_coefficient", &Numerics::density_diffusion_coefficient,
                         "Its coefficient delta.")
                         .at_least(1e-4)
                         .at_most(1)
                         .because("0.1 is usual")
                         .applies_with("numerics.density_diffusion", {"fourtakas", "molteni", "antuono"}));
    s.keys.push_back(
        key("density_relaxation", &Numerics::density_relaxation,
            "Rate, over the strain rate, at which the density that a particle carries goes to what the "
            "kernel's sum over the particles makes of it, so that water that is sheared long stays even; "
            "not near a free surface. 0: it does not.")
            .at_least(0)
            .at_most(1)
            .because("it is for departures that grow over many turns"));
    s.keys.push_back(key("density_filter", &Numerics::density_filter, "Renormalisation of the density."));
    s.keys.push_back(key("density_filter_interval", &Numerics::density_filter_interval,
                         "Steps from one density filter to the next.")
                         .at_least(1)
                         .at_most(1000000)
                         .because("30 is usual; a run has some 1e5 steps")
                         .applies_with("numerics.density_filter", {"shepard", "mls"}));
    s.keys.push_back(key("viscosity", &Numerics::viscosity, "Form of the pair viscosity."));
    s.keys.push_back(key("eddy_stress", &Numerics::eddy_stress, "How the stress of the closure acts.")
                         .applies_with("turbulence.closure", {"ramp", "nezu-rodi", "nikuradse", "sps",
                                                              "czernuszenko-rylov", "wale", "vreman"}));
    s.keys.push_back(
        key("drag_sampling", &Numerics::drag_sampling, "Where a particle takes the drag of the bed.")
            .applies_with("bed.kind", {"spheres"}));
    s.keys.push_back(
        key("artificial_viscosity", &Numerics::artificial_viscosity, "alpha of the artificial viscosity.")
            .at_least(1e-4)
            .at_most(2)
            .because("used: 0.01 to 0.5")
            .applies_with("numerics.viscosity", {"artificial"}));
    s.keys.push_back(key("tensile_correction", &Numerics::tensile_correction,
                         "Monaghan's repulsion against clumping, its coefficient; 0: none.")
                         .at_least(0)
                         .at_most(1)
                         .because("0.2 is usual")
                         .applies_with("numerics.kernel", {"cubic-spline"}));
    s.keys.push_back(
        key("impact_dissipation", &Numerics::impact_dissipation,
            "Dissipation between particles that approach each other, that of a Riemann problem, with "
            "this factor of its limiter; 0: none. 3 in impacts; the Riemann forms have it. Above 0, "
            "particles that an impact has driven to one place are parted too.")
            .at_least(0)
            .at_most(20));
    s.keys.push_back(
        key("acoustic_damping", &Numerics::acoustic_damping,
            "Bulk viscosity over h c0, which damps sound and leaves flow without divergence alone; 0: "
            "none. 0.2 in impacts.")
            .at_least(0)
            .at_most(2));
    s.keys.push_back(key("xsph", &Numerics::xsph, "Smoothing of the particles' transport velocity; 0: none.")
                         .at_least(0)
                         .at_most(1)
                         .because("1 is the mean over the neighbours"));
    s.keys.push_back(key("stepping", &Numerics::stepping, "Time stepping."));
    s.keys.push_back(key("step_rule", &Numerics::step_rule, "What the time step follows from.")
                         .applies_with("numerics.time_step", {"auto"}));
    s.keys.push_back(key("courant_number", &Numerics::courant_number, "Courant number, dt c0 / h.")
                         .at_least(1e-3)
                         .at_most(2)
                         .because("above 2 no scheme is stable"));
    s.keys.push_back(key("time_step", &Numerics::time_step, "Fixed time step.")
                         .measured_in(time)
                         .greater_than(0)
                         .unset_by("auto", "from the Courant number, the viscosity and the forces"));
    s.keys.push_back(key("wall", &Numerics::wall, "Kind of the wall particles."));
    s.keys.push_back(key("wall_layers", &Numerics::wall_layers, "Layers of wall particles.")
                         .at_least(1)
                         .at_most(10)
                         .because("no kernel reaches farther")
                         .with_default_note("as deep as the kernel reaches")
                         .applies_with("numerics.wall", {"dummy", "dynamic", "modified-dynamic"}));
    s.keys.push_back(key("precision", &Numerics::precision, "Precision of the pair arithmetic."));
    s.keys.push_back(
        key("skin", &Numerics::skin, "Reach of the neighbour lists beyond the kernel, in units of h.")
            .at_least(0.01)
            .at_most(1)
            .because("thinner, the lists are built anew at every step")
            .unset_by("auto", "0.3; in three dimensions 0.1"));
    return s;
}

SectionKeys start() {
    SectionKeys s{"start", "The state at the beginning.", {}};
    const auto key = [](const char* name, auto member, const char* meaning) {
        return make_key("start", name, &Case::start, member, meaning);
    };
    const std::string kind = "start.kind";
    s.keys.push_back(key("kind", &Start::kind, "What the run starts from."));
    s.keys.push_back(
        key("velocity", &Start::velocity,
            "uniform: the velocity; power-law: U_max at the surface; standing-wave, taylor-green: the "
            "velocity amplitude.")
            .measured_in(velocity)
            .unset_by(
                "auto",
                "from the column twin (uniform, power-law), of a canal by Colebrook and White (uniform); zero (standing-wave); an error "
                "(taylor-green)")
            .applies_with(kind, {"uniform", "power-law", "standing-wave", "taylor-green"}));
    s.keys.push_back(key("exponent", &Start::exponent, "m of the power law.")
                         .at_least(0.1)
                         .at_most(100)
                         .because("measured: 3 to 10")
                         .applies_with(kind, {"power-law"}));
    s.keys.push_back(key("amplitude", &Start::amplitude, "Amplitude of the surface of the standing wave.")
                         .measured_in(length)
                         .at_least(0)
                         .applies_with(kind, {"standing-wave"}));
    s.keys.push_back(
        key("file", &Start::file,
            "results: the file to start from; isotropic: CSV table of the energy spectrum, columns "
            "`wavenumber` [1/m] and `energy` [m3/s2], whose integral is the kinetic energy per mass.")
            .applies_with(kind, {"results", "isotropic"}));
    s.keys.push_back(key("lattice", &Start::lattice, "Arrangement of the particles at the start."));
    const auto water = [&](const char* name, auto member, const char* meaning, const char* example) {
        return key(name, member, meaning)
            .measured_in(length)
            .may_be_empty()
            .with_default_note("all up to the depth")
            .with_example(example)
            .applies_with(kind, {"rest", "uniform"}, true);
    };
    s.keys.push_back(
        water("water_x", &Start::water_x,
              "Corners of the outline of the water along the channel, across all of its width; the "
              "depth then only sets the spacing of the rows.",
              R"(["0 mm", "100 mm", "100 mm", "0 mm"])"));
    s.keys.push_back(water("water_z", &Start::water_z, "Heights of the same corners above the bed level.",
                           R"(["0 mm", "0 mm", "200 mm", "200 mm"])"));
    s.keys.push_back(
        key("jitter", &Start::jitter,
            "Largest random displacement of the particles from their lattice, in units of the spacing.")
            .at_least(0)
            .at_most(0.5)
            .because("farther, two particles may meet"));
    s.keys.push_back(
        key("packed", &Start::packed,
            "Whether the particles beside solids, with jitter all, are moved before the run until they fill the "
            "water evenly; else faces that cut the rows of the lattice start with gaps beside them, and in three "
            "dimensions the surface of solids is that of the lattice, to half a spacing.")
            .unset_by(
                "auto",
                "in two dimensions beside solids whose faces leave such gaps, but for free surfaces between open "
                "ends; in three dimensions not")
            .applies_with("start.kind", {"rest", "uniform", "column", "section", "power-law", "results"}));
    s.keys.push_back(
        key("settling_time", &Start::settling_time,
            "Time at the beginning of the run over which a drag takes the motion out of still water, in its second "
            "half less and less: what the start lacks of its balance then becomes no lasting motion.")
            .measured_in(time)
            .at_least(0)
            .applies_with("start.kind", {"rest", "results"}));
    s.keys.push_back(
        key("perturbation", &Start::perturbation,
            "Random velocity without divergence that is added to the start, root mean square of a component.")
            .measured_in(velocity)
            .at_least(0)
            .unset_by(
                "auto",
                "a quarter of the friction velocity over spheres in two dimensions, where the flow then "
                "starts in the state that lasts; 0 elsewhere"));
    s.keys.push_back(key("seed", &Start::seed, "Seed of the random displacement and of the perturbation.")
                         .at_least(0)
                         .at_most(9007199254740991.0)
                         .because("whole numbers that every program keeps"));
    return s;
}

SectionKeys stirring() {
    SectionKeys s{
        "stirring",
        "A body force of travelling vortex modes of zero mean, which disorders the particles: a test of the "
        "scheme, no part of the flow.",
        {}};
    const auto key = [](const char* name, auto member, const char* meaning) {
        return make_key("stirring", name, &Case::stirring, member, meaning);
    };
    s.keys.push_back(key("acceleration", &Stirring::acceleration, "Amplitude F of the force; 0: none.")
                         .measured_in(acceleration)
                         .at_least(0));
    s.keys.push_back(key("modes", &Stirring::modes, "Number of modes.")
                         .at_least(1)
                         .at_most(100)
                         .because("waves of less than a hundredth of the channel are not resolved"));
    s.keys.push_back(key("celerity", &Stirring::celerity, "Speed at which the modes travel downstream.")
                         .measured_in(velocity)
                         .unset_by("auto",
                                   "the mean velocity of the column twin over the whole depth, from the bed "
                                   "level; 0 without a twin"));
    return s;
}

/// `run.until` is a word or a time, and so sets two members.
Key until_key() {
    Key key;
    key.section = "run";
    key.name = "until";
    key.meaning = "When the run ends: at a simulated time, or when the mean flow is known well enough.";
    key.type = ValueType::number;
    key.dimension = time;
    key.range = {0.0, 1e9, true, ""};
    key.unset_word = word(RunUntil::converged);
    key.unset_meaning =
        "until the depth-mean velocity is known within `run.tolerance`, at most `run.maximum_time`";
    key.example = "\"60 s\"";
    key.read = [](const Case& c, std::size_t) {
        return c.run.until == RunUntil::converged ? Value() : Value(c.run.time);
    };
    key.write = [](Case& c, const Value& value, std::size_t) {
        const auto* const end = std::get_if<double>(&value);
        c.run.until = end ? RunUntil::time : RunUntil::converged;
        c.run.time = end ? *end : c.run.time;
    };
    return key;
}

SectionKeys run() {
    SectionKeys s{"run", "How long the run lasts and what it averages over.", {}};
    const auto key = [](const char* name, auto member, const char* meaning) {
        return make_key("run", name, &Case::run, member, meaning);
    };
    const std::string until = "run.until";
    s.keys.push_back(until_key());
    s.keys.push_back(key("maximum_time", &Run::time, "Latest end of the run, in simulated time.")
                         .measured_in(time)
                         .greater_than(0)
                         .at_most(1e9)
                         .applies_with(until, {"converged"}, true));
    s.keys.push_back(
        key("tolerance", &Run::tolerance,
            "Relative half-width of the 95 % interval of the depth-mean velocity at which the run ends.")
            .at_least(1e-6)
            .at_most(1)
            .because("a mean is never known to less than a millionth")
            .applies_with(until, {"converged"}));
    s.keys.push_back(key("average_from", &Run::average_from, "Simulated time at which the averages begin.")
                         .measured_in(time)
                         .at_least(0)
                         .unset_by("auto", "where the statistical test finds the start-up over"));
    return s;
}

SectionKeys output() {
    SectionKeys s{"output", "What is written, and how often.", {}};
    const auto key = [](const char* name, auto member, const char* meaning) {
        return make_key("output", name, &Case::output, member, meaning).measured_in(time);
    };
    s.keys.push_back(
        key("series_interval", &Output::series_interval, "Between rows of the time series.").greater_than(0));
    s.keys.push_back(key("surface_interval", &Output::surface_interval,
                         "Between records of the surface. Spectra reach up to half of its inverse.")
                         .greater_than(0));
    s.keys.push_back(make_key("output", "surface_detection", &Case::output, &Output::surface_detection,
                              "How the surface is found for the records and the wave probes; compared in "
                              "docs/free-surface.md."));
    s.keys.push_back(make_key("output", "surface_threshold", &Case::output, &Output::surface_threshold,
                              "The value at which the detection sees the surface, scanned from above.")
                         .greater_than(0)
                         .at_most(3)
                         .because("the detections' values in the water: 1, or the number of dimensions")
                         .unset_by("auto",
                                   "half of the value in the water (volume-fraction 0.5, "
                                   "position-divergence 1 in two and 1.5 in three dimensions); "
                                   "density-ratio 0.9")
                         .applies_with("output.surface_detection",
                                       {"volume-fraction", "position-divergence", "density-ratio"}, true));
    s.keys.push_back(
        key("profile_interval", &Output::profile_interval, "Between samples of the mean profiles.")
            .greater_than(0));
    s.keys.push_back(
        key("snapshot_interval", &Output::snapshot_interval, "Between snapshots of all particles; 0: none.")
            .at_least(0));
    s.keys.push_back(
        key("checkpoint_interval", &Output::checkpoint_interval, "Wall-clock time between checkpoints.")
            .greater_than(0));
    s.keys.push_back(
        key("progress_interval", &Output::progress_interval, "Wall-clock time between progress lines.")
            .greater_than(0));
    s.keys.push_back(make_key("output", "standard_probes", &Case::output, &Output::standard_probes,
                              "Whether the instruments that suit the case record without being asked for; "
                              "`riffle check` lists them."));
    const auto in_space = [](Key row) {
        return std::move(row).applies_with("channel.dimensions", {"3"}, true);
    };
    s.keys.push_back(in_space(key("mean_field_interval", &Output::mean_field_interval,
                                  "Length of the averaging windows of the mean field; 0: none.")
                                  .at_least(0)));
    s.keys.push_back(in_space(make_key("output", "mean_field_spacing", &Case::output,
                                       &Output::mean_field_spacing, "Edge of the mean field's cells.")
                                  .measured_in(length)
                                  .greater_than(0)
                                  .unset_by("auto", "the particle spacing")));
    s.keys.push_back(in_space(key("surface_map_interval", &Output::surface_map_interval,
                                  "Between plan maps of the surface; 0: none.")
                                  .at_least(0)));
    s.keys.push_back(make_key("output", "snapshot_fields", &Case::output, &Output::snapshot_fields,
                              "What the snapshots hold beside position and number of the particles: any of "
                              "velocity, pressure, density, eddy_viscosity."));
    const auto region = [](const char* name, auto member, const char* meaning) {
        return make_key("output", name, &Case::output, member, meaning)
            .measured_in(length)
            .may_be_empty()
            .with_example(R"(["0 mm", "50 mm"])");
    };
    s.keys.push_back(
        region("snapshot_x", &Output::snapshot_x, "From and to where along the channel; not given: all."));
    s.keys.push_back(in_space(
        region("snapshot_y", &Output::snapshot_y, "From and to where across the channel; not given: all.")));
    s.keys.push_back(region("snapshot_z", &Output::snapshot_z,
                            "From and to which height above the bed level; not given: all."));
    s.keys.push_back(make_key("output", "compression", &Case::output, &Output::compression,
                              "Of the results file: 0 none, 9 smallest and slowest.")
                         .at_least(0)
                         .at_most(9)
                         .because("the levels of deflate"));
    return s;
}

SectionKeys measured() {
    SectionKeys s{"measured", "What was measured, to compare with.", {}};
    const auto key = [](const char* name, auto member, const char* meaning) {
        return make_key("measured", name, &Case::measured, member, meaning);
    };
    const auto number = [&](const char* name, auto member, Dimension dimension, const char* meaning) {
        return key(name, member, meaning)
            .measured_in(dimension)
            .greater_than(0)
            .unset_by("unknown", "nothing to compare with");
    };
    s.keys.push_back(number("depth_mean_velocity", &Measured::depth_mean_velocity, velocity,
                            "Mean of u over the water above the datum."));
    s.keys.push_back(
        number("friction_velocity", &Measured::friction_velocity, velocity, "Friction velocity u_*."));
    s.keys.push_back(number("equivalent_roughness", &Measured::equivalent_roughness, length,
                            "Equivalent sand roughness k_s of the rough log law."));
    s.keys.push_back(number("discharge", &Measured::discharge, discharge, "Discharge Q of the flume."));
    s.keys.push_back(number("surface_standard_deviation", &Measured::surface_standard_deviation, length,
                            "Standard deviation of the surface elevation."));
    s.keys.push_back(
        key("velocity_profile", &Measured::velocity_profile,
            "CSV file with the columns z, u and if known u_uncertainty (m, m/s); z above the datum."));
    s.keys.push_back(key("uniform", &Measured::uniform, "Whether the measured flow was uniform."));
    s.keys.push_back(key("source", &Measured::source, "Where the values come from."));
    return s;
}

std::vector<SectionKeys> make_table() {
    std::vector<SectionKeys> table = channel_keys();
    for (auto* const section : {inflow_keys, outflow_keys, numerics, start, stirring, run, output, measured,
                                solid_keys, vegetation_keys, porous_keys, probe_keys}) {
        table.push_back(section());
    }
    return table;
}

}  // namespace

std::string SectionKeys::heading() const {
    if (name.empty()) {
        return "";
    }
    return repeated() ? "[[" + name + "]]" : "[" + name + "]";
}

const std::vector<SectionKeys>& key_table() {
    static const std::vector<SectionKeys> table = make_table();
    return table;
}

const SectionKeys* find_section(std::string_view name) {
    const auto& table = key_table();
    const auto found =
        std::find_if(table.begin(), table.end(), [&](const auto& s) { return s.name == name; });
    return found == table.end() ? nullptr : &*found;
}

const Key* find_key(std::string_view section, std::string_view name) {
    const SectionKeys* const keys = find_section(section);
    if (keys == nullptr) {
        return nullptr;
    }
    const auto found =
        std::find_if(keys->keys.begin(), keys->keys.end(), [&](const Key& key) { return key.name == name; });
    return found == keys->keys.end() ? nullptr : &*found;
}

const Key* find_key(std::string_view id) {
    const auto dot = id.find('.');
    return dot == std::string_view::npos ? find_key("", id) : find_key(id.substr(0, dot), id.substr(dot + 1));
}

namespace {

bool condition_holds(const Applies& applies, const Case& c, std::size_t item) {
    if (applies.id.empty()) {
        return true;
    }
    const Key& other = *find_key(applies.id);
    const Value value = other.get(c, item);
    std::string now;
    if (const auto* const text = std::get_if<std::string>(&value)) {
        now = *text;
    } else if (const auto* const integer = std::get_if<long long>(&value)) {
        now = std::to_string(*integer);
    } else if (std::holds_alternative<std::monostate>(value)) {
        now = other.unset_word;
    }
    return std::find(applies.words.begin(), applies.words.end(), now) != applies.words.end() &&
           key_applies(other, c, item);
}

}  // namespace

const Applies* unmet_condition(const Key& key, const Case& c, std::size_t item) {
    for (const Applies* const applies : {&key.applies, &key.applies_also}) {
        if (!condition_holds(*applies, c, item)) {
            return applies;
        }
    }
    return nullptr;
}

bool key_applies(const Key& key, const Case& c, std::size_t item) {
    return unmet_condition(key, c, item) == nullptr;
}

}  // namespace riffle
