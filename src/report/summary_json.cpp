#include "report/summary_json.hpp"

#include <fmt/format.h>

#include "case/bed_traits.hpp"
#include "case/flow_kind.hpp"
#include "record/run_fields.hpp"

namespace riffle::inline report {

Json summary_object(const ReportData& data, const Analysis& analysis) {
    const std::vector<SummaryRow> quantities = summarize(data, analysis);
    const std::vector<Diagnostic> diagnostics = diagnose(data, analysis);
    return {{"format", "riffle-report-summary"},
            {"title", data.title},
            {"riffle_version", data.riffle_version},
            {"build", data.build},
            {"results", data.source.string()},
            {"complete", data.complete},
            {"failure", data.failure},
            {"flow_kind", flow_kind_word(flow_kind(data.flow))},
            {"converged", find_value(data.summary, fields::summary.converged).value_or(0.0) != 0.0},
            {"window", {{"start", data.window_start}, {"end", data.window_end}}},
            {"quantities", quantities_by_key(quantities)},
            {"diagnostics", diagnostics_json(diagnostics)},
            {"verdict", verdict_json(judge(data, quantities, diagnostics))},
            {"findings", findings_json(analysis)},
            {"warnings", analysis.warnings}};
}

std::string summary_json(const ReportData& data, const Analysis& analysis) {
    return json_text(summary_object(data, analysis), 2) + "\n";
}

std::string flow_line(const ReportData& data) {
    const Case& c = data.flow;
    return fmt::format("Riffle {} · water depth {:.4g} mm above the datum, slope {:.4g}{}",
                       data.riffle_version, 1000 * c.channel.depth, c.channel.slope,
                       has_spheres(c.bed)
                           ? fmt::format(", spheres of {:.3g} mm", 1000 * c.bed.sphere_diameter)
                           : std::string{});
}

}  // namespace riffle::inline report
