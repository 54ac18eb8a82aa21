#include "sph/kernel_table.hpp"

#include <cmath>
#include <numbers>

#include "case/words.hpp"
#include "sph/kernel_registry.hpp"

namespace riffle::inline sph {

namespace {

constexpr std::size_t nodes = KernelTable<double>::degree + 1;
using Coefficients = std::array<double, nodes>;

/// Coefficients of t^k, t in [-1, 1], of the polynomial that meets f at the Chebyshev nodes.
template <class F>
Coefficients interpolate(const F& f) {
    constexpr double pi = std::numbers::pi;
    Coefficients chebyshev{};
    for (std::size_t n = 0; n < nodes; ++n) {
        const double angle = pi * (static_cast<double>(n) + 0.5) / static_cast<double>(nodes);
        const double y = f(std::cos(angle));
        for (std::size_t k = 0; k < nodes; ++k) {
            chebyshev[k] += (k == 0 ? 1.0 : 2.0) / static_cast<double>(nodes) * y *
                            std::cos(static_cast<double>(k) * angle);
        }
    }
    // T_k+1 = 2 t T_k - T_k-1.
    Coefficients before{};
    Coefficients polynomial{};
    polynomial[0] = 1.0;
    Coefficients sum{};
    for (std::size_t k = 0; k < nodes; ++k) {
        Coefficients next{};
        for (std::size_t m = 0; m < nodes; ++m) {
            sum[m] += chebyshev[k] * polynomial[m];
            next[m] -= before[m];
            if (m + 1 < nodes) next[m + 1] += (k == 0 ? 1.0 : 2.0) * polynomial[m];
        }
        before = polynomial;
        polynomial = next;
    }
    return sum;
}

template <int D, class Real>
KernelTable<Real> make_table(KernelKind kind) {
    using Table = KernelTable<Real>;
    Table table{};
    visit_kernel<D>(kind, [&](auto chosen) {
        using Kernel = decltype(chosen);
        for (int piece = 0; piece < Table::pieces; ++piece) {
            // The pieces are open at the radius, where a kernel may end with a step.
            const auto q = [&](double t) {
                return (static_cast<double>(piece) + 0.5 + 0.5 * t) * 2.0 /
                       static_cast<double>(Table::pieces);
            };
            const Coefficients value = interpolate([&](double t) { return Kernel::value(q(t)); });
            const Coefficients slope =
                interpolate([&](double t) { return Kernel::gradient_factor(q(t)) * q(t); });
            for (std::size_t k = 0; k < nodes; ++k) {
                table.value[k][static_cast<std::size_t>(piece)] = static_cast<Real>(value[k]);
                table.slope[k][static_cast<std::size_t>(piece)] = static_cast<Real>(slope[k]);
            }
        }
    });
    return table;
}

}  // namespace

template <int D, class Real>
const KernelTable<Real>& kernel_table(KernelKind kind) {
    constexpr std::size_t kinds = Words<KernelKind>::list.size();
    static const auto tables = [] {
        std::array<KernelTable<Real>, kinds> all{};
        for (std::size_t k = 0; k < kinds; ++k) all[k] = make_table<D, Real>(static_cast<KernelKind>(k));
        return all;
    }();
    return tables.at(static_cast<std::size_t>(kind));
}

template const KernelTable<float>& kernel_table<2, float>(KernelKind);
template const KernelTable<double>& kernel_table<2, double>(KernelKind);
template const KernelTable<float>& kernel_table<3, float>(KernelKind);
template const KernelTable<double>& kernel_table<3, double>(KernelKind);

}  // namespace riffle::inline sph
