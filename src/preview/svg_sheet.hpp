#pragma once

#include <string>
#include <vector>

namespace riffle::inline preview {

/// A place in a drawing or in what it shows.
struct SheetPoint {
    double x = 0.0;
    double y = 0.0;
};

/// A view in a drawing: its place in pixels, and what it shows from edge to edge, m; upward is up.
struct SheetView {
    double left = 0.0, top = 0.0, width = 0.0, height = 0.0;
    double u_low = 0.0, u_high = 1.0, v_low = 0.0, v_high = 1.0;

    [[nodiscard]] double x(double u) const { return left + width * (u - u_low) / (u_high - u_low); }
    [[nodiscard]] double y(double v) const { return top + height * (1.0 - (v - v_low) / (v_high - v_low)); }
    /// Pixels of a metre along either axis.
    [[nodiscard]] double scale_u() const { return width / (u_high - u_low); }
    [[nodiscard]] double scale_v() const { return height / (v_high - v_low); }
};

/// The unit that lengths are shown in.
struct SheetUnit {
    double metres = 1.0;
    std::string name = "m";

    /// Millimetres for what is less than two metres long.
    static SheetUnit of(double extent);
    /// A length with the unit, in four digits.
    [[nodiscard]] std::string text(double length) const;
};

/// The pieces of a drawing (SVG), one above the other. Styles are attributes: "fill=\"#fff\"".
class SvgSheet {
  public:
    void text(double x, double y, const std::string& text, const std::string& style = "");
    void line(double x1, double y1, double x2, double y2, const std::string& style);
    void rectangle(double x, double y, double width, double height, const std::string& style);
    void circle(double x, double y, double radius, const std::string& style);
    void path(const std::string& d, const std::string& style);
    /// A closed polygon of a view.
    void polygon(const SheetView& view, const std::vector<SheetPoint>& corners, const std::string& style);
    /// A line with an arrow at each end and a text in its middle, over a white ground.
    void dimension(double x1, double y1, double x2, double y2, const std::string& text);
    /// An arrow.
    void arrow(double x1, double y1, double x2, double y2, const std::string& colour);
    /// Axes of a view with ticks at round numbers, a frame and titles.
    void axes(const SheetView& view, const SheetUnit& unit, const std::string& u, const std::string& v);
    /// What follows is cut off outside of a view, until end_clip().
    void begin_clip(const SheetView& view);
    void end_clip();

    /// The drawing as a document of its own.
    [[nodiscard]] std::string document(double width, double height, const std::string& title) const;

  private:
    std::string body_;
    int clips_ = 0;
};

/// A path of a polygon of a view, closed.
[[nodiscard]] std::string polygon_path(const SheetView& view, const std::vector<SheetPoint>& corners);

}  // namespace riffle::inline preview
