#include "ends/inflow_streams.hpp"

#include <algorithm>
#include <cmath>
#include <vector>

namespace riffle::inline ends {

int InflowStreams::rows_for(double depth) const {
    return std::max(1, static_cast<int>(std::lround(depth / row_height_)));
}

void InflowStreams::begin(OpenEndsState& state, int rows, double front) const {
    state.rows = rows;
    state.front.assign(static_cast<std::size_t>(rows) * static_cast<std::size_t>(files_), front);
}

void InflowStreams::advance(OpenEndsState& state, double dt, double spreading,
                            const std::function<double(int, int)>& velocity) const {
    for (int row = 0; row < state.rows; ++row) {
        for (int file = 0; file < files_; ++file) {
            if (!lattice_.holds(row, file)) continue;
            double& place = front(state, row, file);
            place += dt * (velocity(row, file) - place * spreading);
        }
    }
}

void InflowStreams::rearrange(OpenEndsState& state, double depth) const {
    constexpr double most =
        0.7;  // of a row: a depth that wavers about a half does not change it again and again
    if (std::abs(depth / row_height_ - state.rows) <= most) return;
    const int rows = rows_for(depth);
    OpenEndsState next = state;
    begin(next, rows, 0.0);
    // The water ends half a particle behind the last one; the mean of that edge over the height of each new
    // row.
    const double before = 0.5 * length(state.rows, depth);
    const double after = 0.5 * length(rows, depth);
    std::vector<double> seen(next.front.size(), 0.0);  // of the height of each new row, in old streams
    for (int row = 0; row < rows; ++row) {
        for (int old = 0; old < state.rows; ++old) {
            const double from = std::max(row * 1.0 / rows, old * 1.0 / state.rows);
            const double to = std::min((row + 1.0) / rows, (old + 1.0) / state.rows);
            if (to <= from) continue;
            for (int file = 0; file < files_; ++file) {
                if (!lattice_.holds(old, file)) continue;
                const double share = (to - from) * rows;
                front(next, row, file) += share * (front(state, old, file) - before);
                seen[index(row, file)] += share;
            }
        }
        for (int file = 0; file < files_; ++file) {
            double& place = front(next, row, file);
            // Over a bank a stream may begin where there was none: from the channel on.
            if (!lattice_.is_rectangle()) {
                const double share = seen[index(row, file)];
                place = share > 0.0 ? place / share : 0.0;
            }
            place += after;
        }
    }
    state = next;
}

void InflowStreams::fill(OpenEndsState& state, double depth,
                         const std::function<void(int, int, double)>& add) const {
    const double step = length(state.rows, depth);
    for (int row = 0; row < state.rows; ++row) {
        for (int file = 0; file < files_; ++file) {
            if (!lattice_.holds(row, file)) continue;
            double& last = front(state, row, file);
            while (last < upstream_edge_ - step) last += step;
            while (last > upstream_edge_) {
                last -= step;
                add(row, file, last);
            }
        }
    }
}

}  // namespace riffle::inline ends
