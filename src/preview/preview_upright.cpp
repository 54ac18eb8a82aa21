// Upright views: along the channel and across it.

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <functional>

#include "boundary/wall.hpp"
#include "case/end_buffers.hpp"
#include "case/end_floor.hpp"
#include "case/outline_check.hpp"
#include "case/patch_range.hpp"
#include "case/porous_zone.hpp"
#include "case/solid_mesh.hpp"
#include "case/solid_shapes.hpp"
#include "case/stem_feet.hpp"
#include "preview/preview_views.hpp"
#include "preview/solid_slices.hpp"
#include "roughness/sphere_lattice.hpp"

namespace riffle::inline preview {

namespace {

/// The largest shift of a table, by its magnitude: where a solid goes farthest; 0 of none.
double farthest(const std::vector<double>& shifts) {
    const auto most = std::max_element(shifts.begin(), shifts.end(),
                                       [](double a, double b) { return std::abs(a) < std::abs(b); });
    return most == shifts.end() ? 0.0 : *most;
}

constexpr const char* wall_style = "fill='url(#hatch)'";
constexpr const char* wall_edge = R"(stroke="#1b2026" stroke-width="1.8")";

class UprightView {
  public:
    UprightView(SvgSheet& sheet, const Case& c, const PreviewPlan& plan, const SheetView& view)
        : sheet_(sheet), c_(c), plan_(plan), view_(view), space_(c.channel.dimensions == 3) {}

    void draw_along() {
        sheet_.begin_clip(view_);
        const double length = c_.channel.length;
        const double beyond = c_.channel.ends == Ends::open ? buffer_length(c_) : 0.0;
        draw_water_along(beyond);
        draw_roughness(-beyond, length + beyond);
        for (const Vegetation& patch : c_.vegetation) {
            for (const PatchRange& along : stretches_along(patch, beyond)) {
                draw_stems(patch, along.from, along.to,
                           [&](double x) { return stem_foot(c_, patch, x, plan_.y); });
            }
        }
        for (const Porous& zone : c_.porous) {
            for (const Outline& cut : porous_cuts_along(c_, zone, plan_.y, plan_.top)) {
                polygon(cut, porous_style());
                name_outline(sheet_, view_, cut, zone.name);
            }
        }
        for (std::size_t k = 0; k < c_.solids.size(); ++k) draw_solid_along(k);
        draw_floor(c_.channel.ends);
        for (const BedPatch& patch : c_.bed_patches) {
            for (const PatchRange& along : stretches_along(patch, beyond)) {
                draw_bed_patch(patch, along.from, along.to);
            }
        }
        draw_end_walls(c_.channel.ends == Ends::walls, length);
        draw_lid(length);
        sheet_.end_clip();
        draw_ends_along();
        name_solids(0);
        draw_instruments_along();
        draw_dimensions(length);
    }

