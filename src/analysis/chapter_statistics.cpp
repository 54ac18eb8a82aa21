// Statistics of the whole-flow series: means with their intervals, settling, drift.

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <optional>

#include "analysis/chapters.hpp"
#include "analysis/figure_tools.hpp"
#include "record/flow_fields.hpp"
#include "record/twin_fields.hpp"
#include "statistics/autocorrelation.hpp"
#include "statistics/confidence.hpp"
#include "statistics/p_value.hpp"
#include "statistics/settling.hpp"
#include "statistics/stationarity.hpp"

namespace riffle::inline analysis {

namespace {

void add_history(const FlowRecord& record, Analysis& analysis) {
    Figure figure =
        make_figure(chapters::statistics, "velocity_history", "Depth-mean velocity against time",
                    "Depth-mean velocity above the datum over the whole run.", "thesis Figs 4.4-4.5, 5.10",
                    make_axis("time t", "s"), make_axis("depth-mean velocity U", "m/s"));
    const SeriesTable& series = record.series();
    const std::vector<double>& time = series[fields::time_series.time];
    const std::vector<double>& velocity = series[fields::time_series.depth_mean_velocity];
    if (velocity.empty() || time.size() < 2) {
        add_missing(record, analysis, std::move(figure), "the results file holds no time series yet");
        return;
    }
    figure.curves.push_back(
        make_curve("simulated", Origin::simulated, Mark::line, thinned(time), thinned(velocity)));
    const std::vector<double> ends = {time.front(), time.back()};
    const auto level = [&](const char* name, Origin origin, double value) {
        figure.curves.push_back(make_curve(name, origin, Mark::line, ends, {value, value}));
    };
    const bool between_walls = record.flow()->has_side_walls();
    if (record.column() != nullptr && !between_walls) {
        level("column twin", Origin::column, record.column()->depth_mean_velocity);
    }
    if (const auto twin = record.section_twin().value(fields::section_numbers.depth_mean_velocity)) {
        level("section twin", Origin::column, *twin);
    }
    const std::vector<double>& centreline = series[fields::time_series.centreline_velocity];
    if (between_walls && !centreline.empty()) {
        Curve curve = make_curve("around the centreline", Origin::simulated, Mark::line, thinned(time),
                                 thinned(centreline));
        curve.variant = 1;
        figure.curves.push_back(std::move(curve));
        figure.caption +=
            " Between side walls that of the whole width, and that around the centreline, "
            "where it was measured.";
    }
    if (record.flow()->measured.depth_mean_velocity) {
        level("measured", Origin::measured, *record.flow()->measured.depth_mean_velocity);
    }
    mark_window(record, figure);
    analysis.figures.push_back(std::move(figure));
}

void add_level_history(const FlowRecord& record, Analysis& analysis) {
    const SeriesTable& series = record.series();
    const std::vector<double>& time = series[fields::time_series.time];
    const std::vector<double>& level = series[fields::time_series.mean_level];
    if (level.empty() || time.size() < 2 || record.flow()->channel.top != Top::free_surface) return;
    Figure figure = make_figure(chapters::statistics, "mean_level_history", "Mean water level against time",
                                "Mean height of the surface above the bed level over the whole run.", "",
                                make_axis("time t", "s"), make_axis("mean level", "m"));
    figure.curves.push_back(
        make_curve("simulated", Origin::simulated, Mark::line, thinned(time), thinned(level)));
    mark_window(record, figure);
    analysis.figures.push_back(std::move(figure));
}

/// A record within the window, at even times to within a step of the simulation.
struct WindowRecord {
    std::string prefix;    ///< of the keys of its figures and its drift
    std::string findings;  ///< before the keys of the other findings; empty for the depth mean of a run
    std::string symbol;
    std::string unit;
    std::vector<double> values;
    double start = 0;
    double interval = 0;
};

void add_settling(const FlowRecord& record, const WindowRecord& window, Analysis& analysis) {
    Figure figure =
        make_figure(chapters::statistics, window.prefix + "_settling",
                    fmt::format("Settling of the mean of {}", window.symbol),
                    "Mean from the start of the window up to each time, with its 95 % interval, over the "
                    "mean of the whole window.",
                    "thesis Figs 4.4-4.5, 5.10", make_axis("time t", "s"),
                    make_axis("running mean over final mean", "1"));
    attempt(record, analysis, std::move(figure), [&](Figure& f) {
        const SettlingCurve settling = settling_curve(window.values);
        const double last = settling.mean.back();
        Curve curve = make_curve(window.symbol, record.origin(), Mark::line, {}, {});
        for (std::size_t i = 0; i < settling.samples.size(); ++i) {
            if (!std::isfinite(settling.half_width[i])) continue;
            curve.x.push_back(window.start + static_cast<double>(settling.samples[i] - 1) * window.interval);
            curve.y.push_back(settling.mean[i] / last);
            curve.y_half_width.push_back(settling.half_width[i] / std::abs(last));
        }
        f.curves.push_back(std::move(curve));
        constexpr double band = 0.01;
        Finding finding = make_finding(
            chapters::statistics, window.findings + "settled_after",
            "time after which the running mean stays within 1 % of the final", "s",
            static_cast<double>(settled_after(window.values, band * std::abs(last))) * window.interval);
        finding.remark =
            fmt::format("of {:.4g} s", static_cast<double>(window.values.size()) * window.interval);
        analysis.findings.push_back(std::move(finding));
    });
}

void add_autocorrelation(const FlowRecord& record, const WindowRecord& window, Analysis& analysis) {
    Figure figure =
        make_figure(chapters::statistics, window.prefix + "_autocorrelation",
                    fmt::format("Autocorrelation of {}", window.symbol),
                    "Autocorrelation in time over the window, from which the integral time scale and "
                    "the intervals of the means follow.",
                    "", make_axis("time lag", "s"), make_axis("autocorrelation", "1"));
    attempt(record, analysis, std::move(figure), [&](Figure& f) {
        const std::vector<double> correlation =
            autocorrelation(window.values, std::max<std::size_t>(1, window.values.size() / 4));
        std::vector<double> lag;
        for (std::size_t i = 0; i < correlation.size(); ++i) {
            lag.push_back(static_cast<double>(i) * window.interval);
        }
        f.curves.push_back(
            make_curve(window.symbol, record.origin(), Mark::line, thinned(lag), thinned(correlation)));
        const IntegralScale scale = integral_scale_to_zero_crossing(correlation);
        Finding finding = make_finding(chapters::statistics, window.findings + "integral_time_to_zero",
                                       "integral time scale to the first zero crossing", "s",
                                       scale.scale * window.interval);
        if (!scale.closed) {
            finding.remark = "the correlation does not reach zero within a quarter of the window";
        }
        analysis.findings.push_back(std::move(finding));
    });
}

/// `tolerance`: drift over the mean below which a run counts as converged; 0 for a laboratory record.
void add_stationarity(const WindowRecord& window, double tolerance, Analysis& analysis) {
    try {
        const Stationarity test = stationarity(window.values);
        const MeanEstimate mean = mean_with_confidence(window.values);
        // Of few independent samples the time scale itself is not known, and with it no chance: steady
        // records of two or three have p < 0.05 one time in four.
        const bool enough = mean.effective_samples >= fewest_effective_samples;
        const double rare = enough ? 0.05 : 1e-4;
        Finding drift = against(
            make_finding(chapters::statistics, window.prefix + "_drift",
                         fmt::format("change of {} over the window by its trend", window.symbol), window.unit,
                         test.drift.value, trusted_half_width(test.drift.half_width, mean.effective_samples)),
            0.0, "steady flow");
        drift.remark = fmt::format("{:.2g} of the mean; chance p of such a trend in a steady record {}",
                                   test.drift.value / mean.mean, p_value_text(test.trend_p_value));
        analysis.findings.push_back(std::move(drift));
        Finding steady =
            make_finding(chapters::statistics, window.findings + "stationarity_p_value",
                         fmt::format("steadiness of {}: smallest p-value (Bonferroni)", window.symbol), "1",
                         std::max(test.p_value, least_p_value));
        steady.remark = test.blocks ? "trend, reverse arrangements and runs of means and variances of blocks"
                                    : fmt::format(
                                          "the trend alone: only {} independent block{}, too few for "
                                          "tests of blocks",
                                          test.block_count, test.block_count == 1 ? "" : "s");
        steady.remark += test.p_value < least_p_value ? ": p " + p_value_text(test.p_value) : "";
        steady.remark += test.p_value < rare ? fmt::format(": not steady (below {:g})", rare)
                         : !enough           ? ": too few independent samples to tell whether it is steady"
                                             : ": nothing speaks against steadiness";
        const double relative = std::abs(test.drift.value / mean.mean);
        if (test.p_value < rare && relative < tolerance && enough) {
            steady.remark += fmt::format(
                "; the drift of {:.2g} % of the mean is below run.tolerance = {:.2g} %, so the flow still "
                "counts as converged",
                100.0 * relative, 100.0 * tolerance);
        }
        analysis.findings.push_back(std::move(steady));
    } catch (const InputError& error) {
        analysis.warnings.push_back(std::string("test of steadiness: ") + error.what());
    }
}

std::optional<double> over(const std::optional<double>& half_width, double scale) {
    if (!half_width) return std::nullopt;
    return *half_width / scale;
}

/// The velocity around the centreline of a channel between side walls, where it was measured.
void add_centreline(const FlowRecord& record, const std::string& remark, Analysis& analysis) {
    const Case& c = *record.flow();
    const std::vector<double> velocity = within_window(record, fields::time_series.centreline_velocity);
    if (velocity.size() < 2) return;
    const MeanEstimate mean = mean_with_confidence(velocity);
    const std::optional<double> half_width = trusted_half_width(mean);
    analysis.findings.push_back(
        against(make_finding(chapters::statistics, "centreline_velocity",
                             "depth-mean velocity around the centreline", "m/s", mean.mean, half_width),
                c.measured.depth_mean_velocity, measured_name(c), remark));
    if (const auto twin = record.section_twin().value(fields::section_numbers.centreline_velocity)) {
        analysis.findings.push_back(
            against(make_finding(chapters::statistics, "centreline_velocity_over_section",
                                 "the same over that of the section twin", "1", mean.mean / *twin,
                                 over(half_width, *twin)),
                    1.0, "section twin"));
    }
}

/// What tells whether the window can give a mean: independent samples, how far the velocity strays, whether
/// the particles' fluctuation still grows.
void add_window_findings(const FlowRecord& record, const MeanEstimate& mean,
                         const std::vector<double>& velocity, Analysis& analysis) {
    analysis.findings.push_back(make_finding(chapters::statistics, "effective_samples",
                                             "independent samples of U in the window", "1",
                                             mean.effective_samples));
    const auto [low, high] = std::minmax_element(velocity.begin(), velocity.end());
    if (mean.mean != 0.0) {
        analysis.findings.push_back(make_finding(chapters::statistics, "velocity_range_in_window",
                                                 "largest less smallest U in the window, over its mean", "1",
                                                 (*high - *low) / std::abs(mean.mean)));
    }
    std::vector<double> fluctuation = within_window(record, fields::time_series.velocity_fluctuation);
    if (fluctuation.size() < 3 ||
        std::any_of(fluctuation.begin(), fluctuation.end(), [](double value) { return !(value > 0.0); })) {
        return;  // particles that move exactly as one have none that could grow
    }
    for (double& value : fluctuation) value = std::log(value);
    const TrendEstimate trend = trend_with_confidence(fluctuation);
    const auto steps = static_cast<double>(fluctuation.size() - 1);
    const double factor = std::exp(trend.slope * steps);
    Finding growth =
        make_finding(chapters::statistics, "velocity_fluctuation_growth",
                     "growth of the velocity fluctuation over the window, by the trend of its logarithm", "1",
                     factor - 1.0);
    const double least = factor * std::exp(-trend.half_width * steps) - 1.0;
    growth.remark = "0: a flow that has come to its lasting state";
    if (std::isfinite(least)) {
        growth.remark += fmt::format("; 95 % interval {:.3g} to {:.3g}", least,
                                     factor * std::exp(trend.half_width * steps) - 1.0);
    }
    analysis.findings.push_back(std::move(growth));
    analysis.findings.push_back(make_finding(chapters::statistics, "velocity_fluctuation_growth_least",
                                             "the least of that growth by its interval", "1", least));
}

void add_means(const FlowRecord& record, Analysis& analysis) {
    const Case& c = *record.flow();
    const std::vector<double> velocity = within_window(record, fields::time_series.depth_mean_velocity);
    const std::vector<double> time = within_window(record, fields::time_series.time);
    if (velocity.size() < 2 || time.size() < 2) {
        analysis.warnings.push_back(
            fmt::format("the window {:.4g} s to {:.4g} s holds {} samples of the time series: too few for "
                        "statistics",
                        record.window().from, record.window().to, velocity.size()));
        return;
    }
    const double interval = (time.back() - time.front()) / static_cast<double>(time.size() - 1);
    const MeanEstimate mean = mean_with_confidence(velocity);
    std::string remark = c.measured.uniform ? "" : "the measured flow was not uniform";
    // Between side walls the measured velocity is that of the centreline, not of the width.
    const bool between_walls = c.has_side_walls();
    Finding depth_mean =
        make_finding(chapters::statistics, "depth_mean_velocity", "depth-mean velocity above the datum, U",
                     "m/s", mean.mean, trusted_half_width(mean));
    if (between_walls) {
        analysis.findings.push_back(against(
            std::move(depth_mean), record.section_twin().value(fields::section_numbers.depth_mean_velocity),
            "section twin", "over the whole width"));
        add_centreline(record, remark, analysis);
    } else {
        analysis.findings.push_back(
            against(std::move(depth_mean), c.measured.depth_mean_velocity, measured_name(c), remark));
    }
    if (record.column() != nullptr && !between_walls) {
        analysis.findings.push_back(
            against(make_finding(chapters::statistics, "depth_mean_velocity_over_column",
                                 "the same over that of the column twin", "1",
                                 mean.mean / record.column()->depth_mean_velocity,
                                 over(trusted_half_width(mean), record.column()->depth_mean_velocity)),
                    1.0, "column twin"));
    }
    Finding scale = make_finding(chapters::statistics, "integral_time_scale", "integral time scale of U", "s",
                                 mean.integral_time * interval);
    scale.remark = fmt::format("{:.4g} effective samples in {:.4g} s", mean.effective_samples,
                               time.back() - time.front());
    analysis.findings.push_back(std::move(scale));
    add_window_findings(record, mean, velocity, analysis);
    if (mean.effective_samples < fewest_effective_samples) {
        analysis.warnings.push_back(fmt::format(
            "the window holds only {:.2g} independent samples of the depth-mean velocity, too few "
            "for an interval of its mean ({:.0f}): simulate longer, or start the window earlier "
            "where the flow was steady before",
            mean.effective_samples, fewest_effective_samples));
    }
    const WindowRecord record_of_velocity{"velocity", "", "U", "m/s", velocity, time.front(), interval};
    add_settling(record, record_of_velocity, analysis);
    add_autocorrelation(record, record_of_velocity, analysis);
    add_stationarity(record_of_velocity, c.run.tolerance, analysis);
    const auto& of = fields::time_series;
    for (const auto& [field, key, label, unit] :
         {std::tuple{of.total_mean_velocity, "total_mean_velocity", "mass-mean velocity of all water", "m/s"},
          std::tuple{of.velocity_fluctuation, "velocity_fluctuation",
                     "rms departure of the particle velocities from their layer means", "m/s"},
          std::tuple{of.secondary_velocity, "secondary_velocity",
                     "rms of sqrt(v^2 + w^2) over the particles at each instant", "m/s"}}) {
        const std::vector<double> values = within_window(record, field);
        if (values.size() < 2) continue;
        const MeanEstimate estimate = mean_with_confidence(values);
        analysis.findings.push_back(make_finding(chapters::statistics, key, label, unit, estimate.mean,
                                                 trusted_half_width(estimate)));
    }
}

}  // namespace

namespace {

/// The record of a laboratory that stands for the flow: u of an instrument's middle point, or the squared
/// elevation at a wave probe (the mean of the elevation itself is the level that it is counted from).
std::optional<WindowRecord> laboratory_record_of(const FlowRecord& record) {
    for (const VelocityProbe& probe : record.velocity_probes()) {
        if (probe.time.size() < 2 || probe.z.empty()) continue;
        const double interval =
            (probe.time.back() - probe.time.front()) / static_cast<double>(probe.time.size() - 1);
        return WindowRecord{"point_velocity",
                            "point_velocity_",
                            "u, " + probe.name,
                            "m/s",
                            probe.point(probe.u, probe.z.size() / 2),
                            probe.time.front(),
                            interval};
    }
    for (const ElevationProbe& probe : record.elevation_probes()) {
        if (probe.time.size() < 2) continue;
        const double interval =
            (probe.time.back() - probe.time.front()) / static_cast<double>(probe.time.size() - 1);
        std::vector<double> squares = probe.elevation;
        const double mean = mean_with_confidence(squares).mean;
        for (double& value : squares) value = (value - mean) * (value - mean);
        return WindowRecord{"elevation", "elevation_", "the squared elevation, " + probe.name,
                            "m2",        squares,      probe.time.front(),
                            interval};
    }
    return std::nullopt;
}

void analyse_laboratory_record(const FlowRecord& record, Analysis& analysis) {
    const std::optional<WindowRecord> window = laboratory_record_of(record);
    if (!window) return;
    if (window->prefix == "point_velocity") {
        const MeanEstimate mean = mean_with_confidence(window->values);
        analysis.findings.push_back(make_finding(chapters::statistics, "point_velocity",
                                                 "mean of " + window->symbol, window->unit, mean.mean,
                                                 trusted_half_width(mean)));
    }
    add_settling(record, *window, analysis);
    add_autocorrelation(record, *window, analysis);
    add_stationarity(*window, 0.0, analysis);
}

}  // namespace

void analyse_statistics(const FlowRecord& record, Analysis& analysis) {
    if (record.origin() != Origin::simulated) {
        analyse_laboratory_record(record, analysis);
        return;
    }
    if (record.flow() == nullptr) return;
    add_history(record, analysis);
    add_level_history(record, analysis);
    if (!record.series().empty()) add_means(record, analysis);
}

}  // namespace riffle::inline analysis
