#include "cli/svg_drawing.hpp"

#include <fmt/format.h>

#include <cmath>
#include <cstddef>

#include "base/markup.hpp"

namespace riffle::inline cli {

namespace {

/// About five round numbers between the ends.
std::vector<double> ticks(double low, double high) {
    const double rough = (high - low) / 5.0;
    const double power = std::pow(10.0, std::floor(std::log10(rough)));
    double step = power;
    for (const double factor : {2.0, 5.0, 10.0}) {
        if (step < rough) step = factor * power;
    }
    std::vector<double> result;
    for (double value = std::ceil(low / step - 1e-9); value * step <= high + 1e-9 * step; value += 1.0) {
        result.push_back(value == 0.0 ? 0.0 : value * step);  // no -0
    }
    return result;
}

}  // namespace

std::string svg_begin(double width, double height, double left, const std::string& title,
                      const std::string& subtitle) {
    std::string svg = fmt::format(
        "<svg xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"0 0 {0:.0f} {1:.0f}\" width=\"{0:.0f}\" "
        "height=\"{1:.0f}\" font-family=\"sans-serif\" font-size=\"13\" fill=\"#222\">\n"
        "<rect width=\"100%\" height=\"100%\" fill=\"#fff\"/>\n",
        width, height);
    svg += svg_text(left, 26.0, title, R"(font-size="17" font-weight="bold")");
    return svg + svg_text(left, 46.0, subtitle, "fill=\"#555\"");
}

std::string svg_text(double x, double y, const std::string& text, const char* extra) {
    return fmt::format("<text x=\"{:.1f}\" y=\"{:.1f}\" {}>{}</text>\n", x, y, extra, escape_markup(text));
}

std::string svg_line(double x1, double y1, double x2, double y2, const char* style) {
    return fmt::format("<line x1=\"{:.1f}\" y1=\"{:.1f}\" x2=\"{:.1f}\" y2=\"{:.1f}\" {}/>\n", x1, y1, x2, y2,
                       style);
}

std::string svg_axes(const SvgPanel& p, const std::string& x_title, const std::string& y_title) {
    std::string svg;
    for (const double value : ticks(p.x_low, p.x_high)) {
        svg += svg_line(p.x(value), p.top + p.height, p.x(value), p.top + p.height + 5.0, "stroke=\"#555\"");
        svg += svg_text(p.x(value), p.top + p.height + 19.0, fmt::format("{:g}", value),
                        "text-anchor=\"middle\"");
    }
    for (const double value : ticks(p.y_low, p.y_high)) {
        svg += svg_line(p.left - 5.0, p.y(value), p.left, p.y(value), "stroke=\"#555\"");
        svg += svg_text(p.left - 8.0, p.y(value) + 4.0, fmt::format("{:g}", value), "text-anchor=\"end\"");
    }
    svg += fmt::format(
        "<rect x=\"{:.1f}\" y=\"{:.1f}\" width=\"{:.1f}\" height=\"{:.1f}\" fill=\"none\" "
        "stroke=\"#555\"/>\n",
        p.left, p.top, p.width, p.height);
    svg += svg_text(p.left + 0.5 * p.width, p.top + p.height + 38.0, x_title, "text-anchor=\"middle\"");
    svg += fmt::format(
        "<text transform=\"translate({:.1f} {:.1f}) rotate(-90)\" text-anchor=\"middle\">{}</text>\n",
        p.left - 54.0, p.top + 0.5 * p.height, escape_markup(y_title));
    return svg;
}

std::string svg_path(const std::vector<double>& x, const std::vector<double>& y, const SvgPanel& p,
                     const char* style) {
    std::string points;
    for (std::size_t i = 0; i < x.size(); ++i) {
        points += fmt::format("{}{:.1f} {:.1f}", i == 0 ? "M" : "L", p.x(x[i]), p.y(y[i]));
    }
    return fmt::format("<path d=\"{}\" fill=\"none\" {}/>\n", points, style);
}

}  // namespace riffle::inline cli
