#include "analysis/figure_csv.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <istream>
#include <iterator>
#include <optional>

#include "analysis/analysis_json.hpp"
#include "analysis/figure_keys.hpp"
#include "base/csv_text.hpp"

namespace riffle::inline analysis {

namespace {

constexpr std::string_view curves_heading = "curve,run,origin,";

std::string heading(const std::string& label, const std::string& unit) {
    return csv_cell(fmt::format("{} [{}]", label, unit.empty() ? "1" : unit));
}

/// Text on comment lines, however many lines it has.
std::string comment(const std::string& text) {
    std::string result;
    std::size_t from = 0;
    while (from <= text.size() && !text.empty()) {
        const std::size_t end = std::min(text.find('\n', from), text.size());
        result += "# " + text.substr(from, end - from) + "\n";
        from = end + 1;
    }
    return result;
}

std::string preamble(const Figure& figure) {
    return comment(figure.title) + comment(figure.source) + comment(figure.caption);
}

bool any_of_curves(const Figure& figure, std::vector<double> Curve::*member) {
    return std::any_of(figure.curves.begin(), figure.curves.end(),
                       [&](const Curve& curve) { return !(curve.*member).empty(); });
}

/// Whether a line is the heading of a map: three cells, each with a unit.
bool is_map_heading(const std::string& line) {
    std::size_t cells = 0;
    bool quoted = false;
    std::string cell;
    for (const char letter : line + ",") {
        if (letter == '"') {
            quoted = !quoted;
        } else if (letter == ',' && !quoted) {
            if (cell.find(" [") == std::string::npos || cell.back() != ']') return false;
            cell.clear();
            ++cells;
        } else {
            cell += letter;
        }
    }
    return cells == 3;
}

std::string optional_cell(const std::vector<double>& values, std::size_t i) {
    return "," + (i < values.size() ? csv_number(values[i]) : std::string());
}

}  // namespace

std::string curves_to_csv(const Figure& figure) {
    if (figure.curves.empty()) return {};
    const bool wide_x = any_of_curves(figure, &Curve::x_half_width);
    const bool wide_y = any_of_curves(figure, &Curve::y_half_width);
    const bool bounded = any_of_curves(figure, &Curve::y_lower);
    std::string text = preamble(figure) + std::string(curves_heading) +
                       heading(figure.x.label, figure.x.unit) + "," + heading(figure.y.label, figure.y.unit);
    if (wide_x) text += "," + heading("half-width of " + figure.x.label, figure.x.unit);
    if (wide_y) text += "," + heading("half-width of " + figure.y.label, figure.y.unit);
    if (bounded) {
        text += "," + heading("lower bound of " + figure.y.label, figure.y.unit) + "," +
                heading("upper bound of " + figure.y.label, figure.y.unit);
    }
    text += "\n";
    for (const Curve& curve : figure.curves) {
        const std::string start =
            csv_cell(curve.name) + "," + csv_cell(curve.run) + "," + word(curve.origin) + ",";
        for (std::size_t i = 0; i < curve.x.size(); ++i) {
            text += start + csv_number(curve.x[i]) + "," + csv_number(curve.y[i]);
            if (wide_x) text += optional_cell(curve.x_half_width, i);
            if (wide_y) text += optional_cell(curve.y_half_width, i);
            if (bounded) text += optional_cell(curve.y_lower, i) + optional_cell(curve.y_upper, i);
            text += "\n";
        }
    }
    return text;
}

std::string map_to_csv(const Figure& figure, const ColourMap& map) {
    std::string text = preamble(figure) + comment(map.run.empty() ? "" : "run: " + map.run) +
                       heading(figure.x.label, figure.x.unit) + "," + heading(figure.y.label, figure.y.unit) +
                       "," + heading(map.label, map.unit) + "\n";
    for (std::size_t j = 0; j < map.y.size(); ++j) {
        for (std::size_t i = 0; i < map.x.size(); ++i) {
            const auto value = static_cast<double>(map.values[j * map.x.size() + i]);
            fmt::format_to(std::back_inserter(text), "{:.9g},{:.9g},{}\n", map.x[i], map.y[j],
                           std::isfinite(value) ? fmt::format("{:.6g}", value) : "");
        }
    }
    return text;
}

std::string findings_to_csv(const std::vector<Analysis>& analyses) {
    std::string text = std::string(findings_heading) + "\n";
    for (const Analysis& analysis : analyses) {
        for (const Finding& f : analysis.findings) {
            text += fmt::format("{},{},{},{},{},{},{},{},{},{}\n", csv_cell(analysis.name), f.chapter, f.key,
                                csv_cell(f.label), csv_number(f.value), csv_number(f.half_width),
                                csv_number(f.reference), csv_cell(f.reference_name), csv_cell(f.unit),
                                csv_cell(f.remark));
        }
    }
    return text;
}

std::vector<CsvFile> figure_to_csv(const Figure& figure) {
    std::vector<CsvFile> files;
    if (!figure.curves.empty()) files.push_back({figure.key + ".csv", curves_to_csv(figure)});
    for (std::size_t i = 0; i < figure.maps.size(); ++i) {
        const std::string number_of_map = i == 0 ? "" : fmt::format("_{}", i + 1);
        files.push_back({figure.key + "_map" + number_of_map + ".csv", map_to_csv(figure, figure.maps[i])});
    }
    return files;
}

bool is_figure_csv_name(std::string_view name, std::string_view chapter) {
    constexpr std::string_view ending = ".csv", of_map = "_map", digits = "0123456789";
    if (!name.ends_with(ending)) return false;
    const std::string_view stem = name.substr(0, name.size() - ending.size());
    if (is_figure_key(stem, chapter)) return true;
    const std::size_t place = stem.rfind(of_map);
    if (place == std::string_view::npos || !is_figure_key(stem.substr(0, place), chapter)) return false;
    const std::string_view number = stem.substr(place + of_map.size());
    return number.empty() || (number.size() > 1 && number.front() == '_' &&
                              number.find_first_not_of(digits, 1) == std::string_view::npos);
}

bool begins_like_analysis_csv(std::istream& file) {
    std::string line;
    bool comments = false;
    while (std::getline(file, line) && line.starts_with("# ")) comments = true;
    if (!comments) return line == findings_heading;
    return line.starts_with(curves_heading) || is_map_heading(line);
}

}  // namespace riffle::inline analysis
