#include "case/solid_places.hpp"

#include <limits>

#include "case/solid_mesh.hpp"

namespace riffle::inline case_file {

SolidPlaces::SolidPlaces(const Case& c)
    : c_(c), period_(c.channel.ends == Ends::periodic ? c.channel.length : 0.0) {
    if (c.channel.dimensions != 2) return;
    for (const Solid& solid : c.solids) {
        const bool known = solid.x.size() == solid.z.size();
        outlines_.push_back(known ? Outline{solid.x, solid.z} : Outline{});
    }
}

bool SolidPlaces::holds(std::size_t solid, const Point3& p) const {
    if (c_.channel.dimensions == 3) {
        const SolidMesh* const mesh = mesh_of(c_, c_.solids[solid]);
        return mesh != nullptr && mesh->contains(p);
    }
    return at_any_image(p[0], period_, [&](double x) { return contains(outlines_[solid], x, p[2]); });
}

std::optional<std::size_t> SolidPlaces::resting_at(const Point3& p,
                                                   std::optional<std::size_t> left_out) const {
    for (std::size_t k = 0; k < c_.solids.size(); ++k) {
        if (k != left_out && c_.solids[k].rests() && holds(k, p)) return k;
    }
    return std::nullopt;
}

PatchRange water_range(const Case& c, std::size_t axis) {
    constexpr double infinite = std::numeric_limits<double>::infinity();
    const bool repeats[] = {c.channel.ends == Ends::periodic,
                            c.channel.dimensions == 2 || c.channel.sides == Sides::periodic, false};
    if (repeats[axis]) return {-infinite, infinite};
    const double to[] = {c.channel.length, c.channel.simulated_width(),
                         c.channel.top == Top::wall ? c.total_depth() : infinite};
    return {0.0, to[axis]};
}

bool is_in_channel(const Case& c, const Point3& p) {
    for (std::size_t axis = 0; axis < p.size(); ++axis) {
        const PatchRange range = water_range(c, axis);
        if (p[axis] <= range.from || p[axis] >= range.to) return false;
    }
    return true;
}

}  // namespace riffle::inline case_file
