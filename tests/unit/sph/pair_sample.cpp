#include "pair_sample.hpp"

#include <cmath>
#include <random>

namespace riffle {

template <int D>
Vec<D> PairSample<D>::difference(const Vec<D>& a, const Vec<D>& b) const {
    Vec<D> r{};
    for (std::size_t k = 0; k < D; ++k) {
        r[k] = a[k] - b[k];
        if (domain.periodic[k]) {
            const double period = domain.extent(static_cast<int>(k));
            r[k] -= period * std::nearbyint(r[k] / period);
        }
    }
    return r;
}

template <int D>
double PairSample<D>::volume() const {
    double sum = 0.0;
    for (const Particle& p : fluid) sum += p.volume;
    return sum;
}

template <int D>
bool PairSample<D>::far_from_seams(const Particle& p) const {
    bool far = true;
    for (std::size_t k = 0; k < D; ++k) {
        const double edge = domain.periodic[k] ? 2.0 * h : 0.0;
        far = far && p.x[k] > domain.lower[k] + edge && p.x[k] < domain.upper[k] - edge;
    }
    return far;
}

template <int D>
PairSample<D> disordered_sample(double jitter, int layers, unsigned seed) {
    constexpr double spacing = PairSample<D>::spacing;
    constexpr std::size_t vertical = D - 1;
    constexpr int columns = D == 2 ? 16 : 8;
    constexpr int files = D == 2 ? 1 : 8;
    constexpr int rows = D == 2 ? 10 : 8;
    PairSample<D> sample;
    const bool periodic = layers == 0;
    sample.h = 1.5 * spacing;
    for (std::size_t k = 0; k < D; ++k) {
        sample.domain.upper[k] = columns * spacing;
        sample.domain.periodic[k] = true;
    }
    sample.domain.lower[vertical] = periodic ? 0.0 : -8.0 * spacing;
    sample.domain.upper[vertical] = (periodic ? 1.0 : 2.0) * rows * spacing;
    sample.domain.periodic[vertical] = periodic;
    sample.fixed_point = FixedPoint<D>(sample.domain);
    std::mt19937 generator(seed);
    std::uniform_real_distribution<double> uniform(-1.0, 1.0);
    // Positions on the grid of the fixed point, so that its rounding is no difference between the two sums.
    const auto on_grid = [&](double x, std::size_t k) {
        if (sample.domain.periodic[k]) {
            const double period = sample.domain.extent(static_cast<int>(k));
            x -= period * std::floor(x / period);
        }
        return sample.fixed_point.decode(sample.fixed_point.encode(x, k), k);
    };
    const auto add = [&](int column, int file, int row) {
        typename PairSample<D>::Particle p;
        const bool wall = row < 0;
        p.x[0] = (column + 0.5) * spacing;
        if constexpr (D == 3) p.x[1] = (file + 0.5) * spacing;
        p.x[vertical] = (row + 0.5) * spacing;
        for (std::size_t k = 0; k < D; ++k) {
            p.x[k] = on_grid(p.x[k] + (wall ? 0.0 : jitter * spacing * uniform(generator)), k);
            p.u[k] = uniform(generator);
        }
        p.s = 0.01 * uniform(generator);
        p.volume = std::pow(spacing, D) * (1.0 + 0.05 * uniform(generator));
        p.pressure = 0.5 + 0.3 * uniform(generator);
        p.viscosity_root = 0.1 * std::abs(uniform(generator));
        for (std::size_t k = 0; k < D * D; ++k) {
            const bool diagonal = k % (D + 1) == 0;
            p.stress[k] = wall ? (diagonal ? p.pressure : 0.0) : uniform(generator);
            p.projector[k] = k == D * D - 1 ? 0.9 : (diagonal ? 0.3 : 0.1);
        }
        p.continuation = wall && column < columns / 2 ? 1.0 : 0.0;
        p.continuation_along = D == 2 || column < columns / 4 ? p.continuation : 0.0;
        (wall ? sample.wall : sample.fluid).push_back(p);
    };
    for (int column = 0; column < columns; ++column) {
        for (int file = 0; file < files; ++file) {
            for (int row = -layers; row < rows; ++row) add(column, file, row);
        }
    }
    return sample;
}

template struct PairSample<2>;
template struct PairSample<3>;
template PairSample<2> disordered_sample<2>(double, int, unsigned);
template PairSample<3> disordered_sample<3>(double, int, unsigned);

}  // namespace riffle
