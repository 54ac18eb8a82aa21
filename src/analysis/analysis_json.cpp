#include "analysis/analysis_json.hpp"

#include <cmath>
#include <nlohmann/json.hpp>
#include <optional>

#include "base/version.hpp"

namespace riffle::inline analysis {

namespace {

using Json = nlohmann::ordered_json;

constexpr int curve_digits = 9;
constexpr int map_digits = 6;

Json number(double value) { return std::isfinite(value) ? Json(value) : Json(nullptr); }

Json rounded(double value, int digits) {
    if (!std::isfinite(value)) return nullptr;
    if (value == 0.0) return 0.0;
    const double scale = std::pow(10.0, digits - 1 - std::floor(std::log10(std::abs(value))));
    return std::isfinite(scale) && scale > 0.0 ? std::round(value * scale) / scale : value;
}

template <class Values>
Json array_of(const Values& values, int digits) {
    Json array = Json::array();
    for (const auto value : values) array.push_back(rounded(static_cast<double>(value), digits));
    return array;
}

Json optional_number(const std::optional<double>& value) { return value ? number(*value) : Json(nullptr); }

Json axis_json(const Axis& axis) {
    return {{"label", axis.label},
            {"unit", axis.unit},
            {"logarithmic", axis.logarithmic},
            {"equal_scale", axis.equal_scale},
            {"from", optional_number(axis.from)},
            {"to", optional_number(axis.to)}};
}

Json curve_json(const Curve& curve) {
    return {{"name", curve.name},
            {"origin", word(curve.origin)},
            {"mark", word(curve.mark)},
            {"run", curve.run},
            {"variant", curve.variant},
            {"x", array_of(curve.x, curve_digits)},
            {"y", array_of(curve.y, curve_digits)},
            {"x_half_width", array_of(curve.x_half_width, curve_digits)},
            {"y_half_width", array_of(curve.y_half_width, curve_digits)},
            {"y_lower", array_of(curve.y_lower, curve_digits)},
            {"y_upper", array_of(curve.y_upper, curve_digits)}};
}

Json map_json(const ColourMap& map) {
    Json json = {{"label", map.label},
                 {"unit", map.unit},
                 {"diverging", map.diverging},
                 {"logarithmic", map.logarithmic},
                 {"run", map.run},
                 {"x", array_of(map.x, curve_digits)},
                 {"y", array_of(map.y, curve_digits)},
                 {"values", array_of(map.values, map_digits)}};
    if (map.contours) json["contours"] = true;
    return json;
}

Json guide_json(const Guide& guide) {
    return {{"name", guide.name},
            {"axis", guide.on_x ? "x" : "y"},
            {"from", number(guide.from)},
            {"to", number(guide.to)}};
}

Json figure_json(const Figure& figure) {
    Json curves = Json::array();
    for (const Curve& curve : figure.curves) curves.push_back(curve_json(curve));
    Json maps = Json::array();
    for (const ColourMap& map : figure.maps) maps.push_back(map_json(map));
    Json guides = Json::array();
    for (const Guide& guide : figure.guides) guides.push_back(guide_json(guide));
    return {{"key", figure.key},         {"chapter", figure.chapter},  {"title", figure.title},
            {"caption", figure.caption}, {"source", figure.source},    {"missing", figure.missing},
            {"x", axis_json(figure.x)},  {"y", axis_json(figure.y)},   {"curves", std::move(curves)},
            {"maps", std::move(maps)},   {"guides", std::move(guides)}};
}

Json finding_json(const Finding& finding) {
    return {{"key", finding.key},
            {"chapter", finding.chapter},
            {"label", finding.label},
            {"unit", finding.unit},
            {"value", number(finding.value)},
            {"half_width", optional_number(finding.half_width)},
            {"reference", optional_number(finding.reference)},
            {"reference_name", finding.reference_name},
            {"remark", finding.remark}};
}

std::string dumped(const Json& json, int indent) {
    return json.dump(indent, ' ', false, Json::error_handler_t::replace);
}

}  // namespace

const char* word(Origin origin) {
    switch (origin) {
        case Origin::simulated:
            return "simulated";
        case Origin::measured:
            return "measured";
        case Origin::column:
            return "column";
        case Origin::theory:
            return "theory";
        case Origin::fit:
            return "fit";
        case Origin::reference:
            break;
    }
    return "reference";
}

const char* word(Mark mark) {
    switch (mark) {
        case Mark::line:
            return "line";
        case Mark::points:
            return "points";
        case Mark::line_and_points:
            return "line_and_points";
        case Mark::bars:
            return "bars";
        case Mark::area:
            break;
    }
    return "area";
}

std::string analysis_to_json(const std::vector<Analysis>& analyses, int indent) {
    Json list = Json::array();
    for (const Analysis& analysis : analyses) {
        Json findings = Json::array();
        for (const Finding& finding : analysis.findings) findings.push_back(finding_json(finding));
        Json figures = Json::array();
        for (const Figure& figure : analysis.figures) figures.push_back(figure_json(figure));
        list.push_back({{"name", analysis.name},
                        {"source", analysis.source},
                        {"warnings", analysis.warnings},
                        {"findings", std::move(findings)},
                        {"figures", std::move(figures)}});
    }
    return dumped({{"format", "riffle-analysis"},
                   {"format_version", analysis_json_version},
                   {"riffle_version", version()},
                   {"analyses", std::move(list)}},
                  indent);
}

std::string figure_to_json(const Figure& figure, int indent) { return dumped(figure_json(figure), indent); }

}  // namespace riffle::inline analysis
