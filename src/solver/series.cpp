#include "solver/series.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>
#include <stdexcept>
#include <string>

#include "base/parallel.hpp"
#include "case/bed_traits.hpp"
#include "case/end_buffers.hpp"
#include "particles/lattice.hpp"
#include "record/flow_fields.hpp"
#include "solver/furthest.hpp"
#include "sph/elastic_energy.hpp"

namespace riffle::inline solver {

namespace {

/// Sums of one layer for the fluctuation and the order of the particles.
struct Layer {
    double count = 0.0, u = 0.0, v = 0.0, w = 0.0, uu = 0.0, vv = 0.0, ww = 0.0, cosine = 0.0, sine = 0.0;

    void add(const Layer& other) {
        constexpr std::array sums{&Layer::count, &Layer::u,  &Layer::v,      &Layer::w,   &Layer::uu,
                                  &Layer::vv,    &Layer::ww, &Layer::cosine, &Layer::sine};
        static_assert(sizeof(Layer) == sums.size() * sizeof(double), "each sum is added");
        for (double Layer::*const sum : sums) this->*sum += other.*sum;
    }
};

/// Sums over the particles.
struct Sums {
    double mass = 0.0, momentum = 0.0, above = 0.0, above_mass = 0.0, energy = 0.0;
    double drag = 0.0, wall = 0.0, pairs = 0.0;
    double vegetation = 0.0, porous = 0.0, side_wall = 0.0, centre = 0.0, centre_mass = 0.0, secondary = 0.0;
    double potential = 0.0, elastic = 0.0, volume = 0.0;

    void add(const Sums& other) {
        constexpr std::array sums{&Sums::mass,        &Sums::momentum,  &Sums::above,     &Sums::above_mass,
                                  &Sums::energy,      &Sums::drag,      &Sums::wall,      &Sums::pairs,
                                  &Sums::vegetation,  &Sums::porous,    &Sums::side_wall, &Sums::centre,
                                  &Sums::centre_mass, &Sums::secondary, &Sums::potential, &Sums::elastic,
                                  &Sums::volume};
        static_assert(sizeof(Sums) == sums.size() * sizeof(double), "each sum is added");
        for (double Sums::*const sum : sums) this->*sum += other.*sum;
    }
};

struct Totals : Sums {
    double fastest = 0.0;
    std::int64_t particles = 0;
    Furthest upstream;  ///< of -x
    Furthest downstream;
    double s_low = std::numeric_limits<double>::infinity();
    double s_high = -std::numeric_limits<double>::infinity();
    std::vector<Layer> layers;

