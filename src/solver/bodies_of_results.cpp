#include "solver/bodies_of_results.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <optional>

#include "base/error.hpp"
#include "base/notice.hpp"
#include "boundary/round_body.hpp"
#include "boundary/wall_motion.hpp"
#include "case/outline.hpp"
#include "case/solid_mesh.hpp"
#include "case/solid_motion.hpp"
#include "record/particle_fields.hpp"
#include "solver/recycled_start.hpp"

namespace riffle::inline solver {

namespace {

/// A solid that moved by less of a spacing stands where it stood.
constexpr double moved_spacings = 0.05;

/// Whether two cases draw a solid alike, whatever its name. Files are compared by their name: each case knows
/// its own folder.
bool is_drawn_alike(const Solid& a, const Solid& b) {
    const auto shape = [](const Solid& s) {
        Solid drawn;
        drawn.shape = s.shape;
        drawn.x = s.x;
        drawn.z = s.z;
        drawn.file = s.file.filename();
        drawn.scale = s.scale;
        drawn.place = s.place;
        drawn.centre = s.centre;
        drawn.size = s.size;
        drawn.angle = s.angle;
        drawn.diameter = s.diameter;
        drawn.length = s.length;
        drawn.axis = s.axis;
        drawn.heights = s.heights.filename();
        drawn.unit = s.unit;
        drawn.height_unit = s.height_unit;
        drawn.origin = s.origin;
        drawn.blend = s.blend;
        drawn.largest_hole = s.largest_hole;
        drawn.y = s.y;
        drawn.levels = s.levels;
        drawn.bottom_width = s.bottom_width;
        drawn.bank_slope = s.bank_slope;
        drawn.bank_height = s.bank_height;
        drawn.floodplain_width = s.floodplain_width;
        drawn.packing = s.packing;
        drawn.level = s.level;
        drawn.seed = s.seed;
        return drawn;
    };
    return shape(a) == shape(b);
}

bool weighs_the_same(const Solid& a, const Solid& b) {
    return a.density == b.density && a.mass == b.mass && a.centre_of_mass == b.centre_of_mass &&
           a.inertia == b.inertia;
}

/// Places of a solid at t = 0 that tell whether it stands elsewhere: of a round one those on its axis, else
/// its corners.
std::vector<Point3> telling_places(const Case& c, const Solid& solid) {
    if (const auto round = round_body(solid)) {
        std::vector<Point3> ends;
        const double half = 0.5 * solid.length;
        for (const double along : {-half, half}) {
            Point3 end = round->centre;
            for (std::size_t k = 0; k < 3; ++k) end[k] += along * round->axis[k];
            ends.push_back(end);
        }
        return ends;
    }
    return corners_of(c, solid);
}

/// The states of the free bodies at the end of a run, in the order of its case.
std::vector<FreeBodyState> last_states(const Case& other, const ResultsReader& results,
                                       const std::string& file_name) {
    const auto count = static_cast<std::size_t>(std::count_if(
        other.solids.begin(), other.solids.end(), [](const Solid& solid) { return solid.is_free(); }));
    if (count == 0) return {};
    const std::string path = fields::state.free_bodies.path();
    const std::vector<double> numbers =
        results.has(path) ? results.read_doubles(path) : std::vector<double>();
    if (numbers.size() < FreeBodyState::count * count) {
        throw InputError(fmt::format(
            "[start] file = \"{}\" does not hold the places of its {} free bodies: the file has been altered; give "
            "one as `riffle run` wrote it",
            file_name, count));
    }
    return free_body_states(numbers, count);
}

/// "12 mm along x, 30 mm down, turned by 4 degrees".
std::string way_text(const BodyState& body) {
    std::string text;
    for (std::size_t k = 0; k < 3; ++k) {
        const double way = 1e3 * body.displacement[k];
        if (std::abs(way) < 1e-3) continue;
        text += fmt::format("{:.4g} mm along {}, ", way, "xyz"[k]);
    }
    text.resize(std::max<std::size_t>(text.size(), 2) - 2);
    const Rotation& r = body.rotation;
    const double turn = std::acos(std::clamp(0.5 * (r[0] + r[4] + r[8] - 1.0), -1.0, 1.0));
    if (body.turns && turn > 1e-4) {
        text += fmt::format("{}turned by {:.3g} degrees", text.empty() ? "" : ", ",
                            turn * 180.0 / std::numbers::pi);
    }
    return text;
}

/// Number of a solid among the free ones of its case.
std::size_t number_among_free(const Case& c, std::size_t solid) {
    return static_cast<std::size_t>(std::count_if(c.solids.begin(),
                                                  c.solids.begin() + static_cast<std::ptrdiff_t>(solid),
                                                  [](const Solid& s) { return s.is_free(); }));
}

}  // namespace

std::vector<FreeBodyState> bodies_from_results(const Case& c, const Case& other, const ResultsReader& results,
                                               const std::string& file_name) {
    const std::vector<FreeBodyState> last = last_states(other, results, file_name);
    const Field& clock = fields::clock.time;
    const auto end = results.attribute(clock.group->path, clock.name);
    // The solids as this case finds their files, moved as that run moved them.
    Case moved = other;
    std::vector<std::optional<std::size_t>> here(other.solids.size());
    for (std::size_t k = 0; k < other.solids.size(); ++k) {
        for (std::size_t i = 0; i < c.solids.size(); ++i) {
            if (!is_drawn_alike(c.solids[i], other.solids[k])) continue;
            here[k] = i;
            moved.solids[k].file = c.solids[i].file;
        }
    }
    // One that is not here any more may have had a file that is not here either.
    for (std::size_t k = 0; k < other.solids.size(); ++k) {
        if (here[k]) continue;
        if (!other.solids[k].rests()) {
            notice(fmt::format(
                "warning: the solid \"{}\" of {} moved there, and the case draws none like it: the water has a hole "
                "where it stood at the end",
                other.solids[k].name, file_name));
        }
        moved.solids[k].motion = SolidMotion::fixed;
    }
    std::vector<FreeBodyState> kept;
    for (std::size_t k = 0; k < other.solids.size(); ++k) {
        if (moved.solids[k].is_free()) kept.push_back(last[number_among_free(other, k)]);
    }
    const std::vector<BodyState> bodies = WallMotion(moved).at(end ? std::get<double>(*end) : 0.0, kept);
    std::vector<FreeBodyState> states;
    for (std::size_t k = 0; k < other.solids.size(); ++k) {
        if (!here[k] || other.solids[k].rests()) continue;
        const Solid& solid = c.solids[*here[k]];
        const BodyState& body = bodies[static_cast<std::size_t>(first_solid) + k];
        double way = 0.0;
        for (const Point3& from : telling_places(c, solid)) {
            const Point3 to = body.placed(from);
            way = std::max(way, std::hypot(to[0] - from[0], to[1] - from[1], to[2] - from[2]));
        }
        const bool goes_on = solid.is_free() && other.solids[k].is_free() &&
                             weighs_the_same(solid, other.solids[k]) && !is_recycled(c, other);
        if (goes_on) {
            if (states.empty()) states.resize(number_among_free(c, c.solids.size()));
            states[number_among_free(c, *here[k])] = last[number_among_free(other, k)];
        } else if (way > moved_spacings * c.numerics.spacing) {
            throw InputError(fmt::format(
                "[start] file = \"{}\": at the end of that run the solid \"{}\" stood elsewhere than the case draws "
                "it ({}), and its water does not fit: draw the solid where it stood then. A free body of the same "
                "shape and weight goes on by itself, in a run of the same spacing and length",
                file_name, solid.name, way_text(body)));
        }
    }
    return states;
}

template <int D>
void refuse_water_in_new_solids(const Case& c, const Case& other, const Particles<D>& water,
                                const std::string& file_name) {
    for (const Solid& solid : c.solids) {
        const bool known = std::any_of(other.solids.begin(), other.solids.end(),
                                       [&](const Solid& before) { return is_drawn_alike(solid, before); });
        if (known || !solid.rests()) continue;
        std::size_t inside = 0;
        if constexpr (D == 2) {
            const Outline outline{solid.x, solid.z};
            for (std::size_t i = 0; i < water.size(); ++i) {
                inside += contains(outline, water.position[0][i], water.position[1][i]) ? 1 : 0;
            }
        } else if (const SolidMesh* const mesh = mesh_of(c, solid)) {
            for (std::size_t i = 0; i < water.size(); ++i) {
                inside += mesh->contains({water.position[0][i], water.position[1][i], water.position[2][i]})
                              ? 1
                              : 0;
            }
        }
        if (inside == 0) continue;
        throw InputError(fmt::format(
            "[start] file = \"{}\": {} of its {} particles of water stand in the solid \"{}\", which that run did "
            "not have; draw the solid where no water stands, or begin anew around it (start.kind = \"rest\")",
            file_name, inside, water.size(), solid.name));
    }
}

template void refuse_water_in_new_solids(const Case&, const Case&, const Particles<2>&, const std::string&);
template void refuse_water_in_new_solids(const Case&, const Case&, const Particles<3>&, const std::string&);

}  // namespace riffle::inline solver
