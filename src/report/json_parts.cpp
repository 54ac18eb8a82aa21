#include "report/json_parts.hpp"

#include <cmath>

#include "analysis/analysis_json.hpp"

namespace riffle::inline report {

namespace {

Json estimate_json(const std::optional<SummaryValue>& estimate) {
    if (!estimate) return nullptr;
    Json object = {{"value", exact(estimate->value)}};
    if (estimate->half_width) object["half_width"] = exact(*estimate->half_width);
    return object;
}

}  // namespace

Json rounded(double value) {
    if (!std::isfinite(value)) return nullptr;
    if (value == 0) return 0.0;
    const double scale = std::pow(10.0, 5 - std::floor(std::log10(std::abs(value))));
    return std::isfinite(scale) && scale > 0 ? std::round(value * scale) / scale : value;
}

Json exact(double value) { return std::isfinite(value) ? Json(value) : Json(nullptr); }

Json array_of(const std::vector<double>& values, std::size_t stride) {
    Json array = Json::array();
    for (std::size_t i = 0; i < values.size(); i += stride) array.push_back(rounded(values[i]));
    return array;
}

const char* word(Health mark) {
    switch (mark) {
        case Health::good:
            return "good";
        case Health::caution:
            return "caution";
        case Health::bad:
            return "bad";
        case Health::none:
            break;
    }
    return "none";
}

Json quantity_rows(const std::vector<SummaryRow>& quantities) {
    Json rows = Json::array();
    for (const SummaryRow& row : quantities) {
        rows.push_back({{"key", row.key},
                        {"label", row.label},
                        {"symbol", row.symbol},
                        {"unit", row.unit},
                        {"factor", row.factor},
                        {"digits", row.digits},
                        {"simulated", estimate_json(row.simulated)},
                        {"measured", estimate_json(row.measured)},
                        {"column", estimate_json(row.column)},
                        {"theory", estimate_json(row.theory)}});
    }
    return rows;
}

Json quantities_by_key(const std::vector<SummaryRow>& quantities) {
    Json values = Json::object();
    for (const SummaryRow& row : quantities) {
        values[row.key] = {{"simulated", estimate_json(row.simulated)},
                           {"measured", estimate_json(row.measured)},
                           {"column", estimate_json(row.column)},
                           {"theory", estimate_json(row.theory)}};
    }
    return values;
}

Json diagnostics_json(const std::vector<Diagnostic>& diagnostics) {
    Json array = Json::array();
    for (const Diagnostic& row : diagnostics) {
        array.push_back({{"key", row.key},
                         {"label", row.label},
                         {"value", row.value},
                         {"healthy", row.healthy},
                         {"explanation", row.explanation},
                         {"status", word(row.mark)}});
    }
    return array;
}

Json verdict_json(const Verdict& verdict) {
    return {{"status", word(verdict.mark)}, {"headline", verdict.headline}, {"sentences", verdict.sentences}};
}

Json references_json(const std::vector<Reference>& references) {
    Json array = Json::array();
    for (const Reference& reference : references) {
        array.push_back({{"name", reference.name}, {"citation", reference.citation}});
    }
    return array;
}

Json findings_json(const Analysis& analysis) {
    Analysis numbers;
    numbers.findings = analysis.findings;
    return Json::parse(analysis_to_json({numbers})).at("analyses").at(0).at("findings");
}

std::string json_text(const Json& json, int indent) {
    return json.dump(indent, ' ', false, Json::error_handler_t::replace);
}

}  // namespace riffle::inline report
