#include "case/refusals.hpp"

#include <algorithm>

#include "base/error.hpp"
#include "case/conversion.hpp"
#include "case/end_levels.hpp"
#include "case/key_table.hpp"

namespace riffle::inline case_file {

namespace {

/// `[numerics] wall = "dummy"`; of a repeated section that the check does not look into, its heading alone.
std::string value_in_case(const std::string& id, const Case& c, const CaseCheck& check, std::size_t item) {
    const Key& key = *find_key(id);
    return key.repeated && !check.condition.of_items()
               ? find_section(key.section)->heading()
               : fmt::format("{} = {}", shown_name(key), handy_value_text(key, key.get(c, item)));
}

std::string values_in_case(const CaseCheck& check, const CaseFinding& finding, const Case& c) {
    std::vector<std::string> values;
    for (const std::string& id : finding.key.empty() ? check.keys : std::vector{finding.key}) {
        values.push_back(value_in_case(id, c, check, finding.item));
    }
    return fmt::format("{}{}{}", fmt::join(values, " with "), finding.name.empty() ? "" : " of ",
                       finding.name);
}

const Place& place_of(const CaseCheck& check, const CaseFinding& finding, const Places& places) {
    std::vector<std::string> ids;
    const auto add = [&](const std::string& id) { ids.push_back(find_key(id)->id(finding.item)); };
    if (!finding.key.empty()) add(finding.key);
    for (const std::string& id : check.keys) add(id);
    const Key& first = *find_key(check.keys.front());
    if (first.repeated) {
        ids.push_back(fmt::format("{}[{}]", first.section, finding.item));
    }
    return places.of_first(ids);
}

}  // namespace

const std::vector<CheckList>& refusals() {
    static const std::vector<CheckList> lists{
        bed_refusals(),          wall_law_refusals(), channel_refusals(),       open_end_refusals(),
        open_section_refusals(), inflow_refusals(),   closed_end_refusals(),    plane_refusals(),
        space_refusals(),        sphere_refusals(),   side_wall_refusals(),     method_refusals(),
        reference_refusals(),    start_refusals(),    water_refusals(),         run_refusals(),
        output_refusals(),       solid_refusals(),    shape_refusals(),         solid_surface_refusals(),
        outline_refusals(),      mesh_refusals(),     turning_refusals(),       motion_refusals(),
        free_body_refusals(),    blockage_refusals(), surface_patch_refusals(), bed_patch_refusals(),
        vegetation_refusals(),   porous_refusals(),   probe_refusals()};
    return lists;
}

std::string refusal_text(const CaseCheck& check, const CaseFinding& finding, const Case& c) {
    const Key& key = *find_key(finding.key.empty() ? check.keys.front() : finding.key);
    const std::string detail = finding.detail.empty()
                                   ? values_in_case(check, finding, c)
                                   : find_section(key.section)->heading() + " " + finding.detail;
    return finding_text(detail, check, finding);
}

void refuse(const Case& c, const Places& places, Problems& problems) {
    for (const CheckList& list : refusals()) {
        for_each_finding(list, c, [&](const CaseCheck& check, const CaseFinding& finding) {
            problems.add(place_of(check, finding, places), refusal_text(check, finding, c));
        });
    }
}

void refuse_to_run(const Case& c) {
    for_each_finding(start_of_run_refusals(), c, [&](const CaseCheck& check, const CaseFinding& finding) {
        throw InputError(refusal_text(check, finding, c));
    });
}

double highest_water(const Case& c) {
    if (!has_free_surface(c)) return c.total_depth();
    double highest = std::max(wave_height(c), c.channel.wall_height.value_or(0.0));
    for (const double z : c.start.water_z) highest = std::max(highest, z);
    if (c.channel.ends != Ends::open) return highest;
    return std::max(highest, has_end_tables(c) ? level_with_room(c) : 1.5 * highest_end_level(c));
}

}  // namespace riffle::inline case_file
