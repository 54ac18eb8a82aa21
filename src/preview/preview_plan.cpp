// The channel from above, and its particles.

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

#include "boundary/wall.hpp"
#include "boundary/wall_motion.hpp"
#include "case/bed_surface.hpp"
#include "case/bed_traits.hpp"
#include "case/outline.hpp"
#include "case/outline_check.hpp"
#include "case/packed_start.hpp"
#include "case/patch_range.hpp"
#include "case/porous_zone.hpp"
#include "case/solid_mesh.hpp"
#include "case/solid_shapes.hpp"
#include "engine/scheme.hpp"
#include "particles/case_size.hpp"
#include "particles/lattice.hpp"
#include "preview/preview_views.hpp"
#include "preview/solid_slices.hpp"
#include "roughness/sphere_lattice.hpp"
#include "solver/start_packing.hpp"

namespace riffle::inline preview {

namespace {

/// Colours of heights, from low to high.
constexpr std::array<const char*, 9> height_colours{"#5b4a2f", "#735f3d", "#8a744d", "#a0895e", "#b59d71",
                                                    "#c8b187", "#d8c49f", "#e6d6b8", "#f2e8d3"};

/// Heights of a bed seen from above, in steps of colour.
void draw_heights(SvgSheet& sheet, const Case& c, const PreviewPlan& plan, const SheetView& view,
                  const SolidMesh& mesh) {
    const double length = c.channel.length;
    const double width = c.channel.simulated_width();
    const int columns = std::clamp(static_cast<int>(3.0 * length / c.numerics.spacing), 80, 260);
    const int rows = std::clamp(static_cast<int>(width / length * columns), 10, 200);
    std::vector<double> heights;
    for (int j = 0; j < rows; ++j) {
        for (int i = 0; i < columns; ++i) {
            const auto parts =
                upright_stretches(mesh, (i + 0.5) / columns * length, (j + 0.5) / rows * width);
            heights.push_back(parts.empty() ? 0.0 : parts.back().high);
        }
    }
    const auto [least, most] = std::minmax_element(heights.begin(), heights.end());
    const double low = *least;
    const double range = std::max(*most - low, 1e-12);
    std::array<std::string, height_colours.size()> paths;
    const double cell_u = view.scale_u() * length / columns;
    const double cell_v = view.scale_v() * width / rows;
    const auto shade = [&](int i, int j) {
        const double share = (heights[static_cast<std::size_t>(j) * static_cast<std::size_t>(columns) +
                                      static_cast<std::size_t>(i)] -
                              low) /
                             range;
        return static_cast<std::size_t>(std::min(share * 9.0, 8.0));
    };
    for (int j = 0; j < rows; ++j) {
        for (int i = 0; i < columns;) {
            int end = i + 1;
            while (end < columns && shade(end, j) == shade(i, j)) ++end;
            paths[shade(i, j)] +=
                fmt::format("M{:.1f} {:.1f}h{:.1f}v{:.1f}h{:.1f}z", view.x(0.0) + i * cell_u,
                            view.y((j + 1.0) / rows * width), (end - i) * cell_u + 0.3, cell_v + 0.3,
                            -((end - i) * cell_u + 0.3));
            i = end;
        }
    }
    for (std::size_t k = 0; k < paths.size(); ++k) {
        sheet.path(paths[k], fmt::format(R"(fill="{}")", height_colours[k]));
    }
    // A scale beside the view.
    const double x = view.left + view.width + 16.0;
    const double step = std::min(16.0, (view.height - 24.0) / 9.0);
    for (std::size_t k = 0; k < height_colours.size(); ++k) {
        sheet.rectangle(x, view.top + 18.0 + step * static_cast<double>(8 - k), 16.0, step,
                        fmt::format(R"(fill="{}")", height_colours[k]));
    }
    sheet.text(x, view.top + 11.0, "bed, z");
    sheet.text(x + 21.0, view.top + 27.0, plan.unit.text(*most));
    sheet.text(x + 21.0, view.top + 18.0 + 9.0 * step, plan.unit.text(low));
}

/// What of a solid is seen from above: its triangles that look up, in one colour.
void draw_silhouette(SvgSheet& sheet, const Case& c, const SheetView& view, std::size_t k,
                     const SolidMesh& mesh) {
    std::string d;
    for (const Triangle& t : mesh.tree().triangles()) {
        if (normal_of(t)[2] > 0.0) {
            d += polygon_path(view, {{t[0][0], t[0][1]}, {t[1][0], t[1][1]}, {t[2][0], t[2][1]}});
        }
    }
    const std::string colour = solid_colour(c, k);
    sheet.path(d, fmt::format(R"(fill="{0}" stroke="{0}" stroke-width="0.7")", colour));
}

void draw_circles(SvgSheet& sheet, const SheetView& view, const std::vector<Point3>& centres, double diameter,
                  const std::string& style) {
    for (const Point3& centre : centres) {
        sheet.circle(view.x(centre[0]), view.y(centre[1]), 0.5 * diameter * view.scale_u(), style);
    }
}

void draw_probes_in_plan(SvgSheet& sheet, const Case& c, const SheetView& view) {
    for (std::size_t k = 0; k < c.probes.size(); ++k) {
        const Probe& probe = c.probes[k];
        if (probe.kind == ProbeKind::flow_rate) {
            for (const double x : probe.x) {
                sheet.line(view.x(x), view.y(0.0), view.x(x), view.y(c.channel.simulated_width()),
                           fmt::format(R"(stroke="{}" stroke-width="1.4")", probe_colour));
            }
            continue;
        }
        // A single place along the channel, or across it, is that of all points.
        for (std::size_t i = 0; !probe.x.empty() && i < std::max(probe.x.size(), probe.y.size()); ++i) {
            const double x = probe.x[std::min(i, probe.x.size() - 1)];
            const double y = probe.y.empty() ? std::min(c.channel.centreline(), c.channel.simulated_width())
                                             : probe.y[std::min(i, probe.y.size() - 1)];
            sheet.circle(view.x(x), view.y(y), 3.6,
                         fmt::format(R"(fill="{}" stroke="#fff" stroke-width="0.8")", probe_colour));
            if (i == 0) {
                sheet.text(view.x(x) + 7.0, view.y(y) - 5.0, std::to_string(k + 1),
                           fmt::format(R"(class="halo" fill="{}" font-size="11")", probe_colour));
            }
        }
    }
}

template <int D>
void draw_placed(SvgSheet& sheet, const Case& c, const PreviewPlan& plan, const SheetView& view) {
    const double spacing = c.numerics.spacing;
    // Each as large as its area or volume: at edges of solids some stand for less than a spacing.
    const auto radius = [&](double volume) {
        return 0.43 * (D == 3 ? std::cbrt(volume) : std::sqrt(volume)) * view.scale_u();
    };
    const double full = radius(lattice_of(c).volume());
    const Lattice lattice = lattice_of(c);
    // The row of the lattice that the cut goes through.
    const double row =
        (std::clamp(std::floor(plan.y / lattice.dy), 0.0, std::max(lattice.files - 1.0, 0.0)) + 0.5) *
        lattice.dy;
    const auto is_shown = [&](double x, double y, double z) {
        return x > view.u_low - spacing && x < view.u_high + spacing && z > view.v_low - spacing &&
               z < view.v_high + spacing && (D == 2 || std::abs(y - row) < 0.499 * lattice.dy);
    };
    const WallParticles<D> walls = wall_particles<D>(c);
    for (std::size_t i = 0; i < walls.size(); ++i) {
        const double x = walls.position[0][i];
        const double z = walls.position[D - 1][i];
        if (!is_shown(x, walls.position[1][i], z)) continue;
        const bool solid = !walls.body.empty() && walls.body[i] >= first_solid;
        sheet.circle(
            view.x(x), view.y(z), radius(walls.volume[i]),
            fmt::format(R"(fill="{}" stroke="#1b2026" stroke-width="0.5")",
                        solid ? solid_colour(c, static_cast<std::size_t>(walls.body[i] - first_solid))
                              : std::string("#b4bcc4")));
    }
    Particles<D> water = lattice_particles<D>(c, plan.surface);
    if (starts_packed(c)) (void)pack_start(c, make_scheme(c, nullptr), water);
    for (std::size_t i = 0; i < water.position[0].size(); ++i) {
        const double x = water.position[0][i];
        const double z = water.position[D - 1][i];
        if (is_shown(x, water.position[1][i], z)) {
            sheet.circle(view.x(x), view.y(z), full, R"(fill="#8fc3e6" stroke="#0072b2" stroke-width="0.5")");
        }
    }
}

/// The bed and the surfaces of the solids over their particles.
void draw_surfaces(SvgSheet& sheet, const Case& c, const PreviewPlan& plan, const SheetView& view) {
    if (c.channel.top != Top::periodic) {
        sheet.line(view.left, view.y(0.0), view.left + view.width, view.y(0.0),
                   R"(stroke="#1b2026" stroke-width="1.4")");
    }
    const std::string style = R"(fill="none" stroke="#1b2026" stroke-width="1.4")";
    for (const Solid& solid : c.solids) {
        std::vector<SheetPoint> corners;
        for (std::size_t i = 0; i < solid.x.size(); ++i) {
            corners.push_back({solid.x[i], solid.z[i]});
        }
        sheet.polygon(view, corners, style);
        if (const SolidMesh* const mesh = mesh_of(c, solid)) {
            const auto at = [&](double x) { return upright_stretches(*mesh, x, plan.y); };
            for (const auto& polygon : slice_polygons(view.u_low, view.u_high, 300, at)) {
                sheet.polygon(view, polygon, style);
            }
        }
    }
}

}  // namespace

void draw_plan(SvgSheet& sheet, const Case& c, const PreviewPlan& plan, const SheetView& view) {
    const double length = c.channel.length;
    const double width = c.channel.simulated_width();
    sheet.begin_clip(view);
    sheet.rectangle(view.left, view.top, view.width, view.height, R"(fill="#f5f7f9")");
    const auto [from, to] = c.start.water_x.empty()
                                ? std::pair(0.0, length)
                                : std::pair(Extent(c.start.water_x).low, Extent(c.start.water_x).high);
    sheet.rectangle(view.x(from), view.y(width), view.x(to) - view.x(from), view.y(0.0) - view.y(width),
                    fmt::format(R"(fill="{}")", water_colour));
    if (has_spheres(c.bed)) {
        std::vector<Point3> centres = SphereLattice(c).centres(length, width);
        const std::size_t count = centres.size();
        for (std::size_t i = 0; i < count && c.channel.ends == Ends::periodic; ++i) {
            centres.push_back({centres[i][0] + length, centres[i][1], centres[i][2]});
        }
        sheet.end_clip();
        sheet.begin_clip(
            {view.x(0.0), view.y(width), view.x(length) - view.x(0.0), view.y(0.0) - view.y(width)});
        draw_circles(sheet, view, centres, c.bed.sphere_diameter,
                     R"(fill="#c2a878" fill-opacity="0.35" stroke="#8a6d3b" stroke-width="0.8")");
        sheet.end_clip();
        sheet.begin_clip(view);
    }
    const auto draw_patch = [&](const Outline& outline, const char* colour, double opacity) {
        std::vector<SheetPoint> corners;
        for (std::size_t i = 0; i < outline.size(); ++i) corners.push_back({outline.x[i], outline.z[i]});
        sheet.polygon(view, corners,
                      fmt::format(R"(fill="{0}" fill-opacity="{1}" stroke="{0}")", colour, opacity));
    };
    for (const BedPatch& patch : c.bed_patches) draw_patch(plan_outline(c, patch), patch_colour, 0.3);
    for (std::size_t k = 0; k < c.solids.size(); ++k) {
        const Solid& solid = c.solids[k];
        const SolidMesh* const mesh = mesh_of(c, solid);
        if (mesh == nullptr) continue;
        constexpr std::size_t few = 20000;
        if (solid.shape == SolidShape::spheres) {
            for (const LaidSphere& sphere : laid_spheres(c, solid)) {
                draw_circles(sheet, view, {sphere.centre}, sphere.diameter,
                             R"(fill="#c2a878" stroke="#5b4a2f" stroke-width="0.8")");
            }
        } else if (is_bed_shape(solid.shape) || mesh->tree().triangles().size() > few) {
            sheet.end_clip();
            draw_heights(sheet, c, plan, view, *mesh);
            sheet.begin_clip(view);
        } else {
            draw_silhouette(sheet, c, view, k, *mesh);
        }
    }
    const auto edge = [&](double u0, double v0, double u1, double v1, bool wall, bool mirror = false) {
        sheet.line(view.x(u0), view.y(v0), view.x(u1), view.y(v1),
                   wall     ? R"(stroke="#1b2026" stroke-width="2.4")"
                   : mirror ? R"(stroke="#1b2026" stroke-dasharray="9 3 2 3")"
                            : R"(stroke="#56606b" stroke-width="1.2" stroke-dasharray="7 5")");
    };
    const bool half = c.channel.sides == Sides::half;
    edge(0.0, 0.0, length, 0.0, c.channel.sides != Sides::periodic);
    edge(0.0, width, length, width, c.channel.sides == Sides::walls, half);
    edge(0.0, 0.0, 0.0, width, c.channel.ends == Ends::walls);
    edge(length, 0.0, length, width, c.channel.ends == Ends::walls);
    sheet.end_clip();
    for (std::size_t k = 0; k < c.solids.size(); ++k) {
        const auto x = extent_of(c, c.solids[k], 0);
        const auto y = extent_of(c, c.solids[k], 1);
        if (x && y && !is_bed_shape(c.solids[k].shape)) {
            sheet.text(view.x(0.5 * (x->low + x->high)), view.y(std::max(y->low, 0.0)) + 15.0,
                       c.solids[k].name, R"(class="halo" text-anchor="middle" font-weight="600")");
        }
    }
    const std::string cut = R"(stroke="#1b2026" stroke-width="1" stroke-dasharray="12 4 3 4")";
    sheet.line(view.left - 2.0, view.y(plan.y), view.left + view.width + 2.0, view.y(plan.y), cut);
    sheet.text(view.left + view.width + 4.0, view.y(plan.y) + 4.0, "A", R"(class="halo" font-weight="600")");
    for (std::size_t k = 0; k < plan.x.size(); ++k) {
        sheet.line(view.x(plan.x[k]), view.top - 2.0, view.x(plan.x[k]), view.top + view.height + 2.0, cut);
        sheet.text(view.x(plan.x[k]) + 5.0, view.top + 13.0, k == 0 ? "B" : "C",
                   R"(class="halo" font-weight="600")");
    }
    for (const BedPatch& patch : c.bed_patches) name_outline(sheet, view, plan_outline(c, patch), patch.name);
    for (const SurfacePatch& patch : c.surface_patches) {
        const Outline outline = plan_outline(c, patch);
        draw_patch(outline, patch_colour, 0.3);
        name_outline(sheet, view, outline, patch.name);
    }
    for (const Vegetation& patch : c.vegetation) {
        const Outline outline = plan_outline(c, patch);
        draw_patch(outline, stem_colour, 0.22);
        name_outline(sheet, view, outline, patch.name);
    }
    for (const Porous& zone : c.porous) {
        const Outline outline = plan_of(c, zone);
        draw_patch(outline, porous_colour, 0.3);
        // A zone that the side view cuts has its name there.
        if (porous_cuts_along(c, zone, plan.y, plan.top).empty()) {
            name_outline(sheet, view, outline, zone.name);
        }
    }
    draw_probes_in_plan(sheet, c, view);
    const double x = view.x(0.06 * length);
    sheet.dimension(x, view.y(0.0), x, view.y(width), plan.unit.text(width));
    if (half) {
        sheet.text(view.x(0.5 * length), view.y(width) + 15.0, "plane of symmetry",
                   R"(class="halo" fill="#56606b" text-anchor="middle")");
    }
    sheet.axes(view, plan.unit, "x", "y");
}

SheetPoint particle_window(const Case& c, double width, double height) {
    const double layers = (c.numerics.wall_layers + 1) * c.numerics.spacing;
    const double lowest = 0.5 * height - layers;
    const bool drawn = !c.start.water_x.empty();
    const double level = drawn ? Extent(c.start.water_z).high : c.total_depth();
    SheetPoint middle{drawn ? Extent(c.start.water_x).high : 0.5 * c.channel.length, lowest};
    for (const Solid& solid : c.solids) {
        const auto x = extent_of(c, solid, 0);
        const auto z = extent_of(c, solid, 2);
        if (!x || !z || z->low > level) continue;
        // At a corner of it that stands in the water.
        if (x->low > 0.0) {
            middle.x = x->low + 0.2 * width;
        } else if (x->high < c.channel.length) {
            middle.x = x->high;
        }
        const double into = is_bed_shape(solid.shape) ? 0.0 : 0.15 * height;
        // Of an outline the face there, which may slope.
        const double foot = z->low + 1e-6 * c.numerics.spacing;
        const double face =
            c.channel.dimensions == 2 ? ceiling_above({solid.x, solid.z}, middle.x, foot) : foot;
        middle.y = std::max(lowest, std::min(face > foot ? face : z->high, level) - into);
        break;
    }
    const double side = 0.5 * width - layers;
    if (c.channel.length > width) middle.x = std::clamp(middle.x, side, c.channel.length - side);
    return middle;
}

bool draw_particles(SvgSheet& sheet, const Case& c, const PreviewPlan& plan, const SheetView& view) {
    constexpr double most = 4e6;
    const CaseSize size = estimate_size(c);
    if (size.places + size.walls > most) return false;
    sheet.begin_clip(view);
    if (c.channel.dimensions == 3) {
        draw_placed<3>(sheet, c, plan, view);
    } else {
        draw_placed<2>(sheet, c, plan, view);
    }
    draw_surfaces(sheet, c, plan, view);
    sheet.end_clip();
    const double spacing = c.numerics.spacing;
    const double x = view.left + 14.0;
    const double y = view.top + 20.0;
    sheet.rectangle(x - 8.0, y - 16.0, std::max(5.0 * spacing * view.scale_u() + 16.0, 110.0), 26.0,
                    R"(fill="#fff" fill-opacity="0.9")");
    sheet.dimension(x, y + 4.0, x + 5.0 * spacing * view.scale_u(), y + 4.0,
                    fmt::format("5 × {:.4g} mm", 1e3 * spacing));
    sheet.axes(view, plan.unit, "x", "z");
    return true;
}

}  // namespace riffle::inline preview
