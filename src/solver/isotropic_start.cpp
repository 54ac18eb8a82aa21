#include "solver/isotropic_start.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <numbers>

#include "base/parallel.hpp"
#include "base/unit_fraction.hpp"
#include "engine/energy_spectrum.hpp"
#include "particles/lattice.hpp"
#include "statistics/fourier.hpp"

namespace riffle::inline solver {

namespace {

using Vector3 = std::array<double, 3>;
using Mode = std::array<int, 3>;  ///< waves over each extent of the box

/// A periodic grid over the box, x fastest.
struct Grid {
    std::array<std::size_t, 3> points;
    Vector3 extent;

    /// Twice as fine as the lattice: it then holds products of two of its modes, and cubic interpolation
    /// keeps all but the smallest waves.
    explicit Grid(const Case& c) : extent{c.channel.length, c.channel.width, c.total_depth()} {
        const Lattice lattice = lattice_of(c);
        const std::array<int, 3> places{lattice.columns, lattice.files, lattice.rows};
        for (std::size_t d = 0; d < 3; ++d) points[d] = fast_length(2 * static_cast<std::size_t>(places[d]));
    }
    [[nodiscard]] std::size_t size() const { return points[0] * points[1] * points[2]; }
    [[nodiscard]] std::size_t index(const std::array<std::size_t, 3>& at) const {
        return (at[2] * points[1] + at[1]) * points[0] + at[0];
    }
    [[nodiscard]] std::size_t place_of(const Mode& mode) const {
        std::array<std::size_t, 3> at{};
        for (std::size_t d = 0; d < 3; ++d) {
            const auto n = static_cast<std::ptrdiff_t>(points[d]);
            at[d] = static_cast<std::size_t>((mode[d] + n) % n);
        }
        return index(at);
    }
    /// The mode whose amplitude stands at a place of the transform.
    [[nodiscard]] Mode mode(std::size_t place) const {
        Mode result{};
        for (std::size_t d = 0; d < 3; ++d) {
            const auto at = static_cast<int>(place % points[d]);
            const auto n = static_cast<int>(points[d]);
            result[d] = 2 * at < n ? at : at - n;
            place /= points[d];
        }
        return result;
    }
    [[nodiscard]] Vector3 wave(const Mode& mode) const {
        Vector3 k{};
        for (std::size_t d = 0; d < 3; ++d) k[d] = 2.0 * std::numbers::pi / extent[d] * mode[d];
        return k;
    }
    void to_space(std::vector<Complex>& values) const {
        inverse_fourier_transform_3d(values, points[2], points[1], points[0]);
    }
    void to_modes(std::vector<Complex>& values) const {
        fourier_transform_3d(values, points[2], points[1], points[0]);
    }
};

double size(const Vector3& v) { return std::hypot(v[0], v[1], v[2]); }

/// Numbers between 0 and 1 that belong to one mode: the splitmix64 sequence (Steele, Lea & Flood 2014) from
/// its key.
class ModeNumbers {
  public:
    ModeNumbers(long long seed, const Mode& mode) : state_(static_cast<std::uint64_t>(seed)) {
        for (const int component : mode) {
            state_ ^= static_cast<std::uint64_t>(static_cast<std::int64_t>(component));
            state_ = next();
        }
    }
    double operator()() { return unit_fraction(next()); }

