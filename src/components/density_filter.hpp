#pragma once

#include "engine/component.hpp"

namespace riffle::inline components {

/// MLS estimate of the density at a particle (Dilts; Colagrossi & Landrini 2003): rho = sum m W (b0 + b.r), A
/// b = e0, lengths in h; from the moments of one lane. Shepard's mean where the neighbours (spray) span no
/// space.
template <int D, class Real>
double moving_least_squares(const FilterResult<D, Real>& f, std::size_t lane, double h) {
    constexpr auto n = static_cast<std::size_t>(D) + 1;
    // A with the right-hand side e0 as the last column, eliminated with the pivot on the diagonal: A is
    // positive.
    std::array<std::array<double, n + 1>, n> a{};
    const auto get = [&](const LaneArray<Real>& values) { return static_cast<double>(values[lane]); };
    a[0][0] = get(f.zeroth);
    std::size_t kl = 0;
    for (std::size_t k = 0; k + 1 < n; ++k) {
        a[0][k + 1] = get(f.first[k]) / h;
        a[k + 1][0] = a[0][k + 1];
        for (std::size_t l = k; l + 1 < n; ++l, ++kl) {
            a[k + 1][l + 1] = get(f.second[kl]) / (h * h);
            a[l + 1][k + 1] = a[k + 1][l + 1];
        }
    }
    a[0][n] = 1.0;
    const double shepard = get(f.mass) / get(f.zeroth);
    for (std::size_t p = 0; p < n; ++p) {
        if (!(a[p][p] > 1e-6 * get(f.zeroth))) return shepard;
        for (std::size_t row = 0; row < n; ++row) {
            if (row == p) continue;
            const double factor = a[row][p] / a[p][p];
            for (std::size_t col = p; col <= n; ++col) a[row][col] -= factor * a[p][col];
        }
    }
    double density = get(f.mass) * a[0][n] / a[0][0];
    for (std::size_t k = 0; k + 1 < n; ++k) {
        density += get(f.mass_first[k]) / h * a[k + 1][n] / a[k + 1][k + 1];
    }
    return density;
}

/// Each so many steps, density anew from the masses around: Shepard's mean or moving least squares.
template <int D, class Real>
class DensityFilterComponent final : public Component<D, Real> {
  public:
    using typename Component<D, Real>::Flow;

    void before_step(Flow& flow) override {
        flow.density_filtered =
            flow.clock.steps > 0 && flow.clock.steps % flow.c.numerics.density_filter_interval == 0;
        if (!flow.density_filtered) return;
        const bool mls = flow.c.numerics.density_filter == DensityFilter::mls;
        flow.for_moments([&](const FilterResult<D, Real>& sums, std::size_t particle, std::size_t lane) {
            // Shepard: rho = sum m W / sum V W.
            const double density =
                mls ? moving_least_squares<D, Real>(sums, lane, flow.scheme.smoothing_length)
                    : static_cast<double>(sums.mass[lane]) / static_cast<double>(sums.zeroth[lane]);
            flow.particles.density_deviation[particle] = density - 1.0;
        });
        flow.repack();
    }
};

template <int D, class Real>
std::unique_ptr<Component<D, Real>> make_density_filter(FlowOf<D, Real>& flow) {
    return flow.c.numerics.density_filter != DensityFilter::none
               ? std::make_unique<DensityFilterComponent<D, Real>>()
               : nullptr;
}

}  // namespace riffle::inline components
