#include <algorithm>
#include <array>
#include <set>
#include <sstream>

#include "case/flow_kind.hpp"
#include "case/refusals.hpp"
#include "case/units.hpp"
#include "case/words.hpp"

namespace riffle::inline case_file {

namespace {

/// What the surface detection gives in the water.
double detected_in_water(const Case& c) {
    return c.output.surface_detection == SurfaceDetection::position_divergence ? c.channel.dimensions : 1.0;
}

constexpr std::array<const char*, 4> known_fields = {"velocity", "pressure", "density", "eddy_viscosity"};

std::vector<std::string> fields_of_snapshots(const Case& c) {
    std::istringstream text(c.output.snapshot_fields);
    std::vector<std::string> fields;
    for (std::string field; text >> field;) fields.push_back(field);
    return fields;
}

struct SnapshotRange {
    const char* name;
    const std::vector<double>& range;
    double extent;  ///< of the water, m

    [[nodiscard]] bool is_whole() const { return range.size() == 2 && range[0] < range[1]; }
};

std::array<SnapshotRange, 3> snapshot_ranges(const Case& c) {
    return {{{"snapshot_x", c.output.snapshot_x, c.channel.length},
             {"snapshot_y", c.output.snapshot_y, c.channel.simulated_width()},
             {"snapshot_z", c.output.snapshot_z, highest_water(c)}}};
}

Findings unknown_fields(const Case& c) {
    Findings found;
    for (const std::string& field : fields_of_snapshots(c)) {
        if (std::find(known_fields.begin(), known_fields.end(), field) == known_fields.end()) {
            found.push_back(
                {.detail = fmt::format("snapshot_fields: \"{}\" is no field of a snapshot", field)});
        }
    }
    return found;
}

Findings repeated_field(const Case& c) {
    std::set<std::string> given;
    for (const std::string& field : fields_of_snapshots(c)) {
        if (!given.insert(field).second) {
            return {{.detail = fmt::format("snapshot_fields: \"{}\" is named twice", field)}};
        }
    }
    return {};
}

Findings broken_ranges(const Case& c) {
    Findings found;
    for (const SnapshotRange& r : snapshot_ranges(c)) {
        if (!r.range.empty() && !r.is_whole()) {
            found.push_back({.detail = fmt::format(
                                 "{}: expected two lengths, from and to, the first one smaller", r.name),
                             .key = fmt::format("output.{}", r.name)});
        }
    }
    return found;
}

Findings dry_ranges(const Case& c) {
    Findings found;
    for (const SnapshotRange& r : snapshot_ranges(c)) {
        if (r.is_whole() && (r.range[1] <= 0.0 || r.range[0] >= r.extent)) {
            found.push_back({.detail = fmt::format("{}: there is no water from {} to {}", r.name,
                                                   shown_length(r.range[0]), shown_length(r.range[1])),
                             .key = fmt::format("output.{}", r.name),
                             .cure = fmt::format("give a part of 0 to {}", shown_length(r.extent))});
        }
    }
    return found;
}

}  // namespace

CheckList run_refusals() {
    return {{
        {{"run.average_from"},
         "`average_from` at the end of the run or later",
         "nothing would be averaged",
         "make it smaller or the run longer",
         [](const Case& c) {
             const double from = c.run.average_from.value_or(0.0);
             return found_if(from >= c.run.time,
                             "average_from is {:.6g} s, not before the end of the run at {:.6g} s", from,
                             c.run.time);
         }},
        {{"run.until", "channel.slope"},
         "`until = \"converged\"` with `channel.slope` 0, without stirring and without open ends",
         "it needs a flow that becomes steady",
         "give a time, for example until = \"5 s\"",
         [](const Case& c) {
             return c.run.until == RunUntil::converged && c.channel.slope == 0.0 &&
                    c.stirring.acceleration == 0.0 && c.channel.ends != Ends::open;
         }},
    }};
}

const CheckList& start_of_run_refusals() {
    static const CheckList list{{
        {{"run.until"},
         "`until = \"converged\"` in a case without a column or a section twin and without open ends, at the start of a run",
         "",
         "or give a time, until = \"10 s\"",
         [](const Case& c) {
             const auto reason = why_no_column(c);
             return found_if(
                 c.run.until == RunUntil::converged && c.channel.ends != Ends::open && reason,
                 "until = \"converged\" tests the mean velocity against the relaxation time of the steady uniform flow, and the case has none: {}",
                 reason.value_or(""));
         }},
    }};
    return list;
}

CheckList output_refusals() {
    return {{
        {{"output.surface_threshold", "output.surface_detection"},
         "`surface_threshold` at what `surface_detection` is in the water, or above: the number of dimensions for `\"position-divergence\"`, else 1",
         "no surface would be found",
         "give less; half of that is on the surface itself",
         [](const Case& c) {
             const double threshold = c.output.surface_threshold.value_or(0.0);
             return found_if(
                 threshold >= detected_in_water(c),
                 "surface_threshold is {:.6g}, and surface_detection = \"{}\" is {:g} in the water",
                 threshold, word(c.output.surface_detection), detected_in_water(c));
         }},
        {{"output.snapshot_fields"},
         "a field in `snapshot_fields` that snapshots do not have",
         "",
         "choose of velocity, pressure, density, eddy_viscosity, with spaces between them",
         unknown_fields},
        {{"output.snapshot_fields"}, "a field twice in `snapshot_fields`", "", "remove one", repeated_field},
        {{"output.snapshot_x", "output.snapshot_y", "output.snapshot_z"},
         "`snapshot_x`, `snapshot_y` or `snapshot_z` other than two lengths, the first one smaller",
         "",
         R"(write for example ["0 mm", "50 mm"])",
         broken_ranges},
        {{"output.snapshot_x", "output.snapshot_y", "output.snapshot_z"},
         "`snapshot_x`, `snapshot_y` or `snapshot_z` where no water is",
         "",
         "give a part of the length, of the simulated width, or of the height that water may reach",
         dry_ranges},
    }};
}

}  // namespace riffle::inline case_file
