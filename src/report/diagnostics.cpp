#include "report/diagnostics.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <span>
#include <utility>

#include "statistics/confidence.hpp"

namespace riffle {

namespace {

/// Mark of a size that should not exceed `bar`.
Health mark_of(double size, double bar) {
    if (!std::isfinite(size)) return Health::bad;
    if (size <= bar) return Health::good;
    return size <= 2 * bar ? Health::caution : Health::bad;
}

std::string percent(double share, int digits = 2) {
    std::string text = fmt::format("{:.{}f} %", 100 * share, digits);
    if (text.front() == '-') text.replace(0, 1, "−");
    return text;
}

std::string signed_percent(double share) { return (share < 0 ? "" : "+") + percent(share, 3); }

/// The part of a series inside the averaging window; all of it before there is a window.
std::span<const double> in_window(const ReportData& data, const std::string& name) {
    const auto& time = data.series.at("time");
    const auto& values = data.series.at(name);
    if (data.window_end <= data.window_start) return values;
    const auto first = std::lower_bound(time.begin(), time.end(), data.window_start);
    const auto last = std::upper_bound(first, time.end(), data.window_end);
    return std::span(values).subspan(static_cast<std::size_t>(first - time.begin()),
                                     static_cast<std::size_t>(last - first));
}

/// One diagnostic per function: it adds its row if the file has what it needs.
class Rows {
  public:
    explicit Rows(const ReportData& data)
        : data_(data),
          stirred_(data.flow.stirring.acceleration > 0),
          space_(data.flow.channel.dimensions == 3) {}

    void interval() {
        const auto mean = value("depth_mean_velocity");
        const auto half = value("depth_mean_velocity_half_width");
        // Without a slope there is no mean flow whose certainty could be given in percent.
        if (!mean || !half || *mean == 0 || data_.flow.channel.slope <= 0) return;
        const double share = *half / std::abs(*mean);
        const double bar = data_.flow.run.tolerance;
        add({"velocity_interval", "Certainty of the depth-mean velocity", "± " + percent(share),
             "at most ± " + percent(bar),
             "Half-width of the 95 % confidence interval of the time mean, with the correlation of "
             "successive values "
             "taken into account. If it is too wide, run longer.",
             mark_of(share, bar)});
    }

    void start_up() {
        const auto relaxation = find_value(data_.column_summary, "relaxation_time");
        if (!relaxation || *relaxation <= 0 || data_.window_end <= data_.window_start) return;
        const double times = data_.window_start / *relaxation;
        add({"start_up", "Time before averaging", fmt::format("{:.1f} relaxation times", times), "at least 3",
             fmt::format("Departures from the steady flow die out with an e-folding time of {:.2f} s. "
                         "Averages taken too "
                         "early still carry the start.",
                         *relaxation),
             times >= 3   ? Health::good
             : times >= 1 ? Health::caution
                          : Health::bad});
    }

    void budget() {
        const auto drag = value("drag_over_gravity");
        if (!drag || data_.flow.channel.slope <= 0) return;
        const double share =
            *drag + value("wall_over_gravity").value_or(0.0) + value("side_wall_over_gravity").value_or(0.0);
        add({"force_budget", "Drag and wall friction over the weight component", percent(share), "100 ± 1 %",
             "In steady uniform flow the bed must carry the whole component of the water's weight down the "
             "slope. "
             "More: the flow still slows down, or numerical friction acts; less: it still speeds up.",
             mark_of(std::abs(share - 1), 0.01)});
    }

    void spurious_stress() {
        const auto share = value("spurious_stress_rms");
        if (!share) return;
        const double bar = space_ ? 0.01 : stirred_ ? 0.015 : 0.005;
        add({"spurious_stress", "Spurious shear stress of the pressure",
             percent(*share) + " of the bed stress", "at most " + percent(bar, 1),
             "Pressure alone must not drag layers along each other. In a particle method it can, when "
             "particles lie "
             "unevenly; a few percent of the bed stress would act as an additional roughness. Rms over the "
             "depth.",
             mark_of(*share, bar)});
    }

    void stress_error() {
        const auto share = value("stress_error_rms");
        if (!share) return;
        const double bar = space_ ? 0.035 : 0.015;
        add({"stress_error", "Total shear stress against the analytic line",
             percent(*share) + " of the stress at the crests", "at most " + percent(bar, 1),
             "In steady uniform flow the shear stress grows linearly from the surface down. Rms departure "
             "above the crests.",
             mark_of(*share, bar)});
    }

    void velocity_errors() {
        // The bars of three dimensions are wider: the spheres stand at their places, which no twin knows.
        if (space_) {
            velocity_error("above", "above the crests", 0.02, 0.04);
            velocity_error("below", "below the crests", 0.10, 0.15);
            return;
        }
        velocity_error("above", "above the crests", 0.01, 0.02);
        // The thin layers between the bed elements are harder to resolve; less so with a wide kernel.
        const bool wide = data_.flow.numerics.smoothing_ratio >= 2;
        velocity_error("below", "below the crests", wide ? 0.025 : 0.03, wide ? 0.04 : 0.06);
    }

