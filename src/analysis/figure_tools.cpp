#include "analysis/figure_tools.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <stdexcept>
#include <utility>

#include "base/interpolation.hpp"
#include "case/flow_kind.hpp"
#include "record/flow_fields.hpp"
#include "statistics/confidence.hpp"

namespace riffle::inline analysis {

std::string measured_name(const Case& c) {
    return c.measured.source.empty() ? measured_in_case : "measured (" + c.measured.source + ")";
}

std::string shown_place(double metres) {
    constexpr double long_channel = 9.999;  // what four digits of millimetres hold
    return std::abs(metres) < long_channel ? fmt::format("{:.4g} mm", 1e3 * metres)
                                           : fmt::format("{:.4g} m", metres);
}

Axis make_axis(std::string label, std::string unit, bool logarithmic) {
    Axis axis;
    axis.label = std::move(label);
    axis.unit = std::move(unit);
    axis.logarithmic = logarithmic;
    return axis;
}

Figure make_figure(const char* chapter, std::string key, std::string title, std::string caption,
                   std::string source, Axis x, Axis y) {
    Figure figure;
    figure.key = std::move(key);
    figure.chapter = chapter;
    figure.title = std::move(title);
    figure.caption = std::move(caption);
    figure.source = std::move(source);
    figure.x = std::move(x);
    figure.y = std::move(y);
    return figure;
}

Curve make_curve(std::string name, Origin origin, Mark mark, std::vector<double> x, std::vector<double> y,
                 int variant) {
    if (x.size() != y.size()) throw std::invalid_argument("curve " + name + ": x and y differ in length");
    Curve curve;
    curve.name = std::move(name);
    curve.origin = origin;
    curve.mark = mark;
    curve.x = std::move(x);
    curve.y = std::move(y);
    curve.variant = variant;
    return curve;
}

Curve spectrum_curve(std::string name, Origin origin, const PowerSpectrum& spectrum, int variant) {
    Curve curve =
        make_curve(std::move(name), origin, Mark::line, spectrum.frequency, spectrum.density, variant);
    for (std::size_t i = 0; i < curve.y.size(); ++i) {
        curve.y_lower.push_back(curve.y[i] * spectrum.lower[i]);
        curve.y_upper.push_back(curve.y[i] * spectrum.upper[i]);
    }
    return curve;
}

Finding make_finding(const char* chapter, std::string key, std::string label, std::string unit, double value,
                     std::optional<double> half_width) {
    Finding finding;
    finding.key = std::move(key);
    finding.chapter = chapter;
    finding.label = std::move(label);
    finding.unit = std::move(unit);
    finding.value = value;
    // Below this it is rounding of a value that does not vary, not an uncertainty.
    constexpr double rounding = 1e-12;
    if (half_width && std::isfinite(*half_width) &&
        (*half_width == 0.0 || *half_width > rounding * std::abs(value))) {
        finding.half_width = half_width;
    }
    return finding;
}

void mark_window(const FlowRecord& record, Figure& figure) {
    const TimeWindow window = record.window();
    const std::vector<double>& time = record.series()[fields::time_series.time];
    if (time.empty()) return;
    const double length = time.back() - time.front();
    if (window.length() > 0.0 && window.length() < 0.99 * length) {
        figure.guides.push_back({"averaging window", true, window.from, window.to});
    }
}

void mark_levels(const FlowRecord& record, Figure& figure) {
    const Case* const c = record.flow();
    if (c == nullptr) return;
    if (has_rough_bed(*c)) {
        figure.guides.push_back({"datum", false, c->datum(), c->datum()});
        figure.guides.push_back({"crests", false, c->crest(), c->crest()});
    }
    const std::vector<double> levels = within_window(record, fields::time_series.mean_level);
    const double mean = levels.size() > 1 ? mean_with_confidence(levels).mean : 0.0;
    const double height = mean > 0.0 ? mean : c->total_depth();
    figure.guides.push_back({mean > 0.0 ? "mean level" : "depth", false, height, height});
}

Finding against(Finding finding, const std::optional<double>& reference, std::string name,
                std::string remark) {
    if (reference && std::isfinite(*reference)) {
        finding.reference = reference;
        finding.reference_name = std::move(name);
    }
    if (!remark.empty()) finding.remark = std::move(remark);
    return finding;
}

void add_missing(const FlowRecord& record, Analysis& analysis, Figure figure, std::string why) {
    if (record.origin() != Origin::simulated) return;
    figure.missing = std::move(why);
    analysis.figures.push_back(std::move(figure));
}

const Finding* find_finding(const Analysis& analysis, const std::string& key) {
    const auto found = std::find_if(analysis.findings.begin(), analysis.findings.end(),
                                    [&](const Finding& finding) { return finding.key == key; });
    return found == analysis.findings.end() ? nullptr : &*found;
}

std::vector<double> thinned(const std::vector<double>& values, std::size_t most) {
    if (values.size() <= most || most < 2) return values;
    const std::size_t stride = (values.size() + most - 2) / (most - 1);
    std::vector<double> result;
    for (std::size_t i = 0; i < values.size(); i += stride) result.push_back(values[i]);
    if ((values.size() - 1) % stride != 0) result.push_back(values.back());
    return result;
}

double interpolated(const std::vector<double>& x, const std::vector<double>& y, double at) {
    if (x.empty() || at < x.front() || at > x.back()) return std::numeric_limits<double>::quiet_NaN();
    return place_in(x, at).in(y);
}

}  // namespace riffle::inline analysis
