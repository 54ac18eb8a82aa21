#include "solver/start.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

#include "base/error.hpp"
#include "case/cross_section.hpp"
#include "case/end_floor.hpp"
#include "case/flow_kind.hpp"
#include "case/outline.hpp"
#include "case/packed_start.hpp"
#include "case/porous_zone.hpp"
#include "column/canal_flow.hpp"
#include "column/section.hpp"
#include "ends/end_input.hpp"
#include "ends/end_lattice.hpp"
#include "particles/lattice.hpp"
#include "solver/isotropic_start.hpp"
#include "solver/start_packing.hpp"
#include "solver/start_perturbation.hpp"

namespace riffle::inline solver {

namespace {

/// A wave along x, the same across the channel: the lattice is displaced by the linear wave's potential,
/// which keeps the volumes to first order.
template <int D>
void start_standing_wave(const Case& c, Particles<D>& particles) {
    const double depth = c.total_depth();
    const double k = 2.0 * std::numbers::pi / c.channel.length;
    for (std::size_t i = 0; i < particles.size(); ++i) {
        double& x = particles.position[0][i];
        double& z = particles.position[D - 1][i];
        const double scale = c.start.amplitude / std::sinh(k * depth);
        const double dx = -scale * std::cosh(k * z) * std::sin(k * x);
        const double dz = scale * std::sinh(k * z) * std::cos(k * x);
        x += dx;
        z += dz;
    }
}

double wave_pressure(const Case& c, const Scheme& scheme, double x, double z) {
    const double k = 2.0 * std::numbers::pi / c.channel.length;
    return scheme.normal_gravity * c.start.amplitude * std::cosh(k * z) / std::cosh(k * scheme.depth) *
           std::cos(k * x);
}

/// Vortices that decay as they are in a plane; in space those of Taylor & Green (1937), which break up: u =
/// u0 sin x cos y cos z, v = -u0 (kx/ky) cos x sin y cos z, w = 0, with their pressure in a cube.
template <int D>
void start_taylor_green(const Case& c, const Scheme& scheme, Particles<D>& particles,
                        std::vector<double>& pressure) {
    const double u0 = c.start.velocity.value_or(1.0);
    const double kx = 2.0 * std::numbers::pi / c.channel.length;
    const double kz = 2.0 * std::numbers::pi / scheme.depth;
    for (std::size_t i = 0; i < particles.size(); ++i) {
        const double x = kx * particles.position[0][i];
        const double z = kz * particles.position[D - 1][i];
        if constexpr (D == 2) {
            particles.velocity[0][i] = u0 * std::sin(x) * std::cos(z);
            particles.velocity[1][i] = -u0 * kx / kz * std::cos(x) * std::sin(z);
            pressure[i] = 0.25 * u0 * u0 * (std::cos(2.0 * x) + kx * kx / (kz * kz) * std::cos(2.0 * z));
        } else {
            const double ky = 2.0 * std::numbers::pi / c.channel.width;
            const double y = ky * particles.position[1][i];
            particles.velocity[0][i] = u0 * std::sin(x) * std::cos(y) * std::cos(z);
            particles.velocity[1][i] = -u0 * kx / ky * std::cos(x) * std::sin(y) * std::cos(z);
            pressure[i] =
                u0 * u0 / 16.0 * (std::cos(2.0 * x) + std::cos(2.0 * y)) * (std::cos(2.0 * z) + 2.0);
        }
    }
}

/// The one velocity of a uniform start.
double uniform_velocity(const Case& c, const ColumnResult* column) {
    if (c.start.velocity) return *c.start.velocity;
    if (column != nullptr) return column->total_mean_velocity;
    if (const auto canal = canal_flow(c)) return canal->velocity;
    throw InputError(
        "[start] kind = \"uniform\" needs `velocity`: this case has no column flow to take it from");
}

double start_velocity(const Case& c, const Scheme& scheme, const ColumnResult* column, double uniform,
                      double z) {
    switch (c.start.kind) {
        case StartKind::column:
            if (column == nullptr) {
                throw InputError(
                    "[start] kind = \"column\" needs a steady column flow, which this case does not have "
                    "(no slope, no friction, or closed ends); choose \"rest\" or \"uniform\"");
            }
            return column->velocity_at(z);
        case StartKind::uniform:
            return uniform;
        case StartKind::power_law: {
            const double top = c.start.velocity.value_or(column != nullptr ? column->surface_velocity : 0.0);
            return top * std::pow(std::max(0.0, z / scheme.depth), 1.0 / c.start.exponent);
        }
        case StartKind::rest:
        case StartKind::results:
        case StartKind::standing_wave:
        case StartKind::taylor_green:
        case StartKind::isotropic:
        case StartKind::section:
        case StartKind::backwater:
            break;
    }
    return 0.0;
}

/// The start of a channel with open ends.
class OpenStart {
  public:
    explicit OpenStart(const Case& c)
        : c_(c),
          input_(read_end_input(c)),
          unit_discharge_(start_unit_discharge(c, input_)),
          depth(start_depths(c, input_)) {
        if (section_of(c) != nullptr) {
            waves_.push_back(waves_of(c));
        } else if (measured_bed_of(c) != nullptr) {
            for (int k = 0; k <= stations; ++k) {
                const double at = c.channel.length * k / stations;
                waves_.push_back(EndLattice(c, lattice_of(c), at).waves(c.normal_gravity()));
            }
        }
    }

