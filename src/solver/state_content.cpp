#include "solver/state_content.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <span>
#include <stdexcept>
#include <type_traits>
#include <utility>

#include "base/error.hpp"
#include "base/notice.hpp"
#include "case/words.hpp"
#include "record/field_content.hpp"
#include "record/particle_fields.hpp"
#include "record/run_fields.hpp"
#include "solver/bodies_of_results.hpp"
#include "solver/recorder.hpp"
#include "solver/recycled_start.hpp"
#include "solver/start.hpp"
#include "solver/start_perturbation.hpp"

namespace riffle::inline solver {

namespace {

/// Place of an axis of a simulation in D dimensions among x, y, z.
template <int D>
constexpr std::size_t axis_of(std::size_t k) {
    return D == 2 && k == 1 ? 2 : k;
}

/// Where a field of the particles stands in the state: their table names the same fields as fields::state.
std::string state_path(const std::string& name) {
    return fmt::format("{}/{}", fields::state.id.group->path, name);
}

/// A dataset of values that are read from an array while they are written. The array must stay until then.
template <class T>
Dataset lent(const FieldInfo& info, const std::vector<T>& values) {
    using Saved = std::conditional_t<std::is_same_v<T, double>, double, std::int64_t>;
    const auto fill = [&values](std::size_t first, std::span<Saved> block) {
        std::copy_n(values.begin() + static_cast<std::ptrdiff_t>(first), block.size(), block.begin());
    };
    return {.path = state_path(info.name),
            .shape = {values.size()},
            .values = StreamedValues<Saved>{values.size(), fill},
            .unit = info.unit,
            .long_name = info.long_name};
}

void add_lost_particles(Content& content, const std::vector<LostParticle>& lost, int dimensions) {
    const auto column = [&]<class T>(const Field& field, T /*zero*/, const auto& value) {
        std::vector<T> values(lost.size());
        std::transform(lost.begin(), lost.end(), values.begin(), value);
        content.datasets.push_back(dataset_of(field, dimensions, {lost.size()}, std::move(values)));
    };
    const auto& of = fields::lost_particles;
    column(of.id, std::int64_t{}, [](const auto& p) { return std::int64_t{p.id}; });
    column(of.exit, std::int64_t{}, [](const auto& p) { return static_cast<std::int64_t>(p.exit); });
    column(of.time, 0.0, [](const auto& p) { return p.time; });
    column(of.mass, 0.0, [](const auto& p) { return p.mass; });
    for (std::size_t k = 0; k < 3; ++k) {
        column(of.position[k], 0.0, [k](const auto& p) { return p.position[k]; });
        column(of.velocity[k], 0.0, [k](const auto& p) { return p.velocity[k]; });
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

/// The free bodies now and when the lists were built, then their springs.
std::vector<double> free_body_numbers(const SimulationClock& clock) {
    std::vector<double> numbers;
    for (const auto* const states : {&clock.free_bodies, &clock.listed_free_bodies}) {
        for (const FreeBodyState& state : *states) {
            const auto own = state.numbers();
            numbers.insert(numbers.end(), own.begin(), own.end());
        }
    }
    for (const Point3& spring : clock.contact_springs) {
        numbers.insert(numbers.end(), spring.begin(), spring.end());
    }
    return numbers;
}

/// The other way; as many numbers as free_body_numbers() gives.
void put_free_body_numbers(const std::vector<double>& numbers, SimulationClock& clock) {
    const std::size_t bodies = clock.free_bodies.size();
    const std::size_t length = bodies * FreeBodyState::count;
    clock.free_bodies = free_body_states(numbers, bodies);
    clock.listed_free_bodies = free_body_states(std::span(numbers).subspan(length), bodies);
    auto place = numbers.begin() + static_cast<std::ptrdiff_t>(2 * length);
    for (Point3& spring : clock.contact_springs) {
        std::copy_n(place, 3, spring.begin());
        place += 3;
    }
}

constexpr std::int64_t largest_id = std::numeric_limits<std::int32_t>::max();

std::vector<LostParticle> saved_lost_particles(const CheckpointReader& checkpoint) {
    const auto& of = fields::lost_particles;
    const std::vector<std::size_t> shape = checkpoint.shape(of.id.path());
    const std::size_t n = shape.empty() ? 0 : shape[0];
    const auto column = [&](const Field& field) { return checkpoint.doubles(field.path(), n); };
    const auto id = whole_numbers(checkpoint, of.id.path(), n, largest_id);
    const auto exit = whole_numbers(checkpoint, of.exit.path(), n, last_exit);
    const auto time = column(of.time);
    const auto mass = column(of.mass);
    std::vector<LostParticle> lost(n);
    for (std::size_t i = 0; i < n; ++i) {
        lost[i].id = static_cast<std::int32_t>(id[i]);
        lost[i].exit = static_cast<Exit>(exit[i]);
        lost[i].time = time[i];
        lost[i].mass = mass[i];
    }
    for (std::size_t k = 0; k < 3; ++k) {
        const auto position = column(of.position[k]);
        const auto velocity = column(of.velocity[k]);
        for (std::size_t i = 0; i < n; ++i) {
            lost[i].position[k] = position[i];
            lost[i].velocity[k] = velocity[i];
        }
    }
    return lost;
}

}  // namespace

template <int D>
void add_state(Content& content, const SimulationIn<D>& simulation) {
    const Particles<D>& p = simulation.particles();
    p.for_each_field([&](const FieldInfo& info, const auto& values) {
        if (!values.empty()) content.datasets.push_back(lent(info, values));
    });
    // What is out of date the run builds anew, here as after a resume.
    for (std::size_t k = 0; k < D && !simulation.lists_out_of_date(); ++k) {
        const auto listed = [&simulation, k](std::size_t first, std::span<double> block) {
            simulation.listed_positions(k, first, block);
        };
        content.datasets.push_back(dataset_of(fields::state.listed_position[axis_of<D>(k)], D, {p.size()},
                                              StreamedValues<double>{p.size(), listed}));
    }
    const Field& wall = fields::state.wall_density_deviation;
    content.datasets.push_back(
        lent({wall.name, wall.unit.in(D), wall.meaning.in(D)}, simulation.wall_density_deviation()));
    add_clock(content, simulation);
}

template <int D>
void add_clock(Content& content, const SimulationIn<D>& simulation) {
    add_lost_particles(content, simulation.particles().lost, D);
    const SimulationClock& clock = simulation.clock();
    const auto& of = fields::clock;
    add_field(content, of.time, clock.time);
    add_field(content, of.steps, clock.steps);
    add_field(content, of.particles_created, std::int64_t{simulation.particles().created});
    add_field(content, of.list_builds, clock.list_builds);
    add_field(content, of.time_step, clock.time_step);
    add_field(content, of.largest_acceleration, clock.largest_acceleration);
    add_field(content, of.displacement_bound, clock.displacement_bound);
    if (clock.open_ends.begun) {
        add_field(content, fields::state.open_ends, D, clock.open_ends.numbers());
        add_field(content, fields::state.sound_at_ends, D, clock.open_ends.sound_numbers());
    }
    if (!clock.free_bodies.empty()) {
        add_field(content, fields::state.free_bodies, D, free_body_numbers(clock));
    }
    if (clock.listed_time > 0.0) add_field(content, of.listed_time, clock.listed_time);
    if (D == 3) add_field(content, of.side_wall_drag_coefficient, clock.side_wall_drag_coefficient);
    add_field(content, of.sound_speed, simulation.scheme().state.sound_speed);
}

template <int D>
void restore_state(const CheckpointReader& checkpoint, SimulationIn<D>& simulation) {
    const auto& state = fields::state;
    const std::vector<std::size_t> shape = checkpoint.shape(state.id.path());
    const std::size_t n = shape.empty() ? 0 : shape[0];
    Particles<D> p;
    for (const FurtherField& field : simulation.particles().further) {
        // Before the first step they have no values, in the file neither.
        const std::size_t place = p.add_field(field.info);
        if (checkpoint.has(state_path(field.info.name))) p.further[place].values.resize(n);
    }
    p.resize(n);
    p.for_each_field([&](const FieldInfo& info, auto& values) {
        if constexpr (std::is_same_v<decltype(values), std::vector<double>&>) {
            if (values.size() == n) values = checkpoint.doubles(state_path(info.name), n);
        } else {
            const auto numbers = whole_numbers(checkpoint, state_path(info.name), n, largest_id);
            values.assign(numbers.begin(), numbers.end());
        }
    });
    for (std::size_t k = 0; k < D; ++k) {
        const std::string name = state.listed_position[axis_of<D>(k)].path();
        if (checkpoint.has(name)) p.listed_position[k] = checkpoint.doubles(name, n);
    }
    p.lost = saved_lost_particles(checkpoint);
    const auto number = [&](const Field& field) { return checkpoint.number(field.group->path, field.name); };
    const auto& of = fields::clock;
    SimulationClock clock;
    const auto present = [&](const Field& field) {
        return checkpoint.attribute(field.group->path, field.name).has_value();
    };
    clock.time = number(of.time);
    clock.steps = static_cast<std::int64_t>(number(of.steps));
    // A checkpoint of before they were counted: the flow counts from the largest number on.
    p.created = present(of.particles_created) ? static_cast<std::int32_t>(number(of.particles_created)) : 0;
    clock.list_builds = static_cast<std::int64_t>(number(of.list_builds));
    clock.time_step = number(of.time_step);
    clock.largest_acceleration = number(of.largest_acceleration);
    clock.displacement_bound = number(of.displacement_bound);
    if (simulation.clock().open_ends.begun) {
        try {
            clock.open_ends = OpenEndsState::from(checkpoint.read_doubles(state.open_ends.path()));
            // A checkpoint of before it was followed has no sound.
            if (checkpoint.has(state.sound_at_ends.path())) {
                clock.open_ends.take_sound(checkpoint.read_doubles(state.sound_at_ends.path()));
            }
        } catch (const std::invalid_argument& wrong) {
            throw FileError(fmt::format("the checkpoint's {}: {}", state.open_ends.path(), wrong.what()));
        }
    }
    clock.free_bodies = simulation.clock().free_bodies;
    clock.listed_free_bodies = clock.free_bodies;
    clock.contact_springs = simulation.clock().contact_springs;
    if (!clock.free_bodies.empty()) {
        const std::size_t numbers = free_body_numbers(clock).size();
        put_free_body_numbers(checkpoint.doubles(state.free_bodies.path(), numbers), clock);
    }
    clock.listed_time = present(of.listed_time) ? number(of.listed_time) : 0.0;
    if (D == 3) clock.side_wall_drag_coefficient = number(of.side_wall_drag_coefficient);
    simulation.restore(std::move(p), clock,
                       checkpoint.doubles(state.wall_density_deviation.path(), simulation.walls().size()));
}

namespace {

/// The particles of the last state in the results of another case.
template <int D>
Particles<D> particles_from_results(const Case& c, const Case& other, const Scheme& scheme,
                                    const ResultsReader& results, const std::string& file_name) {
    const auto& state = fields::state;
    if (other.channel.dimensions != D) {
        throw InputError(fmt::format(
            "[start] file = \"{}\" was run in {} dimensions, this case has {}: start from a run of the same "
            "number, or from the column",
            file_name, other.channel.dimensions, D));
    }
    if (D == 3 && other.channel.sides != c.channel.sides) {
        throw InputError(fmt::format(
            "[start] file = \"{}\" was run with sides = \"{}\", this case has \"{}\": start from a run of the "
            "same sides, or from the column",
            file_name, word(other.channel.sides), word(c.channel.sides)));
    }
    if (const std::string why = why_not_recycled(c, other); !why.empty()) {
        throw InputError(fmt::format(
            "[start] file = \"{}\": {}; start from a run of such water, of any spacing, or from the column",
            file_name, why));
    }
    if (other.porous != c.porous) {
        throw InputError(fmt::format(
            "[start] file = \"{}\" was run with other [[porous]] zones: its particles fill other pores; start from "
            "a run of the same zones, or from the column",
            file_name));
    }
    const std::vector<std::size_t> shape = results.shape(state.id.path());
    const std::size_t n = shape.empty() ? 0 : shape[0];
    const auto doubles = [&](const std::string& path) {
        std::vector<double> values = results.read_doubles(path);
        const bool finite =
            std::all_of(values.begin(), values.end(), [](double x) { return std::isfinite(x); });
        if (values.size() != n || !finite) {
            throw InputError(fmt::format(
                "[start] file = \"{}\": {} has {} values{}, expected {} numbers, one for each of its "
                "particles: the file has been altered; give one as `riffle run` wrote it",
                file_name, path, values.size(), finite ? "" : ", not all of them numbers", n));
        }
        return values;
    };
    Particles<D> p;
    p.for_each_field([&](const FieldInfo& info, auto& values) {
        if constexpr (std::is_same_v<decltype(values), std::vector<double>&>) {
            values = doubles(state_path(info.name));
        } else {
            const auto numbers = whole_numbers(results, state_path(info.name), n, largest_id);
            values.assign(numbers.begin(), numbers.end());
        }
    });
    if (is_recycled(c, other)) return recycled_particles(c, scheme, other, p);
    if (c.start.jitter > 0.0) {
        notice(fmt::format(
            "warning: start.jitter has no effect: the particles go on where those of {} were, at the "
            "same spacing",
            file_name));
    }
    if (c.channel.ends == Ends::open) stand_between_open_ends(c, other, p);
    const Field& sound = fields::clock.sound_speed;
    const auto sound_speed = results.attribute(sound.group->path, sound.name);
    const StateEquation old{
        .kind = other.numerics.equation_of_state,
        .sound_speed = sound_speed ? std::get<double>(*sound_speed) : scheme.state.sound_speed};
    const double denser = c.fluid.density / other.fluid.density;
    for (std::size_t i = 0; i < p.size(); ++i) {
        // Same volume and pressure (over the density) under the new equation of state and density.
        const double volume_density = denser * p.mass[i] / (1.0 + p.density_deviation[i]);
        p.density_deviation[i] = scheme.state.deviation(old.pressure(p.density_deviation[i]));
        p.mass[i] = volume_density * (1.0 + p.density_deviation[i]);
    }
    return p;
}

}  // namespace

template <int D>
std::unique_ptr<SimulationIn<D>> simulation_from_results(const Case& c, const ColumnResult* column,
                                                         const Scheme& scheme) {
    const ResultsReader results(c.start.file);
    const std::string file_name = c.start.file.string();
    if (!results.has(fields::state.position[0].path())) {
        throw InputError(
            fmt::format("[start] file = \"{}\" holds no state to start from; give the results file of a run "
                        "of `riffle run`",
                        file_name));
    }
    const Case other = parse_case(results.read_string(fields::stored_case.text.path()), file_name);
    Particles<D> particles = particles_from_results<D>(c, other, scheme, results, file_name);
    perturb_velocity(c, particles);
    const std::vector<FreeBodyState> bodies = bodies_from_results(c, other, results, file_name);
    refuse_water_in_new_solids(c, other, particles, file_name);
    auto simulation = make_simulation<D>(c, column, std::move(particles));
    if (bodies.empty()) return simulation;
    // The bodies stand where they were; the water keeps what the components have found of it.
    SimulationClock clock = simulation->clock();
    clock.free_bodies = clock.listed_free_bodies = bodies;
    simulation->restore(Particles<D>(simulation->particles()), clock,
                        std::vector<double>(simulation->walls().size()));
    return simulation;
}

template std::unique_ptr<SimulationIn<2>> simulation_from_results(const Case&, const ColumnResult*,
                                                                  const Scheme&);
template std::unique_ptr<SimulationIn<3>> simulation_from_results(const Case&, const ColumnResult*,
                                                                  const Scheme&);
template void add_state(Content&, const SimulationIn<2>&);
template void add_state(Content&, const SimulationIn<3>&);
template void add_clock(Content&, const SimulationIn<2>&);
template void add_clock(Content&, const SimulationIn<3>&);
template void restore_state(const CheckpointReader&, SimulationIn<2>&);
template void restore_state(const CheckpointReader&, SimulationIn<3>&);

}  // namespace riffle::inline solver
