#include <fmt/format.h>

#include <algorithm>
#include <fstream>
#include <map>
#include <sstream>
#include <system_error>
#include <utility>

#include "base/error.hpp"
#include "case/bed_friction.hpp"
#include "case/bed_heights.hpp"
#include "case/bed_surface.hpp"
#include "case/bed_traits.hpp"
#include "case/case.hpp"
#include "case/case_text.hpp"
#include "case/conversion.hpp"
#include "case/key_table.hpp"
#include "case/outline_check.hpp"
#include "case/overrides.hpp"
#include "case/presets.hpp"
#include "case/problems.hpp"
#include "case/quiet_water.hpp"
#include "case/refusals.hpp"
#include "case/solid_mesh.hpp"
#include "case/solid_shapes.hpp"
#include "case/toml_entries.hpp"
#include "case/unknown_names.hpp"

namespace riffle::inline case_file {

namespace {

/// Most sections of a repeated kind.
constexpr std::size_t most_sections = 1000;

/// By the key, and in which of the sections of its name it stands.
using Values = std::map<std::pair<const Key*, std::size_t>, Value>;

std::string not_as_section(const SectionKeys& section) {
    return fmt::format("`{}` is a section{}: write {} on a line of its own and its keys below", section.name,
                       section.repeated() ? " that may stand several times" : "", section.heading());
}

/// Report sections that are not known or not written as they must be, and keep their places.
void check_sections(const Document& document, Places& places, Problems& problems) {
    for (const SectionMention& section : document.sections) {
        const SectionKeys* const known = find_section(section.name);
        if (known == nullptr) {
            problems.add(section.place, unknown_section(section.name));
        } else if (known->repeated() != section.repeated) {
            problems.add(section.place, not_as_section(*known));
        } else if (section.item == most_sections) {
            problems.add(places.of(""), fmt::format("more than {} sections {}: leave some out", most_sections,
                                                    known->heading()));
        } else if (section.repeated) {
            places.set(fmt::format("{}[{}]", section.name, section.item), section.place);
        }
    }
}

/// The values of all right entries by key, and where they stand.
Values collect_values(const Document& document, Places& places, Problems& problems) {
    check_sections(document, places, problems);
    Values values;
    UnknownKeys unknown;
    for (const Entry& entry : document.entries) {
        const SectionKeys* const section = find_section(entry.section);
        if (section == nullptr || section->repeated() != entry.repeated || entry.item >= most_sections) {
            continue;  // reported with its section
        }
        if (entry.section.empty() && find_section(entry.key) != nullptr && !entry.key.empty()) {
            problems.add(entry.key_place, not_as_section(*find_section(entry.key)));
            continue;
        }
        const Key* const key = find_key(entry.section, entry.key);
        if (key == nullptr) {
            problems.add(entry.key_place, unknown.message(entry.section, entry.key));
            continue;
        }
        places.set(key->id(entry.item), entry.value_place);
        auto converted = convert(*key, entry.value);
        if (auto* const message = std::get_if<std::string>(&converted)) {
            problems.add(entry.value_place, std::move(*message));
        } else {
            values[{key, entry.item}] = std::get<Value>(std::move(converted));
        }
    }
    return values;
}

void require_key(const Key& key, std::size_t item, const Places& places, Problems& problems) {
    if (!places.given(key.id(item))) {
        // In a repeated section at its own line, else at the file.
        problems.add(places.of(key.repeated ? fmt::format("{}[{}]", key.section, item) : ""),
                     fmt::format("{} is missing: {} Give {}, for example {} = {}", shown_name(key),
                                 key.meaning, expectation(key), key.name, key.example));
    }
}

/// How many items of each repeated section the document has.
std::size_t items_of(const Document& document, const SectionKeys& section) {
    std::size_t items = section.repeated() ? 0 : 1;
    for (const SectionMention& mention : document.sections) {
        if (section.repeated() && mention.repeated && mention.name == section.name) {
            items = std::min(std::max(items, mention.item + 1), most_sections);
        }
    }
    return items;
}

void require_keys(const Case& c, const Document& document, const Places& places, Problems& problems) {
    for (const SectionKeys& section : key_table()) {
        for (std::size_t item = 0; item < items_of(document, section); ++item) {
            for (const Key& key : section.keys) {
                if (key.required) require_key(key, item, places, problems);
            }
        }
    }
    if (has_spheres(c.bed)) require_key(*find_key("bed.roughness_height"), 0, places, problems);
}

/// Defaults that follow from other keys.
void set_dependent_defaults(Case& c, const Values& values) {
    for (const char* id : {"channel.dimensions", "channel.sides", "numerics.preset", "bed.kind"}) {
        const auto given = values.find({find_key(id), 0});
        if (given != values.end()) given->first.first->set(c, given->second);
    }
    c.numerics = preset_numerics(c.numerics.preset, c.channel.dimensions);
    if (!has_spheres(c.bed)) {
        c.bed.roughness_height = 0.0;
        c.bed.datum_below_crest = 0.0;
        if (c.has_side_walls()) {
            c.side_walls.drag_form = has_wall_law(c) ? SideDragForm::log_law : SideDragForm::none;
        }
    }
}

/// What a key goes with and does not have; where that key itself goes with what is not there, this outer one.
const Applies* outermost_unmet_condition(const Key& key, const Case& c, std::size_t item) {
    const Applies* unmet = unmet_condition(key, c, item);
    while (unmet != nullptr) {
        const Key* const other = find_key(unmet->id);
        const Applies* const outer = other != nullptr ? unmet_condition(*other, c, item) : nullptr;
        if (outer == nullptr || !other->applies.strictly) return unmet;
        unmet = outer;
    }
    return unmet;
}

/// Set a key of the case, if it goes with what is set already.
void set_key(Case& c, const Key& key, std::size_t item, const Value& value, const Places& places,
             Problems& problems) {
    const Applies* const unmet = outermost_unmet_condition(key, c, item);
    if (unmet != nullptr && key.applies.strictly) {
        // An option such as --set run.until=1s supersedes what the file says for the other choice.
        const Place& place = places.of(key.id(item));
        if (place.option || !places.of(unmet->id).option) {
            problems.add(place, fmt::format("{} goes only with {} = \"{}\": remove one of the two",
                                            shown_name(key), unmet->id, fmt::join(unmet->words, "\", \"")));
        }
        return;
    }
    const auto* const diameters = std::get_if<Diameters>(&value);
    key.set(c, diameters != nullptr ? Value(diameters->length(c.bed.sphere_diameter)) : value, item);
}

Case assemble(const Values& values, const Document& document, const Places& places, Problems& problems) {
    Case c;
    set_dependent_defaults(c, values);
    for (const SectionKeys& section : key_table()) {
        for (std::size_t item = 0; item < items_of(document, section); ++item) {
            for (const Key& key : section.keys) {
                const auto given = values.find({&key, item});
                const auto is_wrong = [&](const Applies& applies) {  // and reported already
                    const Key* const other = find_key(applies.id);
                    const std::size_t its_item = other != nullptr && other->repeated ? item : 0;
                    return other != nullptr && places.given(other->id(its_item)) &&
                           !values.contains({other, its_item});
                };
                const bool other_wrong = is_wrong(key.applies) || is_wrong(key.applies_also);
                if (given != values.end() && !other_wrong) {
                    set_key(c, key, item, given->second, places, problems);
                }
            }
        }
    }
    return c;
}

std::filesystem::path resolved(const std::filesystem::path& file, const std::filesystem::path& case_file) {
    if (file.empty() || case_file.empty()) return file;
    return (std::filesystem::absolute(case_file).parent_path() / file).lexically_normal();
}

/// The outline of a solid in two dimensions that is given by its shape. A bed becomes an outline for good:
/// the text of the case holds its corners, and the results need no other file.
void shape_outlines(Case& c, Solid& solid) {
    Outline outline;
    if (solid.shape == SolidShape::bed) {
        const BedHeights bed = bed_heights(c, solid);
        c.solid_notes.insert(c.solid_notes.end(), bed.notes.begin(), bed.notes.end());
        outline = bed_outline(c, bed);
        if (outline.size() > longest_list) {
            throw InputError(
                fmt::format("{}: the bed becomes an outline of {} corners: expected at most {}; make "
                            "the channel shorter or the spacing larger",
                            solid.heights.string(), outline.size(), longest_list));
        }
        const Solid given = std::exchange(solid, Solid{});
        solid.name = given.name;
        solid.surface = given.surface;
        solid.part_of_bed = given.part_of_bed;
    } else {
        outline = shape_outline(c, solid);
    }
    solid.x = outline.x;
    solid.z = outline.z;
}

/// Make the shapes of the solids; what refuse() says of their keys is left to it.
void make_shapes(Case& c, const Places& places, Problems& problems) {
    const bool space = c.channel.dimensions == 3;
    const bool from_files = std::any_of(c.solids.begin(), c.solids.end(), [](const Solid& solid) {
        return !solid.file.empty() || !solid.heights.empty();
    });
    if (c.solids.empty() || (space && from_files && c.path.empty())) return;
    auto meshes = std::make_shared<std::vector<SolidMesh>>();
    for (std::size_t item = 0; item < c.solids.size(); ++item) {
        Solid& solid = c.solids[item];
        if (!shape_is_complete(c, solid) || (!space && solid.shape == SolidShape::free_form)) continue;
        try {
            if (space) {
                meshes->emplace_back(c, solid, &c.solid_notes);
            } else {
                shape_outlines(c, solid);
            }
        } catch (const Error& e) {
            const auto id = [&](const char* name) { return find_key(name)->id(item); };
            problems.add(
                places.of_first({id("solid.file"), id("solid.heights"), fmt::format("solid[{}]", item)}),
                fmt::format("[[solid]] {}: {}", solid.name, e.what()));
        }
    }
    if (space && meshes->size() == c.solids.size()) c.meshes = std::move(meshes);
}

/// The crests of a bed of solids are its highest points, unless the case says otherwise.
void set_crests_of_solids(Case& c, const Places& places) {
    if (places.given("bed.roughness_height") || has_spheres(c.bed)) return;
    if (const auto highest = highest_of_solid_bed(c)) c.bed.roughness_height = std::max(0.0, *highest);
}

}  // namespace

Case parse_case(const std::string& text, const std::string& name, const std::filesystem::path& path,
                const std::vector<Override>& overrides) {
    Problems problems;
    Document document = read_toml(text, name);
    apply_overrides(document, overrides, problems);
    Places places(Place{name, 0, 0, false});
    const auto values = collect_values(document, places, problems);
    Case c = assemble(values, document, places, problems);
    require_keys(c, document, places, problems);
    const GivenNumerics given{.spacing = places.given("numerics.spacing"),
                              .smoothing_ratio = places.given("numerics.smoothing_ratio"),
                              .wall_layers = places.given("numerics.wall_layers"),
                              .lattice = places.given("start.lattice"),
                              .pressure_correction_time = places.given("numerics.pressure_correction_time"),
                              .settling_time = places.given("start.settling_time")};
    choose_resolution(c, given);
    for (std::size_t i = 0; i < c.probes.size(); ++i) {
        c.probe_places.push_back(places.of(fmt::format("probe[{}]", i)).text());
    }
    c.path = path;
    c.start.file = resolved(c.start.file, path);
    for (auto* const file : {&c.inflow.discharge_file, &c.inflow.depth_file, &c.inflow.profile_file,
                             &c.inflow.results, &c.outflow.depth_file, &c.outflow.rating_file}) {
        *file = resolved(*file, path);
    }
    for (Solid& solid : c.solids) {
        solid.file = resolved(solid.file, path);
        solid.heights = resolved(solid.heights, path);
    }
    c.measured.velocity_profile = resolved(c.measured.velocity_profile, path);
    // What the keys demand of each other can only be judged when each of them is right.
    if (problems.empty()) {
        make_shapes(c, places, problems);
        choose_for_quiet_water(c, given);
        set_crests_of_solids(c, places);
        refuse(c, places, problems);
    }
    if (!problems.empty()) problems.raise();
    c.text = case_text(c);
    return c;
}

namespace {

/// Whether a file is of HDF5, or begins with the seal of Riffle's results and checkpoints.
bool is_of_a_run(std::string_view text) {
    return text.starts_with("\x89HDF") || text.starts_with("riffle-results ") ||
           text.starts_with("riffle-checkpoint ");
}

}  // namespace

Case read_case(const std::filesystem::path& path, const std::vector<Override>& overrides) {
    std::error_code error;
    if (!std::filesystem::exists(path, error)) {
        throw FileError(fmt::format("{}: there is no such case file; `riffle new {}` writes one",
                                    path.string(), path.string()));
    }
    if (!std::filesystem::is_regular_file(path, error)) {
        throw FileError(fmt::format("{}: not a file; give the name of a case file (TOML)", path.string()));
    }
    constexpr std::uintmax_t largest = 4U << 20U;
    if (std::filesystem::file_size(path, error) > largest && !error) {
        throw InputError(
            fmt::format("{}: a case file of more than 4 MB is none: a solid of many corners goes "
                        "into an STL file, measured values into a CSV file",
                        path.string()));
    }
    std::ifstream stream(path, std::ios::binary);
    std::ostringstream text;
    text << stream.rdbuf();
    if (!stream) {
        throw FileError(fmt::format("{}: cannot be read; check its permissions", path.string()));
    }
    if (is_of_a_run(text.view())) {
        const std::filesystem::path folder = path.has_parent_path() ? path.parent_path() : ".";
        throw InputError(fmt::format(
            "{}: a file of a run (HDF5), not a case file (TOML): `riffle resume {}` goes on with the run, and its case "
            "is the text /case/text of results.h5",
            path.string(), folder.string()));
    }
    return parse_case(text.str(), path.string(), path, overrides);
}

}  // namespace riffle::inline case_file
