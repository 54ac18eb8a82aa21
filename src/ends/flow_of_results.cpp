#include "ends/flow_of_results.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <filesystem>
#include <mutex>
#include <numeric>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "base/error.hpp"
#include "base/multiple.hpp"
#include "base/not_a_number.hpp"
#include "base/parallel.hpp"
#include "case/end_floor.hpp"
#include "case/word.hpp"
#include "case/words.hpp"
#include "instruments/fluid_view.hpp"
#include "particles/lattice.hpp"
#include "record/particle_fields.hpp"
#include "record/run_results.hpp"
#include "record/whole_snapshots.hpp"

namespace riffle::inline ends {

namespace {

[[noreturn]] void refuse(const Case& c, const std::string& why) {
    throw InputError(fmt::format("[inflow] results = \"{}\": {}", c.inflow.results.string(), why));
}

void require_fitting(const Case& c, const Case& other) {
    if (other.channel.dimensions != c.channel.dimensions) {
        refuse(c, fmt::format("it was run in {} dimensions, this case has {}; give a run of the same number",
                              other.channel.dimensions, c.channel.dimensions));
    }
    if (other.channel.ends != Ends::periodic) {
        refuse(c, fmt::format(
                      "it has ends = \"{}\", expected \"periodic\" ones: only such a flow is the same all "
                      "along a channel",
                      word(other.channel.ends)));
    }
    if (other.channel.top != c.channel.top) {
        refuse(c, fmt::format(R"(it was run with top = "{}", this case has "{}"; give a run of the same top)",
                              word(other.channel.top), word(c.channel.top)));
    }
    const double depth = c.total_depth() - end_floors(c).upstream;
    constexpr double close = 0.01;
    if (std::abs(other.total_depth() - depth) > close * depth) {
        refuse(c,
               fmt::format(
                   "the water there is {:.6g} m deep in all and here {:.6g} m, expected the same depth: its "
                   "eddies are as large as that",
                   other.total_depth(), depth));
    }
    if (c.channel.dimensions == 2) return;
    if (other.channel.sides != c.channel.sides) {
        refuse(c, fmt::format(
                      R"(it was run with sides = "{}", this case has "{}"; give a run of the same sides)",
                      word(other.channel.sides), word(c.channel.sides)));
    }
    const bool across = c.channel.sides == Sides::periodic;
    constexpr double rounded = 1e-6;
    const bool same = std::abs(other.channel.width - c.channel.width) < rounded * c.channel.width;
    if (!same && !(across && is_multiple(c.channel.width, other.channel.width, rounded))) {
        refuse(c, fmt::format("channel.width is {:.10g} m there and {:.10g} m here, expected the same{}",
                              other.channel.width, c.channel.width, across ? ", or several times that" : ""));
    }
}

/// The snapshots that enter.
std::vector<SnapshotPlace> snapshots_from(const Case& c, const RunResults& results, const Case& other) {
    if (!snapshots_are_whole(other)) {
        refuse(c,
               "its snapshots hold a part of the water (output.snapshot_x, snapshot_y or snapshot_z); give a "
               "run whose snapshots hold all of it");
    }
    const double from = c.inflow.results_from.value_or(other.run.average_from.value_or(0.0));
    std::vector<SnapshotPlace> found;
    for (SnapshotPlace& snapshot : snapshots_with_velocities(results)) {
        if (snapshot.time >= from && (found.empty() || snapshot.time > found.back().time)) {
            found.push_back(std::move(snapshot));
        }
    }
    if (found.empty()) {
        refuse(c, fmt::format(
                      "it has no snapshots with velocities from {:g} s on; give inflow.results_from, or a "
                      "run with output.snapshot_interval and \"velocity\" in output.snapshot_fields",
                      from));
    }
    return found;
}

/// Velocities of a snapshot in the middle of the cells of a grid; not a number where there is no water.
template <int D>
std::vector<float> on_cells(const Case& other, const std::vector<double>& position,
                            const std::vector<double>& velocity, const RecordedWater& water) {
    const std::size_t n = position.size() / 3;
    const Lattice lattice = lattice_of(other);
    Particles<D> particles;
    particles.append(n);
    for (std::size_t i = 0; i < n; ++i) {
        for (std::size_t k = 0; k < D; ++k) {
            const std::size_t axis = k == D - 1 ? 2 : k;
            particles.position[k][i] = position[3 * i + axis];
            particles.velocity[k][i] = velocity[3 * i + axis];
        }
        particles.mass[i] = other.fluid.density * lattice.volume();
        particles.density_deviation[i] = 0.0;
    }
    const double h = other.numerics.smoothing_ratio * other.numerics.spacing;
    const FluidViewIn<D> view(other, particles, h);
    const std::size_t nx = water.cells[0];
    const std::size_t ny = water.cells[1];
    const std::size_t nz = water.cells[2];
    std::vector<float> values(3 * nx * ny * nz);
    constexpr std::size_t block = 256;
    parallel_blocks(nx * ny * nz, block, [&](std::size_t begin, std::size_t end) {
        for (std::size_t cell = begin; cell < end; ++cell) {
            const auto middle = [](std::size_t index, double extent, std::size_t cells) {
                return extent * (static_cast<double>(index) + 0.5) / static_cast<double>(cells);
            };
            const auto found =
                velocity_below(view,
                               {middle(cell % nx, water.length, nx), middle(cell / nx % ny, water.width, ny),
                                middle(cell / (nx * ny), other.total_depth(), nz)},
                               h);
            const auto u = found.value_or(FluidView::Velocity{not_a_number, not_a_number, not_a_number});
            values[3 * cell] = static_cast<float>(u.u);
            values[3 * cell + 1] = static_cast<float>(u.v);
            values[3 * cell + 2] = static_cast<float>(u.w);
        }
    });
    return values;
}

/// What enters is scaled to the discharge at each moment, so at none may the water stand or flow back.
void require_flowing(const Case& c, const RecordedWater& water) {
    std::vector<double> means;
    for (const std::vector<float>& moment : water.velocity) {
        double sum = 0.0;
        for (std::size_t i = 0; i < moment.size(); i += 3) sum += static_cast<double>(moment[i]);
        means.push_back(sum / (static_cast<double>(moment.size()) / 3.0));
    }
    const double mean = std::accumulate(means.begin(), means.end(), 0.0) / static_cast<double>(means.size());
    constexpr double least = 0.5;
    for (std::size_t i = 0; i < means.size(); ++i) {
        if (!(means[i] > 0.0) || means[i] < least * mean) {
            refuse(c, fmt::format(
                          "the mean velocity of its water is {:.4g} m/s at {:g} s and {:.4g} m/s over all "
                          "snapshots, expected above 0 and at least half of that; give an "
                          "inflow.results_from from which on it flows steadily",
                          means[i], water.time[i], mean));
        }
    }
}

/// The water of another run, and its case.
struct Recording {
    std::shared_ptr<const RecordedFlow> flow;
    std::optional<Case> of;
};

Recording read(const Case& c) {
    const RunResults results(c.inflow.results);
    const Case& other = results.flow();
    require_fitting(c, other);
    RecordedWater water;
    water.length = other.channel.length;
    const bool space = other.channel.dimensions == 3;
    water.width = space ? other.channel.simulated_width() : 0.0;
    water.repeats_across = !space || other.channel.sides == Sides::periodic;
    const auto cells = [&other](double extent) {
        return std::max<std::size_t>(1,
                                     static_cast<std::size_t>(std::lround(extent / other.numerics.spacing)));
    };
    water.cells = {cells(water.length), space ? cells(water.width) : 1, cells(other.total_depth())};
    const auto& of = fields::snapshot;
    for (const auto& [time, group] : snapshots_from(c, results, other)) {
        const std::vector<double> position = results.values({group, of.position});
        const std::vector<double> velocity = results.values({group, of.velocity});
        const auto is_number = [](double value) { return std::isfinite(value); };
        if (position.empty() || position.size() != velocity.size() ||
            !std::all_of(position.begin(), position.end(), is_number) ||
            !std::all_of(velocity.begin(), velocity.end(), is_number)) {
            throw FileError(fmt::format(
                "{} of {}: positions and velocities do not fit each other, or are not all numbers; "
                "the file has been altered: give one as `riffle run` wrote it",
                group, c.inflow.results.string()));
        }
        water.time.push_back(time);
        water.velocity.push_back(space ? on_cells<3>(other, position, velocity, water)
                                       : on_cells<2>(other, position, velocity, water));
        if (!std::all_of(water.velocity.back().begin(), water.velocity.back().end(), is_number)) {
            refuse(c,
                   fmt::format(
                       "at {:g} s there is no water at places within its depth; give an inflow.results_from "
                       "from which on the water fills it",
                       time));
        }
    }
    require_flowing(c, water);
    return {std::make_shared<const RecordedFlow>(std::move(water)), other};
}

}  // namespace

std::shared_ptr<const RecordedFlow> recorded_flow(const Case& c) {
    // A run asks for it some times before its first step, and reading takes seconds.
    struct Key {
        std::filesystem::path path;
        std::filesystem::file_time_type changed;
        std::string fitting;
        bool operator==(const Key&) const = default;
    };
    static std::mutex mutex;
    static Key key;
    static Recording kept;
    const std::scoped_lock lock(mutex);
    std::error_code none;
    Key asked{std::filesystem::absolute(c.inflow.results, none),
              std::filesystem::last_write_time(c.inflow.results, none),
              fmt::format("{} {} {:.17g} {:.17g}", c.channel.dimensions, word(c.channel.sides),
                          c.channel.width, c.inflow.results_from.value_or(-1.0))};
    if (!kept.flow || asked != key) {
        kept = read(c);
        key = std::move(asked);
    }
    require_fitting(c, *kept.of);
    return kept.flow;
}

}  // namespace riffle::inline ends
