#include "cli/section_figure.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <vector>

#include "cli/svg_drawing.hpp"

namespace riffle::inline cli {

namespace {

constexpr double figure_width = 960.0;
constexpr double map_left = 70.0;
constexpr double map_width = 800.0;
constexpr double map_top = 70.0;

/// Colours of cividis, read by everyone alike, interpolated between a few of its points.
std::string colour(double fraction) {
    struct Rgb {
        double r, g, b;
    };
    constexpr std::array<Rgb, 6> stops{
        {{0, 34, 78}, {53, 69, 108}, {102, 105, 112}, {148, 142, 119}, {200, 184, 102}, {254, 232, 56}}};
    const double at = std::clamp(fraction, 0.0, 1.0) * static_cast<double>(stops.size() - 1);
    const auto low = std::min(static_cast<std::size_t>(at), stops.size() - 2);
    const double part = at - static_cast<double>(low);
    const auto mix = [part](double a, double b) { return static_cast<int>(std::lround(a + part * (b - a))); };
    return fmt::format("#{:02x}{:02x}{:02x}", mix(stops[low].r, stops[low + 1].r),
                       mix(stops[low].g, stops[low + 1].g), mix(stops[low].b, stops[low + 1].b));
}

/// The values of the map on an even grid, whose squares make the picture and the isolines.
class EvenMap {
  public:
    EvenMap(const SectionResult& r, double width, double depth) : width_(width), depth_(depth) {
        for (int j = 0; j <= rows_; ++j) {
            for (int i = 0; i <= columns_; ++i) {
                value_.push_back(r.velocity_at(y(i), z(j)) / r.maximum_velocity);
            }
        }
    }

    [[nodiscard]] std::string picture(const SvgPanel& p) const {
        std::string svg = "<g shape-rendering=\"crispEdges\">\n";
        const double dx = p.width / columns_;
        const double dz = p.height / rows_;
        constexpr int levels = 25;
        for (int j = 0; j < rows_; ++j) {
            for (int i = 0; i < columns_;) {
                // Neighbours of one colour are one rectangle.
                const int level = level_of(i, j, levels);
                int end = i + 1;
                while (end < columns_ && level_of(end, j, levels) == level) ++end;
                svg += fmt::format(
                    "<rect x=\"{:.2f}\" y=\"{:.2f}\" width=\"{:.2f}\" height=\"{:.2f}\" fill=\"{}\"/>\n",
                    p.left + i * dx, p.top + p.height - (j + 1) * dz, (end - i) * dx, dz,
                    colour((level + 0.5) / levels));
                i = end;
            }
        }
        return svg + "</g>\n";
    }

    /// Marching triangles: where the level crosses the two triangles of each square.
    [[nodiscard]] std::string isoline(const SvgPanel& p, double level) const {
        std::string d;
        for (int j = 0; j < rows_; ++j) {
            for (int i = 0; i < columns_; ++i) {
                d += segment(p, level, {{{i, j}, {i + 1, j}, {i + 1, j + 1}}});
                d += segment(p, level, {{{i, j}, {i + 1, j + 1}, {i, j + 1}}});
            }
        }
        return fmt::format("<path d=\"{}\" fill=\"none\" stroke=\"#fff\" stroke-width=\"1\"/>\n", d);
    }

  private:
    struct Node {
        int i, j;
    };
    [[nodiscard]] double y(int i) const { return width_ * i / columns_; }
    [[nodiscard]] double z(int j) const { return depth_ * j / rows_; }
    [[nodiscard]] double at(Node n) const {
        const auto row = static_cast<std::size_t>(columns_) + 1;
        return value_[static_cast<std::size_t>(n.j) * row + static_cast<std::size_t>(n.i)];
    }
    [[nodiscard]] int level_of(int i, int j, int levels) const {
        const double mean = 0.25 * (at({i, j}) + at({i + 1, j}) + at({i, j + 1}) + at({i + 1, j + 1}));
        return std::clamp(static_cast<int>(mean * levels), 0, levels - 1);
    }
    [[nodiscard]] std::string segment(const SvgPanel& p, double level,
                                      const std::array<Node, 3>& nodes) const {
        std::string d;
        for (std::size_t k = 0; k < 3; ++k) {
            const Node a = nodes[k];
            const Node b = nodes[(k + 1) % 3];
            if ((at(a) < level) == (at(b) < level)) continue;
            const double part = (level - at(a)) / (at(b) - at(a));
            d += fmt::format("{}{:.1f} {:.1f}", d.empty() ? "M" : "L",
                             p.x(1e3 * (y(a.i) + part * (y(b.i) - y(a.i)))),
                             p.y(1e3 * (z(a.j) + part * (z(b.j) - z(a.j)))));
        }
        return d;
    }

