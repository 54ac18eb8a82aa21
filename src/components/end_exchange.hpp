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
/// replaced: places behind the last particles of the rows, up to `support` (m) beyond the end, as many as the
/// water lacks from the end of that on to where it is still full, where the rows are shortest. (Rows of water
/// that has been in the channel are in disorder, and their number changes with the depth; one that looked
/// empty was filled from the end of the channel on, and a wave half a row high ran up it.) `area` (m2): of
/// the water's section, which fills the places `across`; its depth in two dimensions.
template <int D>
[[nodiscard]] std::vector<Vec<D>> gaps_behind_outflow(const Particles<D>& p, const Lattice& lattice,
                                                      const InflowStreams& streams, const EndLattice& across,
                                                      const EndRows& of, double length, double support,
                                                      double density, double area) {
    const double step = streams.length(of.rows, of.depth);
    const auto slices = static_cast<std::size_t>(std::lround(support / step));
    const double slice = support / static_cast<double>(slices);
    const double due = slice * area;
    const double end = length + support;
    // Volume by slice, from the far end on; each particle as long as its row demands.
    std::vector<double> volume(slices, 0.0);
    for (std::size_t i = 0; i < p.size(); ++i) {
        const double back = end - p.position[0][i];
        if (back < -0.5 * step || back > support + 0.5 * step) continue;
        const double whole = p.mass[i] / (density * (1.0 + p.density_deviation[i])) / step;
        for (std::size_t k = 0; k < slices; ++k) {
            const double within = std::min(back + 0.5 * step, slice * static_cast<double>(k + 1)) -
                                  std::max(back - 0.5 * step, slice * static_cast<double>(k));
            if (within > 0.0) volume[k] += whole * within;
        }
    }
    constexpr double full = 0.8;
    double lacking = 0.0;
    std::size_t open = 0;
    while (open < slices) {
        lacking += due - volume[open];
        if (volume[open++] >= full * due) break;
    }
    const double from = end - slice * static_cast<double>(open);
    const int files = lattice.files;
    std::vector<double> last(static_cast<std::size_t>(of.rows) * static_cast<std::size_t>(files),
                             from - 0.5 * step);
    for (int row = 0; row < of.rows; ++row) {
        for (int file = 0; file < files; ++file) {
            if (across.holds(row, file)) continue;
            last[static_cast<std::size_t>(row) * static_cast<std::size_t>(files) +
                 static_cast<std::size_t>(file)] = end;
        }
    }
    const auto index = [](double place, int count) {
        return static_cast<std::size_t>(std::clamp(place, 0.0, count - 0.5));
    };
    for (std::size_t i = 0; i < p.size(); ++i) {
        if (p.position[0][i] <= from - 0.5 * step) continue;
        const std::size_t row = index((p.position[D - 1][i] - of.floor) / of.depth * of.rows, of.rows);
        const std::size_t file = index(across_of<D>(p.position, i) / lattice.dy, files);
        double& place = last[row * static_cast<std::size_t>(files) + file];
        place = std::max(place, p.position[0][i]);
    }
    std::vector<Vec<D>> places;
    for (lacking -= 0.5 * lattice.volume(); lacking > 0.0; lacking -= lattice.volume()) {
        const auto shortest = std::min_element(last.begin(), last.end());
        if (*shortest + step >= end) break;
        *shortest += step;
        const auto at = static_cast<int>(shortest - last.begin());
        places.push_back(place_in_rows<D>(lattice, streams, of, at / files, at % files, *shortest));
    }
    return places;
}

}  // namespace riffle::inline components
