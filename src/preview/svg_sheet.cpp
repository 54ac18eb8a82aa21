#include "preview/svg_sheet.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "base/markup.hpp"

namespace riffle::inline preview {

namespace {

/// Round numbers between the ends, about so many.
std::vector<double> round_numbers(double low, double high, double about) {
    const double rough = (high - low) / about;
    const double power = std::pow(10.0, std::floor(std::log10(rough)));
    double step = power;
    for (const double factor : {2.0, 5.0, 10.0}) {
        step = step < rough ? factor * power : step;
    }
    std::vector<double> numbers;
    for (double i = std::ceil(low / step - 1e-9); i * step <= high + 1e-9 * step; i += 1.0) {
        numbers.push_back(i == 0.0 ? 0.0 : i * step);
    }
    return numbers;
}

}  // namespace

SheetUnit SheetUnit::of(double extent) { return extent < 2.0 ? SheetUnit{1e-3, "mm"} : SheetUnit{1.0, "m"}; }

std::string SheetUnit::text(double length) const { return fmt::format("{:.4g} {}", length / metres, name); }

void SvgSheet::text(double x, double y, const std::string& text, const std::string& style) {
    body_ += fmt::format("<text x=\"{:.1f}\" y=\"{:.1f}\" {}>{}</text>\n", x, y, style, escape_markup(text));
}

void SvgSheet::line(double x1, double y1, double x2, double y2, const std::string& style) {
    body_ += fmt::format("<line x1=\"{:.1f}\" y1=\"{:.1f}\" x2=\"{:.1f}\" y2=\"{:.1f}\" {}/>\n", x1, y1, x2,
                         y2, style);
}

void SvgSheet::rectangle(double x, double y, double width, double height, const std::string& style) {
    body_ += fmt::format("<rect x=\"{:.1f}\" y=\"{:.1f}\" width=\"{:.1f}\" height=\"{:.1f}\" {}/>\n", x, y,
                         std::max(width, 0.0), std::max(height, 0.0), style);
}

void SvgSheet::circle(double x, double y, double radius, const std::string& style) {
    body_ += fmt::format("<circle cx=\"{:.1f}\" cy=\"{:.1f}\" r=\"{:.2f}\" {}/>\n", x, y, radius, style);
}

void SvgSheet::path(const std::string& d, const std::string& style) {
    if (!d.empty()) {
        body_ += fmt::format("<path d=\"{}\" {}/>\n", d, style);
    }
}

std::string polygon_path(const SheetView& view, const std::vector<SheetPoint>& corners) {
    std::string d;
    for (std::size_t i = 0; i < corners.size(); ++i) {
        d += fmt::format("{}{:.1f} {:.1f}", i == 0 ? "M" : "L", view.x(corners[i].x), view.y(corners[i].y));
    }
    return d.empty() ? d : d + "Z";
}

void SvgSheet::polygon(const SheetView& view, const std::vector<SheetPoint>& corners,
                       const std::string& style) {
    path(polygon_path(view, corners), style);
}

void SvgSheet::arrow(double x1, double y1, double x2, double y2, const std::string& colour) {
    line(x1, y1, x2, y2, fmt::format(R"(stroke="{}" stroke-width="1.6")", colour));
    const double length = std::hypot(x2 - x1, y2 - y1);
    const double u = (x2 - x1) / length;
    const double v = (y2 - y1) / length;
    path(fmt::format("M{:.1f} {:.1f}L{:.1f} {:.1f}L{:.1f} {:.1f}Z", x2, y2, x2 - 8.0 * u + 3.5 * v,
                     y2 - 8.0 * v - 3.5 * u, x2 - 8.0 * u - 3.5 * v, y2 - 8.0 * v + 3.5 * u),
         fmt::format(R"(fill="{}")", colour));
}

void SvgSheet::dimension(double x1, double y1, double x2, double y2, const std::string& words) {
    const double middle_x = 0.5 * (x1 + x2);
    const double middle_y = 0.5 * (y1 + y2);
    if (std::hypot(x2 - x1, y2 - y1) > 20.0) {
        arrow(middle_x, middle_y, x1, y1, "#4a535d");
        arrow(middle_x, middle_y, x2, y2, "#4a535d");
    } else {
        line(x1, y1, x2, y2, R"(stroke="#4a535d" stroke-width="1.6")");
    }
    const bool upright = std::abs(y2 - y1) > std::abs(x2 - x1);
    text(middle_x + (upright ? 7.0 : 0.0), middle_y + (upright ? 4.0 : -5.0), words,
         fmt::format(R"(class="halo" text-anchor="{}")", upright ? "start" : "middle"));
}

void SvgSheet::axes(const SheetView& view, const SheetUnit& unit, const std::string& u,
                    const std::string& v) {
    const double bottom = view.top + view.height;
    for (const double value : round_numbers(view.u_low / unit.metres, view.u_high / unit.metres,
                                            std::clamp(view.width / 90.0, 2.0, 10.0))) {
        const double x = view.x(value * unit.metres);
        line(x, bottom, x, bottom + 5.0, R"(stroke="#4a535d")");
        text(x, bottom + 19.0, fmt::format("{:g}", value), R"(text-anchor="middle")");
    }
    for (const double value : round_numbers(view.v_low / unit.metres, view.v_high / unit.metres,
                                            std::clamp(view.height / 40.0, 2.0, 8.0))) {
        const double y = view.y(value * unit.metres);
        line(view.left - 5.0, y, view.left, y, R"(stroke="#4a535d")");
        if (y < view.top + 17.0) {
            continue;  // the title stands there
        }
        text(view.left - 8.0, y + 4.0, fmt::format("{:g}", value), R"(text-anchor="end")");
    }
    rectangle(view.left, view.top, view.width, view.height, R"(fill="none" stroke="#4a535d")");
    text(view.left + view.width, bottom + 36.0, fmt::format("{}, {}", u, unit.name), R"(text-anchor="end")");
    text(view.left - 52.0, view.top + 4.0, fmt::format("{}, {}", v, unit.name), "");
}

void SvgSheet::begin_clip(const SheetView& view) {
    ++clips_;
    body_ += fmt::format(
        R"(<clipPath id="view{0}"><rect x="{1:.1f}" y="{2:.1f}" width="{3:.1f}" height="{4:.1f}"/>)"
        "</clipPath>\n<g clip-path=\"url(#view{0})\">\n",
        clips_, view.left, view.top, view.width, view.height);
}

void SvgSheet::end_clip() { body_ += "</g>\n"; }

std::string SvgSheet::document(double width, double height, const std::string& title) const {
    return fmt::format(
        R"(<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 {0:.0f} {1:.0f}" width="{0:.0f}" )"
        R"(height="{1:.0f}" role="img" font-family="system-ui, 'DejaVu Sans', 'Liberation Sans', sans-serif" )"
        "font-size=\"12.5\" fill=\"#1b2026\">\n<title>{2}</title>\n"
        "<style>.halo{{paint-order:stroke;stroke:#fff;stroke-width:3.5px;stroke-linejoin:round}}</style>\n"
        R"(<defs><pattern id="hatch" width="7" height="7" patternUnits="userSpaceOnUse" )"
        "patternTransform='rotate(45)'><rect width='7' height='7' fill='#e6e9ed'/><line x1='0' y1='0' "
        "x2=\"0\" y2=\"7\" stroke=\"#7d8791\" stroke-width=\"1.6\"/></pattern></defs>\n"
        "<rect width=\"100%\" height=\"100%\" fill=\"#fff\"/>\n{3}</svg>\n",
        width, height, escape_markup(title), body_);
}

}  // namespace riffle::inline preview
