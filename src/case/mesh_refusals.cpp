#include <algorithm>

#include "case/refusals.hpp"
#include "case/solid_mesh.hpp"
#include "case/solid_places.hpp"
#include "case/units.hpp"

namespace riffle::inline case_file {

namespace {

std::string extent_text(const SolidMesh& mesh) {
    const auto range = [&](std::size_t k) {
        return fmt::format("{} to {}", shown_length(mesh.lower()[k]), shown_length(mesh.upper()[k]));
    };
    return fmt::format("x {}, y {}, z {}", range(0), range(1), range(2));
}

/// A solid may go through a periodic channel from end to end, but not lie across its ends.
bool crosses(const SolidMesh& mesh, std::size_t k, double extent) {
    const double low = mesh.lower()[k];
    const double high = mesh.upper()[k];
    return !(low <= 0.0 && high >= extent) && (low < 0.0 || high > extent);
}

Findings mesh_outside(const Case& c, const Solid& solid) {
    const SolidMesh* const mesh = mesh_of(c, solid);
    if (mesh == nullptr) {
        return {};
    }
    // A deck may stand above the water that is to come.
    constexpr double far_above = 4.0;
    const double extent[3] = {c.channel.length, c.channel.simulated_width(),
                              (has_free_surface(c) ? far_above : 1.0) * highest_water(c)};
    const bool open[3] = {c.channel.ends == Ends::periodic, c.channel.sides == Sides::periodic, false};
    bool outside = false;
    for (std::size_t k = 0; k < 3; ++k) {
        outside = outside || (open[k] && crosses(*mesh, k, extent[k])) || mesh->lower()[k] >= extent[k] ||
                  mesh->upper()[k] <= 0.0;
    }
    return found_if(
        outside,
        "lies outside of the channel, or across its periodic ends: {}; expected x from 0 to {}, y from 0 to {} (or all of it) and a part of z from 0 to {}",
        extent_text(*mesh), shown_length(extent[0]), shown_length(extent[1]), shown_length(extent[2]));
}

Findings mesh_that_fills_all(const Case& c, const Solid& solid) {
    const SolidMesh* const mesh = mesh_of(c, solid);
    const auto covers = [&](double share) {
        return mesh->contains(
            {share * c.channel.length, share * c.channel.simulated_width(), share * c.total_depth()});
    };
    return mesh != nullptr && covers(1e-3) && covers(0.5) && covers(0.999)
               ? found_if(true, "fills the whole channel: {}", extent_text(*mesh))
               : Findings{};
}

/// Whether there may be water on one side alone of a solid along an axis: what rests against a wall has none
/// behind it. A plane of symmetry is no wall.
bool stands_against_wall(const Case& c, const Solid& solid, const SolidMesh& mesh, std::size_t axis) {
    Point3 before = mesh.lower();
    Point3 behind = mesh.upper();
    for (std::size_t k = 0; k < 3; ++k) {
        if (k == axis) continue;
        const PatchRange range = water_range(c, k);
        before[k] = behind[k] =
            0.5 * (std::max(mesh.lower()[k], range.from) + std::min(mesh.upper()[k], range.to));
    }
    before[axis] -= 1e-6 * c.numerics.spacing;
    behind[axis] += 1e-6 * c.numerics.spacing;
    const bool mirrored =
        axis == 1 && c.channel.sides == Sides::half && behind[1] >= c.channel.simulated_width();
    const bool water_before = is_in_channel(c, before);
    const bool water_behind = mirrored || is_in_channel(c, behind);
    return solid.rests() && water_before != water_behind;
}

Findings thin_mesh(const Case& c, const Solid& solid) {
    const SolidMesh* const mesh = mesh_of(c, solid);
    for (std::size_t k = 0; mesh != nullptr && k < 3; ++k) {
        const double width = mesh->upper()[k] - mesh->lower()[k];
        if (width < wall_thickness(c) && !stands_against_wall(c, solid, *mesh, k)) {
            return found_if(true, "is only {} wide, less than {} layers of wall particles ({})",
                            shown_length(width), c.numerics.wall_layers, shown_length(wall_thickness(c)));
        }
    }
    return {};
}

}  // namespace

CheckList mesh_refusals() {
    return {{
                {{"solid.file"},
                 "`file` missing in three dimensions",
                 "",
                 "give the file of its closed surface, for example file = \"stone.stl\", or a shape",
                 [](const Case&, const Solid& solid) {
                     return found_if(solid.shape == SolidShape::free_form && solid.file.empty(),
                                     "file is missing");
                 }},
                {{"solid.place"},
                 "`place` of other than three lengths",
                 "",
                 "give all three, or remove the key",
                 [](const Case&, const Solid& solid) {
                     return found_if(!solid.place.empty() && solid.place.size() != 3,
                                     "place holds {} lengths; expected three: x, y and z",
                                     solid.place.size());
                 }},
                {{"solid.place", "solid.centre"},
                 "a surface outside of the channel or across its periodic ends and sides",
                 "",
                 "see `place` and `scale` (the length of the file's unit), or `centre`",
                 mesh_outside},
                {{"solid.scale", "solid.size", "solid.diameter"},
                 "a surface around all of the channel",
                 "no water is left",
                 "make it smaller; see `scale`, the length of a file's unit",
                 mesh_that_fills_all},
                {{"solid.file", "solid.shape", "numerics.spacing"},
                 "a surface narrower than the `numerics.wall_layers`",
                 "water on one side would reach water on the other",
                 "make it larger or the spacing smaller",
                 thin_mesh},
            },
            in_space};
}

}  // namespace riffle::inline case_file
