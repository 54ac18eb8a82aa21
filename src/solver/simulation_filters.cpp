// Density filters, XSPH and crowds: what takes sums of W over the neighbours, beside the steps.

#include "solver/simulation_of.hpp"
#include "sph/crowding.hpp"

namespace riffle {

namespace {

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
        if (!(a[p][p] > 1e-6 * get(f.zeroth))) {
            return shepard;
        }
        for (std::size_t row = 0; row < n; ++row) {
            if (row == p) {
                continue;
            }
            const double factor = a[row][p] / a[p][p];
            for (std::size_t col = p; col <= n; ++col) {
                a[row][col] -= factor * a[p][col];
            }
        }
    }
    double density = get(f.mass) * a[0][n] / a[0][0];
    for (std::size_t k = 0; k + 1 < n; ++k) {
        density += get(f.mass_first[k]) / h * a[k + 1][n] / a[k + 1][k + 1];
    }
    return density;
}

}  // namespace

template <int D, class Real>
template <class F>
void SimulationOf<D, Real>::for_filter_blocks(const F& f) {
    for_blocks(clusters_.size(), [&](Task& task, std::size_t begin, std::size_t end) {
        loops_.filter(data_, begin, end, task.sums);
        for_clusters(begin, end, [&](std::size_t first, std::size_t last, std::size_t lane) {
            for (std::size_t i = first; i < last; ++i) {
                f(task.sums.filter, i, lane + (i - first));
            }
        });
    });
}

template <int D, class Real>
void SimulationOf<D, Real>::filter_density() {
    const bool mls = case_.numerics.density_filter == DensityFilter::mls;
    for_filter_blocks([&](const FilterResult<D, Real>& sums, std::size_t particle, std::size_t lane) {
        // Shepard: rho = sum m W / sum V W.
        const double density =
            mls ? moving_least_squares<D, Real>(sums, lane, scheme_.smoothing_length)
                : static_cast<double>(sums.mass[lane]) / static_cast<double>(sums.zeroth[lane]);
        particles_.density_deviation[particle] = density - 1.0;
    });
}

template <int D, class Real>
bool SimulationOf<D, Real>::dissolves_crowds() const {
    return case_.numerics.impact_dissipation > 0.0 && clock_.steps % crowding_interval == 0;
}

template <int D, class Real>
void SimulationOf<D, Real>::dissolve_crowds(double dt) {
    const double turns = crowding_interval * dt * scheme_.state.sound_speed / scheme_.smoothing_length;
    for_filter_blocks([&](const FilterResult<D, Real>& sums, std::size_t particle, std::size_t lane) {
        particles_.density_deviation[particle] +=
            turns * crowding_rate(static_cast<double>(sums.zeroth[lane]));
    });
    repack();
}

template <int D, class Real>
void SimulationOf<D, Real>::sweep_smoothed_velocity() {
    for (auto& component : smoothed_velocity_) {
        component.resize(particles_.size());
    }
    for_filter_blocks([&](const FilterResult<D, Real>& sums, std::size_t particle, std::size_t lane) {
        for (std::size_t k = 0; k < axes; ++k) {
            smoothed_velocity_[k][particle] =
                case_.numerics.xsph * static_cast<double>(sums.velocity[k][lane]);
        }
    });
}

template class SimulationOf<2, float>;
template class SimulationOf<2, double>;
template class SimulationOf<3, float>;
template class SimulationOf<3, double>;

}  // namespace riffle
