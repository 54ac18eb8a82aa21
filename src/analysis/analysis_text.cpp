#include "analysis/analysis_text.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <iterator>

#include "analysis/chapters.hpp"
#include "analysis/figure_tools.hpp"
#include "base/wrapped_text.hpp"

namespace riffle::inline analysis {

namespace {

std::string printed_value(double value) { return std::isfinite(value) ? fmt::format("{:.4g}", value) : "-"; }

/// Two significant digits: the half-width itself is not known better.
std::string uncertainty(double half_width) { return fmt::format("{:.2g}", half_width); }

std::string unit_of(const Finding& finding) { return finding.unit == "1" ? "" : finding.unit; }

/// Relative difference to the reference; to a reference of zero there is none.
std::string difference(const Finding& finding) {
    if (!finding.reference || *finding.reference == 0.0 || !std::isfinite(finding.value)) return "";
    const double percent = 100.0 * (finding.value / *finding.reference - 1.0);
    return std::abs(percent) < 1000.0 ? fmt::format("{:+.1f} %", percent) : fmt::format("{:+.2g} %", percent);
}

std::string padded(const std::string& text, std::size_t width) {
    const std::size_t has = columns_of(text);
    return text + std::string(has < width ? width - has : 0, ' ');
}

std::string right(const std::string& text, std::size_t width) {
    const std::size_t has = columns_of(text);
    return std::string(has < width ? width - has : 0, ' ') + text;
}

std::string trimmed(std::string line) {
    line.erase(line.find_last_not_of(' ') + 1);
    return line + "\n";
}

/// Columns of the labels at most: value, interval and unit then stand beside them on 80 columns.
constexpr std::size_t widest_label = 42;
constexpr std::size_t further_indent = 6;  // of what else is said of a finding

/// A line of its own, or several.
std::string further_lines(const std::string& text) {
    return wrapped_text(std::string(further_indent, ' ') + text, further_indent) + "\n";
}

/// A label in as many lines as it takes, the last one as wide as a label may be: values stand behind it.
std::string label_lines(const std::string& label, std::size_t width) {
    const std::string lines = wrapped_text("  " + label, 4, 2 + width);
    const std::size_t last = lines.rfind('\n') + 1;  // npos + 1 is 0
    return lines.substr(0, last) + padded(lines.substr(last), 2 + width);
}

std::string finding_lines(const Finding& finding, std::size_t label_width) {
    std::string lines = label_lines(finding.label, label_width) + right(printed_value(finding.value), 12);
    lines += finding.half_width ? " ± " + padded(uncertainty(*finding.half_width), 10) : std::string(13, ' ');
    lines = trimmed(lines + padded(unit_of(finding), 8));
    if (finding.reference) {
        const std::string apart = difference(finding);
        lines += further_lines(printed_value(*finding.reference) + ": " + finding.reference_name +
                               (apart.empty() ? "" : ", " + apart));
    }
    if (!finding.remark.empty()) lines += further_lines(finding.remark);
    return lines;
}

/// What two labels of one quantity share: up to the comma before the place where they differ, such as the
/// height of a point, which is another one in each record.
std::string common_label(const std::string& a, const std::string& b) {
    if (a == b) return a;
    const auto differ = std::mismatch(a.begin(), a.end(), b.begin(), b.end()).first;
    const std::size_t comma = std::string(a.begin(), differ).rfind(", ");
    return comma == std::string::npos ? a : a.substr(0, comma);
}

std::size_t label_width(const std::vector<Finding>& findings) {
    std::size_t width = 0;
    for (const Finding& finding : findings) width = std::max(width, columns_of(finding.label));
    return std::min(width, widest_label);
}

}  // namespace

std::string analysis_to_text(const Analysis& analysis) {
    std::string text = fmt::format("{}\n{}\n", analysis.name, analysis.source);
    const std::size_t width = label_width(analysis.findings);
    for (const Chapter& chapter : analysis_chapters()) {
        std::string lines;
        for (const Finding& finding : analysis.findings) {
            if (finding.chapter == chapter.name) lines += finding_lines(finding, width);
        }
        if (!lines.empty()) text += fmt::format("\n{}\n{}", chapter.title, lines);
    }
    if (analysis.findings.empty()) text += "\nNothing could be found in this record.\n";
    std::string missing;
    for (const Figure& figure : analysis.figures) {
        if (!figure.missing.empty()) {
            missing += wrapped_text("  " + figure.key + ": " + figure.missing, 4) + "\n";
        }
    }
    if (!missing.empty()) text += "\nFigures without data\n" + missing;
    if (!analysis.warnings.empty()) text += "\nWarnings\n";
    for (const std::string& warning : analysis.warnings) text += wrapped_text("  " + warning, 4) + "\n";
    return text;
}

std::string comparison_to_text(const std::vector<Analysis>& analyses) {
    std::vector<Finding> rows;  // one of each key, in the order of the chapters
    for (const Chapter& chapter : analysis_chapters()) {
        for (const Analysis& analysis : analyses) {
            for (const Finding& finding : analysis.findings) {
                const auto known = std::find_if(rows.begin(), rows.end(),
                                                [&](const Finding& row) { return row.key == finding.key; });
                if (known != rows.end()) {
                    known->label = common_label(known->label, finding.label);
                } else if (finding.chapter == chapter.name) {
                    rows.push_back(finding);
                }
            }
        }
    }
    const std::size_t width = label_width(rows);
    constexpr std::size_t column = 24;
    std::string text = "Comparison\n";
    for (std::size_t i = 0; i < analyses.size(); ++i) {
        // A name that is made from the source needs no source beside it.
        const bool tells_source = analyses[i].name.find(analyses[i].source) != std::string::npos;
        text += fmt::format("  ({}) {}{}\n", i + 1, analyses[i].name,
                            tells_source ? "" : ", " + analyses[i].source);
    }
    std::string heading = "  " + padded("", width + 8);
    for (std::size_t i = 0; i < analyses.size(); ++i) heading += right(fmt::format("({})", i + 1), column);
    text += trimmed(heading);
    for (const Finding& row : rows) {
        std::string line = label_lines(row.label, width) + " " + padded(unit_of(row), 7);
        std::size_t found = 0;
        for (const Analysis& analysis : analyses) {
            const Finding* const finding = find_finding(analysis, row.key);
            std::string cell = "-";
            if (finding != nullptr) {
                ++found;
                cell = printed_value(finding->value);
                if (finding->half_width) cell += " ± " + uncertainty(*finding->half_width);
            }
            line += right(cell, column);
        }
        if (found > 1) text += trimmed(line);
    }
    return text;
}

}  // namespace riffle::inline analysis
