#include "case/mesh_validation.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <memory>
#include <utility>
#include <vector>

#include "base/error.hpp"
#include "case/solid_mesh.hpp"
#include "case/units.hpp"

namespace riffle {

namespace {

/// Where a solid lies against the channel.
void check_place(const Case& c, const SolidMesh& mesh,
                 const std::function<void(const char*, const std::string&)>& say) {
    const auto& low = mesh.lower();
    const auto& high = mesh.upper();
    const auto range = [&](std::size_t k) {
        return fmt::format("{} to {}", shown_length(low[k]), shown_length(high[k]));
    };
    const double width = c.channel.simulated_width();
    const double height = std::max(c.total_depth(), c.channel.wall_height.value_or(0.0));
    const bool open_sides = c.channel.sides == Sides::periodic;
    const bool open_ends = c.channel.ends == Ends::periodic;
    const auto crosses = [&](std::size_t k, double extent) {
        const bool goes_through = low[k] <= 0.0 && high[k] >= extent;
        return !goes_through && (low[k] < 0.0 || high[k] > extent);
    };
    if ((open_ends && crosses(0, c.channel.length)) || (open_sides && crosses(1, width)) ||
        low[0] >= c.channel.length || high[0] <= 0.0 || low[1] >= width || high[1] <= 0.0 || high[2] <= 0.0 ||
        low[2] >= height) {
        say("place", fmt::format("lies outside of the channel, or across its periodic ends: x {}, y {}, z "
                                 "{}; expected x from 0 to {}, y from 0 to {} (or all of it) and a part of z "
                                 "from 0 to {}; see `place` and `scale` (the length of the file's unit)",
                                 range(0), range(1), range(2), shown_length(c.channel.length),
                                 shown_length(width), shown_length(height)));
    }
    const auto covers = [&](double share) {
        return mesh.contains({share * c.channel.length, share * width, share * c.total_depth()});
    };
    if (covers(1e-3) && covers(0.5) && covers(0.999)) {
        say("scale", fmt::format("fills the whole channel: no water is left; x {}, y {}, z {}: see `scale`, "
                                 "the length of the file's unit",
                                 range(0), range(1), range(2)));
    }
    for (std::size_t k = 0; k < 3; ++k) {
        const double needed = c.numerics.wall_layers * c.numerics.spacing;
        if (high[k] - low[k] < needed) {
            say("file",
                fmt::format("is only {} wide, less than {} layers of wall particles ({}); make it "
                            "larger or the spacing smaller",
                            shown_length(high[k] - low[k]), c.numerics.wall_layers, shown_length(needed)));
            break;
        }
    }
}

}  // namespace

void read_meshes(Case& c, const Places& places, Problems& problems) {
    if (c.channel.dimensions != 3 || c.solids.empty()) {
        return;
    }
    auto meshes = std::make_shared<std::vector<SolidMesh>>();
    for (std::size_t item = 0; item < c.solids.size(); ++item) {
        const Solid& solid = c.solids[item];
        if (solid.file.empty() || (!solid.place.empty() && solid.place.size() != 3)) {
            continue;  // said by validate_mesh()
        }
        try {
            meshes->emplace_back(solid);
        } catch (const Error& e) {
            const std::string place = fmt::format("solid[{}]", item);
            problems.add(
                places.of_first({place + ".file", place}),
                fmt::format("[[solid]]{}{}: {}", solid.name.empty() ? "" : " ", solid.name, e.what()));
        }
    }
    if (meshes->size() == c.solids.size()) {
        c.meshes = std::move(meshes);
    }
}

void validate_mesh(const Case& c, std::size_t item,
                   const std::function<void(const char* key, const std::string& message)>& say) {
    const Solid& solid = c.solids[item];
    if (solid.motion != SolidMotion::fixed) {
        say("motion", "goes with [channel] dimensions = 2: in three dimensions solids stand still");
    }
    if (solid.file.empty()) {
        say("file",
            "file is missing: give the STL file of its closed surface, for example file = \"stone.stl\"");
    } else if (!solid.place.empty() && solid.place.size() != 3) {
        say("place", fmt::format("holds {} lengths; expected three: x, y and z", solid.place.size()));
    } else if (c.meshes) {
        check_place(c, (*c.meshes)[item], say);
    }
}

}  // namespace riffle
