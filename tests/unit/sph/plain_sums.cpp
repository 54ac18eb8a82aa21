#include "plain_sums.hpp"

#include <algorithm>
#include <boost/math/quadrature/gauss.hpp>
#include <cmath>
#include <complex>
#include <map>
#include <numbers>
#include <utility>

namespace riffle {

namespace {

using std::numbers::pi;

/// W and dW/dr of the kernels, written down again.
struct KernelValue {
    double w = 0.0;
    double slope = 0.0;
};

/// W without its constant, q < 2, of the kernels that the loops take from a table; for complex q too.
template <class T>
T shape(KernelKind kind, T q) {
    using std::exp;
    using std::pow;
    const T t = 1.0 - 0.5 * q;
    switch (kind) {
        case KernelKind::gaussian:
            return exp(-2.25 * q * q) - std::exp(-9.0);
        case KernelKind::quadratic:
            return 0.1875 * q * q - 0.75 * q + 0.75;
        case KernelKind::quintic_spline: {
            const double real = std::real(std::complex<double>(q));
            T sum = pow(3.0 - 1.5 * q, 5);
            if (1.5 * real < 2.0) sum -= 6.0 * pow(2.0 - 1.5 * q, 5);
            if (1.5 * real < 1.0) sum += 15.0 * pow(1.0 - 1.5 * q, 5);
            return sum;
        }
        case KernelKind::wendland_c4:
            return pow(t, 6) * (35.0 / 12.0 * q * q + 3.0 * q + 1.0);
        case KernelKind::wendland_c6:
            return pow(t, 8) * (4.0 * q * q * q + 6.25 * q * q + 4.0 * q + 1.0);
        default:
            return T(0);
    }
}

/// The constant by which the kernel integrates to one in D dimensions, h = 1.
template <int D>
double integrated_constant(KernelKind kind) {
    const auto shell = [&](double q) { return shape(kind, q) * (D == 2 ? 2.0 * pi * q : 4.0 * pi * q * q); };
    double integral = 0.0;
    for (int piece = 0; piece < 6; ++piece) {
        integral +=
            boost::math::quadrature::gauss<double, 15>::integrate(shell, piece / 3.0, (piece + 1) / 3.0);
    }
    return 1.0 / integral;
}

/// The same, integrated once: every pair asks for it.
template <int D>
double constant_of(KernelKind kind) {
    static std::map<KernelKind, double> constants;
    const auto found = constants.find(kind);
    return found != constants.end() ? found->second
                                    : constants.emplace(kind, integrated_constant<D>(kind)).first->second;
}

template <int D>
KernelValue kernel_value(KernelKind kind, double r, double h) {
    const double q = r / h;
    if (q >= 2.0) {
        return {};
    }
    if (kind == KernelKind::wendland_c2) {
        const double a = (D == 2 ? 7.0 / (4.0 * pi) : 21.0 / (16.0 * pi)) / std::pow(h, D);
        const double t = 1.0 - 0.5 * q;
        return {a * std::pow(t, 4) * (2.0 * q + 1.0), -5.0 * a * q * std::pow(t, 3) / h};
    }
    if (kind == KernelKind::cubic_spline) {
        const double a = (D == 2 ? 10.0 / (7.0 * pi) : 1.0 / pi) / std::pow(h, D);
        if (q < 1.0) {
            return {a * (1.0 - 1.5 * q * q + 0.75 * q * q * q), a * (-3.0 * q + 2.25 * q * q) / h};
        }
        return {0.25 * a * std::pow(2.0 - q, 3), -0.75 * a * (2.0 - q) * (2.0 - q) / h};
    }
    const double a = constant_of<D>(kind) / std::pow(h, D);
    constexpr double step = 1e-100;  // the derivative by a complex step
    return {a * shape(kind, q), a * shape(kind, std::complex<double>(q, step)).imag() / step / h};
}

/// Geometry and kernel of a pair.
template <int D>
struct Pair {
    Vec<D> r{};
    double distance = 0.0;
    double w = 0.0;
    double slope = 0.0;
    Vec<D> gradient{};
};

/// The sums as they grow.
template <int D>
class Summation {
  public:
    using Particle = typename PairSample<D>::Particle;

