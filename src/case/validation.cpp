#include "case/validation.hpp"

#include <fmt/format.h>

#include <system_error>
#include <utility>

#include "case/flow_kind.hpp"
#include "case/probe_validation.hpp"
#include "case/scheme_rules.hpp"
#include "case/solid_validation.hpp"
#include "case/space_validation.hpp"
#include "case/units.hpp"
#include "case/words.hpp"

namespace riffle {

namespace {

/// The checks, each a small function over the case; a failed one adds its message at the place of its keys.
class Validation {
  public:
    Validation(const Case& c, const Places& places, Problems& problems)
        : c_(c), places_(places), problems_(problems) {}

    void run(bool check_files) {
        if (c_.bed.kind == BedKind::spheres) {
            check_spheres();
        } else {
            check_smooth_bed();
        }
        check_extent();
        check_top();
        check_turbulence();
        check_start();
        check_run();
        check_surface_threshold();
        if (check_files) {
            check_file("start.file", c_.start.file);
            check_file("measured.velocity_profile", c_.measured.velocity_profile);
        }
    }

  private:
    void add(const std::vector<std::string>& keys, std::string message) {
        problems_.add(places_.of_first(keys), std::move(message));
    }

    void check_spheres() {
        const Bed& bed = c_.bed;
        const double height = bed.roughness_height;
        if (height <= 0) {
            add({"bed.roughness_height"},
                "[bed] roughness_height = 0: a bed of spheres needs a roughness zone; give a length or a "
                "multiple "
                "of the sphere diameter such as \"0.4 D\", or choose kind = \"slip\" or \"no-slip\"");
            return;
        }
        if (height > bed.sphere_diameter) {
            add({"bed.roughness_height", "bed.sphere_diameter"},
                fmt::format(
                    "[bed] roughness_height is {}, more than the sphere diameter {}: expected at most one "
                    "diameter (\"1 D\"), since the drag needs the chord of the sphere at each height",
                    shown_length(height), shown_length(bed.sphere_diameter)));
        }
        if (bed.datum_below_crest > height) {
            add({"bed.datum_below_crest", "bed.roughness_height"},
                fmt::format(
                    "[bed] datum_below_crest is {}, below the bed level: expected at most the roughness "
                    "height {}",
                    shown_length(bed.datum_below_crest), shown_length(height)));
        }
        if (c_.numerics.spacing > height) {
            add({"numerics.spacing", "bed.roughness_height"},
                fmt::format(
                    "[numerics] spacing is {}, larger than the roughness height {}: no particle would "
                    "resolve the roughness zone; make the spacing {} or less",
                    shown_length(c_.numerics.spacing), shown_length(height), shown_length(height / 4)));
        }
    }

    void check_smooth_bed() {
        const std::string kind(c_.bed.kind == BedKind::slip ? "slip" : "no-slip");
        const std::pair<const char*, double> zeros[] = {{"roughness_height", c_.bed.roughness_height},
                                                        {"datum_below_crest", c_.bed.datum_below_crest}};
        for (const auto& [name, value] : zeros) {
            if (value != 0) {
                add({fmt::format("bed.{}", name)},
                    fmt::format(
                        "[bed] {} is {}, but a smooth bed (kind = \"{}\") has no roughness zone: remove the "
                        "key, set it to 0, or choose kind = \"spheres\"",
                        name, shown_length(value), kind));
            }
        }
    }

    void check_extent() {
        const Numerics& n = c_.numerics;
        const double smoothing_length = n.smoothing_ratio * n.spacing;
        const double support = 2 * smoothing_length;
        const double reach = support + n.skin_in(c_.channel.dimensions) * smoothing_length;
        if (c_.channel.ends == Ends::periodic && c_.channel.length < 2 * reach) {
            add({"channel.length", "numerics.spacing"},
                fmt::format(
                    "[channel] length is {}: periodic ends need at least {}, two kernel supports of 2 h with "
                    "their skin, so that no particle meets its own image; make the reach longer or the "
                    "spacing smaller",
                    shown_length(c_.channel.length), shown_length(2 * reach)));
        }
        // Positions are 32-bit fractions of the length: a unit of 1e-5 spacings costs 1e-4 g in the
        // accelerations.
        const double longest = 1e-5 * n.spacing * 4294967296.0;
        if (c_.channel.length > longest) {
            add({"channel.length", "numerics.spacing"},
                fmt::format(
                    "[channel] length is {}: at a spacing of {} the positions, 32-bit integers, resolve "
                    "channels of up to {}; make the channel shorter or the spacing larger",
                    shown_length(c_.channel.length), shown_length(n.spacing), shown_length(longest)));
        }
        const double needed = c_.channel.top == Top::periodic ? 2 * reach : support;
        if (c_.total_depth() < needed) {
            add({"channel.depth", "numerics.spacing"},
                fmt::format(
                    "[channel] the total depth is {}: at least {} ({}) is needed; make the spacing smaller",
                    shown_length(c_.total_depth()), shown_length(needed),
                    c_.channel.top == Top::periodic ? "two kernel supports of 2 h with their skin"
                                                    : "one kernel support, 2 h"));
        }
    }

