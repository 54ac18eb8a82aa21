#pragma once

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "case/case.hpp"
#include "case/outline.hpp"
#include "preview/svg_sheet.hpp"

namespace riffle::inline preview {

/// What the views of a case share: colours, unit, where it is cut.
struct PreviewPlan {
    SheetUnit unit;
    double y = 0.0;         ///< of the side view's cut in three dimensions, m
    std::vector<double> x;  ///< of the cross-sections, m; none in two dimensions
    double top = 0.0;       ///< of what is shown, m
    double below = 0.0;     ///< so far below the bed it is shown, m
    double beside = 0.0;    ///< and beyond the ends and sides, m
    /// Outline of the water at the start along the channel, where it is not as deep everywhere; else empty.
    Outline water = {};
    std::function<double(double x)> surface =
        {};  ///< m over the bed level, where no key gives it; else empty
};
[[nodiscard]] PreviewPlan plan_preview(const Case& c);

/// Colour of a solid of a case.
[[nodiscard]] std::string solid_colour(const Case& c, std::size_t solid);
inline constexpr const char* water_colour = "#cfe6f5";
inline constexpr const char* surface_colour = "#0072b2";
inline constexpr const char* stem_colour = "#3f7d3a";
inline constexpr const char* patch_colour = "#b5651d";
inline constexpr const char* porous_colour = "#8a7456";
inline constexpr const char* probe_colour = "#b3341f";

/// A view of so much of a plane in a place of so many pixels, at one scale along both axes; where that would
/// make it flatter than `least` pixels, heights are drawn larger by a round factor, which comes with it.
struct ScaledView {
    SheetView view;
    double exaggeration = 1.0;
};
[[nodiscard]] ScaledView scaled_view(double left, double top, double width, double least, double most,
                                     double u_low, double u_high, double v_low, double v_high);

/// The name of what an outline shows, in the middle of its corners; beside a view that is too narrow for it.
void name_outline(SvgSheet& sheet, const SheetView& view, const Outline& outline, const std::string& name);

/// The upright plane along a channel: bed, water at its start, solids, walls, ends, instruments.
void draw_side(SvgSheet& sheet, const Case& c, const PreviewPlan& plan, const SheetView& view);
/// A cross-section at a place along a channel in three dimensions.
void draw_section(SvgSheet& sheet, const Case& c, const PreviewPlan& plan, const SheetView& view, double x);
/// The channel from above.
void draw_plan(SvgSheet& sheet, const Case& c, const PreviewPlan& plan, const SheetView& view);
/// The particles as they are placed at the start, in a window of the side view. False where there are too
/// many to place them for a picture.
bool draw_particles(SvgSheet& sheet, const Case& c, const PreviewPlan& plan, const SheetView& view);
/// Middle of the window of such a size that shows the spacing best: at the first solid in the water, else at
/// the bed.
[[nodiscard]] SheetPoint particle_window(const Case& c, double width, double height);

}  // namespace riffle::inline preview