    Summation(const PairSample<D>& sample, const PlainOptions& options, const Corrections<D>& correction)
        : sample_(sample), options_(options), correction_(correction) {
        const std::size_t n = sample.fluid.size();
        const std::size_t m = sample.wall.size();
        const auto resize = [](auto& arrays, std::size_t size) {
            for (auto& array : arrays) array.resize(size);
        };
        for (auto* array :
             {&sums.density_rate, &sums.midway_density_rate, &sums.diffusion, &sums.zeroth, &sums.mass}) {
            array->resize(n);
        }
        resize(sums.gradient, n);
        for (auto* arrays : {&sums.m_fluid, &sums.m_wall, &sums.m_continued, &sums.m_along, &sums.second}) {
            resize(*arrays, n);
        }
        for (auto* arrays :
             {&sums.tensor, &sums.viscous, &sums.wall, &sums.first, &sums.mass_first, &sums.velocity}) {
            resize(*arrays, n);
        }
        for (auto* array : {&sums.wall_weight, &sums.wall_pressure, &sums.wall_density_rate}) {
            array->resize(m);
        }
        resize(sums.wall_offset, m);
        resize(sums.wall_velocity, m);
    }

    /// Call f for each pair within the support.
    template <class F>
    void for_pairs(const std::vector<Particle>& i, const std::vector<Particle>& j, const F& f) {
        for (std::size_t n = 0; n < i.size(); ++n) {
            for (const Particle& b : j) {
                const Vec<D> r = sample_.difference(i[n].x, b.x);
                double squared = 0.0;
                for (const double component : r) squared += component * component;
                if (squared < 4.0 * sample_.h * sample_.h) f(n, i[n], b, pair_of(r, std::sqrt(squared)));
            }
        }
    }

    void add_fluid(std::size_t i, const Particle& a, const Particle& b, const Pair<D>& p) {
        const double V = b.volume;
        for (std::size_t k = 0; k < D; ++k) {
            const double u = a.u[k] - b.u[k];
            sums.density_rate[i].add(V * u * p.gradient[k]);
            sums.tensor[k][i].add(
                -V * (dissipation(a, b, p) + repulsion(a, b, p) - options_.non_conservative * a.pressure) *
                p.gradient[k]);
            for (std::size_t l = 0; l < D; ++l) {
                sums.gradient[D * k + l][i].add(-V * u * p.gradient[l]);
                sums.tensor[k][i].add(-V * (a.stress[D * k + l] + b.stress[D * k + l]) * p.gradient[l]);
            }
            sums.viscous[k][i].add(viscous_force(a, b, p, k));
            sums.first[k][i].add(V * p.w * p.r[k]);
            sums.mass_first[k][i].add(V * (1.0 + b.s) * p.w * p.r[k]);
            sums.velocity[k][i].add(-V * p.w * u);
        }
        if (p.distance > 0.0) {
            sums.diffusion[i].add(options_.diffusion * 2.0 * V *
                                  (a.s - b.s + options_.hydrostatic_gradient * p.r[D - 1]) * p.slope /
                                  p.distance);
        }
        sums.zeroth[i].add(V * p.w);
        sums.mass[i].add(V * (1.0 + b.s) * p.w);
        add_moment(sums.m_fluid, i, V, p);
        for (std::size_t k = 0, n = 0; k < D; ++k) {
            for (std::size_t l = k; l < D; ++l, ++n) sums.second[n][i].add(V * p.w * p.r[k] * p.r[l]);
        }
    }

