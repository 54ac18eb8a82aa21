#include "solver/state_content.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <span>
#include <utility>

#include "base/error.hpp"
#include "case/words.hpp"
#include "record/field_content.hpp"
#include "record/particle_fields.hpp"
#include "record/run_fields.hpp"
#include "solver/recorder.hpp"

namespace riffle {

namespace {

/// Place of an axis of a simulation in D dimensions among x, y, z.
template <int D>
constexpr std::size_t axis_of(std::size_t k) {
    return D == 2 && k == 1 ? 2 : k;
}

/// Values that are read from an array while they are written. It must stay until then.
StreamedValues<double> lent(const std::vector<double>& values) {
    return {.count = values.size(), .fill = [&values](std::size_t first, std::span<double> block) {
                std::copy_n(values.begin() + static_cast<std::ptrdiff_t>(first), block.size(), block.begin());
            }};
}

void add_lent(Content& content, const Field& field, int dimensions, StreamedValues<double> values) {
    const std::size_t n = values.count;
    content.datasets.push_back(dataset_of(field, dimensions, {n}, std::move(values)));
}

/// What the stepper keeps of the step before, where it keeps anything.
template <int D>
void add_previous_step(Content& content, const PreviousStep<D>& previous, Stepping stepping) {
    if (previous.empty()) {
        return;
    }
    const auto& state = fields::state;
    const bool rates = stepping == Stepping::beeman;
    const std::array<Field, 3>& motion = rates ? state.previous_acceleration : state.previous_velocity;
    for (std::size_t k = 0; k < D; ++k) {
        add_lent(content, motion[axis_of<D>(k)], D, lent(previous.motion[k]));
    }
    add_lent(content, rates ? state.previous_density_rate : state.previous_density, D,
             lent(previous.density));
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
    const std::size_t n = p.size();
    const auto& state = fields::state;
    for (std::size_t k = 0; k < D; ++k) {
        const std::size_t axis = axis_of<D>(k);
        add_lent(content, state.position[axis], D, lent(p.position[k]));
        add_lent(content, state.velocity[axis], D, lent(p.velocity[k]));
        if (simulation.lists_out_of_date()) {
            continue;  // the run builds them anew, here as after a resume
        }
        const auto listed = [&simulation, k](std::size_t first, std::span<double> block) {
            simulation.listed_positions(k, first, block);
        };
        add_lent(content, state.listed_position[axis], D, {n, listed});
    }
    add_lent(content, state.density_deviation, D, lent(p.density_deviation));
    add_previous_step(content, p.previous, simulation.stepping());
    add_lent(content, state.mass, D, lent(p.mass));
    add_lent(content, state.wall_density_deviation, D, lent(simulation.wall_density_deviation()));
    const auto numbers = [&p](std::size_t first, std::span<std::int64_t> block) {
        std::copy_n(p.id.begin() + static_cast<std::ptrdiff_t>(first), block.size(), block.begin());
    };
    content.datasets.push_back(dataset_of(state.id, D, {n}, StreamedValues<std::int64_t>{n, numbers}));
    add_clock(content, simulation);
}

template <int D>
void add_clock(Content& content, const SimulationIn<D>& simulation) {
    add_lost_particles(content, simulation.particles().lost, D);
    const SimulationClock& clock = simulation.clock();
    const auto& of = fields::clock;
    add_field(content, of.time, clock.time);
    add_field(content, of.steps, clock.steps);
    add_field(content, of.list_builds, clock.list_builds);
    add_field(content, of.time_step, clock.time_step);
    add_field(content, of.largest_acceleration, clock.largest_acceleration);
    add_field(content, of.displacement_bound, clock.displacement_bound);
    if (clock.listed_time > 0.0) {
        add_field(content, of.listed_time, clock.listed_time);
    }
    if (D == 3) {
        add_field(content, of.side_wall_drag_coefficient, clock.side_wall_drag_coefficient);
    }
    add_field(content, of.sound_speed, simulation.scheme().state.sound_speed);
}

template <int D>
void restore_state(const CheckpointReader& checkpoint, SimulationIn<D>& simulation) {
    const auto& state = fields::state;
    const std::vector<std::size_t> shape = checkpoint.shape(state.id.path());
    const std::size_t n = shape.empty() ? 0 : shape[0];
    const auto doubles = [&](const Field& field) { return checkpoint.doubles(field.path(), n); };
    Particles<D> p;
    for (std::size_t k = 0; k < D; ++k) {
        const std::size_t axis = axis_of<D>(k);
        p.position[k] = doubles(state.position[axis]);
        p.velocity[k] = doubles(state.velocity[axis]);
        if (checkpoint.has(state.listed_position[axis].path())) {
            p.listed_position[k] = doubles(state.listed_position[axis]);
        }
    }
    p.density_deviation = doubles(state.density_deviation);
    p.mass = doubles(state.mass);
    if (checkpoint.has(state.previous_density.path())) {
        for (std::size_t k = 0; k < D; ++k) {
            p.previous.motion[k] = doubles(state.previous_velocity[axis_of<D>(k)]);
        }
        p.previous.density = doubles(state.previous_density);
    }
    const auto numbers = whole_numbers(checkpoint, state.id.path(), n, largest_id);
    p.id.assign(numbers.begin(), numbers.end());
    p.lost = saved_lost_particles(checkpoint);
    const auto number = [&](const Field& field) { return checkpoint.number(field.group->path, field.name); };
    const auto& of = fields::clock;
    SimulationClock clock;
    clock.time = number(of.time);
    clock.steps = static_cast<std::int64_t>(number(of.steps));
    clock.list_builds = static_cast<std::int64_t>(number(of.list_builds));
    clock.time_step = number(of.time_step);
    clock.largest_acceleration = number(of.largest_acceleration);
    clock.displacement_bound = number(of.displacement_bound);
    const bool dated = checkpoint.attribute(of.listed_time.group->path, of.listed_time.name).has_value();
    clock.listed_time = dated ? number(of.listed_time) : 0.0;
    if (D == 3) {
        clock.side_wall_drag_coefficient = number(of.side_wall_drag_coefficient);
    }
    simulation.restore(std::move(p), clock,
                       checkpoint.doubles(state.wall_density_deviation.path(), simulation.walls().size()));
}

template <int D>
Particles<D> particles_from_results(const Case& c, const Scheme& scheme, const ResultsReader& results,
                                    const std::string& file_name) {
    const auto& state = fields::state;
    if (!results.has(state.position[0].path())) {
        throw InputError(
            fmt::format("[start] file = \"{}\" holds no state to start from; give the results file of a run "
                        "of `riffle run`",
                        file_name));
    }
    const Case other = parse_case(results.read_string(fields::stored_case.text.path()), file_name);
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
    const std::vector<std::size_t> shape = results.shape(state.id.path());
    const std::size_t n = shape.empty() ? 0 : shape[0];
    const auto doubles = [&](const Field& field) {
        std::vector<double> values = results.read_doubles(field.path());
        const bool finite =
            std::all_of(values.begin(), values.end(), [](double x) { return std::isfinite(x); });
        if (values.size() != n || !finite) {
            throw InputError(fmt::format(
                "[start] file = \"{}\": {} has {} values{}, expected {} numbers, one for each of its "
                "particles: the file has been altered; give one as `riffle run` wrote it",
                file_name, field.path(), values.size(), finite ? "" : ", not all of them numbers", n));
        }
        return values;
    };
    Particles<D> p;
    for (std::size_t k = 0; k < D; ++k) {
        p.position[k] = doubles(state.position[axis_of<D>(k)]);
        p.velocity[k] = doubles(state.velocity[axis_of<D>(k)]);
    }
    p.density_deviation = doubles(state.density_deviation);
    p.mass = doubles(state.mass);
    const auto numbers = whole_numbers(results, state.id.path(), n, largest_id);
    p.id.assign(numbers.begin(), numbers.end());
    const Field& sound = fields::clock.sound_speed;
    const auto sound_speed = results.attribute(sound.group->path, sound.name);
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

template void add_state(Content&, const SimulationIn<2>&);
template void add_state(Content&, const SimulationIn<3>&);
template void add_clock(Content&, const SimulationIn<2>&);
template void add_clock(Content&, const SimulationIn<3>&);
template void restore_state(const CheckpointReader&, SimulationIn<2>&);
template void restore_state(const CheckpointReader&, SimulationIn<3>&);
template Particles<2> particles_from_results(const Case&, const Scheme&, const ResultsReader&,
                                             const std::string&);
template Particles<3> particles_from_results(const Case&, const Scheme&, const ResultsReader&,
                                             const std::string&);

}  // namespace riffle
