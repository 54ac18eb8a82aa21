#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "ends/inflow_streams.hpp"
#include "engine/flow.hpp"
#include "particles/lattice.hpp"

namespace riffle::inline components {

// Particles that come and go at open ends, each with its row in the account.

/// What the particles that are taken out have done.
enum class TakenOut {
    left,        ///< they have left the channel
    not_entered  ///< they have waited before it, and are made anew: they count no more among those that
                 ///< entered
};

/// Take out the particles of which leaves(index) holds.
template <int D, class Real, class Leaves>
void take_out_with_account(FlowOf<D, Real>& flow, TakenOut how, const Leaves& leaves) {
    Particles<D>& p = flow.particles;
    EndsLedger& ledger = flow.clock.open_ends.ledger;
    std::vector<std::int32_t> kept;
    kept.reserve(p.size());
    for (std::size_t i = 0; i < p.size(); ++i) {
        if (!leaves(i)) {
            kept.push_back(static_cast<std::int32_t>(i));
            continue;
        }
        if (how == TakenOut::left) {
            ++ledger.left;
            ledger.mass_left += p.mass[i];
            ledger.momentum_left += p.mass[i] * p.velocity[0][i];
        } else {
            --ledger.entered;
            ledger.mass_entered -= p.mass[i];
            ledger.momentum_entered -= p.mass[i] * p.velocity[0][i];
        }
    }
    if (kept.size() < p.size()) p.permute(kept);
}

/// Add particles of a volume (m3; in two dimensions m2) at places, with the pressure (over the density) and
/// the velocity of each by its index.
template <int D, class Real, class Pressure, class Velocity>
void add_with_account(FlowOf<D, Real>& flow, double volume, const std::vector<Vec<D>>& places,
                      const Pressure& pressure, const Velocity& velocity) {
    if (places.empty()) return;
    Particles<D>& p = flow.particles;
    EndsLedger& ledger = flow.clock.open_ends.ledger;
    const std::size_t first = p.append(places.size());
    for (std::size_t n = 0; n < places.size(); ++n) {
        const std::size_t i = first + n;
        for (std::size_t k = 0; k < D; ++k) p.position[k][i] = places[n][k];
        const double s = flow.scheme.state.deviation(pressure(i));
        p.density_deviation[i] = s;
        p.mass[i] = flow.scheme.density * (1.0 + s) * volume;
        const Vec<D> u = velocity(i);
        for (std::size_t k = 0; k < D; ++k) p.velocity[k][i] = u[k];
        ++ledger.entered;
        ledger.mass_entered += p.mass[i];
        ledger.momentum_entered += p.mass[i] * u[0];
    }
}

/// Rows of particles beyond an end: how many over each other in water of a depth (m) over a floor (m).
struct EndRows {
    int rows = 0;
    double depth = 0.0;
    double floor = 0.0;
};

/// Place of a particle of a row and a file at x, m.
template <int D>
[[nodiscard]] Vec<D> place_in_rows(const Lattice& lattice, const InflowStreams& streams, const EndRows& of,
                                   int row, int file, double x) {
    Vec<D> place{};
    place[0] = x;
    if constexpr (D == 3) place[1] = lattice.y(file, row);
    place[D - 1] = of.floor + streams.height_of(row, of.rows, of.depth);
    return place;
}

/// Where the flow comes back from the outflow at x = `length`, what has gone into the channel is to be
/// replaced: places behind the last particle of each row, up to `support` (m) beyond the end.
template <int D>
[[nodiscard]] std::vector<Vec<D>> gaps_behind_outflow(const Particles<D>& p, const Lattice& lattice,
                                                      const InflowStreams& streams, const EndRows& of,
                                                      double length, double support) {
    const int files = lattice.files;
    const double step = streams.length(of.rows, of.depth);
    std::vector<double> last(static_cast<std::size_t>(of.rows) * static_cast<std::size_t>(files),
                             length - step);
    const auto index = [](double place, int count) {
        return static_cast<std::size_t>(std::clamp(place, 0.0, count - 0.5));
    };
    for (std::size_t i = 0; i < p.size(); ++i) {
        if (p.position[0][i] > length - step) {
            const std::size_t row = index((p.position[D - 1][i] - of.floor) / of.depth * of.rows, of.rows);
            const std::size_t file = index(across_of<D>(p.position, i) / lattice.dy, files);
            double& place = last[row * static_cast<std::size_t>(files) + file];
            place = std::max(place, p.position[0][i]);
        }
    }
    std::vector<Vec<D>> places;
    for (int row = 0; row < of.rows; ++row) {
        for (int file = 0; file < files; ++file) {
            const auto at = static_cast<std::size_t>(row) * static_cast<std::size_t>(files) +
                            static_cast<std::size_t>(file);
            for (double x = last[at] + step; x < length + support; x += step) {
                places.push_back(place_in_rows<D>(lattice, streams, of, row, file, x));
            }
        }
    }
    return places;
}

}  // namespace riffle::inline components