    void add_wall(std::size_t i, const Particle& a, const Particle& b, const Pair<D>& p) {
        const double V = b.volume;
        const bool continued = b.continuation > 0.0;
        const bool along = b.continuation_along > 0.0;
        add_moment(continued ? sums.m_continued : sums.m_wall, i, V, p);
        if (along) add_moment(sums.m_along, i, V, p);
        const double pressure =
            a.pressure + b.pressure + repulsion(a, b, p) - options_.non_conservative * a.pressure;
        for (std::size_t k = 0; k < D; ++k) {
            for (std::size_t l = 0; l < D; ++l) {
                sums.density_rate[i].add(V * b.projector[D * k + l] * a.u[l] * p.gradient[k]);
                const double identity = k == l ? 1.0 : 0.0;
                const bool corrected = k == 0 ? along : continued;
                const double matrix = corrected ? correction_[i][D * k + l] : identity;
                const double force = -V * pressure * matrix * p.gradient[l];
                sums.tensor[k][i].add(force);
                sums.wall[k][i].add(force);
            }
            const double force = viscous_force(a, b, p, k);
            sums.viscous[k][i].add(force);
            sums.wall[k][i].add(force);
        }
    }

    /// The continuity sum of pairs that have come straight to where they are; a wall counts with the part of
    /// the particle's velocity that its projector takes.
    void add_midway() {
        for (std::size_t n = 0; n < sample_.fluid.size(); ++n) {
            const Particle& a = sample_.fluid[n];
            const auto add = [&](const Particle& b, const Vec<D>& u) {
                Vec<D> r = sample_.difference(a.x, b.x);
                double squared = 0.0;
                for (std::size_t k = 0; k < D; ++k) {
                    r[k] -= options_.ago * u[k];
                    squared += r[k] * r[k];
                }
                if (squared < 4.0 * sample_.h * sample_.h) {
                    const Pair<D> p = pair_of(r, std::sqrt(squared));
                    for (std::size_t k = 0; k < D; ++k) {
                        sums.midway_density_rate[n].add(b.volume * u[k] * p.gradient[k]);
                    }
                }
            };
            for (const Particle& b : sample_.fluid) {
                Vec<D> u{};
                for (std::size_t k = 0; k < D; ++k) u[k] = a.u[k] - b.u[k];
                add(b, u);
            }
            for (const Particle& b : sample_.wall) {
                Vec<D> u{};
                for (std::size_t k = 0; k < D; ++k) {
                    for (std::size_t l = 0; l < D; ++l) u[k] += b.projector[D * k + l] * a.u[l];
                }
                add(b, u);
            }
        }
    }

    /// a is a particle of the wall.
    void extrapolate(std::size_t i, const Particle& b, const Pair<D>& p) {
        const double w = p.w * std::pow(sample_.h, D);  // the loops leave h^-D out
        sums.wall_weight[i].add(w);
        sums.wall_pressure[i].add(w * b.pressure);
        for (std::size_t k = 0; k < D; ++k) {
            sums.wall_offset[k][i].add(w * p.r[k]);
            sums.wall_velocity[k][i].add(w * b.u[k]);
            sums.wall_density_rate[i].add(-b.volume * b.u[k] * p.gradient[k]);
        }
    }

    PlainSums<D> sums;

  private:
    Pair<D> pair_of(const Vec<D>& r, double distance) const {
        const KernelValue k = kernel_value<D>(options_.kernel, distance, sample_.h);
        Pair<D> pair{.r = r, .distance = distance, .w = k.w, .slope = k.slope};
        for (std::size_t c = 0; c < D; ++c) {
            pair.gradient[c] = distance > 0.0 ? k.slope * r[c] / distance : 0.0;
        }
        return pair;
    }

    /// u.r
    static double scalar_product(const Particle& a, const Particle& b, const Pair<D>& p) {
        double sum = 0.0;
        for (std::size_t k = 0; k < D; ++k) sum += (a.u[k] - b.u[k]) * p.r[k];
        return sum;
    }

    /// Of the Riemann problem: rho_ij beta (U_l - U_r), beta = min(3 max(U_l - U_r, 0), c0).
    double dissipation(const Particle& a, const Particle& b, const Pair<D>& p) const {
        if (p.distance == 0.0) return 0.0;
        const double difference = -scalar_product(a, b, p) / p.distance;
        const double beta = std::min(options_.impact * std::max(difference, 0.0), options_.impact_bound);
        return (1.0 + 0.5 * (a.s + b.s)) * beta * difference;
    }

