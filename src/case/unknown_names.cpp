#include "case/unknown_names.hpp"

#include <fmt/format.h>

#include <vector>

#include "base/visible_text.hpp"
#include "case/key_table.hpp"
#include "case/nearest.hpp"

namespace riffle::inline case_file {

namespace {

std::vector<std::string> section_names() {
    std::vector<std::string> names;
    for (const SectionKeys& section : key_table()) {
        if (!section.name.empty()) names.push_back(section.name);
    }
    return names;
}

std::string joined(const std::vector<std::string>& names) {
    std::string list;
    for (const std::string& name : names) list += list.empty() ? name : ", " + name;
    return list;
}

/// Other sections that know the key: "in [measured]".
std::vector<std::string> sections_with(const std::string& name) {
    std::vector<std::string> homes;
    for (const SectionKeys& section : key_table()) {
        if (find_key(section.name, name) != nullptr) {
            homes.push_back(section.name.empty() ? "before the first section" : "in " + section.heading());
        }
    }
    return homes;
}

/// Keys that people look for and that are not there by that name, or for a reason.
const char* key_hint(const std::string& section, const std::string& name) {
    struct Hint {
        const char* section;
        const char* name;
        const char* text;
    };
    static constexpr const char* place_of_box =
        "of a box and a rectangle `centre` and `size` say where it stands";
    static constexpr Hint hints[] = {
        {"channel", "discharge",
         "a periodic channel has no inflow: its discharge follows from slope, depth and roughness (`riffle "
         "column` says which); to compare with a measured one, give it in [measured]"},
        {"channel", "velocity",
         "the velocity follows from slope, depth and roughness (`riffle column` says which); what a run "
         "starts from is [start] velocity, what was measured [measured] depth_mean_velocity"},
        {"channel", "height", "the height of the water is `depth`, that of the end walls `wall_height`"},
        {"numerics", "dx", "the particle spacing is `spacing`"},
        {"numerics", "h", "the smoothing length is given over the spacing, by `smoothing_ratio`"},
        {"numerics", "cfl", "it is `courant_number`"},
        {"numerics", "dt", "a fixed time step is `time_step`"},
        {"turbulence", "model", "it is `closure`"},
        {"solid", "radius", "the size of spheres, cylinders and circles is their `diameter`"},
        {"solid", "height",
         "of a box and a rectangle it is the last value of `size`, of a cylinder its `length` along `axis`"},
        {"solid", "width", "of a box and a rectangle it is one of the values of `size`"},
        {"solid", "x_from", place_of_box},
        {"solid", "x_to", place_of_box},
        {"solid", "y_from", "of a box `centre` and `size` say where it stands"},
        {"solid", "y_to", "of a box `centre` and `size` say where it stands"},
        {"solid", "z_from", place_of_box},
        {"solid", "z_to", place_of_box},
        {"run", "end_time", "it is `until`, for example until = \"60 s\""},
        {"run", "time", "it is `until`, for example until = \"60 s\""},
    };
    for (const Hint& hint : hints) {
        if (section == hint.section && name == hint.name) return hint.text;
    }
    return nullptr;
}

}  // namespace

std::string unknown_section(const std::string& name) {
    const auto names = section_names();
    const auto meant = nearest_name(name, names);
    return fmt::format("unknown section [{}]{}; the sections are {}", shortened(visible_text(name)),
                       meant ? fmt::format(": did you mean [{}]?", *meant) : "", joined(names));
}

std::string UnknownKeys::message(const std::string& section, const std::string& name) {
    const std::string shown = shortened(visible_text(name));
    const SectionKeys& here = *find_section(section);
    if (const char* const hint = key_hint(section, name)) {
        return fmt::format("unknown key `{}` in {}: {}", shown, here.heading(), hint);
    }
    std::vector<std::string> names;
    for (const Key& key : here.keys) names.push_back(key.name);
    const std::string where = section.empty() ? "before the first section" : "in " + here.heading();
    const auto meant = nearest_name(name, names);
    const std::vector<std::string> homes = sections_with(name);
    std::string advice;
    if (!homes.empty()) {
        advice = fmt::format(": it belongs {}", fmt::join(homes, " or "));
    } else if (meant) {
        advice = fmt::format(": did you mean `{}`?", *meant);
    }
    const bool is_first = listed_.insert(section).second;
    const std::string keys = is_first ? fmt::format("; the keys {} are {}", where, joined(names)) : "";
    return fmt::format("unknown key `{}` {}{}{}", shown, where, advice, keys);
}

}  // namespace riffle::inline case_file
