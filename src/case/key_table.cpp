#include "case/key_table.hpp"

#include <algorithm>
#include <utility>

#include "case/bed_patch_keys.hpp"
#include "case/channel_keys.hpp"
#include "case/numerics_keys.hpp"
#include "case/open_end_keys.hpp"
#include "case/porous_keys.hpp"
#include "case/probe_keys.hpp"
#include "case/solid_keys.hpp"
#include "case/start_keys.hpp"
#include "case/surface_patch_keys.hpp"
#include "case/units.hpp"
#include "case/vegetation_keys.hpp"

namespace riffle::inline case_file {

namespace {

using enum Dimension;

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
        "until the depth-mean velocity is known within `run.tolerance`, between open ends the mean level and the "
        "discharge at the outflow too, at most `run.maximum_time`";
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
    for (auto* const section :
         {inflow_keys, outflow_keys, numerics_keys, start_keys, stirring_keys, run, output, measured,
          solid_keys, surface_patch_keys, bed_patch_keys, vegetation_keys, porous_keys, probe_keys}) {
        table.push_back(section());
    }
    return table;
}

}  // namespace

std::string SectionKeys::heading() const {
    if (name.empty()) return "";
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
    if (keys == nullptr) return nullptr;
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
    if (applies.id.empty()) return true;
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
        if (!condition_holds(*applies, c, item)) return applies;
    }
    return nullptr;
}

bool key_applies(const Key& key, const Case& c, std::size_t item) {
    return unmet_condition(key, c, item) == nullptr;
}

}  // namespace riffle::inline case_file
