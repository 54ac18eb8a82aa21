#pragma once

#include <algorithm>
#include <filesystem>
#include <optional>
#include <string>
#include <system_error>
#include <vector>

#include "case/bed_traits.hpp"
#include "case/case_check.hpp"
#include "case/problems.hpp"

namespace riffle::inline case_file {

/// All that a case is refused for, beyond what the key table says of each key by itself.
[[nodiscard]] const std::vector<CheckList>& refusals();

/// Adds the problem of each check that a case fails.
void refuse(const Case& c, const Places& places, Problems& problems);

/// What a case that can be read, and compared with, is refused for when it shall run.
[[nodiscard]] const CheckList& start_of_run_refusals();

/// Throws InputError where one of these checks finds something.
void refuse_to_run(const Case& c);

/// The message of what a check finds in a case: "[numerics] spacing is 12 mm, larger than ...: why; what to
/// do".
[[nodiscard]] std::string refusal_text(const CaseCheck& check, const CaseFinding& finding, const Case& c);

/// A level at an end (m over the datum) that the solid there, with its top at `floor`, does not leave free.
[[nodiscard]] Findings below_floor(const std::optional<double>& level, const Case& c, double floor);

// The lists, by subject.

[[nodiscard]] CheckList bed_refusals();
[[nodiscard]] CheckList wall_law_refusals();  ///< beds by roughness and smooth ones
[[nodiscard]] CheckList channel_refusals();
[[nodiscard]] CheckList open_end_refusals();      ///< open ends
[[nodiscard]] CheckList open_section_refusals();  ///< open ends of a channel with a cross-section
[[nodiscard]] CheckList inflow_refusals();        ///< what enters there
[[nodiscard]] CheckList closed_end_refusals();    ///< any other ends
[[nodiscard]] CheckList plane_refusals();         ///< two dimensions
[[nodiscard]] CheckList space_refusals();         ///< three dimensions
[[nodiscard]] CheckList sphere_refusals();        ///< spheres in three dimensions
[[nodiscard]] CheckList side_wall_refusals();
[[nodiscard]] CheckList method_refusals();
[[nodiscard]] CheckList reference_refusals();  ///< a hydrostatic reference pressure
[[nodiscard]] CheckList start_refusals();
[[nodiscard]] CheckList water_refusals();  ///< the outline of the water
[[nodiscard]] CheckList run_refusals();
[[nodiscard]] CheckList output_refusals();
[[nodiscard]] CheckList solid_refusals();          ///< any dimensions
[[nodiscard]] CheckList shape_refusals();          ///< solids by their shape
[[nodiscard]] CheckList solid_surface_refusals();  ///< surfaces by the log law
[[nodiscard]] CheckList outline_refusals();        ///< solids in two dimensions
[[nodiscard]] CheckList mesh_refusals();           ///< solids in three dimensions
[[nodiscard]] CheckList turning_refusals();    ///< the keys of solids that turn, follow a table or are free
[[nodiscard]] CheckList motion_refusals();     ///< solids that move
[[nodiscard]] CheckList free_body_refusals();  ///< solids that are free
[[nodiscard]] CheckList blockage_refusals();   ///< solids that close a channel
[[nodiscard]] CheckList surface_patch_refusals();  ///< parts of solids of another roughness
[[nodiscard]] CheckList bed_patch_refusals();
[[nodiscard]] CheckList vegetation_refusals();
[[nodiscard]] CheckList porous_refusals();
[[nodiscard]] CheckList probe_refusals();

// What several of them ask.

inline bool in_space(const Case& c) { return c.channel.dimensions == 3; }
inline bool over_spheres(const Case& c) { return has_spheres(c.bed); }
inline bool has_free_surface(const Case& c) { return c.channel.top == Top::free_surface; }

/// Whether an item of a list has the name of one before it.
template <class Item>
[[nodiscard]] bool repeats_a_name(const std::vector<Item>& items, const Item& item) {
    return std::any_of(items.data(), &item, [&](const Item& other) { return other.name == item.name; });
}

/// Reach of the kernel, 2 h, m.
inline double kernel_support(const Case& c) { return 2.0 * c.numerics.smoothing_ratio * c.numerics.spacing; }

/// Files are looked for where the case itself is one: the text of a results file is read where they may be
/// gone.
inline bool is_lost(const Case& c, const std::filesystem::path& file) {
    std::error_code error;
    return !c.path.empty() && !file.empty() && !std::filesystem::is_regular_file(file, error);
}

[[nodiscard]] inline CaseCheck lost_file(
    const char* id, std::string_view what, bool (*lost)(const Case&),
    std::string_view cure =
        "correct the name (relative names start from the folder of the case file) or remove the key") {
    return {{id}, what, "there is no such file", cure, lost};
}
/// The same of the results of a run, whose folder is taken for them on the command line alone.
[[nodiscard]] inline CaseCheck lost_results(const char* id, std::string_view what,
                                            bool (*lost)(const Case&)) {
    return lost_file(
        id, what, lost,
        "correct the name (relative names start from the folder of the case file; of a run give its "
        "results.h5, not its folder) or remove the key");
}

/// Thickness of the layers of wall particles, m.
inline double wall_thickness(const Case& c) { return c.numerics.wall_layers * c.numerics.spacing; }

/// Least extent of a periodic direction, m: two kernel supports with their skin, so that no particle meets
/// its own image.
inline double least_period(const Case& c) {
    return 2.0 * kernel_support(c) +
           2.0 * c.numerics.skin_in(c.channel.dimensions) * c.numerics.smoothing_ratio * c.numerics.spacing;
}

/// Height of walls beside a surface with waves, m, where the case gives none.
inline double wave_height(const Case& c) { return 1.5 * c.total_depth(); }

/// Greatest height over the bed level up to which water may stand or swing, m: under the lid; as high as its
/// waves, its walls, the water of its start, and the levels at its ends with the waves on them.
[[nodiscard]] double highest_water(const Case& c);

}  // namespace riffle::inline case_file