    int columns_ = 160;
    int rows_ = 48;
    double width_, depth_;
    std::vector<double> value_;
};

std::string colour_bar(double left, double top, double height) {
    std::string svg;
    constexpr int steps = 25;
    for (int i = 0; i < steps; ++i) {
        svg += fmt::format("<rect x=\"{:.1f}\" y=\"{:.2f}\" width=\"14\" height=\"{:.2f}\" fill=\"{}\"/>\n",
                           left, top + height * (1.0 - (i + 1.0) / steps), height / steps + 0.3,
                           colour((i + 0.5) / steps));
    }
    for (const double value : {0.0, 0.5, 1.0}) {
        svg += svg_text(left + 19.0, top + height * (1.0 - value) + 4.0, fmt::format("{:g}", value));
    }
    return svg + svg_text(left - 4.0, top - 14.0, "U/U_max");
}

}  // namespace

std::string section_figure(const Case& c, const SectionResult& r, const std::string& subtitle) {
    const double width = c.channel.simulated_width();
    const double depth = c.total_depth();
    // To scale while that leaves the map readable.
    const double map_height = std::clamp(map_width * depth / width, 100.0, 320.0);
    const double lower = map_top + map_height + 80.0;
    constexpr double lower_height = 230.0;
    const double height = lower + lower_height + 60.0;
    constexpr const char* curve = R"(stroke="#1f5fa8" stroke-width="2")";
    constexpr const char* dashed = R"(stroke="#555" stroke-dasharray="5 4")";

    std::string svg =
        svg_begin(figure_width, height, map_left, c.title.empty() ? "Cross-section twin" : c.title, subtitle);

    const SvgPanel map{map_left, map_top, map_width, map_height, 0.0, 1e3 * width, 0.0, 1e3 * depth};
    const EvenMap values(r, width, depth);
    svg += values.picture(map);
    for (int i = 1; i < 10; ++i) svg += values.isoline(map, 0.1 * i);
    svg += svg_line(map.left, map.y(1e3 * c.crest()), map.left + map.width, map.y(1e3 * c.crest()),
                    "stroke=\"#fff\" stroke-dasharray=\"2 4\"");
    svg += svg_text(map.left + map.width, map.top - 14.0, "isolines every 0.1",
                    "fill=\"#555\" text-anchor=\"end\"");
    svg += svg_axes(map, "distance from the side wall y [mm]", "height z [mm]");
    svg += colour_bar(map_left + map_width + 20.0, map_top, map_height);

    // Profile at the centreline.
    std::vector<double> u;
    std::vector<double> z;
    for (int i = 0; i <= 200; ++i) {
        z.push_back(1e3 * depth * i / 200.0);
        u.push_back(r.velocity_at(c.channel.centreline(), 1e-3 * z.back()));
    }
    const double top = 1.05 * std::max(r.maximum_velocity, c.measured.depth_mean_velocity.value_or(0.0));
    const SvgPanel profile{map_left, lower, 300.0, lower_height, 0.0, top, 0.0, 1e3 * depth};
    svg += svg_line(profile.left, profile.y(1e3 * c.crest()), profile.left + profile.width,
                    profile.y(1e3 * c.crest()), dashed);
    svg += svg_text(profile.left + 6.0, profile.y(1e3 * c.crest()) - 5.0, "crest", "fill=\"#555\"");
    svg += svg_path(u, z, profile, curve);
    svg += svg_axes(profile, "U at the centreline [m/s]", "height z [mm]");

    // Depth mean across.
    const std::vector<double> mean = r.depth_means(c.datum(), depth);
    std::vector<double> y;
    for (const double place : r.y) y.push_back(1e3 * place);
    const SvgPanel across{
        map_left + 400.0, lower, map_width - 400.0, lower_height, 0.0, 1e3 * width, 0.0, top};
    if (c.measured.depth_mean_velocity) {
        const double at = across.y(*c.measured.depth_mean_velocity);
        svg += svg_line(across.left, at, across.left + across.width, at, dashed);
        svg += svg_text(across.left + 6.0, at - 5.0, "measured at the centreline", "fill=\"#555\"");
    }
    svg += svg_path(y, mean, across, curve);
    svg += svg_axes(across, "distance from the side wall y [mm]", "depth mean of U [m/s]");
    return svg + "</svg>\n";
}

}  // namespace riffle::inline cli
