#include "column/uniform_rating.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <utility>

#include "base/interpolation.hpp"
#include "case/cross_section.hpp"
#include "column/canal_channel.hpp"
#include "column/twin_channel.hpp"

namespace riffle::inline column {

namespace {

constexpr double step = 0.15;  // in the logarithm of the depth
constexpr int points = 4;

}  // namespace

UniformRating::UniformRating(Case c)
    : case_(std::move(c)),
      lowest_(static_cast<int>(std::ceil(std::log(least_known_depth(case_) / case_.channel.depth) / step))) {
    const Solid* const canal = canal_of(case_);
    if (canal == nullptr) return;
    constexpr double ratio = 1.005;
    constexpr double highest = 10.0;  // of the depth of the case
    const auto shape = shape_of_section(case_, *canal);
    const double least = std::max(least_known_depth(case_), 1e-3 * case_.channel.depth);
    double most = 0.0;
    for (double depth = least; depth < highest * case_.channel.depth; depth *= ratio) {
        most = std::max(most, canal_uniform_discharge(case_, *shape, depth));
        canal_depths_.push_back(depth);
        canal_discharges_.push_back(most);
    }
}

double UniformRating::depth_of_canal(double unit_discharge) const {
    // Beyond the ends as the power of the depth of a wide channel.
    constexpr double power = 0.6;
    const std::size_t last = canal_depths_.size() - 1;
    for (const std::size_t end : {std::size_t{0}, last}) {
        const bool beyond =
            end == 0 ? unit_discharge < canal_discharges_[end] : unit_discharge > canal_discharges_[end];
        if (beyond) return canal_depths_[end] * std::pow(unit_discharge / canal_discharges_[end], power);
    }
    return place_in(canal_discharges_, unit_discharge).in(canal_depths_);
}

double UniformRating::log_discharge(int k) {
    const auto found = log_discharges_.find(k);
    if (found != log_discharges_.end()) return found->second;
    const double discharge = uniform_discharge_at(case_, case_.channel.depth * std::exp(step * k));
    return log_discharges_.emplace(k, std::log(discharge)).first->second;
}

double UniformRating::depth(double unit_discharge) {
    if (!(unit_discharge > 0.0)) return 0.0;
    if (!canal_depths_.empty()) return depth_of_canal(unit_discharge);
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
