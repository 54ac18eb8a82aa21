#include "case/solid_validation.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "case/mesh_validation.hpp"
#include "case/outline.hpp"
#include "case/solid_motion.hpp"
#include "case/units.hpp"
#include "case/words.hpp"

namespace riffle {

namespace {

constexpr std::size_t fewest_corners = 3;
constexpr std::size_t most_corners = 20000;  ///< of all outlines

std::string corner_text(const Outline& outline, std::size_t i) {
    return fmt::format("({}, {})", shown_length(outline.x[i]), shown_length(outline.z[i]));
}

/// What is wrong with an outline by itself, or nothing.
std::string outline_fault(const Outline& outline) {
    if (outline.x.size() != outline.z.size()) {
        return fmt::format("{} values of x and {} of z: a corner needs one of each", outline.x.size(),
                           outline.z.size());
    }
    if (outline.size() < fewest_corners) {
        return fmt::format("{} corners: an outline needs at least 3", outline.size());
    }
    if (const auto edges = crossing_edges(outline)) {
        const auto [i, j] = *edges;
        if (i == j) {
            return fmt::format("the corner {} is given twice in a row: remove one", corner_text(outline, i));
        }
        return fmt::format(
            "the outline crosses or touches itself: its edge from {} to {} meets the one from {} to {}; give "
            "the corners in the order in which one walks around",
            corner_text(outline, i), corner_text(outline, outline.next(i)), corner_text(outline, j),
            corner_text(outline, outline.next(j)));
    }
    return "";
}

class SolidValidation {
  public:
    SolidValidation(const Case& c, const Places& places, Problems& problems)
        : c_(c), places_(places), problems_(problems) {}

    void run() {
        check_wall_height();
        check_lid();
        std::size_t corners = c_.start.water_x.size();
        for (const Solid& solid : c_.solids) {
            corners += solid.x.size();
        }
        if (corners > most_corners) {
            add({"solid[0]", "start.water_x"},
                fmt::format(
                    "the outlines have {} corners in all: expected at most {}; leave out what is finer "
                    "than the particle spacing",
                    corners, most_corners));
            return;  // each edge is compared with each other one below
        }
        const bool water = !c_.start.water_x.empty() || !c_.start.water_z.empty();
        if (water) {
            check_water();
        }
        bool sound = true;
        for (std::size_t k = 0; k < c_.solids.size(); ++k) {
            check_solid(k);
            const Outline outline{c_.solids[k].x, c_.solids[k].z};
            sound = sound && c_.channel.dimensions == 2 && outline_fault(outline).empty();
        }
        if (sound) {
            check_overlaps();
        }
    }

  private:
    void add(const std::vector<std::string>& keys, std::string message) {
        problems_.add(places_.of_first(keys), std::move(message));
    }

    void check_wall_height() {
        if (!c_.channel.wall_height) {
            return;
        }
        if (c_.channel.top != Top::free_surface) {
            add({"channel.wall_height", "channel.top"},
                fmt::format("[channel] wall_height: with top = \"{}\" the end walls reach up to it; remove "
                            "the key",
                            word(c_.channel.top)));
        } else if (*c_.channel.wall_height < c_.total_depth() && c_.start.water_x.empty()) {
            add({"channel.wall_height", "channel.depth"},
                fmt::format("[channel] wall_height is {}, lower than the water, {}: make it higher",
                            shown_length(*c_.channel.wall_height), shown_length(c_.total_depth())));
        }
    }

    void check_lid() {
        if (c_.channel.lid_velocity == 0.0) {
            return;
        }
        if (c_.channel.top != Top::wall) {
            add({"channel.lid_velocity", "channel.top"},
                fmt::format("[channel] lid_velocity: the lid is the wall at the top, and the top is "
                            "\"{}\"; set top = \"wall\" or remove the key",
                            word(c_.channel.top)));
            return;
        }
        if (c_.bed.kind != BedKind::no_slip) {
            add({"channel.lid_velocity", "bed.kind"},
                "[channel] lid_velocity: a lid without friction does not move the water, and the bed's kind "
                "is that of all walls; set [bed] kind = \"no-slip\"");
        }
        check_dummy("channel.lid_velocity", "[channel] lid_velocity");
        check_plane("channel.lid_velocity", "[channel] lid_velocity");
    }

    void check_dummy(const std::string& key, const std::string& what) {
        if (c_.numerics.wall != WallKind::dummy) {
            add({key, "numerics.wall"},
                fmt::format("{} goes with [numerics] wall = \"dummy\": dynamic particles stand still in "
                            "layers along the bed",
                            what));
        }
    }

    void check_plane(const std::string& key, const std::string& what) {
        if (c_.channel.dimensions != 2) {
            add({key, "channel.dimensions"}, fmt::format("{} goes with [channel] dimensions = 2", what));
        }
    }

