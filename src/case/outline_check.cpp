#include "case/outline_check.hpp"

#include <algorithm>
#include <array>
#include <utility>

#include "case/solid_mesh.hpp"
#include "case/units.hpp"

namespace riffle::inline case_file {

namespace {

constexpr std::size_t fewest_corners = 3;

std::string crossing_text(const Outline& outline) {
    const auto edges = crossing_edges(outline);
    if (!edges) return "";
    const auto [i, j] = *edges;
    if (i == j) {
        return fmt::format("the corner {} is given twice in a row", corner_text(outline, i));
    }
    return fmt::format("the outline crosses or touches itself, its edge from {} to {} the one from {} to {}",
                       corner_text(outline, i), corner_text(outline, outline.next(i)),
                       corner_text(outline, j), corner_text(outline, outline.next(j)));
}

}  // namespace

Findings outline_findings(const Outline& outline, OutlineFault fault, std::string_view name,
                          std::string_view second_axis) {
    switch (fault) {
        case OutlineFault::uneven:
            return found_if(outline.x.size() != outline.z.size(), "{}{} values of x and {} of {}", name,
                            outline.x.size(), outline.z.size(), second_axis);
        case OutlineFault::few:
            return found_if(outline.size() < fewest_corners, "{}{} corners", name, outline.size());
        case OutlineFault::crossing:
            break;
    }
    const std::string text = crossing_text(outline);
    return found_if(!text.empty(), "{}{}", name, text);
}

CaseCheck outline_row(OutlineFault fault, std::vector<std::string> keys, std::string_view what,
                      CheckCondition condition) {
    struct Advice {
        const char* why;
        const char* cure;
    };
    static constexpr std::array<Advice, 3> advice{{
        {"a corner needs one of each", "give both for each corner"},
        {"an outline needs at least 3", "give more"},
        {"an outline divides inside from outside",
         "give each corner once, in the order in which one walks around"},
    }};
    const Advice& its = advice[static_cast<std::size_t>(fault)];
    return {std::move(keys), what, its.why, its.cure, std::move(condition), true};
}

bool is_simple(const Outline& outline) {
    return outline_findings(outline, OutlineFault::uneven).empty() &&
           outline_findings(outline, OutlineFault::few).empty() && !crossing_edges(outline);
}

std::string corner_text(const Outline& outline, std::size_t i) {
    return fmt::format("({}, {})", shown_length(outline.x[i]), shown_length(outline.z[i]));
}

std::size_t corners_of_outlines(const Case& c) {
    std::size_t corners = c.start.water_x.size();
    for (const Solid& solid : c.solids) corners += solid.x.size();
    return corners;
}

bool have_shapes(const Case& c) {
    if (c.channel.dimensions == 3) return c.meshes && c.meshes->size() == c.solids.size();
    return corners_of_outlines(c) <= most_corners &&
           std::all_of(c.solids.begin(), c.solids.end(), [](const Solid& solid) {
               return is_simple({solid.x, solid.z});
           });
}

Extent::Extent(const std::vector<double>& values) {
    const auto [least, most] = std::minmax_element(values.begin(), values.end());
    low = *least;
    high = *most;
}

std::optional<Extent> extent_of(const Case& c, const Solid& solid, std::size_t axis) {
    if (c.channel.dimensions == 3) {
        const SolidMesh* const mesh = mesh_of(c, solid);
        return mesh != nullptr ? std::optional(Extent({mesh->lower()[axis], mesh->upper()[axis]}))
                               : std::nullopt;
    }
    const std::vector<double>& corners = axis == 0 ? solid.x : solid.z;
    return corners.empty() ? std::nullopt : std::optional(Extent(corners));
}

std::optional<double> highest_of_solid_bed(const Case& c) {
    std::optional<double> highest;
    for (const Solid& solid : c.solids) {
        if (!solid.part_of_bed) continue;
        std::optional<double> top;
        if (solid.shape == SolidShape::spheres) {
            // The facets of their surfaces stay some micrometres below.
            const double radius = 0.5 * solid.diameter;
            top = solid.level.value_or(radius) + radius;
        } else if (const auto upright = extent_of(c, solid, c.channel.dimensions == 3 ? 2 : 1)) {
            top = upright->high;
        }
        if (!top) return std::nullopt;
        highest = std::max(highest.value_or(*top), *top);
    }
    return highest;
}

}  // namespace riffle::inline case_file
