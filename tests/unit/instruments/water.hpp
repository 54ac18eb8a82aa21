#pragma once

#include <cmath>
#include <functional>
#include <random>

#include "case/case.hpp"
#include "instruments/fluid_view.hpp"
#include "instruments/instrument.hpp"
#include "particles/lattice.hpp"
#include "working.hpp"

namespace riffle::test {

/// A periodic channel of 0.1 m with a smooth bed, 0.04 m of water and particles 2 mm apart, h = 4 mm.
inline Case small_water() {
    Case c;
    c.channel.slope = 0.004;
    c.channel.depth = 0.04;
    c.channel.length = 0.1;
    c.bed.kind = BedKind::no_slip;
    c.bed.datum_below_crest = 0.0;
    c.numerics.spacing = 0.002;
    c.numerics.smoothing_ratio = 2.0;
    c.run.until = RunUntil::time;
    return c;
}

using Field = std::function<double(double x, double z)>;

/// Its particles on a lattice, displaced at random by up to `jitter` spacings, with a velocity field and a
/// surface at depth + rise(x), to which the columns are stretched.
struct Water {
    Case parameters;
    Particles<2> particles;
    double h = 0.0;
    Field pressure = [](double, double) { return 0.0; };
    Field shear_stress = [](double, double) { return 0.0; };

    explicit Water(const Case& c, double jitter = 0.0, const std::function<double(double)>& rise = {})
        : parameters(c), h(c.numerics.smoothing_ratio * c.numerics.spacing) {
        Case displaced = c;
        displaced.start.jitter = jitter;
        particles = lattice_particles(displaced);
        const Lattice lattice = lattice_of(c);
        for (std::size_t i = 0; i < particles.size(); ++i) {
            double& z = particles.position[1][i];
            const double stretch = rise ? 1.0 + rise(particles.position[0][i]) / c.total_depth() : 1.0;
            z *= stretch;
            particles.mass[i] = c.fluid.density * lattice.volume() * stretch;
        }
    }
    Water& with_velocity(const Field& u, const Field& w) {
        for (std::size_t i = 0; i < particles.size(); ++i) {
            const double x = particles.position[0][i];
            const double z = particles.position[1][i];
            particles.velocity[0][i] = u(x, z);
            particles.velocity[1][i] = w(x, z);
        }
        return *this;
    }
    [[nodiscard]] FluidViewIn<2> view() const { return {parameters, particles, h}; }
    [[nodiscard]] std::vector<double> of_particles(const Field& field) const {
        std::vector<double> values;
        for (std::size_t i = 0; i < particles.size(); ++i) {
            values.push_back(field(particles.position[0][i], particles.position[1][i]));
        }
        return values;
    }
    /// One sample at a time.
    void sample(Instrument& instrument, double time = 1.0) const {
        const FluidViewIn<2> fluid = view();
        const WorkingValues pressures = working(of_particles(pressure));
        const std::vector<double> stresses = of_particles(shear_stress);
        instrument.sample({.time = time,
                           .mass = particles.mass,
                           .fluid = &fluid,
                           .pressure = &pressures,
                           .shear_stress = stresses});
    }
};

/// Values of a record by name.
inline std::vector<double> values_of(const Instrument& instrument, const std::string& name) {
    for (const InstrumentRecord& record : instrument.records()) {
        if (record.name == name) {
            return std::visit(
                [](const auto& values) { return std::vector<double>(values.begin(), values.end()); },
                record.values);
        }
    }
    throw std::logic_error("no record " + name);
}

}  // namespace riffle::test
