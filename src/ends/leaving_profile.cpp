#include "ends/leaving_profile.hpp"

#include <algorithm>
#include <cmath>
#include <span>

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
    const double mean = mean_over(state, state.downstream.depth);
    const double wanted = state.downstream.velocity;
    const bool turns = mean * wanted <= 0.0 || std::abs(wanted) > 2.0 * std::abs(mean);
    factor_ = turns ? 1.0 : wanted / mean;
    shift_ = turns ? wanted - mean : 0.0;
}

double LeavingProfile::mean_over(const OpenEndsState& state, double depth) const {
    double mean = 0.0;
    if (floors_.empty()) {
        for (const double velocity : state.leaving) {
            mean += velocity / static_cast<double>(state.leaving.size());
        }
        return mean;
    }
    double area = 0.0;
    for (std::size_t file = 0; file < files(); ++file) {
        const double water = std::max(0.0, depth - floors_[file]) / static_cast<double>(bins(state));
        for (std::size_t bin = 0; bin < bins(state); ++bin) {
            mean += water * state.leaving[first_of(state, file) + bin];
            area += water;
        }
    }
    return area > 0.0 ? mean / area : 0.0;
}

double LeavingProfile::at(const OpenEndsState& state, double height, double depth, std::size_t file) const {
    // Straight lines between the middles of the bins.
    const std::size_t count = bins(state);
    const std::span<const double> profile(&state.leaving[first_of(state, file)], count);
    const double place = place_in_file(height, depth, file);
    const double velocity =
        factor_ * place_among(place * static_cast<double>(count) - 0.5, count).in(profile) + shift_;
    return state.downstream.velocity >= 0.0 ? std::max(0.0, velocity) : velocity;
}

std::size_t LeavingProfile::bin_of(const OpenEndsState& state, double place) const {
    const auto count = static_cast<double>(bins(state));
    return static_cast<std::size_t>(std::clamp(place * count, 0.0, count - 0.5));
}

}  // namespace riffle::inline ends
