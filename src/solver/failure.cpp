#include "solver/failure.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <numeric>
#include <utility>

#include "output/results_file.hpp"
#include "output/xdmf.hpp"
#include "particles/lattice.hpp"
#include "record/field_content.hpp"
#include "record/particle_fields.hpp"
#include "record/run_fields.hpp"
#include "solver/content.hpp"

namespace riffle::inline solver {

namespace {

/// Rows of the table in the log.
constexpr std::size_t table_rows = 12;

template <int D>
bool is_finite(const Vec<D>& v) {
    return std::all_of(v.begin(), v.end(), [](double x) { return std::isfinite(x); });
}

/// Where a particle is, or was when the lists were built where it is nowhere now.
template <int D>
Vec<D> place_of(const SimulationIn<D>& simulation, std::size_t particle) {
    Vec<D> place{};
    for (std::size_t k = 0; k < D; ++k) place[k] = simulation.particles().position[k][particle];
    if (!is_finite<D>(place)) {
        for (std::size_t k = 0; k < D; ++k) {
            simulation.listed_positions(k, particle, {&place[k], 1});
        }
    }
    return place;
}

template <int D>
double squared_distance(const Domain<D>& domain, const Vec<D>& a, const Vec<D>& b) {
    double sum = 0.0;
    for (std::size_t k = 0; k < D; ++k) {
        double d = a[k] - b[k];
        if (domain.periodic[k]) {
            const double extent = domain.extent(static_cast<int>(k));
            d -= extent * std::round(d / extent);
        }
        sum += d * d;
    }
    return sum;
}

template <int D>
double speed_of(const SimulationIn<D>& simulation, std::size_t particle) {
    double sum = 0.0;
    for (std::size_t k = 0; k < D; ++k) {
        const double u = simulation.particles().velocity[k][particle];
        sum += u * u;
    }
    return std::sqrt(sum);
}

template <int D>
std::vector<double> all_in_space(const std::array<std::vector<double>, static_cast<std::size_t>(D)>& vectors,
                                 const std::vector<std::size_t>& particles) {
    std::vector<double> values;
    values.reserve(3 * particles.size());
    for (const std::size_t i : particles) {
        for (const double x : in_space<D>(vectors, i)) values.push_back(x);
    }
    return values;
}

/// The state of some particles.
template <int D>
void add_particles(Content& content, const std::string& group, const Case& c,
                   const SimulationIn<D>& simulation, const std::vector<std::size_t>& particles) {
    const Particles<D>& p = simulation.particles();
    std::vector<double> density;
    std::vector<std::int32_t> id;
    for (const std::size_t i : particles) {
        density.push_back(c.fluid.density * (1.0 + p.density_deviation[i]));
        id.push_back(p.id[i]);
    }
    const auto add = [&](const Field& field, std::vector<std::size_t> shape, Dataset::Values values) {
        content.datasets.push_back(dataset_of(field, D, std::move(shape), std::move(values)));
        content.datasets.back().path = field.path_in(group);
    };
    const std::size_t n = particles.size();
    const auto& of = fields::snapshot;
    add(of.position, {n, 3}, all_in_space<D>(p.position, particles));
    add(of.velocity, {n, 3}, all_in_space<D>(p.velocity, particles));
    add(of.density, {n}, std::move(density));
    add(of.id, {n}, std::move(id));
}

}  // namespace

template <int D>
FailureScene look_around(const Case& c, const SimulationIn<D>& simulation, std::size_t particle) {
    const Domain<D> domain = domain_of<D>(c);
    const std::size_t n = simulation.particles().size();
    const Vec<D> centre = place_of(simulation, particle);
    std::vector<std::pair<double, std::size_t>> others;  // squared distance, particle
    for (std::size_t i = 0; i < n; ++i) {
        if (i != particle) {
            others.emplace_back(squared_distance<D>(domain, centre, place_of(simulation, i)), i);
        }
    }
    const std::size_t count = std::min(failure_neighbours, others.size());
    std::partial_sort(others.begin(), others.begin() + static_cast<std::ptrdiff_t>(count), others.end());
    others.resize(count);
    others.insert(others.begin(), {0.0, particle});

    const double support = 2.0 * simulation.scheme().smoothing_length;
    FailureScene scene{.particle = particle, .nearest = {}};
    for (const auto& [squared, near] : others) {
        const Vec<D> place = place_of(simulation, near);
        std::size_t neighbours = 0;
        for (std::size_t i = 0; i < n; ++i) {
            neighbours +=
                i != near && squared_distance<D>(domain, place, place_of(simulation, i)) < support * support
                    ? 1
                    : 0;
        }
        scene.nearest.push_back({.particle = near, .distance = std::sqrt(squared), .neighbours = neighbours});
    }
    return scene;
}

template <int D>
void write_failure(const RunFiles& files, const Case& c, const SimulationIn<D>& simulation,
                   const FailureScene& scene, const std::string& message) {
    const std::size_t n = simulation.particles().size();
    std::vector<std::size_t> all(n);
    std::iota(all.begin(), all.end(), std::size_t{0});
    std::vector<std::size_t> nearest;
    std::vector<double> distance;
    std::vector<double> neighbours;
    for (const NearbyParticle& near : scene.nearest) {
        nearest.push_back(near.particle);
        distance.push_back(near.distance);
        neighbours.push_back(static_cast<double>(near.neighbours));
    }
    Content content;
    content.compression = c.output.compression;
    const double time = simulation.clock().time;
    const std::string snapshot = snapshot_group(0);
    add_particles(content, snapshot, c, simulation, all);
    add_attribute(content, snapshot, fields::snapshot.time.name, time);
    add_particles(content, "/neighbourhood", c, simulation, nearest);
    add_array(content, "/neighbourhood/distance", std::move(distance), "m",
              "distance from the particle at which the simulation failed");
    add_array(content, "/neighbourhood/neighbours", std::move(neighbours), "1",
              "particles of the water within the kernel's support");
    content.datasets.push_back(dataset_of(fields::stored_case.text, D, {}, c.text));
    add_field(content, fields::file.failure, message);
    add_attribute(content, "/", "time", time);
    add_attribute(content, "/", "particle",
                  static_cast<std::int64_t>(simulation.particles().id[scene.particle]));
    ResultsFile::create(files.failure(), content, true);
    constexpr ElementType real = ElementType::float64;
    write_xdmf(files.failure_xdmf(), files.failure().filename().string(),
               {{.index = 0, .time = time, .particles = n}},
               {{.name = "position", .components = 3, .type = real},
                {.name = "velocity", .components = 3, .type = real},
                {.name = "density", .components = 1, .type = real},
                {.name = "id", .components = 1, .type = ElementType::int32}});
}

template <int D>
std::string neighbourhood_table(const SimulationIn<D>& simulation, const FailureScene& scene) {
    const Particles<D>& p = simulation.particles();
    std::string text =
        fmt::format("the particle and the nearest to it, of {} in failure.h5:\n", scene.nearest.size());
    text += fmt::format("{:>9} {:>11} {:>11} {:>11} {:>11} {:>11} {:>11} {:>11} {:>10}\n", "particle",
                        "distance mm", "x m", "y m", "z m", "speed m/s", "w m/s", "density/-1", "neighbours");
    for (std::size_t row = 0; row < std::min(table_rows, scene.nearest.size()); ++row) {
        const NearbyParticle& near = scene.nearest[row];
        const auto [x, y, z] = in_space<D>(p.position, near.particle);
        text += fmt::format(
            "{:>9} {:>11.4g} {:>11.6g} {:>11.6g} {:>11.6g} {:>11.4g} {:>11.4g} {:>11.4g} {:>10}\n",
            p.id[near.particle], 1e3 * near.distance, x, y, z, speed_of(simulation, near.particle),
            p.velocity[D - 1][near.particle], p.density_deviation[near.particle], near.neighbours);
    }
    text.pop_back();
    return text;
}

template <int D>
std::string advice(const SimulationIn<D>& simulation, const FailureScene& scene) {
    const Particles<D>& p = simulation.particles();
    double fastest = -1.0;  // below zero: none is finite
    double density = -1.0;
    std::size_t not_finite = 0;
    for (const NearbyParticle& near : scene.nearest) {
        const double speed = speed_of(simulation, near.particle);
        const double s = p.density_deviation[near.particle];
        not_finite += std::isfinite(speed) && std::isfinite(s) ? 0 : 1;
        fastest = std::max(fastest, std::isfinite(speed) ? speed : -1.0);
        density = std::max(density, std::isfinite(s) ? std::abs(s) : -1.0);
    }
    if (fastest < 0.0 && density < 0.0) {
        return fmt::format(
            "Around it, none of {} particles has a finite velocity or density any more, so it began some steps before: resume from the checkpoint with output.snapshot_interval of some steps, and look at what departs first.",
            scene.nearest.size());
    }
    const double sound = simulation.scheme().state.sound_speed;
    const auto largest = [](const char* what, double value, const char* unit) {
        return value < 0.0 ? fmt::format("no finite {}", what)
                           : fmt::format("largest finite {} {:.3g}{}", what, value, unit);
    };
    std::string text = fmt::format(
        "Around it, among {} particles: {} (sound {:.3g} m/s, largest expected {:.3g} m/s), {}, {} not finite, {} neighbours. ",
        scene.nearest.size(), largest("speed", fastest, " m/s"), sound, simulation.scheme().maximum_velocity,
        largest("density deviation", density, ""), not_finite, scene.nearest.front().neighbours);
    if (density > 0.1 || fastest > 0.5 * sound) {
        text +=
            "So the water is compressed far beyond what the scheme allows: either the step is too long (a "
            "smaller one helps at once), or the flow is faster than the sound speed was chosen for: look "
            "at the surroundings of the particle, and raise numerics.sound_speed.";
    } else if (scene.nearest.front().neighbours < 4) {
        text += "So it is spray: a particle with hardly any neighbours, of which the sums know little.";
    } else if (not_finite > 1) {
        text +=
            "So those that are finite are in order, and what is not began at one of the others: look at the step, and at what acts there (a wall, a solid, an opening).";
    } else {
        text +=
            "So the particles around it are in order: look at what acts on this one alone (a wall, a solid, "
            "an opening), and at the step.";
    }
    return text;
}

template FailureScene look_around(const Case&, const SimulationIn<2>&, std::size_t);
template FailureScene look_around(const Case&, const SimulationIn<3>&, std::size_t);
template void write_failure(const RunFiles&, const Case&, const SimulationIn<2>&, const FailureScene&,
                            const std::string&);
template void write_failure(const RunFiles&, const Case&, const SimulationIn<3>&, const FailureScene&,
                            const std::string&);
template std::string neighbourhood_table(const SimulationIn<2>&, const FailureScene&);
template std::string neighbourhood_table(const SimulationIn<3>&, const FailureScene&);
template std::string advice(const SimulationIn<2>&, const FailureScene&);
template std::string advice(const SimulationIn<3>&, const FailureScene&);

}  // namespace riffle::inline solver
