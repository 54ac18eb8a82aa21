#include "ends/outgoing_sound.hpp"

#include <algorithm>
#include <cmath>

#include "base/interpolation.hpp"

namespace riffle::inline ends {

namespace {

/// The place of one from 0 to 1 among the middles of bins.
TablePlace between(double place, int bins) {
    return place_among(place * bins - 0.5, static_cast<std::size_t>(bins));
}

std::size_t bin_at(double place, int bins) {
    return static_cast<std::size_t>(std::clamp(place * bins, 0.0, bins - 0.5));
}

}  // namespace

OutgoingSound::OutgoingSound(const Grid& grid)
    : grid_(grid),
      nodes_(static_cast<std::size_t>(std::ceil(grid.length / grid.spacing)) + 2),
      weight_(static_cast<std::size_t>(grid.bins_upright) * static_cast<std::size_t>(grid.bins_across)),
      pressure_(weight_.size()) {}

std::size_t OutgoingSound::bin(std::size_t upright, std::size_t across) const {
    return across * static_cast<std::size_t>(grid_.bins_upright) + upright;
}

void OutgoingSound::clear() {
    weight_.assign(weight_.size(), 0.0);
    pressure_.assign(pressure_.size(), 0.0);
}

void OutgoingSound::add(const Place& place, double weight, double pressure) {
    const std::size_t at =
        bin(bin_at(place.upright, grid_.bins_upright), bin_at(place.across, grid_.bins_across));
    weight_[at] += weight;
    pressure_[at] += weight * pressure;
}

void OutgoingSound::advance(SoundBeyondEnd& sound, double speed, double slow_time, double full, double most,
                            double dt) {
    sound.slow.resize(bins(), 0.0);
    sound.now.resize(bins() * nodes_, 0.0);
    sound.change = sound.now;
    const double courant = std::max(0.0, speed) * dt / grid_.spacing;
    const int parts = std::max(1, static_cast<int>(std::ceil(courant)));
    for (int part = 0; part < parts; ++part) carry(sound.now, courant / parts);
    const double share = std::min(1.0, dt / slow_time);
    for (std::size_t b = 0; b < bins(); ++b) {
        double fast = 0.0;
        if (weight_[b] > 0.5 * full) {
            const double pressure = std::clamp(pressure_[b] / weight_[b], -most, most);
            sound.slow[b] += share * (pressure - sound.slow[b]);
            fast = pressure - sound.slow[b];
        }
        sound.now[b * nodes_] = fast;
    }
    for (std::size_t k = 0; k < sound.now.size(); ++k) sound.change[k] = sound.now[k] - sound.change[k];
}

/// One step of Lax & Wendroff's scheme, at the last node upwind.
void OutgoingSound::carry(std::vector<double>& nodes, double courant) const {
    for (std::size_t b = 0; b < bins(); ++b) {
        double* const f = nodes.data() + b * nodes_;
        double behind = f[0];
        for (std::size_t k = 1; k < nodes_; ++k) {
            const double here = f[k];
            f[k] = here - courant * (here - behind);
            if (k + 1 < nodes_) f[k] -= 0.5 * courant * (1.0 - courant) * (f[k + 1] - 2.0 * here + behind);
            behind = here;
        }
    }
}

double OutgoingSound::at(const std::vector<double>& nodes, double distance, const Place& place) const {
    if (nodes.empty()) return 0.0;
    const TablePlace along = place_among(distance / grid_.spacing, nodes_);
    const TablePlace upright = between(place.upright, grid_.bins_upright);
    const TablePlace across = grid_.bins_across > 1 ? between(place.across, grid_.bins_across) : TablePlace{};
    const auto of_bin = [&](std::size_t up, std::size_t side) {
        return along.in(nodes.data() + bin(up, side) * nodes_);
    };
    const auto of_file = [&](std::size_t side) {
        const double low = of_bin(upright.low, side);
        return low + upright.share * (of_bin(upright.high, side) - low);
    };
    const double low = of_file(across.low);
    if (across.share == 0.0) return low;  // in two dimensions always
    return low + across.share * (of_file(across.high) - low);
}

}  // namespace riffle::inline ends
