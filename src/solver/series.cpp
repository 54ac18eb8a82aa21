#include "solver/series.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <stdexcept>

#include "particles/lattice.hpp"

namespace riffle {

namespace {

/// Sums of one layer for the fluctuation and the order of the particles.
struct Layer {
    double count = 0.0, u = 0.0, w = 0.0, uu = 0.0, ww = 0.0, cosine = 0.0, sine = 0.0;
};

struct Totals {
    double mass = 0.0, momentum = 0.0, above = 0.0, above_mass = 0.0, energy = 0.0;
    double drag = 0.0, wall = 0.0, pairs = 0.0;
    double fastest = 0.0;
    double s_low = std::numeric_limits<double>::infinity();
    double s_high = -std::numeric_limits<double>::infinity();
};

}  // namespace

TimeSeries::TimeSeries(const Case& c) : case_(c) {
    const auto add = [&](const char* name, const char* unit, const char* long_name) {
        columns_.push_back({.name = name, .unit = unit, .long_name = long_name, .values = {}});
    };
    add("time", "s", "simulated time");
    add("depth_mean_velocity", "m/s", "mean streamwise velocity over the water above the datum");
    add("total_mean_velocity", "m/s", "mass-mean streamwise velocity of all fluid");
    add("drag_over_gravity", "1", "bed drag over the weight component");
    add("wall_over_gravity", "1", "streamwise wall force over the weight component");
    add("acceleration_over_gravity", "1", "rate of change of streamwise momentum over the weight component");
    add("mean_level", "m", "mean surface level above the bed level");
    add("maximum_velocity", "m/s", "largest particle speed");
    add("density_deviation_minimum", "1", "smallest rho/rho0 - 1");
    add("density_deviation_maximum", "1", "largest rho/rho0 - 1");
    add("velocity_fluctuation", "m/s", "rms departure of the particle velocities from their layer means");
    add("particle_order", "1", "layering of the particles, 1: perfect rows, 0: none");
    add("kinetic_energy", "J/m", "kinetic energy per unit width");
    add("time_step", "s", "time step");
}

const std::vector<double>& TimeSeries::column(const std::string& name) const {
    for (const SeriesColumn& c : columns_) {
        if (c.name == name) {
            return c.values;
        }
    }
    throw std::invalid_argument("no time series " + name);
}

double TimeSeries::last(const std::string& name) const {
    const auto& values = column(name);
    return values.empty() ? 0.0 : values.back();
}

void TimeSeries::sample(const Simulation& simulation, double mean_level) {
    const Particles<2>& p = simulation.particles();
    const ParticleFields& f = simulation.fields();
    const Lattice lattice = lattice_of(case_);
    const double datum = case_.datum();
    Totals sum;
    std::vector<Layer> layers(static_cast<std::size_t>(lattice.rows));
    for (std::size_t i = 0; i < p.size(); ++i) {
        const double mass = p.mass[i];
        const double z = p.position[1][i];
        const double u = p.velocity[0][i];
        const double w = p.velocity[1][i];
        const double speed_squared = u * u + w * w;
        sum.mass += mass;
        sum.momentum += mass * u;
        sum.energy += 0.5 * mass * speed_squared;
        sum.fastest = std::max(sum.fastest, speed_squared);
        if (z > datum) {
            sum.above += mass * u;
            sum.above_mass += mass;
        }
        sum.drag -= mass * f.drag_acceleration_x[i];
        sum.wall -= mass * f.wall_acceleration_x[i];
        sum.pairs += mass * (f.pair_acceleration_x[i] + f.viscous_acceleration_x[i]);
        sum.s_low = std::min(sum.s_low, p.density_deviation[i]);
        sum.s_high = std::max(sum.s_high, p.density_deviation[i]);
        Layer& layer = layers[static_cast<std::size_t>(std::clamp(z / lattice.dz, 0.0, lattice.rows - 0.5))];
        layer.count += 1.0;
        layer.u += u;
        layer.w += w;
        layer.uu += u * u;
        layer.ww += w * w;
        const double phase = 2.0 * std::numbers::pi * z / lattice.dz;
        layer.cosine += std::cos(phase);
        layer.sine += std::sin(phase);
    }
    double fluctuation = 0.0;
    double order = 0.0;
    for (const Layer& l : layers) {
        if (l.count > 0.0) {
            fluctuation += l.uu + l.ww - (l.u * l.u + l.w * l.w) / l.count;
            order += std::hypot(l.cosine, l.sine);
        }
    }
    const auto n = static_cast<double>(p.size());
    const double weight = sum.mass * simulation.scheme().streamwise_gravity;
    const auto over_weight = [&](double force) { return weight > 0.0 ? force / weight : 0.0; };
    const double row[] = {simulation.clock().time,
                          sum.above_mass > 0.0 ? sum.above / sum.above_mass : 0.0,
                          sum.momentum / sum.mass,
                          over_weight(sum.drag),
                          over_weight(sum.wall),
                          over_weight(weight + sum.pairs - sum.drag),
                          mean_level,
                          std::sqrt(sum.fastest),
                          sum.s_low,
                          sum.s_high,
                          std::sqrt(std::max(0.0, fluctuation / n)),
                          order / n,
                          sum.energy,
                          simulation.clock().time_step};
    for (std::size_t k = 0; k < columns_.size(); ++k) {
        columns_[k].values.push_back(row[k]);
    }
}

}  // namespace riffle