    void check_top() {
        if (c_.channel.top == Top::free_surface) {
            if (c_.fluid.gravity <= 0) {
                add({"fluid.gravity"},
                    "[fluid] gravity = 0: a free surface needs gravity; give 9.81, or choose another "
                    "[channel] top");
            }
            return;
        }
        const std::string top = c_.channel.top == Top::wall ? "wall" : "periodic";
        if (c_.bed.kind == BedKind::spheres) {
            add({"channel.top"},
                fmt::format("[channel] top = \"{}\" goes with a smooth bed: set [bed] kind = {}", top,
                            c_.channel.top == Top::wall ? R"("no-slip" or "slip")" : R"("slip")"));
        }
        if (c_.channel.top != Top::periodic) {
            return;
        }
        if (c_.channel.ends != Ends::periodic) {
            add({"channel.ends", "channel.top"},
                R"([channel] top = "periodic" needs ends = "periodic" as well: set it)");
        }
        if (c_.bed.kind == BedKind::no_slip) {
            add({"bed.kind", "channel.top"},
                "[bed] kind = \"no-slip\": with [channel] top = \"periodic\" there is no bed; set kind = "
                "\"slip\"");
        }
        if (c_.fluid.gravity != 0) {
            add({"fluid.gravity", "channel.top"},
                "[fluid] gravity must be 0 with [channel] top = \"periodic\", where no bed carries the "
                "water: set it to 0");
        }
    }

    void check_turbulence() {
        const Turbulence& t = c_.turbulence;
        if (t.zero >= c_.total_depth()) {
            add({"turbulence.zero"},
                fmt::format(
                    "[turbulence] zero is {}, not below the surface: expected less than the total depth {}",
                    shown_length(t.zero), shown_length(c_.total_depth())));
        }
    }

    void check_start() {
        const Start& s = c_.start;
        switch (s.kind) {
            case StartKind::column:
                check_column_start();
                break;
            case StartKind::results:
                if (s.file.empty()) {
                    add({"start.file", "start.kind"},
                        "[start] file is missing: kind = \"results\" needs the results file to start from, "
                        "for example file = \"run/results.h5\"");
                }
                break;
            case StartKind::standing_wave:
                if (s.amplitude <= 0 && !s.velocity) {
                    add({"start.amplitude", "start.kind"},
                        "[start] kind = \"standing-wave\" needs an amplitude of the surface greater than "
                        "0, for example amplitude = \"1 mm\", or a velocity amplitude");
                }
                if (s.amplitude >= c_.total_depth()) {
                    add({"start.amplitude"},
                        fmt::format("[start] amplitude is {}: expected less than the depth {}",
                                    shown_length(s.amplitude), shown_length(c_.total_depth())));
                }
                break;
            case StartKind::taylor_green:
                if (!s.velocity) {
                    add({"start.velocity", "start.kind"},
                        "[start] velocity is missing: kind = \"taylor-green\" needs the velocity "
                        "amplitude, for example velocity = \"1 m/s\"");
                }
                if (c_.channel.top != Top::periodic) {
                    add({"start.kind"},
                        R"([start] kind = "taylor-green" needs [channel] top = "periodic": set it)");
                }
                break;
            case StartKind::uniform:
            case StartKind::power_law:
                check_velocity_start();
                break;
            case StartKind::rest:
            case StartKind::section:
                break;
        }
    }

    void check_column_start() {
        if (const auto reason = why_no_column(c_)) {
            add({"start.kind"},
                fmt::format(
                    "[start] kind = \"column\" starts from the column twin, and the case has none: {}; "
                    "or choose kind = \"rest\" or \"uniform\"",
                    *reason));
        }
    }

    void check_velocity_start() {
        if (c_.start.velocity) return;
        if (const auto reason = why_no_column(c_)) {
            add({"start.velocity", "start.kind"},
                fmt::format(
                    "[start] velocity is missing, and the case has no column twin to take it from: {}; or "
                    "give the velocity, for example velocity = \"0.3 m/s\"",
                    *reason));
        }
    }

    void check_run() {
        if (c_.run.average_from && *c_.run.average_from >= c_.run.time) {
            add({"run.average_from"}, fmt::format("[run] average_from is {:.6g} s, not before the end of the "
                                                  "run at {:.6g} s: nothing would be "
                                                  "averaged; make it smaller or the run longer",
                                                  *c_.run.average_from, c_.run.time));
        }
        if (c_.run.until == RunUntil::converged && c_.channel.slope == 0 && c_.stirring.acceleration == 0) {
            add({"run.until", "channel.slope"},
                "[run] until = \"converged\" needs a flow that becomes steady: with slope = 0 give a time, "
                "for example until = \"5 s\"");
        }
    }

    void check_surface_threshold() {
        const Output& output = c_.output;
        const bool divergence = output.surface_detection == SurfaceDetection::position_divergence;
        const double in_water = divergence ? c_.channel.dimensions : 1.0;
        if (output.surface_threshold && *output.surface_threshold >= in_water) {
            add({"output.surface_threshold", "output.surface_detection"},
                fmt::format("[output] surface_threshold is {:.6g}, what surface_detection = \"{}\" is in the "
                            "water or more: no surface would be found; expected less than {:g}, half of it "
                            "on the surface itself",
                            *output.surface_threshold, word(output.surface_detection), in_water));
        }
    }

    void check_file(const std::string& id, const std::filesystem::path& file) {
        std::error_code error;
        if (!file.empty() && !std::filesystem::is_regular_file(file, error)) {
            const auto dot = id.find('.');
            add({id}, fmt::format(
                          "[{}] {} = {}: there is no such file; correct the name (relative names start from "
                          "the folder of the case file) or remove the key",
                          id.substr(0, dot), id.substr(dot + 1), toml_string(file.string())));
        }
    }

    const Case& c_;
    const Places& places_;
    Problems& problems_;
};

}  // namespace

void validate(const Case& c, const Places& places, bool check_files, Problems& problems) {
    Validation(c, places, problems).run(check_files);
    validate_scheme(c, places, problems);
    validate_space(c, places, problems);
    validate_solids(c, places, problems);
    validate_snapshots(c, places, problems);
    validate_probes(c, places, problems);
}

}  // namespace riffle
