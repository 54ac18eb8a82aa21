#include "case/stem_feet.hpp"

#include <algorithm>
#include <vector>

#include "case/gauge_face.hpp"
#include "case/solid_mesh.hpp"
#include "case/solid_stretches.hpp"

namespace riffle::inline case_file {

namespace {

void widen(std::optional<SolidStretch>& extent, double z) {
    if (!extent) extent = SolidStretch{z, z};
    extent->low = std::min(extent->low, z);
    extent->high = std::max(extent->high, z);
}

void widen_by_outline(std::optional<SolidStretch>& extent, const Outline& outline, double x) {
    for (std::size_t i = 0; i < outline.size(); ++i) {
        const std::size_t j = outline.next(i);
        const double along = outline.x[j] - outline.x[i];
        if (x < std::min(outline.x[i], outline.x[j]) || x > std::max(outline.x[i], outline.x[j])) continue;
        if (along == 0.0) {
            widen(extent, outline.z[i]);
            widen(extent, outline.z[j]);
        } else {
            widen(extent, outline.z[i] + (x - outline.x[i]) / along * (outline.z[j] - outline.z[i]));
        }
    }
}

}  // namespace

std::optional<SolidStretch> solid_extent(const Case& c, const Solid& solid, double x, double y) {
    if (c.channel.dimensions == 2) {
        const Outline outline{solid.x, solid.z};
        std::optional<SolidStretch> extent;
        widen_by_outline(extent, outline, x);
        if (c.channel.ends == Ends::periodic) {
            widen_by_outline(extent, outline, x - c.channel.length);
            widen_by_outline(extent, outline, x + c.channel.length);
        }
        return extent;
    }
    const SolidMesh* const mesh = mesh_of(c, solid);
    const auto stretches = mesh != nullptr ? upright_stretches(*mesh, x, y) : std::vector<SolidStretch>{};
    return stretches.empty() ? std::nullopt
                             : std::optional(SolidStretch{stretches.front().low, stretches.back().high});
}

std::optional<double> solid_top(const Case& c, const Solid& solid, double x, double y) {
    const auto extent = solid_extent(c, solid, x, y);
    return extent ? std::optional(extent->high) : std::nullopt;
}

double stem_foot(const Case& c, const Vegetation& stems, double x, double y) {
    if (stems.stands_on.empty()) return 0.0;
    const auto solid = solid_named(c, stems.stands_on);
    return solid ? std::max(0.0, solid_top(c, c.solids[*solid], x, y).value_or(0.0)) : 0.0;
}

Outline canopy_outline(const Vegetation& stems, double from, double to,
                       const std::function<double(double)>& foot) {
    // A level patch needs no more than its corners.
    const int parts = stems.stands_on.empty() ? 1 : 200;
    Outline outline;
    for (int i = 0; i <= 2 * parts + 1; ++i) {
        const bool upper = i > parts;
        const double step = upper ? 2 * parts + 1 - i : i;
        // At its very end a solid may count as past it: look a little inside.
        const double inside = std::clamp(step, 1e-3, parts - 1e-3);
        outline.x.push_back(from + (to - from) * step / parts);
        outline.z.push_back(foot(from + (to - from) * inside / parts) + (upper ? stems.height : 0.0));
    }
    return outline;
}

}  // namespace riffle::inline case_file