    void depth_drift() {
        if (!has_column(data_.series, "mean_level") || !has_column(data_.series, "time")) return;
        auto levels = in_window(data_, "mean_level");
        auto times = in_window(data_, "time");
        // A run's first rows may precede the first sample of the surface.
        while (!levels.empty() && !std::isfinite(levels.front())) {
            levels = levels.subspan(1);
            times = times.subspan(1);
        }
        constexpr std::size_t fewest = 20;
        if (levels.size() < fewest) return;
        const double interval = (times.back() - times.front()) / static_cast<double>(times.size() - 1);
        if (!(interval > 0)) return;
        const TrendEstimate trend = trend_with_confidence(levels);
        const double minute = 60.0 / interval;
        const double depth = data_.flow.total_depth();
        add({"depth_drift", "Drift of the water level",
             fmt::format("{:+.3f} ± {:.3f} mm per minute", 1000 * trend.slope * minute,
                         1000 * trend.half_width * minute),
             fmt::format("at most {:.2f} mm per minute, 0.5 % of the depth", 1000 * 0.005 * depth),
             "Water is neither lost nor added, so the level must stay. A drift means that the particles' "
             "volume changes.",
             drift_mark(std::abs(trend.slope) * minute / depth, trend.half_width * minute / depth)});
    }

    void density() {
        if (!has_column(data_.series, "density_deviation_minimum") ||
            !has_column(data_.series, "density_deviation_maximum")) {
            return;
        }
        const auto low = in_window(data_, "density_deviation_minimum");
        const auto high = in_window(data_, "density_deviation_maximum");
        if (low.empty() || high.empty()) return;
        const double least = *std::min_element(low.begin(), low.end());
        const double most = *std::max_element(high.begin(), high.end());
        add({"density_range", "Range of the density", signed_percent(least) + " to " + signed_percent(most),
             "within ± 1.5 %",
             "The water is treated as slightly compressible: its own weight alone may compress it by up to 1 "
             "% at the bed. "
             "More tells of pressure noise.",
             mark_of(std::max(std::abs(least), std::abs(most)), 0.015)});
    }

    void order() {
        if (!has_column(data_.series, "particle_order")) return;
        const auto values = in_window(data_, "particle_order");
        if (values.empty()) return;
        add({"particle_order", "Order of the particles",
             fmt::format("{:.2f} (mean over the window)", mean_with_confidence(values).mean),
             "1: perfect layers, 0: none",
             "A flow without resolved turbulence lets the particles slide in layers. Loss of order is not "
             "wrong in "
             "itself; it tells how hard the test of the pressure form is.",
             Health::none});
    }

    void fluctuation() {
        if (!has_column(data_.series, "velocity_fluctuation")) return;
        const auto values = in_window(data_, "velocity_fluctuation");
        const auto friction = value("friction_velocity");
        if (values.empty()) return;
        const double mean = mean_with_confidence(values).mean;
        std::string text = fmt::format("{:.2f} mm/s", 1000 * mean);
        if (friction && *friction > 0)
            text += fmt::format(" ({:.0f} % of the friction velocity)", 100 * mean / *friction);
        add({"velocity_fluctuation", "Velocity fluctuation of the particles", text,
             stirred_ ? "set by the stirring force" : "small where the closure carries the turbulence",
             "Rms departure from the mean of the layer. The closure stands for the turbulence, so the "
             "particles "
             "themselves need not fluctuate as the water in a flume does.",
             Health::none});
    }

    [[nodiscard]] std::vector<Diagnostic> take() { return std::move(rows_); }

  private:
    [[nodiscard]] std::optional<double> value(const std::string& name) const {
        return find_value(data_.summary, name);
    }
    void add(Diagnostic row) { rows_.push_back(std::move(row)); }

    /// A drift counts as bad only where it stands out of its own uncertainty.
    static Health drift_mark(double drift, double half_width) {
        constexpr double bar = 0.005;
        const Health mark = mark_of(drift, bar);
        return mark == Health::bad && drift - half_width <= bar ? Health::caution : mark;
    }

    void velocity_error(const std::string& part, const std::string& where, double rms_bar,
                        double maximum_bar) {
        const auto rms = value("velocity_error_" + part + "_rms");
        const auto maximum = value("velocity_error_" + part + "_maximum");
        if (!rms || !maximum) return;
        add({"velocity_error_" + part, "Velocity " + where + " against the column twin",
             fmt::format("rms {}, largest {}", percent(*rms), percent(*maximum)),
             fmt::format("rms at most {}, largest at most {}", percent(rms_bar, 1), percent(maximum_bar, 0)),
             "The column twin is the exact steady solution of the same equations, so this is the error of "
             "the "
             "particles, not of the model.",
             std::max(mark_of(*rms, rms_bar), mark_of(*maximum, maximum_bar))});
    }

    const ReportData& data_;
    bool stirred_;
    bool space_;
    std::vector<Diagnostic> rows_;
};

}  // namespace

std::vector<Diagnostic> diagnose(const ReportData& data) {
    Rows rows(data);
    rows.interval();
    rows.start_up();
    rows.budget();
    rows.spurious_stress();
    rows.stress_error();
    rows.velocity_errors();
    rows.depth_drift();
    rows.density();
    rows.order();
    rows.fluctuation();
    return rows.take();
}

}  // namespace riffle
