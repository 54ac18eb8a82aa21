#include "case/bed_patch.hpp"

#include <algorithm>

#include "case/mirror_image.hpp"
#include "case/patch_range.hpp"

namespace riffle::inline case_file {

namespace {

bool lies_at(const Case& c, const BedPatch& patch, double x) {
    const PatchRange along = ranges_of(c, patch)[0];
    return x >= along.from && x <= along.to;
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
    bed.roughness_height = patch.kind == BedKind::spheres ? patch.roughness_height.value_or(0.0) : 0.0;
    bed.datum_below_crest = bed.roughness_height - c.datum();
    if (c.bed.kind != BedKind::spheres) bed.drag_form = DragForm::consistent;
    return bed;
}

Case with_bed_of(const Case& c, const BedPatch& patch) {
    Case everywhere = c;
    everywhere.bed = bed_of(c, patch);
    everywhere.bed_patches.clear();
    return everywhere;
}

Case with_bed_at(const Case& c, double x) {
    for (const BedPatch& patch : c.bed_patches) {
        if (lies_at(c, patch, x) && covers_width(c, patch)) return with_bed_of(c, patch);
    }
    Case everywhere = c;
    everywhere.bed_patches.clear();
    for (const BedPatch& patch : c.bed_patches) {
        if (!lies_at(c, patch, x)) continue;
        BedPatch strip = patch;
        strip.x_from.reset();
        strip.x_to.reset();
        strip.x.clear();
        strip.y.clear();
        if (!is_outlined(patch)) {
            everywhere.bed_patches.push_back(strip);
            continue;
        }
        // On the edge of an outline a line has no length in it.
        for (const PatchRange& across : stretches_of(c, patch, 1, within_ends(x, c.channel.length))) {
            strip.y_from = across.from;
            strip.y_to = across.to;
            if (covers_width(c, strip)) return with_bed_of(c, patch);
            everywhere.bed_patches.push_back(strip);
        }
    }
    return everywhere;
}

bool strips_have_section(const Case& c, double x) {
    const Case there = with_bed_at(c, x);
    const auto is_plane = [](const BedPatch& patch) { return patch.kind != BedKind::spheres; };
    return c.has_side_walls() && c.bed.kind != BedKind::spheres &&
           std::all_of(there.bed_patches.begin(), there.bed_patches.end(), is_plane) &&
           without_image(there, there.bed_patches) == nullptr;
}

const BedPatch* patch_beside(const Case& c, double x) {
    const auto found = std::find_if(c.bed_patches.begin(), c.bed_patches.end(), [&](const BedPatch& patch) {
        if (!lies_at(c, patch, x) || covers_width(c, patch)) return false;
        const auto strips = stretches_of(c, patch, 1, within_ends(x, c.channel.length));
        constexpr double rounding = 1e-9;
        const double width = c.channel.simulated_width();
        return !is_outlined(patch) || !(strips.size() == 1 && strips[0].from <= rounding * width &&
                                        strips[0].to >= (1.0 - rounding) * width);
    });
    return found != c.bed_patches.end() ? &*found : nullptr;
}

}  // namespace riffle::inline case_file
