#include "analysis/probe_point_statistics.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>

#include "base/error.hpp"
#include "statistics/autocorrelation.hpp"
#include "statistics/confidence.hpp"

namespace riffle::inline analysis {

namespace {

/// Integral time of u' in samples; zero where the record is constant.
double integral_samples(const std::vector<double>& record) {
    try {
        const std::size_t lags = std::max<std::size_t>(1, record.size() / 4);
        return integral_scale_to_zero_crossing(autocorrelation(record, lags)).scale;
    } catch (const InputError&) {
        return 0.0;
    }
}

/// Without an interval where too few independent samples tell it.
Estimate known(Estimate estimate, double effective_samples) {
    constexpr double unknown = std::numeric_limits<double>::infinity();
    return {estimate.value, trusted_half_width(estimate.half_width, effective_samples).value_or(unknown)};
}

}  // namespace

double sampling_interval_of(const VelocityProbe& probe) {
    if (probe.time.size() < 2) return 0.0;
    return (probe.time.back() - probe.time.front()) / static_cast<double>(probe.time.size() - 1);
}

std::vector<ProbePointStatistics> probe_point_statistics(const VelocityProbe& probe, std::size_t fewest) {
    std::vector<ProbePointStatistics> result;
    const double interval = sampling_interval_of(probe);
    for (std::size_t i = 0; i < probe.z.size(); ++i) {
        const std::vector<double> u = probe.point(probe.u, i);
        const auto there = static_cast<std::size_t>(
            std::count_if(u.begin(), u.end(), [](double value) { return std::isfinite(value); }));
        if (there < std::max<std::size_t>(fewest, 2)) continue;
        ProbePointStatistics point;
        point.point = i;
        point.x = i < probe.x.size() ? probe.x[i] : 0.0;
        point.y = i < probe.y.size() ? probe.y[i] : 0.0;
        point.z = probe.z[i];
        point.samples = there;
        const Moments of_u = moments(u);
        point.u = known(of_u.mean, of_u.effective_samples);
        point.u_rms = known(of_u.standard_deviation, of_u.effective_samples);
        point.u_skewness = known(of_u.skewness, of_u.effective_samples);
        point.integral_time = integral_samples(u) * interval;
        point.integral_length = point.integral_time * std::abs(point.u.value);
        if (!probe.w.empty()) {
            const std::vector<double> w = probe.point(probe.w, i);
            const auto w_there =
                std::count_if(w.begin(), w.end(), [](double value) { return std::isfinite(value); });
            if (w_there >= 2) {
                const Moments of_w = moments(w);
                point.w = known(of_w.mean, of_w.effective_samples);
                point.w_rms = known(of_w.standard_deviation, of_w.effective_samples);
                point.w_skewness = known(of_w.skewness, of_w.effective_samples);
                const Covariance of_both = covariance(u, w);
                point.uw = known(of_both.covariance, of_both.effective_samples);
            }
        }
        if (!probe.v.empty()) {
            const std::vector<double> v = probe.point(probe.v, i);
            const auto v_there =
                std::count_if(v.begin(), v.end(), [](double value) { return std::isfinite(value); });
            if (v_there >= 2) {
                const Moments of_v = moments(v);
                point.v = known(of_v.mean, of_v.effective_samples);
                point.v_rms = known(of_v.standard_deviation, of_v.effective_samples);
            }
        }
        result.push_back(point);
    }
    std::sort(result.begin(), result.end(),
              [](const ProbePointStatistics& a, const ProbePointStatistics& b) { return a.z < b.z; });
    return result;
}

}  // namespace riffle::inline analysis