    void draw_across(double x) {
        sheet_.begin_clip(view_);
        const double width = c_.channel.simulated_width();
        const double depth = water_level_at(x);
        if (depth > 0.0) {
            rectangle(0.0, width, 0.0, depth, fmt::format(R"(fill="{}")", water_colour));
            line(0.0, depth, width, depth, fmt::format(R"(stroke="{}" stroke-width="1.6")", surface_colour));
        }
        draw_roughness(0.0, width);
        for (const Vegetation& patch : c_.vegetation) {
            for (const PatchRange& across : stretches_of(c_, patch, 1, x)) {
                draw_stems(patch, across.from, std::min(width, across.to),
                           [&](double y) { return stem_foot(c_, patch, x, y); });
            }
        }
        for (const Porous& zone : c_.porous) {
            for (const PorousCut& cut : porous_cuts_across(c_, zone, x, plan_.top)) {
                rectangle(cut.across.from, std::min(width, cut.across.to), cut.upright.from, cut.upright.to,
                          porous_style());
            }
        }
        for (std::size_t k = 0; k < c_.solids.size(); ++k) {
            if (const SolidMesh* const mesh = mesh_of(c_, c_.solids[k])) {
                draw_slices(k, slice_polygons(view_.u_low, view_.u_high, 300,
                                              [&](double y) { return upright_stretches(*mesh, x, y); }));
            }
        }
        draw_floor(c_.channel.sides == Sides::periodic ? Ends::periodic : Ends::walls);
        for (const BedPatch& patch : c_.bed_patches) {
            for (const PatchRange& across : stretches_of(c_, patch, 1, x)) {
                draw_bed_patch(patch, across.from, std::min(width, across.to));
            }
        }
        if (c_.channel.sides != Sides::periodic) draw_end_walls(true, width, c_.channel.sides == Sides::half);
        draw_lid(width);
        sheet_.end_clip();
        if (c_.channel.sides == Sides::periodic) {
            mark_periodic(0.0);
            mark_periodic(width);
        } else if (c_.channel.sides == Sides::half) {
            line(width, view_.v_low, width, view_.v_high, R"(stroke="#1b2026" stroke-dasharray="9 3 2 3")");
        }
        draw_dimensions(width);
    }

  private:
    /// The stretches of a patch that the section along the channel goes through; one that ends with the
    /// channel goes on beyond open ends.
    template <class Patch>
    [[nodiscard]] std::vector<PatchRange> stretches_along(const Patch& patch, double beyond) const {
        std::vector<PatchRange> stretches = stretches_of(c_, patch, 0, plan_.y);
        for (PatchRange& along : stretches) {
            if (along.from <= 0.0) along.from -= beyond;
            if (along.to >= c_.channel.length) along.to += beyond;
        }
        return stretches;
    }

    void rectangle(double u0, double u1, double v0, double v1, const std::string& style) {
        sheet_.rectangle(view_.x(u0), view_.y(v1), view_.x(u1) - view_.x(u0), view_.y(v0) - view_.y(v1),
                         style);
    }
    void polygon(const Outline& outline, const std::string& style) {
        std::vector<SheetPoint> corners;
        for (std::size_t i = 0; i < outline.size(); ++i) {
            corners.push_back({outline.x[i], outline.z[i]});
        }
        sheet_.polygon(view_, corners, style);
    }
    void line(double u0, double v0, double u1, double v1, const std::string& style) {
        sheet_.line(view_.x(u0), view_.y(v0), view_.x(u1), view_.y(v1), style);
    }

    /// Height of the water at the start at a place along the channel; 0 where there is none.
    [[nodiscard]] double water_level_at(double x) const {
        if (plan_.water.x.empty()) return c_.total_depth();
        return contains(plan_.water, x, 1e-9) ? ceiling_above(plan_.water, x, 1e-9) : 0.0;
    }

    void draw_water_along(double beyond) {
        const std::string fill = fmt::format(R"(fill="{}")", water_colour);
        const std::string surface = fmt::format(R"(stroke="{}" stroke-width="1.6")", surface_colour);
        const double length = c_.channel.length;
        if (!plan_.water.x.empty()) {
            polygon(plan_.water, fill + " " + surface);
        } else {
            const double depth = c_.total_depth();
            rectangle(-beyond, length + beyond, 0.0, depth, fill);
            if (c_.channel.top == Top::free_surface) {
                line(-beyond, depth, length + beyond, depth, surface);
                level_mark(0.82 * length, depth);
            }
        }
        if (beyond > 0.0) {
            for (const double u : {-beyond, length}) {
                rectangle(u, u + beyond, 0.0, water_level_at(std::max(u, 0.0)),
                          R"(fill="#0072b2" fill-opacity="0.18")");
            }
        }
    }

    /// The mark of a free surface: a triangle on it, with two lines below.
    void level_mark(double u, double v) {
        const double x = view_.x(u);
        const double y = view_.y(v);
        sheet_.path(fmt::format("M{:.1f} {:.1f}l-6 -10h12z", x, y - 1.0),
                    fmt::format(R"(fill="none" stroke="{}" stroke-width="1.3")", surface_colour));
        for (const double part : {1.0, 2.0}) {
            sheet_.line(x - 8.0 + 3.0 * part, y + 3.5 * part, x + 8.0 - 3.0 * part, y + 3.5 * part,
                        fmt::format(R"(stroke="{}")", surface_colour));
        }
    }

    /// The zone in which spheres act by their drag.
    void draw_roughness(double from, double to) {
        if (c_.bed.roughness_height <= 0.0) return;
        rectangle(from, to, 0.0, c_.crest(), R"(fill="#c2a878" fill-opacity="0.45")");
        line(from, c_.crest(), to, c_.crest(), R"(stroke="#8a6d3b" stroke-dasharray="3 3")");
        line(from, c_.datum(), to, c_.datum(), R"(stroke="#56606b" stroke-dasharray="10 4")");
    }

    /// A patch of the bed: its roughness zone, or of a plane one a strip below it.
    void draw_bed_patch(const BedPatch& patch, double from, double to) {
        const double strip = 5.0 / view_.scale_u();
        rectangle(from, to, patch.roughness_height ? 0.0 : -strip, patch.roughness_height.value_or(0.0),
                  fmt::format(R"(fill="{0}" fill-opacity="0.75" stroke="{0}")", patch_colour));
    }

    /// Stems of a patch, as far apart as they stand in the mean, but no nearer than three pixels.
    /// `foot`: the height at which they stand.
    void draw_stems(const Vegetation& patch, double from, double to,
                    const std::function<double(double)>& foot) {
        polygon(canopy_outline(patch, from, to, foot),
                fmt::format(R"(fill="{}" fill-opacity="0.18")", stem_colour));
        const double apart = std::max(1.0 / std::sqrt(patch.stems_per_area), 3.0 / view_.scale_u());
        const double width = std::clamp(patch.stem_diameter * view_.scale_u(), 0.8, 6.0);
        for (double u = from + 0.5 * apart; u < to; u += apart) {
            line(
                u, foot(u), u, foot(u) + patch.height,
                fmt::format(R"(stroke="{}" stroke-opacity="0.7" stroke-width="{:.1f}")", stem_colour, width));
        }
    }

    static std::string porous_style() {
        return fmt::format(R"(fill="{0}" fill-opacity="0.35" stroke="{0}")", porous_colour);
    }

    void draw_slices(std::size_t solid, const std::vector<std::vector<SheetPoint>>& polygons) {
        std::string d;
        for (const auto& polygon : polygons) d += polygon_path(view_, polygon);
        sheet_.path(d, solid_style(solid));
    }

    [[nodiscard]] std::string solid_style(std::size_t solid) const {
        return fmt::format(R"(fill="{}" stroke="#1b2026" stroke-width="1" stroke-linejoin="round")",
                           solid_colour(c_, solid));
    }

    void draw_solid_along(std::size_t k) {
        const Solid& solid = c_.solids[k];
        if (!space_) {
            polygon({solid.x, solid.z}, solid_style(k));
        } else if (const SolidMesh* const mesh = mesh_of(c_, solid)) {
            draw_slices(k, slice_polygons(view_.u_low, view_.u_high, 500,
                                          [&](double x) { return upright_stretches(*mesh, x, plan_.y); }));
        }
        draw_motion(solid);
    }

    /// Where a solid moves to: an arrow from its middle.
    void draw_motion(const Solid& solid) {
        if (solid.rests()) return;
        const auto x = extent_of(c_, solid, 0);
        const auto z = extent_of(c_, solid, 2);
        const bool swings = solid.motion == SolidMotion::oscillating;
        double along = swings ? solid.amplitude_x : solid.velocity_x;
        double up = swings ? solid.amplitude_z : solid.velocity_z;
        if (solid.motion == SolidMotion::table) {
            along = farthest(solid.shifts_x);
            up = farthest(solid.shifts_z);
        }
        const double size = std::hypot(along, up);
        if (!x || !z || size == 0.0) return;
        const double u = view_.x(0.5 * (x->low + x->high));
        const double v = view_.y(std::min(0.5 * (z->low + z->high), 0.9 * view_.v_high));
        const double du = 34.0 * along / size;
        const double dv = -34.0 * up / size;
        sheet_.arrow(u, v, u + du, v + dv, "#1b2026");
        if (swings) sheet_.arrow(u, v, u - du, v - dv, "#1b2026");
    }

    void draw_floor(Ends ends) {
        if (c_.channel.top == Top::periodic) return;
        const double length = view_.u_high;
        const double to = bed_ends(c_) && ends == Ends::open ? c_.channel.length : length;
        const bool covered = std::any_of(c_.solids.begin(), c_.solids.end(), [](const Solid& solid) {
            return is_bed_shape(solid.shape) && solid.shape != SolidShape::spheres;
        });
        if (!covered) rectangle(view_.u_low, to, view_.v_low, 0.0, wall_style);
        line(view_.u_low, 0.0, to, 0.0, covered ? R"(stroke="#56606b" stroke-dasharray="2 4")" : wall_edge);
    }

    void draw_end_walls(bool stand, double extent, bool first_only = false) {
        if (!stand) return;
        const double high = c_.channel.top == Top::wall ? c_.total_depth() : end_wall_height(c_);
        rectangle(view_.u_low, 0.0, view_.v_low, high, wall_style);
        line(0.0, 0.0, 0.0, high, wall_edge);
        if (!first_only) {
            rectangle(extent, view_.u_high, view_.v_low, high, wall_style);
            line(extent, 0.0, extent, high, wall_edge);
        }
    }

    void draw_lid(double extent) {
        if (c_.channel.top != Top::wall) return;
        const double depth = c_.total_depth();
        rectangle(view_.u_low, view_.u_high, depth, view_.v_high, wall_style);
        line(view_.u_low, depth, view_.u_high, depth, wall_edge);
        if (c_.channel.lid_velocity != 0.0) {
            const double y = view_.y(depth) - 10.0;
            sheet_.arrow(view_.x(0.4 * extent), y, view_.x(0.6 * extent), y, "#1b2026");
        }
    }

    void mark_periodic(double u) {
        line(u, view_.v_low, u, view_.v_high,
             R"(stroke="#56606b" stroke-width="1.2" stroke-dasharray="7 5")");
    }

    void draw_ends_along() {
        const double length = c_.channel.length;
        const double y = view_.y(view_.v_high) + 16.0;
        if (c_.channel.ends == Ends::periodic) {
            mark_periodic(0.0);
            mark_periodic(length);
            sheet_.text(view_.x(0.0) + 6.0, y, "periodic", R"(class="halo" fill="#56606b")");
            sheet_.text(view_.x(length) - 6.0, y, "periodic",
                        R"(class="halo" fill="#56606b" text-anchor="end")");
        } else if (c_.channel.ends == Ends::open) {
            const EndFloors floors = end_floors(c_);
            for (const double u : {0.0, length}) {
                const double floor = u == 0.0 ? floors.upstream : floors.downstream;
                const double middle = view_.y(0.5 * (floor + c_.total_depth()));
                line(u, 0.0, u, c_.total_depth(),
                     R"(stroke="#0072b2" stroke-width="1.4" stroke-dasharray="4 3")");
                sheet_.arrow(view_.x(u) - 14.0, middle, view_.x(u) + 20.0, middle, surface_colour);
            }
            sheet_.text(view_.x(0.0) + 6.0, y, "water enters", R"(class="halo" fill="#0072b2")");
            sheet_.text(view_.x(length) - 6.0, y, "water leaves",
                        R"(class="halo" fill="#0072b2" text-anchor="end")");
        }
    }

    /// Whether the side view cuts a solid: the plan has the names of the others.
    [[nodiscard]] bool is_cut(const Solid& solid) const {
        const auto across = space_ ? extent_of(c_, solid, 1) : std::nullopt;
        return !across || (across->low <= plan_.y && plan_.y <= across->high);
    }

    void name_solids(std::size_t axis) {
        double last_x = -1e9;
        double last_y = -1e9;
        for (const Solid& solid : c_.solids) {
            const auto u = extent_of(c_, solid, axis);
            const auto z = extent_of(c_, solid, 2);
            if (!u || !z || !is_cut(solid)) continue;
            const bool bed = is_bed_shape(solid.shape) || u->high - u->low > 0.9 * c_.channel.length;
            const double x = view_.x(bed ? 0.3 * c_.channel.length
                                         : std::clamp(0.5 * (u->low + u->high), 0.0, c_.channel.length));
            double y = bed ? view_.y(0.0) + 14.0 : std::max(view_.y(z->high) - 6.0, view_.top + 30.0);
            if (std::abs(x - last_x) < 90.0 && std::abs(y - last_y) < 14.0) y = last_y + 15.0;
            sheet_.text(x, y, solid.name, R"(class="halo" text-anchor="middle" font-weight="600")");
            last_x = x;
            last_y = y;
        }
    }

    void draw_instruments_along() {
        const std::string stroke = fmt::format(R"(stroke="{}" stroke-width="1.4")", probe_colour);
        const std::string fill = fmt::format(R"(fill="{}" stroke="#fff" stroke-width="0.8")", probe_colour);
        for (std::size_t k = 0; k < c_.probes.size(); ++k) {
            const Probe& probe = c_.probes[k];
            const std::string number = std::to_string(k + 1);
            const auto badge = [&](double x, double y) {
                sheet_.circle(x, y, 8.0, fmt::format(R"(fill="#fff" stroke="{}")", probe_colour));
                sheet_.text(x, y + 4.0, number,
                            fmt::format(R"(text-anchor="middle" font-size="11" fill="{}")", probe_colour));
            };
            switch (probe.kind) {
                case ProbeKind::wave:
                case ProbeKind::flow_rate:
                    for (const double x : probe.x) {
                        line(x, 0.0, x, view_.v_high,
                             stroke + (probe.kind == ProbeKind::wave ? R"( stroke-dasharray="2 3")" : ""));
                        badge(view_.x(x), view_.top + 32.0 + 18.0 * static_cast<double>(k % 3));
                    }
                    break;
                case ProbeKind::velocity:
                case ProbeKind::pressure:
                    for (std::size_t i = 0; i < std::max(probe.x.size(), probe.z.size()); ++i) {
                        const double x = view_.x(probe.x.size() == 1 ? probe.x[0] : probe.x[i]);
                        const double y = view_.y(probe.z.size() == 1 ? probe.z[0] : probe.z[i]);
                        if (probe.kind == ProbeKind::velocity) {
                            sheet_.circle(x, y, 3.4, fill);
                        } else {
                            sheet_.rectangle(x - 3.2, y - 3.2, 6.4, 6.4, fill);
                        }
                        if (i == 0) badge(x + 14.0, y - 9.0);
                    }
                    break;
                case ProbeKind::surface_line:
                    line(0.0, 1.02 * c_.total_depth(), c_.channel.length, 1.02 * c_.total_depth(),
                         stroke + R"( stroke-dasharray="1 4")");
                    badge(view_.x(0.93 * c_.channel.length), view_.y(1.02 * c_.total_depth()) - 10.0);
                    break;
                case ProbeKind::grid: {
                    const double left = probe.x_from.value_or(0.0);
                    const double right = probe.x_to.value_or(c_.channel.length);
                    const double low = probe.z_from.value_or(0.0);
                    const double high = probe.z_to.value_or(c_.total_depth());
                    rectangle(left, right, low, high, R"(fill="none" stroke-dasharray="5 3" )" + stroke);
                    badge(view_.x(left) + 10.0, view_.y(high) + 10.0);
                    break;
                }
                case ProbeKind::force:
                    break;  // of the walls and solids: in the table alone
            }
        }
    }

    void draw_dimensions(double extent) {
        const double y = view_.top + view_.height - 9.0;
        sheet_.dimension(view_.x(0.0), y, view_.x(extent), y, plan_.unit.text(extent));
        if (c_.start.water_x.empty()) {
            const double x = view_.x(0.12 * extent);
            sheet_.dimension(x, view_.y(c_.datum()), x, view_.y(c_.total_depth()),
                             plan_.unit.text(c_.channel.depth));
        }
    }

    SvgSheet& sheet_;
    const Case& c_;
    const PreviewPlan& plan_;
    const SheetView& view_;
    bool space_;
};

}  // namespace

void draw_side(SvgSheet& sheet, const Case& c, const PreviewPlan& plan, const SheetView& view) {
    UprightView(sheet, c, plan, view).draw_along();
    sheet.axes(view, plan.unit, "x", "z");
}

void draw_section(SvgSheet& sheet, const Case& c, const PreviewPlan& plan, const SheetView& view, double x) {
    UprightView(sheet, c, plan, view).draw_across(x);
    sheet.axes(view, plan.unit, "y", "z");
}

}  // namespace riffle::inline preview
