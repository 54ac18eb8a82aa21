#include "case/probe_validation.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <set>

#include "case/units.hpp"
#include "case/words.hpp"

namespace riffle {

namespace {

/// Points of a grid at most: more than any display or disk makes sense of, and far below what memory holds.
constexpr double most_points = 1e6;

/// The checks of one probe; a failed one adds its message at the place of its keys.
class ProbeValidation {
  public:
    ProbeValidation(const Case& c, std::size_t item, const Places& places, Problems& problems)
        : c_(c), p_(c.probes[item]), item_(item), places_(places), problems_(problems) {}

    void run(std::set<std::string>& names) {
        check_name(names);
        if (p_.start >= c_.run.time) {
            add("start",
                fmt::format("start is {:.6g} s, not before the end of the run at {:.6g} s: it would record "
                            "nothing; make it smaller",
                            p_.start, c_.run.time));
        }
        switch (p_.kind) {
            case ProbeKind::velocity:
                check_positions();
                check_heights();
                break;
            case ProbeKind::wave:
                check_surface();
                check_positions();
                break;
            case ProbeKind::surface_line:
                check_surface();
                check_across();
                check_spacing();
                break;
            case ProbeKind::grid:
                check_across();
                check_grid();
                break;
            case ProbeKind::flow_rate:
                check_positions();
                check_sections();
                break;
            case ProbeKind::pressure:
                check_positions();
                check_heights();
                break;
            case ProbeKind::force:
                break;
        }
    }

  private:
    void add(const std::string& key, const std::string& message) {
        const std::string probe = fmt::format("probe[{}]", item_);
        problems_.add(places_.of_first({probe + "." + key, probe}), "[[probe]] " + message);
    }

    [[nodiscard]] std::string kind() const { return fmt::format("kind = \"{}\"", word(p_.kind)); }

    void check_name(std::set<std::string>& names) {
        const bool right = !p_.name.empty() && std::all_of(p_.name.begin(), p_.name.end(), [](char letter) {
            return (letter >= 'a' && letter <= 'z') || (letter >= 'A' && letter <= 'Z') ||
                   (letter >= '0' && letter <= '9') || letter == '_' || letter == '-';
        });
        if (!right) {
            add("name",
                "name: expected letters a-z, A-Z, digits, _ and -, as it names a group in the results; "
                "choose such a name");
        } else if (p_.name.rfind(standard_probe_prefix, 0) == 0) {
            add("name",
                fmt::format("name = \"{}\": names that begin with {} are those of the instruments that "
                            "record without asking; choose another name (output.standard_probes = false "
                            "switches those off)",
                            p_.name, standard_probe_prefix));
        } else if (!names.insert(p_.name).second) {
            add("name",
                fmt::format("name = \"{}\" is that of another probe already: each needs its own", p_.name));
        }
    }

    void check_surface() {
        if (c_.channel.top != Top::free_surface) {
            add("kind",
                fmt::format("{}: the water of this case has no free surface ([channel] top = \"{}\"); "
                            "choose another kind",
                            kind(), word(c_.channel.top)));
        }
    }

    void check_positions() {
        if (p_.x.empty()) {
            add("x", fmt::format("x is missing: {} needs at least one position, for example x = \"{}\"",
                                 kind(), shown_length(0.5 * c_.channel.length)));
        }
        for (const double x : p_.x) {
            if (x < 0.0 || x > c_.channel.length) {
                add("x", fmt::format("x = {} is outside of the channel: expected 0 to its length {}",
                                     shown_length(x), shown_length(c_.channel.length)));
            }
        }
        check_across();
    }

    /// Positions across a three-dimensional channel.
    void check_across() {
        if (!p_.y.empty() && c_.channel.dimensions == 2) {
            add("y", "y: positions across the channel go with [channel] dimensions = 3; remove the key");
            return;
        }
        const bool has_heights = p_.kind == ProbeKind::velocity || p_.kind == ProbeKind::pressure;
        const std::size_t points = std::max(p_.x.size(), has_heights ? p_.z.size() : 1);
        if (p_.y.size() > 1 && p_.y.size() != points) {
            add("y", fmt::format("y has {} positions: expected one, or {} as there are points", p_.y.size(),
                                 points));
        }
        for (const double y : p_.y) {
            if (y < 0.0 || y > c_.channel.simulated_width()) {
                add("y", fmt::format("y = {} is outside of the simulated channel: expected 0 to {}",
                                     shown_length(y), shown_length(c_.channel.simulated_width())));
            }
        }
    }

    /// Greatest height that an instrument may have: waves may rise above the depth, and a gauge may sit high
    /// on a wall.
    [[nodiscard]] double highest() const {
        if (c_.channel.top != Top::free_surface) {
            return c_.total_depth();
        }
        const double waves = 1.5 * c_.total_depth();
        return p_.kind == ProbeKind::pressure ? std::max(waves, c_.channel.wall_height.value_or(0.0)) : waves;
    }