    void check_water() {
        const Outline water{c_.start.water_x, c_.start.water_z};
        const std::string key = c_.start.water_x.empty() ? "start.water_z" : "start.water_x";
        const std::string fault = outline_fault(water);
        if (!fault.empty()) {
            add({key, "start.water_z"}, fmt::format("[start] water_x, water_z: {}", fault));
            return;
        }
        if (c_.channel.top != Top::free_surface) {
            add({key, "channel.top"},
                fmt::format("[start] water_x, water_z: with [channel] top = \"{}\" the water fills all up to "
                            "the top; remove them, or set top = \"free-surface\"",
                            word(c_.channel.top)));
        }
        const auto [left, right] = std::minmax_element(water.x.begin(), water.x.end());
        const auto [low, high] = std::minmax_element(water.z.begin(), water.z.end());
        if (*left < 0.0 || *right > c_.channel.length || *low < 0.0) {
            add({key},
                fmt::format("[start] water_x, water_z: the water lies outside of the channel: expected x "
                            "from 0 to its length {} and z from 0, the bed level",
                            shown_length(c_.channel.length)));
        }
        const double top = c_.channel.wall_height.value_or(1.5 * c_.total_depth());
        if (c_.channel.ends == Ends::walls && *high > top * (1 + 1e-9)) {
            add({"start.water_z", "channel.wall_height"},
                fmt::format("[start] water_z: the water stands {} high, and the end walls {}; give [channel] "
                            "wall_height",
                            shown_length(*high), shown_length(top)));
        }
        const double support = 2.0 * c_.numerics.smoothing_ratio * c_.numerics.spacing;
        if (*high - *low < support || *right - *left < support) {
            add({key, "numerics.spacing"},
                fmt::format("[start] water_x, water_z: the water is {} by {}, less than one kernel support "
                            "({}) of particles; make the spacing smaller",
                            shown_length(*right - *left), shown_length(*high - *low), shown_length(support)));
        }
        for (const Solid& solid : c_.solids) {
            check_water_against(water, solid, key);
        }
    }

    void check_water_against(const Outline& water, const Solid& solid, const std::string& key) {
        const Outline body{solid.x, solid.z};
        if (!outline_fault(body).empty()) {
            return;  // said of the solid
        }
        for (std::size_t i = 0; i < water.size(); ++i) {
            if (contains(body, water.x[i], water.z[i]) &&
                distance_from_outline(body, water.x[i], water.z[i]) > 0.5 * c_.numerics.spacing) {
                add({key}, fmt::format("[start] water_x, water_z: the corner {} of the water lies inside of "
                                       "the solid \"{}\"; move one of them",
                                       corner_text(water, i), solid.name));
            }
        }
    }

    void check_solid(std::size_t item) {
        const Solid& solid = c_.solids[item];
        const std::string place = fmt::format("solid[{}]", item);
        const auto say = [&](const char* key, const std::string& message) {
            add({place + "." + key, place},
                fmt::format("[[solid]]{}{}: {}", solid.name.empty() ? "" : " ", solid.name, message));
        };
        if (solid.name.empty()) {
            say("name", "name is empty: give one, for messages");
        }
        for (std::size_t other = 0; other < item; ++other) {
            if (c_.solids[other].name == solid.name) {
                say("name", "another solid has this name already: each needs its own");
            }
        }
        check_dummy(place, "[[solid]]");
        if (c_.channel.dimensions == 3) {
            validate_mesh(c_, item, say);
            return;
        }
        if (c_.channel.top == Top::periodic) {
            say("name", "goes with [channel] top = \"free-surface\" or \"wall\"");
        }
        if (solid.x.empty() || solid.z.empty()) {
            say("x",
                "x or z is missing: give the corners of its outline, for example x = [\"100 mm\", \"140 "
                "mm\", \"120 mm\"] and z = [\"0 mm\", \"0 mm\", \"20 mm\"]");
            return;
        }
        const Outline outline{solid.x, solid.z};
        const std::string fault = outline_fault(outline);
        if (!fault.empty()) {
            say("x", fault);
            return;
        }
        const auto [left, right] = std::minmax_element(outline.x.begin(), outline.x.end());
        const auto [low, high] = std::minmax_element(outline.z.begin(), outline.z.end());
        if (*right <= 0.0 || *left >= c_.channel.length || *high <= 0.0) {
            say("x", fmt::format("lies outside of the channel: expected a part of x from 0 to {} and z above "
                                 "0",
                                 shown_length(c_.channel.length)));
        }
        check_room(solid, *right - *left, say);
        check_thickness(outline, say);
        if (solid.motion != SolidMotion::fixed) {
            check_motion(solid, *left, *right, *low, say);
        }
    }