    void add(const Totals& other) {
        Sums::add(other);
        fastest = std::max(fastest, other.fastest);
        particles += other.particles;
        upstream.add(other.upstream);
        downstream.add(other.downstream);
        s_low = std::min(s_low, other.s_low);
        s_high = std::max(s_high, other.s_high);
        for (std::size_t k = 0; k < layers.size(); ++k) layers[k].add(other.layers[k]);
    }
};

/// Share of a particle at height z, as thick as its row, that stands above the datum: counted whole or not at
/// all, the rows beside the datum would move the depth mean by up to 1 % as they rise and fall.
double share_above(double z, double datum, double thickness) {
    return std::clamp((z - datum) / thickness + 0.5, 0.0, 1.0);
}

/// Sums over the particles of one block.
template <int D>
Totals sums_over(const SimulationIn<D>& simulation, const Case& c, std::size_t begin, std::size_t end) {
    const Particles<D>& p = simulation.particles();
    const ParticleFields& f = simulation.fields();
    const Lattice lattice = lattice_of(c);
    const double datum = c.datum();
    const double centreline = c.channel.centreline();
    const double half_strip = centreline_half_strip(c);
    const Scheme& scheme = simulation.scheme();
    // Between closed ends the weight acts along the bed too; along a periodic channel it has no potential
    // there.
    const double along = c.channel.ends == Ends::walls ? scheme.streamwise_gravity : 0.0;
    Totals sum;
    sum.layers.resize(static_cast<std::size_t>(lattice.rows));
    for (std::size_t i = begin; i < end; ++i) {
        if (!in_channel(c, p.position[0][i])) continue;
        const double mass = p.mass[i];
        const double z = p.position[D - 1][i];
        const double u = p.velocity[0][i];
        const double w = p.velocity[D - 1][i];
        const double above = mass * share_above(z, datum, lattice.dz);
        double speed_squared = u * u + w * w;
        Layer& layer =
            sum.layers[static_cast<std::size_t>(std::clamp(z / lattice.dz, 0.0, lattice.rows - 0.5))];
        if constexpr (D == 3) {
            const double v = p.velocity[1][i];
            speed_squared += v * v;
            layer.v += v;
            layer.vv += v * v;
            sum.secondary += v * v + w * w;
            sum.side_wall -= mass * f.side_wall_acceleration_x[i];
            if (std::abs(p.position[1][i] - centreline) < half_strip) {
                sum.centre += above * u;
                sum.centre_mass += above;
            }
        }
        sum.mass += mass;
        sum.momentum += mass * u;
        sum.energy += 0.5 * mass * speed_squared;
        sum.potential += mass * (scheme.normal_gravity * z - along * p.position[0][i]);
        sum.elastic += mass * elastic_energy(scheme.state, p.density_deviation[i]);
        sum.volume += mass / (1.0 + p.density_deviation[i]);
        sum.fastest = std::max(sum.fastest, speed_squared);
        sum.upstream.add(-p.position[0][i]);
        sum.downstream.add(p.position[0][i]);
        sum.above += above * u;
        sum.above_mass += above;
        sum.drag -= mass * f.drag_acceleration_x[i];
        sum.vegetation -= mass * f.vegetation_acceleration_x[i];
        sum.porous -= mass * f.porous_acceleration_x[i];
        sum.wall -= mass * f.wall_acceleration_x[i];
        sum.pairs += mass * (f.pair_acceleration_x[i] + f.viscous_acceleration_x[i]);
        sum.s_low = std::min(sum.s_low, p.density_deviation[i]);
        sum.s_high = std::max(sum.s_high, p.density_deviation[i]);
        layer.count += 1.0;
        layer.u += u;
        layer.w += w;
        layer.uu += u * u;
        layer.ww += w * w;
        ++sum.particles;
        const double phase = 2.0 * std::numbers::pi * z / lattice.dz;
        layer.cosine += std::cos(phase);
        layer.sine += std::sin(phase);
    }
    return sum;
}

/// The sums over all particles; in three dimensions, where they are many, in parallel.
template <int D>
Totals all_sums(const SimulationIn<D>& simulation, const Case& c) {
    const std::size_t n = simulation.particles().size();
    if constexpr (D == 2) {
        return sums_over(simulation, c, 0, n);
    } else {
        Totals none;
        none.layers.resize(static_cast<std::size_t>(lattice_of(c).rows));
        constexpr std::size_t block = std::size_t{1} << 15U;
        return reduce_blocks(
            n, block, none,
            [&](std::size_t begin, std::size_t end) { return sums_over(simulation, c, begin, end); },
            [](Totals sum, const Totals& part) {
                sum.add(part);
                return sum;
            });
    }
}

}  // namespace

namespace {

/// Waves over the section of an open end.
LongWaves waves_at(const Case& c, bool at_inflow) {
    return c.channel.ends == Ends::open ? waves_of_lattice(c, at_inflow) : LongWaves(c.normal_gravity());
}

}  // namespace

TimeSeries::TimeSeries(const Case& c)
    : case_(c),
      end_floors_(end_floors(c)),
      upstream_waves_(waves_at(c, true)),
      downstream_waves_(waves_at(c, false)) {
    for (const Field& field : fields_of(fields::time_series)) {
        const bool written = (field.written & three_dimensions) == 0 || c.channel.dimensions == 3;
        const bool grown = (field.written & with_vegetation) == 0 || !c.vegetation.empty();
        const bool filled = (field.written & with_porous_zones) == 0 || !c.porous.empty();
        if (written && grown && filled &&
            ((field.written & with_open_ends) == 0 || c.channel.ends == Ends::open)) {
            columns_.push_back({.field = field, .values = {}});
        }
    }
}

std::vector<double>& TimeSeries::values_of(const Field& field) {
    const auto found = std::find_if(columns_.begin(), columns_.end(),
                                    [&](const SeriesColumn& column) { return column.field == field; });
    if (found == columns_.end()) throw std::invalid_argument(std::string("no time series ") + field.name);
    return found->values;
}

const std::vector<double>& TimeSeries::column(const Field& field) const {
    return const_cast<TimeSeries&>(*this).values_of(field);
}

double TimeSeries::last(const Field& field) const {
    const auto& values = column(field);
    return values.empty() ? 0.0 : values.back();
}

template <int D>
void TimeSeries::sample_ends(const SimulationIn<D>& simulation) {
    const OpenEndsState& ends = simulation.clock().open_ends;
    const Particles<D>& p = simulation.particles();
    double mass = 0.0;
    double momentum = 0.0;
    double between_sections = 0.0;
    // A row of particles that passes a section counts by the part of its spacing that is inside.
    const double of_spacing = 1.0 / case_.numerics.spacing;
    const auto [first, last] = momentum_sections(case_);
    for (std::size_t i = 0; i < p.size(); ++i) {
        const double of_particle = p.mass[i] * p.velocity[0][i];
        const double x = p.position[0][i];
        const double inside = std::min(x - first, last - x) * of_spacing + 0.5;
        mass += p.mass[i];
        momentum += of_particle;
        between_sections += std::clamp(inside, 0.0, 1.0) * of_particle;
    }
    const double width = case_.channel.flow_width();
    const auto add = [&](const Field& field, double value) { values_of(field).push_back(value); };
    const auto& series = fields::time_series;
    add(series.inflow_discharge, width * upstream_waves_.area(ends.upstream.depth) * ends.upstream.velocity);
    add(series.inflow_depth, end_floors_.upstream + ends.upstream.depth);
    add(series.outflow_discharge,
        width * downstream_waves_.area(ends.downstream.depth) * ends.downstream.velocity);
    add(series.outflow_depth, end_floors_.downstream + ends.downstream.depth);
    add(series.particles_stored, static_cast<double>(p.size()));
    add(series.particles_entered, static_cast<double>(ends.ledger.entered));
    add(series.particles_left, static_cast<double>(ends.ledger.left));
    add(series.particles_lost, static_cast<double>(p.lost.size()));
    add(series.mass_stored, mass);
    add(series.mass_entered, ends.ledger.mass_entered);
    add(series.mass_left, ends.ledger.mass_left);
    add(series.momentum_stored, momentum);
    add(series.momentum_between_sections, between_sections);
    add(series.momentum_entered, ends.ledger.momentum_entered);
    add(series.momentum_left, ends.ledger.momentum_left);
}

template <int D>
void TimeSeries::sample(const SimulationIn<D>& simulation, double mean_level) {
    const Totals sum = all_sums(simulation, case_);
    double fluctuation = 0.0;
    double order = 0.0;
    for (const Layer& l : sum.layers) {
        if (l.count > 0.0) {
            fluctuation += l.uu + l.ww - (l.u * l.u + l.w * l.w) / l.count;
            if constexpr (D == 3) fluctuation += l.vv - l.v * l.v / l.count;
            order += std::hypot(l.cosine, l.sine);
        }
    }
    const auto n = static_cast<double>(sum.particles);
    const double weight = sum.mass * simulation.scheme().streamwise_gravity;
    const auto over_weight = [&](double force) { return weight > 0.0 ? force / weight : 0.0; };
    const auto add = [&](const Field& field, double value) { values_of(field).push_back(value); };
    const auto& series = fields::time_series;
    add(series.time, simulation.clock().time);
    add(series.depth_mean_velocity, sum.above_mass > 0.0 ? sum.above / sum.above_mass : 0.0);
    add(series.total_mean_velocity, sum.momentum / sum.mass);
    add(series.drag_over_gravity, over_weight(sum.drag));
    add(series.wall_over_gravity, over_weight(sum.wall));
    add(series.acceleration_over_gravity,
        over_weight(weight + sum.pairs - sum.drag - sum.side_wall - sum.vegetation - sum.porous));
    add(series.mean_level, mean_level);
    add(series.maximum_velocity, std::sqrt(sum.fastest));
    add(series.density_deviation_minimum, sum.s_low);
    add(series.density_deviation_maximum, sum.s_high);
    add(series.velocity_fluctuation, std::sqrt(std::max(0.0, fluctuation / n)));
    add(series.particle_order, order / n);
    add(series.kinetic_energy, sum.energy);
    add(series.time_step, simulation.clock().time_step);
    add(series.potential_energy, sum.potential);
    add(series.elastic_energy, sum.elastic);
    add(series.water_volume, sum.volume / case_.fluid.density);
    add(series.first_particle, -sum.upstream.furthest());
    add(series.last_particle, sum.downstream.furthest());
    add(series.front_upstream, -sum.upstream.front());
    add(series.front_downstream, sum.downstream.front());
    const EnergyRates& rates = simulation.energy_rates();
    add(series.gravity_power, rates.gravity);
    add(series.bed_drag_power, rates.bed_drag);
    add(series.closure_power, rates.closure);
    add(series.viscosity_power, rates.viscosity);
    add(series.density_diffusion_power, rates.density_diffusion);
    add(series.pressure_power, rates.pressure);
    add(series.further_power, rates.further_forces);
    add(series.solids_power, rates.solids);
    if (!case_.vegetation.empty()) {
        add(series.vegetation_over_gravity, over_weight(sum.vegetation));
        add(series.vegetation_power, rates.vegetation);
    }
    if (!case_.porous.empty()) {
        add(series.porous_over_gravity, over_weight(sum.porous));
        add(series.porous_power, rates.porous);
    }
    if (case_.channel.ends == Ends::open) sample_ends(simulation);
    if constexpr (D == 3) {
        add(series.side_wall_power, rates.side_drag);
        add(series.side_wall_over_gravity, over_weight(sum.side_wall));
        add(series.centreline_velocity, sum.centre_mass > 0.0 ? sum.centre / sum.centre_mass : 0.0);
        add(series.secondary_velocity, std::sqrt(sum.secondary / n));
    }
}

void TimeSeries::set_mean_level(double level) { values_of(fields::time_series.mean_level).back() = level; }

template void TimeSeries::sample(const SimulationIn<2>&, double);
template void TimeSeries::sample(const SimulationIn<3>&, double);

double centreline_half_strip(const Case& c) {
    return has_spheres(c.bed) ? 0.5 * std::numbers::sqrt3 * c.bed.sphere_diameter : 0.05 * c.channel.width;
}

}  // namespace riffle::inline solver
