#include "solver/state_content.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <span>
#include <type_traits>
#include <utility>

#include "base/error.hpp"
#include "case/words.hpp"
#include "solver/content.hpp"
#include "solver/recorder.hpp"

namespace riffle {

namespace {

constexpr const char* lost_group = "/lost_particles";

/// A dataset of values that are read from an array while they are written. The array must stay until then.
template <class T>
Dataset lent(const std::string& group, const FieldInfo& info, const std::vector<T>& values) {
    using Saved = std::conditional_t<std::is_same_v<T, double>, double, std::int64_t>;
    const auto fill = [&values](std::size_t first, std::span<Saved> block) {
        std::copy_n(values.begin() + static_cast<std::ptrdiff_t>(first), block.size(), block.begin());
    };
    return {.path = group + "/" + info.name,
            .shape = {values.size()},
            .values = StreamedValues<Saved>{values.size(), fill},
            .unit = info.unit,
            .long_name = info.long_name};
}

void add_lost_particles(Content& content, const std::vector<LostParticle>& lost, int dimensions) {
    const auto column = [&](const char* name, const char* unit, const char* long_name, const auto& value) {
        std::vector<double> values(lost.size());
        std::transform(lost.begin(), lost.end(), values.begin(), value);
        add_array(content, fmt::format("{}/{}", lost_group, name), std::move(values), unit, long_name);
    };
    const auto whole = [&](const char* name, const char* long_name, const auto& value) {
        std::vector<std::int64_t> values(lost.size());
        std::transform(lost.begin(), lost.end(), values.begin(), value);
        content.datasets.push_back({.path = fmt::format("{}/{}", lost_group, name),
                                    .shape = {lost.size()},
                                    .values = std::move(values),
                                    .unit = "1",
                                    .long_name = long_name});
    };
    whole("id", "number of the particle", [](const auto& p) { return std::int64_t{p.id}; });
    whole("exit", "way out", [](const auto& p) { return static_cast<std::int64_t>(p.exit); });
    column("time", "s", "simulated time at which it was taken out", [](const auto& p) { return p.time; });
    column("mass", dimensions == 2 ? "kg/m" : "kg", dimensions == 2 ? "mass per unit width" : "mass",
           [](const auto& p) { return p.mass; });
    for (std::size_t k = 0; k < 3; ++k) {
        const char axis = "xyz"[k];
        column(fmt::format("position_{}", axis).c_str(), "m", "place where it was taken out",
               [k](const auto& p) { return p.position[k]; });
        column(fmt::format("velocity_{}", axis).c_str(), "m/s", "velocity with which it left",
               [k](const auto& p) { return p.velocity[k]; });
    }
}

/// So many whole numbers from 0 to `most`. Throws FileError.
std::vector<std::int64_t> whole_numbers(const ContentReader& file, const std::string& path, std::size_t count,
                                        std::int64_t most) {
    const Dataset dataset = file.read(path);
    const auto* const saved = std::get_if<std::vector<std::int64_t>>(&dataset.values);
    const bool whole =
        saved != nullptr && saved->size() == count &&
        std::all_of(saved->begin(), saved->end(), [most](std::int64_t i) { return i >= 0 && i <= most; });
    if (!whole) {
        throw FileError(fmt::format("{}: {} does not hold {} numbers from 0 to {}: the file has been altered",
                                    file.path().string(), path, count, most));
    }
    return *saved;
}

constexpr std::int64_t largest_id = std::numeric_limits<std::int32_t>::max();

std::vector<LostParticle> saved_lost_particles(const CheckpointReader& checkpoint) {
    const auto path = [](const std::string& name) { return fmt::format("{}/{}", lost_group, name); };
    const std::vector<std::size_t> shape = checkpoint.shape(path("id"));
    const std::size_t n = shape.empty() ? 0 : shape[0];
    const auto column = [&](const std::string& name) { return checkpoint.doubles(path(name), n); };
    const auto id = whole_numbers(checkpoint, path("id"), n, largest_id);
    const auto exit = whole_numbers(checkpoint, path("exit"), n, last_exit);
    const auto time = column("time");
    const auto mass = column("mass");
    std::vector<LostParticle> lost(n);
    for (std::size_t i = 0; i < n; ++i) {
        lost[i].id = static_cast<std::int32_t>(id[i]);
        lost[i].exit = static_cast<Exit>(exit[i]);
        lost[i].time = time[i];
        lost[i].mass = mass[i];
    }
    for (std::size_t k = 0; k < 3; ++k) {
        const auto position = column(fmt::format("position_{}", "xyz"[k]));
        const auto velocity = column(fmt::format("velocity_{}", "xyz"[k]));
        for (std::size_t i = 0; i < n; ++i) {
            lost[i].position[k] = position[i];
            lost[i].velocity[k] = velocity[i];
        }
    }
    return lost;
}

}  // namespace

template <int D>
void add_state(Content& content, const std::string& group, const SimulationIn<D>& simulation) {
    const Particles<D>& p = simulation.particles();
    p.for_each_field([&](const FieldInfo& info, const auto& values) {
        if (!values.empty()) {
            content.datasets.push_back(lent(group, info, values));
        }
    });
    // What is out of date the run builds anew, here as after a resume.
    for (std::size_t k = 0; k < D && !simulation.lists_out_of_date(); ++k) {
        const auto listed = [&simulation, k](std::size_t first, std::span<double> block) {
            simulation.listed_positions(k, first, block);
        };
        const std::string axis = axis_names<D>[k];
        content.datasets.push_back(
            {.path = group + "/listed_position_" + axis,
             .shape = {p.size()},
             .values = StreamedValues<double>{p.size(), listed},
             .unit = "m",
             .long_name = "position at the last build of the neighbour lists, " + axis});
    }
    content.datasets.push_back(lent(group,
                                    {"wall_density_deviation", "1", "rho/rho0 - 1 of the wall particles"},
                                    simulation.wall_density_deviation()));
    add_clock(content, group, simulation);
}

template <int D>
void add_clock(Content& content, const std::string& group, const SimulationIn<D>& simulation) {
    add_lost_particles(content, simulation.particles().lost, D);
    const SimulationClock& clock = simulation.clock();
    const auto attribute = [&](const char* name, AttributeValue value) {
        add_attribute(content, group, name, std::move(value));
    };
    attribute("time", clock.time);
    attribute("steps", clock.steps);
    attribute("particles_created", std::int64_t{simulation.particles().created});
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
void restore_state(const CheckpointReader& checkpoint, const std::string& group,
                   SimulationIn<D>& simulation) {
    const std::vector<std::size_t> shape = checkpoint.shape(group + "/id");
    const std::size_t n = shape.empty() ? 0 : shape[0];
    const auto path = [&group](const std::string& name) { return group + "/" + name; };
    Particles<D> p;
    for (const FurtherField& field : simulation.particles().further) {
        // Before the first step they have no values, in the file neither.
        const std::size_t place = p.add_field(field.info);
        if (checkpoint.has(path(field.info.name))) {
            p.further[place].values.resize(n);
        }
    }
    p.resize(n);
    p.for_each_field([&](const FieldInfo& info, auto& values) {
        if constexpr (std::is_same_v<decltype(values), std::vector<double>&>) {
            if (values.size() == n) {
                values = checkpoint.doubles(path(info.name), n);
            }
        } else {
            const auto numbers = whole_numbers(checkpoint, path(info.name), n, largest_id);
            values.assign(numbers.begin(), numbers.end());
        }
    });
    for (std::size_t k = 0; k < D; ++k) {
        const std::string name = path(std::string("listed_position_") + axis_names<D>[k]);
        if (checkpoint.has(name)) {
            p.listed_position[k] = checkpoint.doubles(name, n);
        }
    }
    p.lost = saved_lost_particles(checkpoint);
    const auto number = [&](const char* name) { return checkpoint.number(group, name); };
    SimulationClock clock;
    clock.time = number("time");
    clock.steps = static_cast<std::int64_t>(number("steps"));
    // A checkpoint of before they were counted: the flow counts from the largest number on.
    p.created = checkpoint.attribute(group, "particles_created")
                    ? static_cast<std::int32_t>(number("particles_created"))
                    : 0;
    clock.list_builds = static_cast<std::int64_t>(number("list_builds"));
    clock.time_step = number("time_step");
    clock.largest_acceleration = number("largest_acceleration");
    clock.displacement_bound = number("displacement_bound");
    clock.listed_time = checkpoint.attribute(group, "listed_time") ? number("listed_time") : 0.0;
    if (D == 3) {
        clock.side_wall_drag_coefficient = number("side_wall_drag_coefficient");
    }
    simulation.restore(std::move(p), clock,
                       checkpoint.doubles(group + "/wall_density_deviation", simulation.walls().size()));
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
            fmt::format("[start] file = \"{}\" was run with channel.width {} m and sides = \"{}\", this "
                        "case has {} m and \"{}\": start from a run of the same water, or from the column",
                        file_name, other.channel.width, word(other.channel.sides), c.channel.width,
                        word(c.channel.sides)));
    }
    if (differs(other.channel.length, c.channel.length) || differs(other.total_depth(), c.total_depth()) ||
        differs(other.numerics.spacing, c.numerics.spacing)) {
        throw InputError(
            fmt::format("[start] file = \"{}\" was run with channel.length {} m, total depth {} m and "
                        "numerics.spacing {} m, this case has {} m, {} m and {} m: start from a run of the "
                        "same water and spacing, or from the column",
                        file_name, other.channel.length, other.total_depth(), other.numerics.spacing,
                        c.channel.length, c.total_depth(), c.numerics.spacing));
    }
    const std::vector<std::size_t> shape = results.shape("/state/id");
    const std::size_t n = shape.empty() ? 0 : shape[0];
    const auto doubles = [&](const std::string& name) {
        std::vector<double> values = results.read_doubles("/state/" + name);
        const bool finite =
            std::all_of(values.begin(), values.end(), [](double x) { return std::isfinite(x); });
        if (values.size() != n || !finite) {
            throw InputError(fmt::format(
                "[start] file = \"{}\": /state/{} has {} values{}, expected {} numbers, one for each of its "
                "particles: the file has been altered; give one as `riffle run` wrote it",
                file_name, name, values.size(), finite ? "" : ", not all of them numbers", n));
        }
        return values;
    };
    Particles<D> p;
    p.for_each_field([&](const FieldInfo& info, auto& values) {
        if constexpr (std::is_same_v<decltype(values), std::vector<double>&>) {
            values = doubles(info.name);
        } else {
            const auto numbers = whole_numbers(results, "/state/" + info.name, n, largest_id);
            values.assign(numbers.begin(), numbers.end());
        }
    });
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
template void add_clock(Content&, const std::string&, const SimulationIn<2>&);
template void add_clock(Content&, const std::string&, const SimulationIn<3>&);
template void restore_state(const CheckpointReader&, const std::string&, SimulationIn<2>&);
template void restore_state(const CheckpointReader&, const std::string&, SimulationIn<3>&);
template Particles<2> particles_from_results(const Case&, const Scheme&, const ResultsReader&,
                                             const std::string&);
template Particles<3> particles_from_results(const Case&, const Scheme&, const ResultsReader&,
                                             const std::string&);

}  // namespace riffle