    /// Solids that move through each other press the water between them out of the world.
    void check_overlaps() {
        const auto overlap = first_overlap(c_);
        if (!overlap) {
            return;
        }
        const Solid& a = c_.solids[overlap->first];
        const Solid& b = c_.solids[overlap->second];
        const std::string place = fmt::format("solid[{}]", overlap->second);
        const std::string where =
            fmt::format("at x = {:.4g} m, z = {:.4g} m", overlap->place[0], overlap->place[1]);
        add({place + ".motion", place},
            overlap->time == 0.0
                ? fmt::format("[[solid]] {}: stands in the solid \"{}\" at the start, {}; move one of them",
                              b.name, a.name, where)
                : fmt::format(
                      "[[solid]] {}: meets the solid \"{}\" at t = {:.4g} s, {}, and would move through "
                      "it; let it stop before (stop), or give it another way",
                      b.name, a.name, overlap->time, where));
    }

    template <class Say>
    void check_room(const Solid& solid, double width, const Say& say) {
        const double support = 2.0 * c_.numerics.smoothing_ratio * c_.numerics.spacing;
        if (c_.channel.ends == Ends::periodic && width > c_.channel.length - support) {
            say("x", fmt::format("is {} long: in a periodic channel of {} its ends would meet; make it "
                                 "shorter or the channel longer",
                                 shown_length(width), shown_length(c_.channel.length)));
        }
        const auto in_solid = [&](double x, double z) { return contains({solid.x, solid.z}, x, z); };
        if (in_solid(0.5 * c_.channel.length, 0.5 * c_.total_depth()) &&
            in_solid(1e-3 * c_.channel.length, 1e-3 * c_.total_depth()) &&
            in_solid(0.999 * c_.channel.length, 0.999 * c_.total_depth()) && c_.start.water_x.empty()) {
            say("x", "fills the whole channel: no water is left");
        }
    }

    /// Water on one side must not reach water on the other, and the layers of wall particles need room.
    template <class Say>
    void check_thickness(const Outline& outline, const Say& say) {
        const double needed = c_.numerics.wall_layers * c_.numerics.spacing;
        for (std::size_t i = 0; i < outline.size(); ++i) {
            const double thickness = thickness_at(outline, i);
            if (thickness < needed * (1 - 1e-9)) {
                say("x", fmt::format("is {} thick behind the middle of its edge from {} to {}, thinner than "
                                     "{} layers of wall particles ({}); make it thicker or the spacing "
                                     "smaller",
                                     shown_length(thickness), corner_text(outline, i),
                                     corner_text(outline, outline.next(i)), c_.numerics.wall_layers,
                                     shown_length(needed)));
                return;
            }
        }
    }

    template <class Say>
    void check_motion(const Solid& solid, double left, double right, double low, const Say& say) {
        const bool constant = solid.motion == SolidMotion::constant;
        if (constant && solid.velocity_x == 0.0 && solid.velocity_z == 0.0) {
            say("motion", "moves at no velocity: give velocity_x or velocity_z, or motion = \"fixed\"");
        }
        if (!constant && ((solid.amplitude_x == 0.0 && solid.amplitude_z == 0.0) || solid.frequency <= 0.0)) {
            say("motion",
                "swings by nothing: give amplitude_x or amplitude_z and frequency, or motion = \"fixed\"");
        }
        if (solid.start >= c_.run.time) {
            say("start",
                fmt::format("starts to move at {:.6g} s, not before the end of the run at {:.6g} s; make it "
                            "smaller",
                            solid.start, c_.run.time));
        }
        if (solid.stop && *solid.stop <= solid.start) {
            say("stop",
                fmt::format("stops at {:.6g} s, not after its start at {:.6g} s; make it larger, or motion = "
                            "\"fixed\"",
                            *solid.stop, solid.start));
        }
        const double moving =
            std::max(0.0, std::min(solid.stop.value_or(c_.run.time), c_.run.time) - solid.start);
        const double swing_x = constant ? moving * std::abs(solid.velocity_x) : std::abs(solid.amplitude_x);
        const double swing_z = constant ? 0.0 : std::abs(solid.amplitude_z);
        const bool left_way = !constant || solid.velocity_x < 0.0;
        const bool right_way = !constant || solid.velocity_x > 0.0;
        const double slack = 1e-9 * c_.numerics.spacing;
        const bool closed = c_.channel.ends == Ends::walls;
        if (low - swing_z < -slack ||
            (closed && (left - (left_way ? swing_x : 0.0) < -slack ||
                        right + (right_way ? swing_x : 0.0) > c_.channel.length + slack))) {
            say("motion",
                fmt::format("moves through the bed or an end wall: expected room for it, x from 0 to "
                            "{} and z from 0",
                            shown_length(c_.channel.length)));
        }
        if (constant && solid.velocity_z < 0.0 && low + solid.velocity_z * moving < -slack) {
            say("velocity_z",
                "reaches the bed before the end of the run: make it slower, or let it stop before");
        }
    }

    const Case& c_;
    const Places& places_;
    Problems& problems_;
};

}  // namespace

void validate_solids(const Case& c, const Places& places, Problems& problems) {
    SolidValidation(c, places, problems).run();
}

}  // namespace riffle
