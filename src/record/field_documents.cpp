// The documents made from the tables of fields.

#include <fmt/format.h>

#include <algorithm>
#include <nlohmann/json.hpp>
#include <string>
#include <utility>
#include <vector>

#include "record/field_tables.hpp"

namespace riffle::inline record {

namespace {

/// A condition: its word for programs, and for the page.
struct ConditionWords {
    Condition condition;
    const char* word;
    const char* text;
};
constexpr ConditionWords condition_words[] = {
    {three_dimensions, "three_dimensions", "in three dimensions"},
    {free_surface, "free_surface", "with a free surface"},
    {column_twin, "column_twin", "where the case has a column"},
    {section_twin, "section_twin", "between side walls"},
    {no_section_twin, "no_section_twin", "without side walls"},
    {with_closure, "closure", "with a closure"},
    {with_solids, "solids", "with solids"},
    {with_moving_solids, "moving_solids", "where solids move"},
    {with_spheres, "spheres", "with a bed of spheres"},
    {when_asked, "asked", "where the case asks for it"},
    {at_the_end, "end", "once the run has ended or was stopped"},
    {with_profiles, "profiles", "once a block of time is complete"},
    {with_samples, "samples", "from ten independent samples on"},
    {on_a_slope, "slope", "on a slope"},
    {where_fitted, "fitted", "where the law can be fitted"},
    {verlet_stepping, "verlet", "with `numerics.stepping` = \"verlet\""},
    {beeman_stepping, "beeman", "with `numerics.stepping` = \"beeman\""},
    {with_open_ends, "open_ends", "with open ends"},
    {with_vegetation, "vegetation", "with vegetation"},
    {with_porous_zones, "porous", "with porous zones"},
    {with_free_bodies, "free_bodies", "with free bodies"},
    {with_local_depth, "local_depth", "where mixing lengths follow the local depth"},
    {slow_correction, "slow_correction", "with `numerics.pressure_correction_time` above 0"},
    {level_surface, "level_surface", "where the surface is as high all along the channel"},
    {with_periodic_ends, "periodic_ends", "with periodic ends"},
    {relaxation_known, "relaxation", "where a twin or the ends tell it"},
    {density_relaxation, "density_relaxation", "with `numerics.density_relaxation` above 0"},
};

const char* word(Averaging averaging) {
    switch (averaging) {
        case Averaging::none:
            return "none";
        case Averaging::over_rows:
            return "over_rows";
        case Averaging::by_samples:
            return "by_samples";
        case Averaging::by_particles:
            return "by_particles";
        case Averaging::moments:
            return "moments";
        case Averaging::sums:
            return "sums";
    }
    return "";
}

const char* word(Reader reader) {
    switch (reader) {
        case Reader::analysis:
            return "analysis";
        case Reader::simulation:
            return "simulation";
        case Reader::index_files:
            return "index_files";
        case Reader::users:
            return "users";
    }
    return "";
}

std::string page_text(Averaging averaging) {
    switch (averaging) {
        case Averaging::over_rows:
            return "rows alike";
        case Averaging::by_samples:
            return "by samples";
        case Averaging::by_particles:
            return "by particles";
        case Averaging::moments:
            return "moments";
        case Averaging::sums:
            return "sums";
        case Averaging::none:
            break;
    }
    return "";
}

std::string conditions_text(unsigned written) {
    std::string text;
    for (const ConditionWords& words : condition_words) {
        if ((written & words.condition) != 0U) text += (text.empty() ? "" : ", ") + std::string(words.text);
    }
    return text;
}

std::string both(const Wording& wording, const char* between) {
    const std::string plane = wording.in(2);
    const std::string space = wording.in(3);
    return plane == space ? plane : plane + between + space;
}

std::string cell(std::string text) {
    for (std::size_t at = text.find('|'); at != std::string::npos; at = text.find('|', at + 2)) {
        text.insert(at, "\\");
    }
    return text;
}

std::string axes_text(const Field& field) {
    if (field.is_attribute()) return "attribute";
    const std::string axes = field.axes;
    std::string text;
    for (const char letter : axes) text += letter == ' ' ? std::string(", ") : std::string(1, letter);
    return text.empty() ? "text" : text;
}

/// The heading that GitHub and its like link to.
std::string section_of(const FieldTable& table) {
    const Group& group = *table.group;
    std::string page = fmt::format("\n## {}\n\n`{}`", group.title, group.path);
    if (*group.kind != '\0') page += fmt::format(", `kind` = {}", group.kind);
    const std::string when = conditions_text(group.written & ~static_cast<unsigned>(when_asked));
    page += fmt::format("{}{}.{}{}\n\n", when.empty() ? "" : ", ", when, *group.note == '\0' ? "" : " ",
                        group.note);
    page += "| name | unit | meaning | axes | mean | written |\n|---|---|---|---|---|---|\n";
    for (const Field& field : table.fields) {
        std::string meaning = both(field.meaning, "; in three dimensions ");
        if (*field.note != '\0') meaning += fmt::format("; {}", field.note);
        page += fmt::format("| `{}` | {} | {} | {} | {} | {} |\n", field.name, both(field.unit, "; "),
                            cell(meaning), axes_text(field), page_text(field.averaging),
                            conditions_text(field.written));
    }
    return page;
}

std::vector<std::string> words_of(const std::string& list) {
    std::vector<std::string> words;
    for (std::size_t from = 0; from < list.size();) {
        const std::size_t end = std::min(list.find(' ', from), list.size());
        words.push_back(list.substr(from, end - from));
        from = end + 1;
    }
    return words;
}

std::vector<std::string> conditions_of(unsigned written) {
    std::vector<std::string> list;
    for (const ConditionWords& words : condition_words) {
        if ((written & words.condition) != 0U) list.emplace_back(words.word);
    }
    return list;
}

}  // namespace

std::string results_fields_markdown() {
    std::string page =
        "# Fields of the results\n\n"
        "<!-- Made by `riffle schema --results --markdown -o docs/results-fields.md` from the tables of fields in "
        "src/record. -->\n\n"
        "Every field of [the results file](results-format.md): datasets, and numbers and texts that are attributes "
        "of their group. Units are SI, and \"1\" without dimension; a unit after a semicolon is that of three "
        "dimensions. Datasets have them in the attribute `units`, the meaning in `long_name`. The axes are x down "
        "the bed, y across the channel from 0 at a side to the simulated width (to the plane of symmetry with "
        "`sides = \"half\"`), z upward from the bed level; the first axis named is the slowest. In three "
        "dimensions forces, discharges and energies are those of the whole simulated width, layer sums and profiles those "
        "of the whole plan.\n\n"
        "The column *mean* says how values of several rows become one: *rows alike*, the mean of the rows; *by "
        "samples*, rows weighted with the `samples` of their window; *by particles*, also with the `count` of their "
        "cell; *moments*, so, each with the product of its means added, from which that of the common means is "
        "taken off again; *sums*, added, and divided by the sum `count`. Places, times and extremes are not "
        "averaged. The last column says which runs have the field, where not all that have the group.\n";
    for (const FieldTable& table : field_tables()) page += section_of(table);
    return page;
}

std::string results_fields_json() {
    using Json = nlohmann::ordered_json;
    // A line for each field, so that changes can be seen.
    std::string text = R"({"format": "riffle-results-fields", "groups": [)";
    const char* between_groups = "\n";
    for (const FieldTable& table : field_tables()) {
        const Group& group = *table.group;
        text += fmt::format(R"({}{{"path": {}, "title": {}, "kind": {}, "fields": [)", between_groups,
                            Json(group.path).dump(), Json(group.title).dump(), Json(group.kind).dump());
        between_groups = ",\n";
        const char* between_fields = "\n ";
        for (const Field& field : table.fields) {
            const Json row = {{"name", field.name},
                              {"attribute", field.is_attribute()},
                              {"unit", {field.unit.in(2), field.unit.in(3)}},
                              {"meaning", {field.meaning.in(2), field.meaning.in(3)}},
                              {"axes", words_of(field.is_attribute() ? "" : field.axes)},
                              {"averaging", word(field.averaging)},
                              {"written", conditions_of(field.written | group.written)},
                              {"reader", word(field.reader)}};
            text += between_fields + row.dump();
            between_fields = ",\n ";
        }
        text += "]}";
    }
    return text + "]}\n";
}

}  // namespace riffle::inline record