    /// Pressure over the density that a duct starts with.
    [[nodiscard]] double pressure() const { return input_.outflow_pressure; }

    [[nodiscard]] double velocity(double x, double y, double height) const {
        if (c_.start.kind == StartKind::rest) return 0.0;
        const double floor = floor_at(c_, within_ends(x, c_.channel.length));
        const double water = std::max(depth(x) - floor, c_.numerics.spacing);
        const double z = height - floor;
        const double area = area_at(x, water);
        const double mean = c_.start.velocity.value_or(unit_discharge_ / area);
        switch (c_.start.kind) {
            case StartKind::uniform:
                return mean;
            case StartKind::power_law: {
                const double m = c_.start.exponent;
                const double top = c_.start.velocity.value_or(unit_discharge_ / area * (m + 1.0) / m);
                return top * std::pow(std::max(0.0, z / water), 1.0 / m);
            }
            case StartKind::column:
            case StartKind::rest:
            case StartKind::results:
            case StartKind::standing_wave:
            case StartKind::taylor_green:
            case StartKind::isotropic:
            case StartKind::section:
            case StartKind::backwater:
                break;
        }
        return unit_discharge_ / area * input_.entering->mean_at(y, z / water);
    }

  private:
    const Case& c_;
    EndInput input_;
    double unit_discharge_;
    /// Sections of a channel that is no rectangle: one, or over measured heights those of stations along it.
    std::vector<LongWaves> waves_;
    static constexpr int stations = 100;

    /// Area of the water at a place, over the width of the channel.
    [[nodiscard]] double area_at(double x, double water) const {
        if (waves_.empty()) return water;
        const double along = waves_.size() > 1 ? std::clamp(x / c_.channel.length, 0.0, 1.0) * stations : 0.0;
        return std::max(waves_[static_cast<std::size_t>(std::lround(along))].area(water),
                        0.01 * c_.numerics.spacing);
    }

