#pragma once

#include <string>
#include <vector>

namespace riffle::inline cli {

// Pieces of the figures that verbs write as SVG files.

/// A panel of a figure: its place in the figure, and the range of data from edge to edge.
struct SvgPanel {
    double left, top, width, height;
    double x_low, x_high, y_low, y_high;

    [[nodiscard]] double x(double value) const { return left + width * (value - x_low) / (x_high - x_low); }
    [[nodiscard]] double y(double value) const {
        return top + height * (1.0 - (value - y_low) / (y_high - y_low));
    }
};

/// The begin of a figure: its size, a white ground, title and subtitle. End it with "</svg>\n".
[[nodiscard]] std::string svg_begin(double width, double height, double left, const std::string& title,
                                    const std::string& subtitle);

/// A text, escaped, with further attributes.
[[nodiscard]] std::string svg_text(double x, double y, const std::string& text, const char* extra = "");

[[nodiscard]] std::string svg_line(double x1, double y1, double x2, double y2, const char* style);

/// The frame of a panel with ticks at about five round numbers a side, and the titles of both axes.
[[nodiscard]] std::string svg_axes(const SvgPanel& p, const std::string& x_title, const std::string& y_title);

/// A curve through points of a panel.
[[nodiscard]] std::string svg_path(const std::vector<double>& x, const std::vector<double>& y,
                                   const SvgPanel& p, const char* style);

}  // namespace riffle::inline cli
