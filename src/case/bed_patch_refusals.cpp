#include <string>
#include <utility>

#include "case/bed_patch.hpp"
#include "case/bed_traits.hpp"
#include "case/flow_kind.hpp"
#include "case/patch_checks.hpp"
#include "case/refusals.hpp"
#include "case/words.hpp"

namespace riffle::inline case_file {

namespace {

/// Whether a check finds something in a case.
bool finds(const CheckList& list, const CaseCheck& wanted, const Case& c) {
    bool found = false;
    for_each_finding(list, c,
                     [&](const CaseCheck& check, const CaseFinding&) { found = found || &check == &wanted; });
    return found;
}

/// What a bed is refused for, where that of a patch is all of it; not what [bed] itself is refused for.
Findings refused_as_bed(const Case& c, const BedPatch& patch) {
    const Case everywhere = with_bed_of(c, patch);
    Findings found;
    const auto look = [&](const CheckList& list) {
        for_each_finding(list, everywhere, [&](const CaseCheck& check, const CaseFinding& finding) {
            if (finds(list, check, c)) return;
            std::string detail = finding.detail.empty() ? std::string(check.what) : finding.detail;
            std::erase(detail, '`');
            found.push_back({.detail = std::move(detail), .cure = finding_text("", check, finding)});
        });
    };
    look(wall_law_refusals());
    if (has_spheres(patch)) {
        look(bed_refusals());
        look(sphere_refusals());
    }
    return found;
}

}  // namespace

CheckList bed_patch_refusals() {
    return {
        plan_outline_rows<BedPatch>(
            "bed_patch",
            {
                {{"bed_patch.name"},
                 "an empty `name`",
                 "messages name the patch",
                 "give one",
                 [](const Case&, const BedPatch& patch) {
                     return found_if(patch.name.empty(), "name is empty");
                 }},
                {{"bed_patch.name"},
                 "the `name` of another patch of the bed",
                 "each needs its own",
                 "choose another one",
                 [](const Case& c, const BedPatch& patch) {
                     return found_if(repeats_a_name(c.bed_patches, patch),
                                     "another patch has this name already");
                 }},
                {{"bed_patch.kind", "bed.kind"},
                 R"(a `[[bed_patch]]` with `kind = "no-slip"`, or over such a bed)",
                 "the water rests at all walls of such a channel",
                 R"(choose [bed] kind = "roughness", "smooth", "spheres" or "slip", and one of them for the patch)",
                 [](const Case& c, const BedPatch& patch) {
                     return found_if(is_no_slip(patch) || is_no_slip(c.bed),
                                     R"(kind is "{}" in a channel with bed.kind = "{}")", word(patch.kind),
                                     word(c.bed.kind));
                 },
                 true},
                {{"bed_patch.kind", "channel.top"},
                 "a `[[bed_patch]]` without a free surface",
                 "the laws of rough beds are those of the depth of a channel",
                 "set [channel] top = \"free-surface\"",
                 [](const Case& c) { return !has_free_surface(c); },
                 true},
                {{"bed_patch.roughness_height", "bed_patch.kind"},
                 "`kind = \"spheres\"` of a patch without `roughness_height`",
                 "a bed of spheres needs a roughness zone",
                 "give the height of their crests above the bed level",
                 [](const Case&, const BedPatch& patch) {
                     return found_if(has_spheres(patch) && !patch.roughness_height,
                                     "roughness_height is missing");
                 },
                 true},
                {{"bed_patch.kind", "bed_patch.equivalent_roughness", "bed_patch.manning"},
                 "a patch whose bed is refused as `[bed]`, for its roughness, the closure, the rows over the depth or the "
                 "tiling of its spheres",
                 "",
                 "do what is said there of `[bed]`",
                 refused_as_bed},
                {{"bed_patch.x_from", "bed_patch.x_to", "bed_patch.y_from", "bed_patch.y_to", "bed_patch.x",
                  "bed_patch.y", "bed_patch.name"},
                 "a patch that begins or ends outside of the channel, or ends before it begins",
                 "",
                 "correct the range; without the keys the patch reaches to the end or the side of the channel",
                 [](const Case& c, const BedPatch& patch) { return beyond_channel(c, patch, "bed_patch"); }},
                {{"bed_patch.x_to", "bed_patch.y_to", "numerics.spacing"},
                 "a patch shorter or narrower than a spacing of the particles",
                 "no particle would resolve it",
                 "make the spacing smaller or the patch larger",
                 [](const Case& c, const BedPatch& patch) {
                     return below_spacing(c, least_extent(c, patch));
                 }},
                {{"bed_patch.x_from", "bed_patch.name"},
                 "a patch that covers the whole channel",
                 "nothing is left of [bed]",
                 "give it as [bed], or a range to the patch",
                 [](const Case& c, const BedPatch& patch) {
                     return found_if(covers_length(c, patch) && covers_width(c, patch),
                                     "covers all of the bed");
                 }},
                {{"bed_patch.name"},
                 "a patch that lies where another one does",
                 "a place has one roughness",
                 "give patches beside each other",
                 [](const Case& c, const BedPatch& patch) {
                     const BedPatch* const other = patch_below(c, c.bed_patches, patch);
                     return other != nullptr ? found_if(true, "lies where \"{}\" does", other->name)
                                             : Findings{};
                 }},
                {{"bed_patch.name", "vegetation.name"},
                 "a patch of the bed under `[[vegetation]]`",
                 "the mixing length among stems is that over one bed",
                 "give patches beside each other",
                 [](const Case& c, const BedPatch& patch) {
                     for (const Vegetation& stems : c.vegetation) {
                         if (lie_over_each_other(c, patch, stems)) {
                             return found_if(true, "lies under the vegetation \"{}\"", stems.name);
                         }
                     }
                     return Findings{};
                 }},
                {{"bed_patch.name", "side_walls.drag_form"},
                 R"(a `[[bed_patch]]` with side walls whose friction is not by the log law)",
                 "the other forms follow from the drag of one bed",
                 R"(choose [side_walls] drag_form = "log-law" or "none")",
                 [](const Case& c) {
                     return c.has_side_wall_drag() && c.side_walls.drag_form != SideDragForm::log_law;
                 }},
            }),
        [](const Case& c) { return !c.bed_patches.empty(); }};
}

}  // namespace riffle::inline case_file