  public:
    std::function<double(double x)> depth;  ///< of all the water, m
};

}  // namespace

template <int D>
Particles<D> initial_particles(const Case& c, const Scheme& scheme, const ColumnResult* column,
                               const SectionVelocity& section, bool pack) {
    constexpr std::size_t vertical = D - 1;
    if (c.start.kind == StartKind::section && (D == 2 || !section)) {
        throw InputError(fmt::format(
            "{}: [start] kind = \"section\" needs the steady flow over the cross-section, and the case has none: {}; or "
            "choose \"rest\" or \"uniform\"",
            c.name(), why_no_section(c).value_or("it has two dimensions")));
    }
    const std::optional<OpenStart> open =
        c.channel.ends == Ends::open ? std::optional<OpenStart>(c) : std::nullopt;
    Particles<D> particles = lattice_particles<D>(c, open ? open->depth : std::function<double(double)>());
    const Lattice lattice = lattice_of(c);
    const std::size_t n = particles.size();
    PackedStart packing;
    if (pack && starts_packed(c)) packing = pack_start(c, scheme, particles);
    std::vector<double> extra_pressure(n, 0.0);
    std::vector<double> still_height = particles.position[vertical];
    if (c.start.kind == StartKind::standing_wave) {
        for (std::size_t i = 0; i < n; ++i) {
            extra_pressure[i] = wave_pressure(c, scheme, particles.position[0][i], still_height[i]);
        }
        start_standing_wave(c, particles);
        // A particle displaced from still_height carries the pressure of its new height and of the wave.
        still_height = particles.position[vertical];
    }
    if (c.start.kind == StartKind::taylor_green) start_taylor_green(c, scheme, particles, extra_pressure);
    if constexpr (D == 3) {
        if (c.start.kind == StartKind::isotropic) start_isotropic(c, particles, extra_pressure);
    }
    if (is_duct(c)) extra_pressure.assign(n, open->pressure());
    if (c.channel.lid_velocity != 0.0) {
        // A box without a surface has no pressure of its own; with that of the lid's velocity it does not
        // fall below zero in the vortex, where the particles would be drawn apart.
        extra_pressure.assign(n, c.channel.lid_velocity * c.channel.lid_velocity);
    }
    const Domain<D> domain = domain_of<D>(c);
    // The lattice stands in porous zones as elsewhere: with the grains around it a particle takes up the same
    // room, of which its mass is that of the water.
    const PorosityField pores(c);
    const double uniform = c.start.kind == StartKind::uniform && !open ? uniform_velocity(c, column) : 0.0;
    for (std::size_t i = 0; i < n; ++i) {
        const bool drawn_out = open && c.start.water_x.empty();  // rows to the depth of each column
        const double surface = drawn_out ? open->depth(particles.position[0][i])
                                         : still_surface(c, particles.position[0][i], still_height[i]);
        const double hydrostatic = scheme.normal_gravity * (surface - still_height[i]);
        const double s = scheme.state.deviation(hydrostatic + extra_pressure[i]);
        particles.density_deviation[i] = s;
        const double row_share = drawn_out ? rows_below(lattice, surface).height / lattice.dz : 1.0;
        const double share = packing.share.empty() ? row_share : packing.share[i];
        particles.mass[i] = scheme.density * (1.0 + s) * (share * lattice.volume());
        if (!pores.empty()) particles.mass[i] *= pores.porosity(vector_of(particles.position, i));
        if (c.start.kind == StartKind::section) {
            if constexpr (D == 3) {
                particles.velocity[0][i] = section(particles.position[1][i], particles.position[2][i]);
            }
        } else if (open) {
            const double y = across_of<D>(particles.position, i);
            particles.velocity[0][i] =
                open->velocity(particles.position[0][i], y, particles.position[vertical][i]);
        } else if (c.start.kind != StartKind::taylor_green && c.start.kind != StartKind::isotropic) {
            particles.velocity[0][i] =
                start_velocity(c, scheme, column, uniform, particles.position[vertical][i]);
        }
        for (std::size_t k = 0; k < D; ++k) {
            double& x = particles.position[k][i];
            if (domain.periodic[k]) {
                const double extent = domain.extent(static_cast<int>(k));
                x -= extent * std::floor(x / extent);
            }
        }
    }
    perturb_velocity(c, particles);
    return particles;
}

template Particles<2> initial_particles<2>(const Case&, const Scheme&, const ColumnResult*,
                                           const SectionVelocity&, bool);
template Particles<3> initial_particles<3>(const Case&, const Scheme&, const ColumnResult*,
                                           const SectionVelocity&, bool);

}  // namespace riffle::inline solver