    /// Monaghan (2000): R f^4, f = W(r)/W(dx).
    double repulsion(const Particle& a, const Particle& b, const Pair<D>& p) const {
        if (options_.tensile == 0.0) return 0.0;
        const double f = p.w / kernel_value<D>(options_.kernel, PairSample<D>::spacing, sample_.h).w;
        double r = 0.01 * (a.pressure + b.pressure);
        if (a.pressure < 0.0 || b.pressure < 0.0) {
            r = options_.tensile *
                ((a.pressure < 0.0 ? -a.pressure : 0.0) + (b.pressure < 0.0 ? -b.pressure : 0.0));
        }
        return r * std::pow(f, 4);
    }

    /// Component of the two-point viscosity.
    double viscous_force(const Particle& a, const Particle& b, const Pair<D>& p,
                         std::size_t component) const {
        if (p.distance == 0.0) return 0.0;
        const double root = 0.5 * (a.viscosity_root + b.viscosity_root);
        const double twice = 2.0 * root * root;
        if (D == 3 && options_.weighted) {
            const DirectionalViscosity<double>& weights = options_.directional;
            const double across = p.r[1] / p.distance;
            const double k =
                (component == 1 ? weights.level_across : weights.level) - weights.slope * across * across;
            return b.volume * (weights.molecular + k * (twice - weights.molecular)) * p.slope / p.distance *
                   (a.u[component] - b.u[component]);
        }
        const double softened = p.distance * p.distance + 0.01 * sample_.h * sample_.h;
        const double approach = scalar_product(a, b, p);
        switch (options_.viscosity) {
            case ViscosityForm::morris:
                return b.volume * twice * p.slope / p.distance * (a.u[component] - b.u[component]);
            case ViscosityForm::lo_shao:
                return b.volume * twice * p.slope * p.distance / softened * (a.u[component] - b.u[component]);
            case ViscosityForm::artificial:
                return approach < 0.0 ? b.volume * twice * approach / softened * p.gradient[component] : 0.0;
            case ViscosityForm::monaghan_gingold:
                break;
        }
        return (D + 2) * b.volume * twice * approach / (p.distance * p.distance) * p.gradient[component];
    }

    static void add_moment(typename PlainSums<D>::SymmetricMatrices& moment, std::size_t i, double V,
                           const Pair<D>& p) {
        for (std::size_t k = 0, n = 0; k < D; ++k) {
            for (std::size_t l = k; l < D; ++l, ++n) moment[n][i].add(-V * p.r[k] * p.gradient[l]);
        }
    }

    const PairSample<D>& sample_;
    const PlainOptions& options_;
    const Corrections<D>& correction_;
};

}  // namespace

void PlainSum::add(double term) {
    value += term;
    magnitude += std::abs(term);
}

template <int D>
PlainSums<D> plain_sums(const PairSample<D>& sample, const PlainOptions& options,
                        const Corrections<D>& correction) {
    Summation<D> sum(sample, options, correction);
    sum.for_pairs(
        sample.fluid, sample.fluid,
        [&](std::size_t i, const auto& a, const auto& b, const auto& p) { sum.add_fluid(i, a, b, p); });
    sum.for_pairs(sample.fluid, sample.wall, [&](std::size_t i, const auto& a, const auto& b, const auto& p) {
        sum.add_wall(i, a, b, p);
    });
    sum.add_midway();
    sum.for_pairs(sample.wall, sample.fluid, [&](std::size_t i, const auto&, const auto& b, const auto& p) {
        sum.extrapolate(i, b, p);
    });
    return std::move(sum.sums);
}

template PlainSums<2> plain_sums<2>(const PairSample<2>&, const PlainOptions&, const Corrections<2>&);
template PlainSums<3> plain_sums<3>(const PairSample<3>&, const PlainOptions&, const Corrections<3>&);

}  // namespace riffle
