#include "analysis/depth_correlation.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "base/error.hpp"
#include "base/not_a_number.hpp"

namespace riffle::inline analysis {

namespace {

bool constant(std::span<const double> record) {
    std::optional<double> first;
    for (const double v : record) {
        if (std::isnan(v)) continue;
        if (first && v != *first) return false;
        first = v;
    }
    return true;
}

/// Height where the correlation plus `shift` half-widths falls through the threshold; heights descending.
std::optional<double> crossing(const std::vector<const HeightCorrelation*>& down, double threshold,
                               double shift) {
    const auto value = [shift](const HeightCorrelation& c) {
        return c.correlation.value + (shift == 0.0 ? 0.0 : shift * c.correlation.half_width);
    };
    for (std::size_t i = 1; i < down.size(); ++i) {
        const double above = value(*down[i - 1]);
        const double below = value(*down[i]);
        if (above >= threshold && below < threshold) {
            return down[i - 1]->z + (threshold - above) / (below - above) * (down[i]->z - down[i - 1]->z);
        }
    }
    return std::nullopt;
}

}  // namespace

std::vector<HeightCorrelation> depth_correlation(std::span<const HeightRecord> vertical_velocity,
                                                 std::span<const double> reference, double interval,
                                                 double largest_lag) {
    if (!(interval > 0.0) || !(largest_lag >= 0.0)) {
        throw InputError(
            fmt::format("correlation over depth: interval {:.4g} s and largest lag {:.4g} s; an interval "
                        "above 0 and a lag of at least 0 are needed",
                        interval, largest_lag));
    }
    const auto lags = static_cast<std::size_t>(largest_lag / interval + 1e-6);
    std::vector<HeightCorrelation> result;
    if (constant(reference)) return result;
    for (const HeightRecord& record : vertical_velocity) {
        if (record.values.size() != reference.size()) {
            throw InputError(
                fmt::format("correlation over depth: {} samples at z = {:.4g} m, {} of the reference; take "
                            "the same times",
                            record.values.size(), record.z, reference.size()));
        }
        if (constant(record.values)) continue;
        HeightCorrelation c;
        c.z = record.z;
        c.correlation = covariance(reference, record.values).correlation;
        c.lagged = cross_correlation(reference, record.values, interval, lags);
        for (const CorrelationExtreme& e : correlation_extremes(c.lagged)) {
            if (!c.extreme || std::abs(e.correlation) > std::abs(c.extreme->correlation)) c.extreme = e;
        }
        result.push_back(std::move(c));
    }
    return result;
}

std::optional<InfluenceDepth> influence_depth(std::span<const HeightCorrelation> correlations, double from,
                                              double threshold) {
    std::vector<const HeightCorrelation*> down;
    for (const HeightCorrelation& c : correlations) {
        if (c.z <= from) down.push_back(&c);
    }
    std::sort(down.begin(), down.end(), [](const auto* a, const auto* b) { return a->z > b->z; });
    const auto z = crossing(down, threshold, 0.0);
    if (!z || down.front()->correlation.value < threshold) return std::nullopt;
    // The curve raised by its half-width falls through the threshold further down.
    return InfluenceDepth{*z, crossing(down, threshold, 1.0).value_or(not_a_number),
                          crossing(down, threshold, -1.0).value_or(not_a_number)};
}

}  // namespace riffle::inline analysis
