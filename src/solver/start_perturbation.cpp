#include "solver/start_perturbation.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <numbers>
#include <random>
#include <vector>

#include "base/unit_fraction.hpp"
#include "case/bed_traits.hpp"
#include "case/flow_kind.hpp"
#include "solver/start_streaks.hpp"

namespace riffle::inline solver {

namespace {

using Vector3 = std::array<double, 3>;

/// One mode of the potential, amplitude times cos(wave . x + phase).
struct Mode {
    Vector3 wave{};
    Vector3 amplitude{};
    double phase = 0.0;
};

/// sin^2(pi x / extent) and its derivative: no motion through an end, and none along it.
struct Envelope {
    double value = 1.0;
    double slope = 0.0;
};

Envelope envelope(double x, double extent) {
    const double angle = std::numbers::pi * std::clamp(x / extent, 0.0, 1.0);
    const double sine = std::sin(angle);
    return {sine * sine, std::numbers::pi / extent * std::sin(2.0 * angle)};
}

/// The same over an edge of a quarter of the extent at either end, and 1 between: it leaves the motion beside
/// a rough bed, where eddies must bring down what the bed takes.
Envelope flat_envelope(double x, double extent) {
    const double edge = 0.25 * extent;
    const double from_end = std::min(x, extent - x);
    if (from_end >= edge) return {};
    const Envelope e = envelope(from_end, 2.0 * edge);
    return {e.value, x < extent - x ? e.slope : -e.slope};
}

/// The amplitude of a potential, as large as a given one, whose mode moves in that direction across its wave
/// in which its velocity along the flow is most against its vertical one: of all of its energy it carries the
/// largest stress.
Vector3 stressed_amplitude(const Vector3& amplitude, const Vector3& wave) {
    const double size = std::hypot(wave[0], wave[1], wave[2]);
    const double flat = std::hypot(wave[0], wave[1]) / size;
    if (flat < 1e-6) return amplitude;  // an upright wave moves level
    const Vector3 k{wave[0] / size, wave[1] / size, wave[2] / size};
    const Vector3 level{-k[1] / flat, k[0] / flat, 0.0};
    const Vector3 steep{-k[0] * k[2] / flat, -k[1] * k[2] / flat, flat};
    // Of cos(t) level + sin(t) steep the product u w is (p sin(2t) + q (1 - cos(2t))) / 2, least at this
    // angle.
    const double p = level[0] * steep[2];
    const double q = steep[0] * steep[2];
    const double t = 0.5 * std::atan2(-p, q);
    Vector3 v{};
    for (std::size_t i = 0; i < 3; ++i) v[i] = std::cos(t) * level[i] + std::sin(t) * steep[i];
    const double length = std::hypot(amplitude[0], amplitude[1], amplitude[2]);
    return {length * (k[1] * v[2] - k[2] * v[1]), length * (k[2] * v[0] - k[0] * v[2]),
            length * (k[0] * v[1] - k[1] * v[0])};
}

/// Random modes; a wave number along a periodic axis is a multiple of that of its period.
class Modes {
  public:
    /// \param stressed whether each mode carries as much stress as its energy allows.
    Modes(const Case& c, double thickest, double thinnest, bool stressed)
        : space_(c.channel.dimensions == 3) {
        // As the jitter's, but another sequence of numbers.
        std::mt19937_64 generator(static_cast<std::uint64_t>(c.start.seed) ^ 0x9e3779b97f4a7c15ULL);
        const auto unit = [&] { return unit_fraction(generator()); };
        const bool round = c.channel.ends == Ends::periodic;
        const bool round_across = c.channel.sides == Sides::periodic;
        constexpr int number = 96;
        modes_.resize(number);
        for (int m = 0; m < number; ++m) {
            // Spread evenly over the logarithm of the wave length.
            const double length = thickest * std::pow(thinnest / thickest, (m + unit()) / number);
            const double size = 2.0 * std::numbers::pi / length;
            const double rise = space_ ? 2.0 * unit() - 1.0 : std::sin(2.0 * std::numbers::pi * unit());
            const double flat = std::sqrt(1.0 - rise * rise);
            const double angle = space_ ? 2.0 * std::numbers::pi * unit() : 0.0;
            Mode& mode = modes_[static_cast<std::size_t>(m)];
            mode.wave = {size * flat * std::cos(angle), space_ ? size * flat * std::sin(angle) : 0.0,
                         size * rise};
            const auto whole = [](double wave, double period) {
                const double lowest = 2.0 * std::numbers::pi / period;
                return lowest * std::round(wave / lowest);
            };
            if (round) mode.wave[0] = whole(mode.wave[0], c.channel.length);
            if (space_ && round_across) mode.wave[1] = whole(mode.wave[1], c.channel.width);
            mode.phase = 2.0 * std::numbers::pi * unit();
            // The velocity of each mode is as large as that of the others.
            for (std::size_t k = 0; k < 3; ++k) {
                mode.amplitude[k] = (space_ || k == 1) ? (2.0 * unit() - 1.0) / size : 0.0;
            }
            if (stressed) mode.amplitude = stressed_amplitude(mode.amplitude, mode.wave);
        }
    }

