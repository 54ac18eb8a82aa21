// What the views share: where a case is cut, colours, scales.

#include "preview/preview_views.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>

#include "base/error.hpp"
#include "boundary/wall.hpp"
#include "case/end_buffers.hpp"
#include "case/end_levels.hpp"
#include "case/outline_check.hpp"
#include "case/patch_range.hpp"
#include "case/porous_zone.hpp"
#include "case/solid_mesh.hpp"
#include "case/solid_shapes.hpp"
#include "ends/end_input.hpp"

namespace riffle::inline preview {

namespace {

/// Place along the channel of the middle of its first patch: of stems, of a porous zone, of another bed.
std::optional<double> middle_of_first_patch(const Case& c) {
    const auto middle = [&](const Outline& outline) {
        const Extent x(outline.x);
        return std::clamp(0.5 * (x.low + x.high), 0.0, c.channel.length);
    };
    if (!c.vegetation.empty()) return middle(plan_outline(c, c.vegetation.front()));
    if (!c.porous.empty()) return middle(plan_of(c, c.porous.front()));
    if (!c.bed_patches.empty()) return middle(plan_outline(c, c.bed_patches.front()));
    return std::nullopt;
}

/// Where the start is the steady varied flow between open ends its surface; a start without such a flow is
/// drawn level, and refused by the run.
std::function<double(double)> varied_surface(const Case& c) {
    if (c.channel.ends != Ends::open || c.start.kind != StartKind::backwater || !c.start.water_x.empty()) {
        return {};
    }
    try {
        return start_depths(c, read_end_levels(c));
    } catch (const Error&) {
        return {};
    }
}

/// What lies under a surface along the channel, and as high beyond its open ends.
Outline water_under(const Case& c, const std::function<double(double)>& surface) {
    constexpr int parts = 200;
    const double beyond = buffer_length(c);
    Outline water{{c.channel.length + beyond, -beyond, -beyond}, {0.0, 0.0, surface(0.0)}};
    for (int i = 0; i <= parts; ++i) {
        water.x.push_back(c.channel.length * i / parts);
        water.z.push_back(surface(water.x.back()));
    }
    water.x.push_back(c.channel.length + beyond);
    water.z.push_back(water.z.back());
    return water;
}

}  // namespace

PreviewPlan plan_preview(const Case& c) {
    PreviewPlan plan;
    plan.surface = varied_surface(c);
    plan.water = plan.surface ? water_under(c, plan.surface) : Outline{c.start.water_x, c.start.water_z};
    const double spacing = c.numerics.spacing;
    plan.unit = SheetUnit::of(c.channel.length);
    double top = c.total_depth();
    for (const double z : plan.water.z) top = std::max(top, z);
    if (c.channel.ends == Ends::walls) top = std::max(top, c.channel.wall_height.value_or(0.0));
    if (c.channel.ends == Ends::open) top = std::max(top, highest_end_level(c));
    const double water = top;
    const bool space = c.channel.dimensions == 3;
    plan.y = c.channel.dimensions == 3 ? std::min(c.channel.centreline(), c.channel.simulated_width()) : 0.0;
    if (space && c.channel.sides == Sides::half) plan.y = 0.999 * c.channel.simulated_width();
    bool found = false;
    for (const Solid& solid : c.solids) {
        if (const auto z = extent_of(c, solid, 2)) top = std::max(top, std::min(z->high, 3.0 * water));
        const auto x = extent_of(c, solid, 0);
        const auto y = space ? extent_of(c, solid, 1) : std::nullopt;
        if (!is_bed_shape(solid.shape) && x && y && plan.x.size() < 2) {
            plan.x.push_back(std::clamp(0.5 * (x->low + x->high), 0.0, c.channel.length));
            plan.y = found ? plan.y : std::clamp(0.5 * (y->low + y->high), 0.0, c.channel.simulated_width());
            found = true;
        }
    }
    if (space && plan.x.empty()) plan.x.push_back(middle_of_first_patch(c).value_or(0.5 * c.channel.length));
    if (plan.x.size() == 2 && std::abs(plan.x[0] - plan.x[1]) < spacing) plan.x.pop_back();
    plan.below = std::max((c.numerics.wall_layers + 1) * spacing, 0.2 * top);
    plan.beside = std::max(0.03 * c.channel.length, (c.numerics.wall_layers + 1) * spacing);
    plan.top = 1.2 * top;
    return plan;
}

void name_outline(SvgSheet& sheet, const SheetView& view, const Outline& outline, const std::string& name) {
    double u = 0.0;
    double v = 0.0;
    for (std::size_t i = 0; i < outline.size(); ++i) {
        u += outline.x[i] / static_cast<double>(outline.size());
        v += outline.z[i] / static_cast<double>(outline.size());
    }
    constexpr double letter = 7.5;
    if (letter * static_cast<double>(name.size()) > view.width) {
        sheet.text(view.left + view.width + 6.0, view.y(v) - 16.0, name, R"(class="halo" font-weight="600")");
        return;
    }
    sheet.text(view.x(u), view.y(v), name, R"(class="halo" text-anchor="middle" font-weight="600")");
}

std::string solid_colour(const Case& c, std::size_t solid) {
    if (is_bed_shape(c.solids[solid].shape)) return "#c2a878";
    static constexpr std::array<const char*, 5> still{"#7d8791", "#5f7a6b", "#8a6f8f", "#6d7fa3", "#93836b"};
    return c.solids[solid].rests() ? still[solid % still.size()] : "#d98a4b";
}

ScaledView scaled_view(double left, double top, double width, double least, double most, double u_low,
                       double u_high, double v_low, double v_high) {
    ScaledView scaled{{left, top, width, 0.0, u_low, u_high, v_low, v_high}};
    double height = width / (u_high - u_low) * (v_high - v_low);
    if (height < least) {
        for (const double factor : {1.5, 2.0, 3.0, 4.0, 5.0, 8.0, 10.0, 15.0, 20.0, 50.0, 100.0}) {
            scaled.exaggeration = factor;
            if (height * factor >= least) break;
        }
        height *= scaled.exaggeration;
    } else if (height > most) {
        scaled.view.width = width * most / height;
        height = most;
    }
    scaled.view.height = std::min(height, most);
    return scaled;
}

}  // namespace riffle::inline preview