  private:
    std::uint64_t next() {
        state_ += 0x9e3779b97f4a7c15ULL;
        std::uint64_t z = state_;
        z = (z ^ (z >> 30U)) * 0xbf58476d1ce4e5b9ULL;
        z = (z ^ (z >> 27U)) * 0x94d049bb133111ebULL;
        return z ^ (z >> 31U);
    }
    std::uint64_t state_;
};

/// Two unit vectors normal to a wave and to each other.
std::array<Vector3, 2> across(const Vector3& wave) {
    const double k = size(wave);
    const double flat = std::hypot(wave[0], wave[1]);
    const Vector3 first = flat > 0.0 ? Vector3{wave[1] / flat, -wave[0] / flat, 0.0} : Vector3{1.0, 0.0, 0.0};
    const Vector3 second{(wave[1] * first[2] - wave[2] * first[1]) / k,
                         (wave[2] * first[0] - wave[0] * first[2]) / k,
                         (wave[0] * first[1] - wave[1] * first[0]) / k};
    return {first, second};
}

/// Amplitude of the velocity of a mode. The modes of a shell share its energy: |u|^2 / 2 is E(k) / (4 pi k^2)
/// times the volume (2 pi)^3 / V that each has among the wave vectors.
std::array<Complex, 3> amplitude(const Grid& grid, const EnergySpectrum& spectrum, const Mode& mode,
                                 long long seed) {
    const Vector3 wave = grid.wave(mode);
    const double k = size(wave);
    const double volume = grid.extent[0] * grid.extent[1] * grid.extent[2];
    const double whole = 2.0 * std::numbers::pi / k * std::sqrt(spectrum.at(k) / volume);
    ModeNumbers unit(seed, mode);
    const double turn = 2.0 * std::numbers::pi * unit();
    const Complex first = whole * std::cos(turn) * std::polar(1.0, 2.0 * std::numbers::pi * unit());
    const Complex second = whole * std::sin(turn) * std::polar(1.0, 2.0 * std::numbers::pi * unit());
    const std::array<Vector3, 2> direction = across(wave);
    std::array<Complex, 3> result{};
    for (std::size_t d = 0; d < 3; ++d) result[d] = first * direction[0][d] + second * direction[1][d];
    return result;
}

/// Call f for one of each pair of modes k and -k up to a largest wave number.
template <class F>
void for_half_of_modes(const Grid& grid, double largest, const F& f) {
    Mode reach{};
    for (std::size_t d = 0; d < 3; ++d) {
        reach[d] = static_cast<int>(largest * grid.extent[d] / (2.0 * std::numbers::pi));
    }
    for (int n = -reach[2]; n <= reach[2]; ++n) {
        for (int m = -reach[1]; m <= reach[1]; ++m) {
            for (int l = 0; l <= reach[0]; ++l) {
                const bool first_of_two = l > 0 || m > 0 || (m == 0 && n > 0);
                if (first_of_two && size(grid.wave({l, m, n})) <= largest) f(Mode{l, m, n});
            }
        }
    }
}

/// One component of the velocity at the points of the grid.
std::vector<double> component(const Case& c, const Grid& grid, const EnergySpectrum& spectrum,
                              std::size_t direction) {
    const double largest = std::numbers::pi / c.numerics.spacing;
    const auto points = static_cast<double>(grid.size());
    std::vector<Complex> modes(grid.size());
    for_half_of_modes(grid, largest, [&](const Mode& mode) {
        const Complex u = points * amplitude(grid, spectrum, mode, c.start.seed)[direction];
        modes[grid.place_of(mode)] = u;
        modes[grid.place_of(Mode{-mode[0], -mode[1], -mode[2]})] = std::conj(u);
    });
    grid.to_space(modes);
    std::vector<double> result(grid.size());
    for (std::size_t i = 0; i < result.size(); ++i) result[i] = modes[i].real();
    return result;
}

/// Pressure over the density of a velocity without divergence: its Laplacian is -d_i d_j (u_i u_j).
std::vector<double> pressure_of(const Grid& grid, const std::array<std::vector<double>, 3>& velocity) {
    std::vector<Complex> sum(grid.size());
    std::vector<Complex> product(grid.size());
    for (std::size_t a = 0; a < 3; ++a) {
        for (std::size_t b = a; b < 3; ++b) {
            for (std::size_t i = 0; i < product.size(); ++i) product[i] = velocity[a][i] * velocity[b][i];
            grid.to_modes(product);
            const double twice = a == b ? 1.0 : 2.0;
            for (std::size_t i = 1; i < product.size(); ++i) {
                const Vector3 k = grid.wave(grid.mode(i));
                sum[i] -= twice * k[a] * k[b] / (k[0] * k[0] + k[1] * k[1] + k[2] * k[2]) * product[i];
            }
        }
    }
    grid.to_space(sum);
    std::vector<double> result(grid.size());
    for (std::size_t i = 0; i < result.size(); ++i) result[i] = sum[i].real();
    return result;
}

/// Cubic interpolation between the points of the grid (Lagrange's, four in each direction).
class CubicPlace {
  public:
    CubicPlace(const Grid& grid, const Vector3& x) {
        for (std::size_t d = 0; d < 3; ++d) {
            const auto n = static_cast<std::ptrdiff_t>(grid.points[d]);
            const double at = x[d] / grid.extent[d] * static_cast<double>(n);
            const double below = std::floor(at);
            const double s = at - below;
            for (std::ptrdiff_t i = 0; i < 4; ++i) {
                point_[d][static_cast<std::size_t>(i)] =
                    static_cast<std::size_t>(((static_cast<std::ptrdiff_t>(below) + i - 1) % n + n) % n);
            }
            weight_[d] = {-s * (s - 1.0) * (s - 2.0) / 6.0, (s + 1.0) * (s - 1.0) * (s - 2.0) / 2.0,
                          -(s + 1.0) * s * (s - 2.0) / 2.0, (s + 1.0) * s * (s - 1.0) / 6.0};
        }
    }
    [[nodiscard]] double of(const Grid& grid, const std::vector<double>& values) const {
        double sum = 0.0;
        for (std::size_t k = 0; k < 4; ++k) {
            for (std::size_t j = 0; j < 4; ++j) {
                double line = 0.0;
                for (std::size_t i = 0; i < 4; ++i) {
                    line += weight_[0][i] * values[grid.index({point_[0][i], point_[1][j], point_[2][k]})];
                }
                sum += weight_[2][k] * weight_[1][j] * line;
            }
        }
        return sum;
    }

  private:
    std::array<std::array<std::size_t, 4>, 3> point_{};
    std::array<std::array<double, 4>, 3> weight_{};
};

}  // namespace

void start_isotropic(const Case& c, Particles<3>& particles, std::vector<double>& pressure) {
    const EnergySpectrum spectrum(c.start.file);
    const Grid grid(c);
    const std::array<std::vector<double>, 3> velocity{
        component(c, grid, spectrum, 0), component(c, grid, spectrum, 1), component(c, grid, spectrum, 2)};
    const std::vector<double> of_eddies = pressure_of(grid, velocity);
    constexpr std::size_t block = 1024;
    parallel_blocks(particles.size(), block, [&](std::size_t begin, std::size_t end) {
        for (std::size_t i = begin; i < end; ++i) {
            const CubicPlace place(grid, vector_of(particles.position, i));
            for (std::size_t d = 0; d < 3; ++d) particles.velocity[d][i] = place.of(grid, velocity[d]);
            pressure[i] += place.of(grid, of_eddies);
        }
    });
}

}  // namespace riffle::inline solver
