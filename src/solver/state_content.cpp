#include "solver/state_content.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>

#include "base/error.hpp"
#include "case/words.hpp"
#include "solver/content.hpp"
#include "solver/recorder.hpp"

namespace riffle {

namespace {

template <int D>
constexpr auto axis_names = [] {
    if constexpr (D == 2) {
        return std::array<const char*, 2>{"x", "z"};
    } else {
        return std::array<const char*, 3>{"x", "y", "z"};
    }
}();

std::vector<double> doubles(const Content& content, const std::string& path) {
    return std::get<std::vector<double>>(checkpoint_dataset(content, path).values);
}

double group_number(const Content& content, const std::string& group, const std::string& name,
                    std::optional<double> otherwise = {}) {
    for (const Attribute& attribute : content.attributes) {
        if (attribute.path == group && attribute.name == name) {
            if (const auto* number = std::get_if<double>(&attribute.value)) {
                return *number;
            }
            return static_cast<double>(std::get<std::int64_t>(attribute.value));
        }
    }
    if (otherwise) {
        return *otherwise;
    }
    throw FileError(
        fmt::format("the checkpoint lacks `{}` of {}: it was written by another build", name, group));
}

/// What the stepper keeps of the step before, where it keeps anything.
template <int D>
void add_previous_step(Content& content, const std::string& group, const PreviousStep<D>& previous,
                       Stepping stepping) {
    if (previous.empty()) {
        return;
    }
    const bool rates = stepping == Stepping::beeman;
    for (std::size_t k = 0; k < D; ++k) {
        const std::string axis = axis_names<D>[k];
        add_array(
            content, group + "/previous_motion_" + axis, previous.motion[k], rates ? "m/s2" : "m/s",
            (rates ? "acceleration of the step before along " : "velocity before the last step along ") +
                axis);
    }
    add_array(content, group + "/previous_density", previous.density, rates ? "1/s" : "1",
              rates ? "rate of change of rho/rho0 of the step before" : "rho/rho0 - 1 before the last step");
}

bool has_dataset(const Content& content, const std::string& path) {
    return std::any_of(content.datasets.begin(), content.datasets.end(),
                       [&](const auto& dataset) { return dataset.path == path; });
}

}  // namespace

template <int D>
void add_state(Content& content, const std::string& group, const SimulationIn<D>& simulation) {
    const Particles<D> p = simulation.state();
    for (std::size_t k = 0; k < D; ++k) {
        const std::string axis = axis_names<D>[k];
        add_array(content, group + "/position_" + axis, p.position[k], "m", "position " + axis);
        add_array(content, group + "/velocity_" + axis, p.velocity[k], "m/s", "velocity along " + axis);
        add_array(content, group + "/listed_position_" + axis, p.listed_position[k], "m",
                  "position at the last build of the neighbour lists, " + axis);
    }
    add_array(content, group + "/density_deviation", p.density_deviation, "1", "rho/rho0 - 1");
    add_previous_step(content, group, p.previous, simulation.stepping());
    add_array(content, group + "/mass", p.mass, D == 2 ? "kg/m" : "kg",
              D == 2 ? "mass per unit width" : "mass");
    add_array(content, group + "/wall_density_deviation", simulation.wall_density_deviation(), "1",
              "rho/rho0 - 1 of the wall particles");
    content.datasets.push_back({.path = group + "/id",
                                .shape = {p.size()},
                                .values = std::vector<std::int64_t>(p.id.begin(), p.id.end()),
                                .unit = "1",
                                .long_name = "particle number"});
    const SimulationClock& clock = simulation.clock();
    const auto attribute = [&](const char* name, AttributeValue value) {
        add_attribute(content, group, name, std::move(value));
    };
    attribute("time", clock.time);
    attribute("steps", clock.steps);
    attribute("list_builds", clock.list_builds);
    attribute("time_step", clock.time_step);
    attribute("largest_acceleration", clock.largest_acceleration);
    attribute("displacement_bound", clock.displacement_bound);
    if (clock.listed_time > 0.0) {
        attribute("listed_time", clock.listed_time);
    }
    if (D == 3) {
        attribute("side_wall_drag_coefficient", clock.side_wall_drag_coefficient);
    }
    attribute("sound_speed", simulation.scheme().state.sound_speed);
}

template <int D>
void restore_state(const Content& content, const std::string& group, SimulationIn<D>& simulation) {
    Particles<D> p;
    for (std::size_t k = 0; k < D; ++k) {
        const std::string axis = axis_names<D>[k];
        p.position[k] = doubles(content, group + "/position_" + axis);
        p.velocity[k] = doubles(content, group + "/velocity_" + axis);
        p.listed_position[k] = doubles(content, group + "/listed_position_" + axis);
    }
    p.density_deviation = doubles(content, group + "/density_deviation");
    p.mass = doubles(content, group + "/mass");
    if (has_dataset(content, group + "/previous_density")) {
        for (std::size_t k = 0; k < D; ++k) {
            p.previous.motion[k] = doubles(content, group + "/previous_motion_" + axis_names<D>[k]);
        }
        p.previous.density = doubles(content, group + "/previous_density");
    }
    for (const std::int64_t id :
         std::get<std::vector<std::int64_t>>(checkpoint_dataset(content, group + "/id").values)) {
        p.id.push_back(static_cast<std::int32_t>(id));
    }
    SimulationClock clock;
    clock.time = group_number(content, group, "time");
    clock.steps = static_cast<std::int64_t>(group_number(content, group, "steps"));
    clock.list_builds = static_cast<std::int64_t>(group_number(content, group, "list_builds"));
    clock.time_step = group_number(content, group, "time_step");
    clock.largest_acceleration = group_number(content, group, "largest_acceleration");
    clock.displacement_bound = group_number(content, group, "displacement_bound");
    clock.listed_time = group_number(content, group, "listed_time", 0.0);
    if (D == 3) {
        clock.side_wall_drag_coefficient = group_number(content, group, "side_wall_drag_coefficient");
    }
    simulation.restore(std::move(p), clock, doubles(content, group + "/wall_density_deviation"));
}

template <int D>
Particles<D> particles_from_results(const Case& c, const Scheme& scheme, const ResultsReader& results,
                                    const std::string& file_name) {
    if (!results.has("/state/position_x")) {
        throw InputError(
            fmt::format("[start] file = \"{}\" holds no state to start from; give the results file of a run "
                        "of `riffle run`",
                        file_name));
    }
    const Case other = parse_case(results.read_string("/case/text"), file_name);
    const auto differs = [](double a, double b) { return std::abs(a - b) > 1e-9 * std::abs(b); };
    if (other.channel.dimensions != D) {
        throw InputError(fmt::format(
            "[start] file = \"{}\" was run in {} dimensions, this case has {}: start from a run of the same "
            "number, or from the column",
            file_name, other.channel.dimensions, D));
    }
    if (D == 3 && (differs(other.channel.width, c.channel.width) || other.channel.sides != c.channel.sides)) {
        throw InputError(
            fmt::format("[start] file = \"{}\" was run with channel.width {} m and sides = \"{}\", this case "
                        "has {} m and "
                        "\"{}\": start from a run of the same water, or from the column",
                        file_name, other.channel.width, word(other.channel.sides), c.channel.width,
                        word(c.channel.sides)));
    }
    if (differs(other.channel.length, c.channel.length) || differs(other.total_depth(), c.total_depth()) ||
        differs(other.numerics.spacing, c.numerics.spacing)) {
        throw InputError(
            fmt::format("[start] file = \"{}\" was run with channel.length {} m, total depth {} m and "
                        "numerics.spacing {} m, this "
                        "case has {} m, {} m and {} m: start from a run of the same water and spacing, or "
                        "from the column",
                        file_name, other.channel.length, other.total_depth(), other.numerics.spacing,
                        c.channel.length, c.total_depth(), c.numerics.spacing));
    }
    Particles<D> p;
    for (std::size_t k = 0; k < D; ++k) {
        const std::string axis = axis_names<D>[k];
        p.position[k] = results.read_doubles("/state/position_" + axis);
        p.velocity[k] = results.read_doubles("/state/velocity_" + axis);
    }
    p.density_deviation = results.read_doubles("/state/density_deviation");
    p.mass = results.read_doubles("/state/mass");
    for (const double id : results.read_doubles("/state/id")) {
        p.id.push_back(static_cast<std::int32_t>(id));
    }
    const auto sound_speed = results.attribute("/state", "sound_speed");
    const StateEquation old{
        .kind = other.numerics.equation_of_state,
        .sound_speed = sound_speed ? std::get<double>(*sound_speed) : scheme.state.sound_speed};
    for (std::size_t i = 0; i < p.size(); ++i) {
        // Same volume and pressure under the new equation of state.
        const double volume_density = p.mass[i] / (1.0 + p.density_deviation[i]);
        p.density_deviation[i] = scheme.state.deviation(old.pressure(p.density_deviation[i]));
        p.mass[i] = volume_density * (1.0 + p.density_deviation[i]);
    }
    return p;
}

template void add_state(Content&, const std::string&, const SimulationIn<2>&);
template void add_state(Content&, const std::string&, const SimulationIn<3>&);
template void restore_state(const Content&, const std::string&, SimulationIn<2>&);
template void restore_state(const Content&, const std::string&, SimulationIn<3>&);
template Particles<2> particles_from_results(const Case&, const Scheme&, const ResultsReader&,
                                             const std::string&);
template Particles<3> particles_from_results(const Case&, const Scheme&, const ResultsReader&,
                                             const std::string&);

}  // namespace riffle
