#include "ends/leaving_profile.hpp"

#include <algorithm>
#include <cmath>

#include "base/interpolation.hpp"

namespace riffle::inline ends {

void LeavingProfile::clear(const OpenEndsState& state) {
    depth_ = std::max(state.downstream.watched_depth, least_depth_);
    weight_.assign(state.leaving.size(), 0.0);
    flux_.assign(state.leaving.size(), 0.0);
}

void LeavingProfile::finish(OpenEndsState& state, double speed, double dt) {
    const double share = std::min(1.0, dt * speed / depth_);
    for (std::size_t bin = 0; bin < state.leaving.size(); ++bin) {
        if (weight_[bin] > 0.0) {
            state.leaving[bin] += share * (flux_[bin] / weight_[bin] - state.leaving[bin]);
        }
    }
    go_on(state);
}

void LeavingProfile::go_on(const OpenEndsState& state) {
    double mean = 0.0;
    for (const double velocity : state.leaving) mean += velocity / static_cast<double>(state.leaving.size());
    const double wanted = state.downstream.velocity;
    const bool turns = mean * wanted <= 0.0 || std::abs(wanted) > 2.0 * std::abs(mean);
    factor_ = turns ? 1.0 : wanted / mean;
    shift_ = turns ? wanted - mean : 0.0;
}

double LeavingProfile::at(const OpenEndsState& state, double place) const {
    // Straight lines between the middles of the bins.
    const std::size_t bins = state.leaving.size();
    const double profile = place_among(place * static_cast<double>(bins) - 0.5, bins).in(state.leaving);
    const double velocity = factor_ * profile + shift_;
    return state.downstream.velocity >= 0.0 ? std::max(0.0, velocity) : velocity;
}

std::size_t LeavingProfile::bin_of(const OpenEndsState& state, double place) {
    const auto bins = static_cast<double>(state.leaving.size());
    return static_cast<std::size_t>(std::clamp(place * bins, 0.0, bins - 0.5));
}

}  // namespace riffle::inline ends