    /// Curl of the potential under an envelope of given gradient.
    [[nodiscard]] Vector3 curl(const Vector3& x, double envelope, const Vector3& slope) const {
        Vector3 result{};
        for (const Mode& mode : modes_) {
            const double angle = mode.wave[0] * x[0] + mode.wave[1] * x[1] + mode.wave[2] * x[2] + mode.phase;
            const double cosine = std::cos(angle);
            const double sine = std::sin(angle);
            Vector3 gradient{};
            for (std::size_t k = 0; k < 3; ++k) {
                gradient[k] = slope[k] * cosine - envelope * mode.wave[k] * sine;
            }
            const Vector3& a = mode.amplitude;
            result[0] += gradient[1] * a[2] - gradient[2] * a[1];
            result[1] += gradient[2] * a[0] - gradient[0] * a[2];
            result[2] += gradient[0] * a[1] - gradient[1] * a[0];
        }
        if (!space_) result[1] = 0.0;
        return result;
    }

  private:
    bool space_;
    std::vector<Mode> modes_;
};

/// Share of streaks in the energy of a perturbation that has them.
constexpr double share_of_streaks = 2.0 / 3.0;

/// Add a field to the velocity of the particles, with a mean of zero and a root mean square of one component.
template <int D, typename Field>
void add_velocity(const Case& c, const Field& field, double root_mean_square, Particles<D>& particles) {
    const std::size_t n = particles.size();
    const double depth = c.total_depth();
    const double width = c.channel.simulated_width();
    const bool with_streaks = starts_with_streaks(c);
    std::vector<Vec<D>> velocity(n);
    Vec<D> momentum{};
    double mass = 0.0;
    for (std::size_t i = 0; i < n; ++i) {
        const auto place = [&](std::size_t k) { return particles.position[k][i]; };
        const Vector3 x{place(0), D == 3 ? place(1) : 0.0, place(D - 1)};
        const Envelope up = with_streaks ? flat_envelope(x[2], depth) : envelope(x[2], depth);
        const Envelope along = c.channel.ends == Ends::walls ? envelope(x[0], c.channel.length) : Envelope{};
        Envelope across;
        if (D == 3 && c.channel.sides == Sides::walls) across = envelope(x[1], width);
        // The middle of a half channel is the other end of an envelope twice as wide.
        if (D == 3 && c.channel.sides == Sides::half) across = envelope(x[1], width);
        const Vector3 u =
            field.curl(x, up.value * along.value * across.value,
                       {along.slope * up.value * across.value, across.slope * up.value * along.value,
                        up.slope * along.value * across.value});
        for (std::size_t k = 0; k < D; ++k) {
            velocity[i][k] = u[D == 2 && k == 1 ? 2 : k];
            momentum[k] += particles.mass[i] * velocity[i][k];
        }
        mass += particles.mass[i];
    }
    double squares = 0.0;
    for (Vec<D>& u : velocity) {
        for (std::size_t k = 0; k < D; ++k) {
            u[k] -= momentum[k] / mass;
            squares += u[k] * u[k] / D;
        }
    }
    const double scale = root_mean_square / std::sqrt(squares / static_cast<double>(n));
    for (std::size_t i = 0; i < n; ++i) {
        for (std::size_t k = 0; k < D; ++k) particles.velocity[k][i] += scale * velocity[i][k];
    }
}

}  // namespace

double start_perturbation(const Case& c) {
    if (c.start.perturbation) return *c.start.perturbation;
    const double friction_velocity = std::sqrt(std::max(0.0, c.streamwise_gravity() * c.channel.depth));
    // Enough to trip the eddies, which else grow from the rounding of the arithmetic.
    if (resolves_eddies(c) && c.start.kind != StartKind::results) return friction_velocity;
    const bool quiet = c.channel.dimensions == 2 && has_spheres(c.bed) && c.channel.ends == Ends::periodic &&
                       c.channel.top == Top::free_surface && c.solids.empty() &&
                       c.numerics.preset == Preset::riffle;
    const bool flows = c.start.kind == StartKind::column || c.start.kind == StartKind::uniform ||
                       c.start.kind == StartKind::power_law;
    if (!quiet || !flows) return 0.0;
    return 0.25 * friction_velocity;
}

template <int D>
void perturb_velocity(const Case& c, Particles<D>& particles) {
    const double wanted = start_perturbation(c);
    if (wanted == 0.0 || particles.size() == 0) return;
    const double depth = c.total_depth();
    const double width = c.channel.simulated_width();
    const double thickest = std::min({depth, c.channel.length, D == 3 ? width : depth});
    // Of many rows over the depth, smaller eddies would shear the water so much that its mixing length, which
    // does not fall with the spacing, makes it stiffer than the step allows.
    const double thinnest = std::min(std::max(8.0 * c.numerics.spacing, depth / 8.0), thickest);
    const bool with_streaks = starts_with_streaks(c);
    const Modes modes(c, thickest, thinnest, with_streaks);
    if (!with_streaks) {
        add_velocity(c, modes, wanted, particles);
        return;
    }
    const StartStreaks streaks(c, depth, width);
    add_velocity(c, modes, wanted * std::sqrt(1.0 - share_of_streaks), particles);
    add_velocity(c, streaks, wanted * std::sqrt(share_of_streaks), particles);
}

template void perturb_velocity<2>(const Case&, Particles<2>&);
template void perturb_velocity<3>(const Case&, Particles<3>&);

}  // namespace riffle::inline solver
