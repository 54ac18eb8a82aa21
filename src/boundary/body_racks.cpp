#include "boundary/body_racks.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "case/end_buffers.hpp"
#include "case/outline.hpp"
#include "case/solid_mesh.hpp"
#include "case/units.hpp"

namespace riffle::inline boundary {

std::vector<BoundaryPlane> body_racks(const Case& c) {
    const bool any =
        std::any_of(c.solids.begin(), c.solids.end(), [](const Solid& solid) { return solid.is_free(); });
    if (c.channel.ends != Ends::open || !any) {
        return {};
    }
    const double clear = watched_stretch(c);
    return {{0, clear, 1.0}, {0, c.channel.length - clear, -1.0}};
}

RackWatch::RackWatch(const Case& c) : racks_(body_racks(c)), motion_(c) {
    if (racks_.empty()) return;
    for (std::size_t k = 0; k < c.solids.size(); ++k) {
        const Solid& solid = c.solids[k];
        if (!solid.is_free()) continue;
        Body body{solid.name, k, {}, std::vector<bool>(racks_.size(), false)};
        if (const SolidMesh* const mesh = mesh_of(c, solid)) {
            for (const Triangle& t : mesh->tree().triangles()) {
                body.corners.insert(body.corners.end(), t.begin(), t.end());
            }
        } else {
            const Outline outline = outline_of(solid);
            for (std::size_t i = 0; i < outline.size(); ++i) {
                body.corners.push_back({outline.x[i], 0.0, outline.z[i]});
            }
        }
        bodies_.push_back(std::move(body));
    }
}

std::vector<std::string> RackWatch::news(double time, std::span<const FreeBodyState> free) {
    std::vector<std::string> sentences;
    if (bodies_.empty()) return sentences;
    const std::vector<BodyState> states = motion_.at(time, free);
    for (Body& body : bodies_) {
        const BodyState& state = states[first_solid + body.solid];
        for (std::size_t r = 0; r < racks_.size(); ++r) {
            if (body.told[r]) continue;
            const BoundaryPlane& rack = racks_[r];
            const bool touches =
                std::any_of(body.corners.begin(), body.corners.end(), [&](const Point3& corner) {
                    return rack.inward * (state.placed(corner)[0] - rack.place) <= 0.0;
                });
            if (touches) {
                body.told[r] = true;
                sentences.push_back(fmt::format(
                    "the free body \"{}\" has come to the rack at x = {} before the {} at t = {:.4g} s: bodies are "
                    "held back there, and the water passes; make the channel longer where it shall go on",
                    body.name, shown_length(rack.place), r == 0 ? "inflow" : "outflow", time));
            }
        }
    }
    return sentences;
}

}  // namespace riffle::inline boundary
