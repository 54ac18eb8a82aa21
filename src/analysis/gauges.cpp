#include "analysis/gauges.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <vector>

#include "analysis/chapter_names.hpp"
#include "analysis/figure_tools.hpp"
#include "analysis/running_means.hpp"
#include "case/flow_kind.hpp"
#include "statistics/confidence.hpp"

namespace riffle::inline analysis {

namespace {

constexpr double response_time = 0.003;  // s

}  // namespace

void add_gauges(const FlowRecord& record, Analysis& analysis) {
    Figure figure = make_figure(
        chapters::forces, "pressure_gauges", "Pressure at the gauges",
        "Pressure of the water over that of the air at the points of the instruments, running means over "
        "3 ms; 0 at a dry point.",
        "", make_axis("time t", "s"), make_axis("pressure p", "Pa"));
    int variant = 0;
    for (const ScalarProbe& probe : record.scalar_probes()) {
        if (probe.kind != "pressure" || probe.value.size() < 2) continue;
        const std::vector<double> means = running_means(probe.time, probe.value, response_time);
        // What rises and falls once has no mean that says anything.
        if (record.flow() != nullptr && !is_undriven(flow_kind(*record.flow()))) {
            const MeanEstimate mean = mean_with_confidence(probe.value);
            analysis.findings.push_back(make_finding(
                chapters::forces, probe.name + "_" + probe.quantity + "_mean",
                probe.label + ", mean over the window", probe.unit, mean.mean, trusted_half_width(mean)));
        }
        const auto largest = std::max_element(means.begin(), means.end());
        const double sample = *std::max_element(probe.value.begin(), probe.value.end());
        Finding finding = make_finding(chapters::forces, probe.name + "_" + probe.quantity + "_largest",
                                       probe.label + ", largest mean over 3 ms", probe.unit, *largest);
        if (*largest > 0.0) {
            finding.remark =
                fmt::format("at t = {:.4g} s; the largest sample is {:.3g} times as large",
                            probe.time[static_cast<std::size_t>(largest - means.begin())], sample / *largest);
        } else {
            const bool dry =
                std::all_of(probe.value.begin(), probe.value.end(), [](double p) { return p == 0.0; });
            finding.remark = dry ? "no water came there" : "it was never above that of the air";
        }
        analysis.findings.push_back(std::move(finding));
        figure.curves.push_back(make_curve(probe.label, record.origin(), Mark::line, thinned(probe.time),
                                           thinned(means), variant++));
    }
    if (!figure.curves.empty()) analysis.figures.push_back(std::move(figure));
}

}  // namespace riffle::inline analysis
