#pragma once

#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "analysis/chapter_names.hpp"
#include "analysis/figure.hpp"
#include "analysis/flow_record.hpp"
#include "base/error.hpp"
#include "statistics/confidence.hpp"
#include "statistics/power_spectrum.hpp"

namespace riffle::inline analysis {

// Small helps for the chapters.

inline constexpr const char* measured_in_case = "measured (case file)";

/// "measured (SOURCE)" with the source that the case names.
[[nodiscard]] std::string measured_name(const Case& c);

/// A place or a distance (m) in words: "450 mm", and from ten metres on "12.5 m".
[[nodiscard]] std::string shown_place(double metres);

[[nodiscard]] Axis make_axis(std::string label, std::string unit, bool logarithmic = false);

/// A figure without curves.
[[nodiscard]] Figure make_figure(const char* chapter, std::string key, std::string title, std::string caption,
                                 std::string source, Axis x, Axis y);

/// A curve of these points. Vectors of different lengths are a defect: std::invalid_argument.
[[nodiscard]] Curve make_curve(std::string name, Origin origin, Mark mark, std::vector<double> x,
                               std::vector<double> y, int variant = 0);

/// The line of a spectrum with the bounds of its intervals (chi-square: factors of the density).
[[nodiscard]] Curve spectrum_curve(std::string name, Origin origin, const PowerSpectrum& spectrum,
                                   int variant = 0);

/// A finding with its 95 % half-width, where that is finite.
[[nodiscard]] Finding make_finding(const char* chapter, std::string key, std::string label, std::string unit,
                                   double value, std::optional<double> half_width = std::nullopt);

/// Mark the window of the averages in a figure over time, where it is a part of the record; the heights of
/// crests, datum and mean surface in a profile, as far as they are known.
void mark_window(const FlowRecord& record, Figure& figure);
void mark_levels(const FlowRecord& record, Figure& figure);

/// Add the reference to a finding.
[[nodiscard]] Finding against(Finding finding, const std::optional<double>& reference, std::string name,
                              std::string remark = {});

/// Add a figure for which a run lacks the data; nothing is added for a laboratory record.
void add_missing(const FlowRecord& record, Analysis& analysis, Figure figure, std::string why);

/// Fill a figure and add it; where the data do not allow it (InputError), add it as missing with the reason
/// and, of a laboratory record, say so in a warning.
template <class Fill>
void attempt(const FlowRecord& record, Analysis& analysis, Figure figure, const Fill& fill) {
    try {
        fill(figure);
    } catch (const InputError& error) {
        if (record.origin() != Origin::simulated) {
            analysis.warnings.push_back(figure.title + ": " + error.what());
        }
        figure.curves.clear();
        figure.maps.clear();
        add_missing(record, analysis, std::move(figure), error.what());
        return;
    }
    analysis.figures.push_back(std::move(figure));
}

/// The finding with this key; null if there is none.
[[nodiscard]] const Finding* find_finding(const Analysis& analysis, const std::string& key);

/// Every n-th value so that at most `most` remain, the last one among them.
[[nodiscard]] std::vector<double> thinned(const std::vector<double>& values, std::size_t most = 3000);

/// Linear interpolation in a table with ascending x; not-a-number beyond its ends.
[[nodiscard]] double interpolated(const std::vector<double>& x, const std::vector<double>& y, double at);

}  // namespace riffle::inline analysis
