#include "column/uniform_rating.hpp"

#include <cmath>
#include <utility>

#include "column/twin_channel.hpp"

namespace riffle::inline column {

namespace {

constexpr double step = 0.15;  // in the logarithm of the depth
constexpr int points = 4;

}  // namespace

UniformRating::UniformRating(Case c)
    : case_(std::move(c)),
      lowest_(static_cast<int>(std::ceil(std::log(least_known_depth(case_) / case_.channel.depth) / step))) {}

double UniformRating::log_discharge(int k) {
    const auto found = log_discharges_.find(k);
    if (found != log_discharges_.end()) return found->second;
    const double discharge = uniform_discharge_at(case_, case_.channel.depth * std::exp(step * k));
    return log_discharges_.emplace(k, std::log(discharge)).first->second;
}

double UniformRating::depth(double unit_discharge) {
    if (!(unit_discharge > 0.0)) return 0.0;
    const double wanted = std::log(unit_discharge);
    // The node below; the depth of the case is where to look first.
    int below = std::max(lowest_, 0);
    while (below > lowest_ && log_discharge(below) > wanted) --below;
    while (log_discharge(below + 1) < wanted) ++below;
    double place = 0.0;
    if (log_discharge(below) > wanted) {
        const double low = log_discharge(lowest_);
        place = lowest_ + (wanted - low) / (log_discharge(lowest_ + 1) - low);
    } else {
        const int first = std::max(lowest_, below - 1);
        for (int k = 0; k < points; ++k) {
            double weight = 1.0;
            for (int other = 0; other < points; ++other) {
                if (other != k) {
                    weight *= (wanted - log_discharge(first + other)) /
                              (log_discharge(first + k) - log_discharge(first + other));
                }
            }
            place += weight * (first + k);
        }
    }
    return case_.channel.depth * std::exp(step * place);
}

}  // namespace riffle::inline column
