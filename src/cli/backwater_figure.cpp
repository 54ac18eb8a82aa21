#include "cli/backwater_figure.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstddef>

#include "cli/svg_drawing.hpp"

namespace riffle::inline cli {

namespace {

constexpr double page_width = 960.0;
constexpr double panel_left = 70.0;
constexpr double panel_width = 860.0;
constexpr double panel_top = 100.0;
constexpr double panel_height = 300.0;
constexpr double small_top = panel_top + panel_height + 70.0;
constexpr double small_height = 190.0;

constexpr const char* surface_style = R"(stroke="#1f5fa8" stroke-width="2.5")";
constexpr const char* energy_style = R"(stroke="#2a7f62" stroke-width="1.6" stroke-dasharray="8 4")";
constexpr const char* critical_style = R"(stroke="#b3402a" stroke-width="1.4" stroke-dasharray="2 3")";
constexpr const char* normal_style = R"(stroke="#777" stroke-width="1.4" stroke-dasharray="10 3 2 3")";
constexpr const char* bed_style = R"(stroke="#5b4a3a" stroke-width="2")";

std::vector<double> column_of(const std::vector<BackwaterStation>& stations,
                              double BackwaterStation::*quantity) {
    std::vector<double> values;
    values.reserve(stations.size());
    for (const BackwaterStation& s : stations) values.push_back(s.*quantity);
    return values;
}

/// A range about values, from zero where they are not far from it, with some room.
void fit_range(const std::vector<double>& values, double& low, double& high) {
    const auto [least, most] = std::minmax_element(values.begin(), values.end());
    constexpr double room = 0.08;
    constexpr double least_span = 0.25;  // of the largest: what changes little looks so
    const double span = std::max(*most - *least, least_span * std::abs(*most));
    const double middle = 0.5 * (*most + *least);
    high = middle + (0.5 + room) * span;
    low = *least < 0.5 * *most ? std::min(0.0, *least) : middle - (0.5 + room) * span;
}

struct LegendEntry {
    const char* name;
    const char* style;
};

std::string legend(const std::vector<LegendEntry>& entries) {
    std::string svg;
    double x = panel_left;
    for (const LegendEntry& entry : entries) {
        svg += svg_line(x, 72.0, x + 34.0, 72.0, entry.style);
        svg += svg_text(x + 40.0, 76.0, entry.name);
        constexpr double letter = 7.0;
        x += 62.0 + letter * static_cast<double>(std::string(entry.name).size());
    }
    return svg;
}

std::string small_panel(double at, double wide, const std::vector<BackwaterStation>& stations,
                        double BackwaterStation::*quantity, const std::string& title) {
    const std::vector<double> x = column_of(stations, &BackwaterStation::x);
    const std::vector<double> values = column_of(stations, quantity);
    SvgPanel panel{at, small_top, wide, small_height, 0.0, x.back(), 0.0, 1.0};
    fit_range(values, panel.y_low, panel.y_high);
    return svg_path(x, values, panel, surface_style) + svg_axes(panel, "x [m]", title);
}

}  // namespace

std::string backwater_figure(const std::string& title, const std::string& subtitle,
                             const SteadyChannel& channel, const VariedFlow& flow,
                             const std::vector<BackwaterStation>& stations) {
    const std::vector<double> x = column_of(stations, &BackwaterStation::x);
    const std::vector<double> bed = column_of(stations, &BackwaterStation::bed);
    const std::vector<double> surface = column_of(stations, &BackwaterStation::surface);
    const std::vector<double> energy = column_of(stations, &BackwaterStation::energy_grade);
    const double upright = channel.cosine();
    const auto over_bed = [&](double depth) {
        std::vector<double> line = bed;
        for (double& z : line) z += depth * upright;
        return line;
    };
    const std::vector<double> critical = over_bed(flow.critical_depth);

    std::vector<double> all = bed;
    for (const auto* line : {&surface, &energy, &critical}) all.insert(all.end(), line->begin(), line->end());
    SvgPanel panel{panel_left, panel_top, panel_width, panel_height, 0.0, x.back(), 0.0, 1.0};
    fit_range(all, panel.y_low, panel.y_high);

    std::string svg = svg_begin(page_width, small_top + small_height + 60.0, panel_left, title, subtitle);
    std::vector<LegendEntry> entries{{"energy grade line", energy_style},
                                     {"water surface", surface_style},
                                     {"critical depth", critical_style}};
    // The water, between surface and bed.
    std::string outline;
    for (std::size_t i = 0; i < x.size(); ++i) {
        outline += fmt::format("{}{:.1f} {:.1f}", i == 0 ? "M" : "L", panel.x(x[i]), panel.y(surface[i]));
    }
    for (std::size_t i = x.size(); i-- > 0;) {
        outline += fmt::format("L{:.1f} {:.1f}", panel.x(x[i]), panel.y(bed[i]));
    }
    svg += fmt::format("<path d=\"{}Z\" fill=\"#cfe0f2\"/>\n", outline);
    // A normal depth far above the surface would take the figure for itself.
    if (flow.normal_depth && *flow.normal_depth * upright + bed.front() <= panel.y_high) {
        svg += svg_path(x, over_bed(*flow.normal_depth), panel, normal_style);
        entries.push_back({"normal depth", normal_style});
    }
    entries.push_back({"bed", bed_style});
    svg += svg_path(x, critical, panel, critical_style);
    svg += svg_path(x, energy, panel, energy_style);
    svg += svg_path(x, surface, panel, surface_style);
    svg += svg_path(x, bed, panel, bed_style);
    for (const SurfaceProfile& part : flow.profiles) {
        const double middle = 0.5 * (part.from + part.to);
        const double z = part.depth_at(middle) * upright + (x.back() - middle) * channel.sine();
        svg +=
            svg_text(panel.x(middle), 0.5 * (panel.y(z) + panel.y(z - part.depth_at(middle) * upright)) + 5.0,
                     part.name, R"(text-anchor="middle" fill="#1f3f68" font-weight="bold")");
    }
    svg += svg_axes(panel, "distance along the bed x [m]", "elevation [m]");
    svg += legend(entries);

    constexpr double gap = 75.0;
    constexpr double wide = (panel_width - 2.0 * gap) / 3.0;
    svg += small_panel(panel_left, wide, stations, &BackwaterStation::velocity, "velocity U [m/s]");
    svg += small_panel(panel_left + wide + gap, wide, stations, &BackwaterStation::froude, "Froude number");
    svg += small_panel(panel_left + 2.0 * (wide + gap), wide, stations, &BackwaterStation::manning,
                       "Manning n [s/m^(1/3)]");
    return svg + "</svg>\n";
}

}  // namespace riffle::inline cli
