#include "case/bed_patch.hpp"

#include <algorithm>
#include <utility>
#include <vector>

#include "case/bed_traits.hpp"
#include "case/mirror_image.hpp"
#include "case/patch_range.hpp"

namespace riffle::inline case_file {

namespace {

/// The stretches of the width that a patch covers at a place along the channel, m. On the edge of an outline,
/// as at an end, a line has no length in it: it is looked at a little farther in.
std::vector<PatchRange> stretches_at(const Case& c, const BedPatch& patch, double x) {
    return stretches_of(c, patch, 1, within_ends(x, c.channel.length));
}

/// Whether these are the whole width.
bool is_whole_width(const Case& c, const std::vector<PatchRange>& stretches) {
    constexpr double rounding = 1e-9;
    const double width = c.channel.simulated_width();
    return c.channel.dimensions == 2 ? !stretches.empty()
                                     : stretches.size() == 1 && stretches[0].from <= rounding * width &&
                                           stretches[0].to >= (1.0 - rounding) * width;
}

}  // namespace

Bed bed_of(const Case& c, const BedPatch& patch) {
    Bed bed = c.bed;
    bed.kind = patch.kind;
    bed.equivalent_roughness = patch.equivalent_roughness;
    bed.manning = patch.manning;
    bed.sphere_diameter = patch.sphere_diameter;
    bed.packing = patch.packing;
    bed.drag_coefficient = patch.drag_coefficient;
    bed.roughness_height = has_spheres(patch) ? patch.roughness_height.value_or(0.0) : 0.0;
    bed.datum_below_crest = bed.roughness_height - c.datum();
    if (!has_spheres(c.bed)) bed.drag_form = DragForm::consistent;
    return bed;
}

Case with_bed_of(const Case& c, const BedPatch& patch) {
    Case everywhere = c;
    everywhere.bed = bed_of(c, patch);
    everywhere.bed_patches.clear();
    return everywhere;
}

Case with_bed_at(const Case& c, double x) {
    Case everywhere = c;
    everywhere.bed_patches.clear();
    for (const BedPatch& patch : c.bed_patches) {
        const std::vector<PatchRange> stretches = stretches_at(c, patch, x);
        if (is_whole_width(c, stretches)) return with_bed_of(c, patch);
        for (const PatchRange& across : stretches) {
            BedPatch strip = patch;
            strip.x_from.reset();
            strip.x_to.reset();
            if (is_outlined(patch)) {
                strip.x.clear();
                strip.y.clear();
                strip.y_from = across.from;
                strip.y_to = across.to;
            }
            everywhere.bed_patches.push_back(std::move(strip));
        }
    }
    return everywhere;
}

bool strips_have_section(const Case& c, double x) {
    const Case there = with_bed_at(c, x);
    const auto is_plane = [](const BedPatch& patch) { return !has_spheres(patch); };
    return c.has_side_walls() && !has_spheres(c.bed) &&
           std::all_of(there.bed_patches.begin(), there.bed_patches.end(), is_plane) &&
           without_image(there, there.bed_patches) == nullptr;
}

const BedPatch* patch_beside(const Case& c, double x) {
    const auto found = std::find_if(c.bed_patches.begin(), c.bed_patches.end(), [&](const BedPatch& patch) {
        const std::vector<PatchRange> stretches = stretches_at(c, patch, x);
        return !stretches.empty() && !is_whole_width(c, stretches);
    });
    return found != c.bed_patches.end() ? &*found : nullptr;
}

}  // namespace riffle::inline case_file