    void check_heights() {
        if (p_.z.empty()) {
            add("z",
                fmt::format("z is missing: {} needs at least one height above the bed level, for example z = "
                            "\"{}\"",
                            kind(), shown_length(0.5 * c_.total_depth())));
        }
        for (const double z : p_.z) {
            const bool gauge = p_.kind == ProbeKind::pressure;  // which may sit on the bed
            if (z < 0.0 || (z == 0.0 && !gauge) || z > highest()) {
                add("z", fmt::format(
                             "z = {} is outside of the water: expected {} (the bed level) and at most {}",
                             shown_length(z), gauge ? "at least 0" : "more than 0", shown_length(highest())));
            }
        }
        if (p_.x.size() > 1 && p_.z.size() > 1 && p_.x.size() != p_.z.size()) {
            add("z",
                fmt::format("{} values of x and {} of z: expected one of either, or as many of both, which "
                            "are then taken as pairs",
                            p_.x.size(), p_.z.size()));
        }
        if (p_.sampling_length > c_.total_depth()) {
            add("sampling_length",
                fmt::format("sampling_length is {}: expected at most the total depth {}",
                            shown_length(p_.sampling_length), shown_length(c_.total_depth())));
        }
    }

    void check_spacing() {
        const double finest = 0.5 * c_.numerics.spacing;
        if (p_.spacing && *p_.spacing < finest) {
            add("spacing",
                fmt::format("spacing is {}, too fine: the particles are {} apart and carry nothing "
                            "finer; make it {} or more",
                            shown_length(*p_.spacing), shown_length(c_.numerics.spacing),
                            shown_length(finest)));
        }
        if (p_.spacing && *p_.spacing > c_.channel.length) {
            add("spacing", fmt::format("spacing is {}: expected at most the length of the channel, {}",
                                       shown_length(*p_.spacing), shown_length(c_.channel.length)));
        }
    }

    void check_edge(const char* key, const std::optional<double>& value, double highest_value) {
        if (value && (*value < 0.0 || *value > highest_value)) {
            add(key, fmt::format("{} = {} is outside of the water: expected 0 to {}", key,
                                 shown_length(*value), shown_length(highest_value)));
        }
    }

    void check_grid() {
        check_spacing();
        check_edge("x_from", p_.x_from, c_.channel.length);
        check_edge("x_to", p_.x_to, c_.channel.length);
        check_edge("z_from", p_.z_from, highest());
        check_edge("z_to", p_.z_to, highest());
        const double step = p_.spacing.value_or(2.0 * c_.numerics.spacing);
        const double width = p_.x_to.value_or(c_.channel.length) - p_.x_from.value_or(0.0);
        const double height = p_.z_to.value_or(c_.total_depth()) - p_.z_from.value_or(0.5 * step);
        if (width < 0.0) {
            add("x_to", "x_to lies before x_from: exchange them");
        }
        if (height < 0.0) {
            add("z_to", "z_to lies below z_from: exchange them");
        }
        const double points = (width / step + 1.0) * (height / step + 1.0);
        if (points > most_points) {
            add("spacing",
                fmt::format("the grid has {:.3g} points, too fine: expected at most {:.0g}; make its "
                            "spacing larger",
                            points, most_points));
        }
        if (p_.averaging_time > 0.0) {
            check_windows();
        }
    }

    void check_windows() {
        const double interval = 1.0 / p_.sampling_frequency;
        if (p_.averaging_time < 2.0 * interval * (1.0 - 1e-9)) {
            add("averaging_time",
                fmt::format("averaging_time is {:.6g} s, less than two samples at {:.6g} Hz: make it longer",
                            p_.averaging_time, p_.sampling_frequency));
        }
        if (p_.start + p_.averaging_time > c_.run.time * (1.0 + 1e-9)) {
            add("averaging_time",
                fmt::format("averaging_time is {:.6g} s: no window would end before the run does, at "
                            "{:.6g} s; make it shorter",
                            p_.averaging_time, c_.run.time));
        }
    }

    /// The kernel of a section must lie in the water.
    void check_sections() {
        if (c_.channel.ends != Ends::walls) {
            return;
        }
        const double support = 2.0 * c_.numerics.smoothing_ratio * c_.numerics.spacing;
        for (const double x : p_.x) {
            if (x < support || x > c_.channel.length - support) {
                add("x",
                    fmt::format("x = {} is too near to an end wall for a flow rate: expected at least 2 h = "
                                "{} from it",
                                shown_length(x), shown_length(support)));
            }
        }
    }

    const Case& c_;
    const Probe& p_;
    std::size_t item_;
    const Places& places_;
    Problems& problems_;
};

}  // namespace

void validate_probes(const Case& c, const Places& places, Problems& problems) {
    std::set<std::string> names;
    for (std::size_t item = 0; item < c.probes.size(); ++item) {
        ProbeValidation(c, item, places, problems).run(names);
    }
}

}  // namespace riffle
