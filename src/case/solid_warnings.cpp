// What solids are warned of.

#include <algorithm>
#include <cmath>
#include <optional>
#include <vector>

#include "case/bed_surface.hpp"
#include "case/blockage.hpp"
#include "case/flow_kind.hpp"
#include "case/outline.hpp"
#include "case/outline_check.hpp"
#include "case/refusals.hpp"
#include "case/solid_mesh.hpp"
#include "case/solid_motion.hpp"
#include "case/solid_places.hpp"
#include "case/units.hpp"
#include "case/warnings.hpp"

namespace riffle::inline case_file {

namespace {

/// Just behind the surface of a solid, a spacing apart at most.
std::vector<Point3> places_behind_surface(const Case& c, const Solid& solid, double behind) {
    std::vector<Point3> places;
    const double apart = c.numerics.spacing;
    if (const SolidMesh* const mesh = in_space(c) ? mesh_of(c, solid) : nullptr) {
        for (const Triangle& t : mesh->tree().triangles()) {
            const Point3 normal = normal_of(t);
            const double length = std::sqrt(dot(normal, normal));
            const int parts = parts_of_edges(t, apart);
            for (int i = 0; i < parts && length > 0.0; ++i) {
                for (int j = 0; i + j < parts; ++j) {
                    const double u = (i + 1.0 / 3.0) / parts;
                    const double v = (j + 1.0 / 3.0) / parts;
                    Point3 place{};
                    for (std::size_t k = 0; k < 3; ++k) {
                        place[k] = t[0][k] + u * (t[1][k] - t[0][k]) + v * (t[2][k] - t[0][k]) -
                                   behind * normal[k] / length;
                    }
                    places.push_back(place);
                }
            }
        }
        return places;
    }
    const Outline outline{solid.x, solid.z};
    const double side = signed_area(outline) > 0.0 ? behind : -behind;
    for (std::size_t i = 0; i < outline.size(); ++i) {
        const double dx = outline.x[outline.next(i)] - outline.x[i];
        const double dz = outline.z[outline.next(i)] - outline.z[i];
        const double length = std::hypot(dx, dz);
        const int parts = std::max(1, static_cast<int>(std::ceil(length / apart)));
        for (int part = 0; part < parts && length > 0.0; ++part) {
            const double share = (part + 0.5) / parts;
            places.push_back({outline.x[i] + share * dx - side * dz / length, 0.0,
                              outline.z[i] + share * dz + side * dx / length});
        }
    }
    return places;
}

/// The solid at rest in which all of the surface of another stands, with others; nothing where water touches
/// it.
std::optional<std::size_t> solid_around(const Case& c, const SolidPlaces& solids, std::size_t own) {
    std::optional<std::size_t> around;
    for (const Point3& p : places_behind_surface(c, c.solids[own], 0.1 * c.numerics.spacing)) {
        if (!is_in_channel(c, p)) continue;
        around = solids.resting_at(p, own);
        if (!around) return std::nullopt;
    }
    return around;
}

Findings buried(const Case& c, const Solid& solid) {
    if (!solid.rests() || c.solids.size() < 2) {
        return {};
    }
    const SolidPlaces solids(c);
    const auto own = static_cast<std::size_t>(&solid - c.solids.data());
    const auto around = solid_around(c, solids, own);
    // Of two alike the second is told.
    const bool first_of_two = around && *around > own && solid_around(c, solids, *around) == own;
    return around && !first_of_two ? found_if(true, "stands in the solid \"{}\"", c.solids[*around].name)
                                   : Findings{};
}

/// A solid at rest above all water that is to come.
Findings out_of_reach(const Case& c, const Solid& solid) {
    const auto range = solid.rests() && has_free_surface(c) ? extent_of(c, solid, 2) : std::nullopt;
    return found_if(range && range->low >= highest_water(c),
                    "begins {} above the bed level, and the water is expected up to {}",
                    shown_length(range ? range->low : 0.0), shown_length(highest_water(c)));
}

/// Where a sphere of one layer stands in one of another, deeper than a tenth of the spacing.
std::optional<Point3> spheres_meet(const Case& c, const Solid& a, const Solid& b) {
    const double slack = 0.1 * c.numerics.spacing;
    const double most = 0.5 * (a.diameter + b.diameter) - slack;
    const std::vector<LaidSphere> first = laid_spheres(c, a);
    std::vector<LaidSphere> second = laid_spheres(c, b);
    std::sort(second.begin(), second.end(),
              [](const LaidSphere& one, const LaidSphere& other) { return one.centre < other.centre; });
    for (const LaidSphere& sphere : first) {
        const Point3& centre = sphere.centre;
        const auto begin =
            std::lower_bound(second.begin(), second.end(), centre[0] - most,
                             [](const LaidSphere& one, double x) { return one.centre[0] < x; });
        for (auto other = begin; other != second.end() && other->centre[0] < centre[0] + most; ++other) {
            const Point3 way = minus(other->centre, centre);
            const double least = 0.5 * (sphere.diameter + other->diameter) - slack;
            if (dot(way, way) < least * least) return centre;
        }
    }
    return std::nullopt;
}

/// With a layer before it in the file.
Findings spheres_in_spheres(const Case& c, const Solid& solid) {
    if (!in_space(c) || solid.shape != SolidShape::spheres) {
        return {};
    }
    for (const Solid* other = c.solids.data(); other != &solid; ++other) {
        const auto place =
            other->shape == SolidShape::spheres ? spheres_meet(c, *other, solid) : std::nullopt;
        if (place) {
            return found_if(true, "spheres of \"{}\" stand in them, one of them at x = {}, y = {}",
                            other->name, shown_length((*place)[0]), shown_length((*place)[1]));
        }
    }
    return {};
}

/// The solid at rest that takes the room of a probe's point. A pressure gauge may stand on a face, and a wave
/// gauge over what waves may wash over: all but what is as high as the end walls.
std::optional<std::size_t> solid_over(const Case& c, const SolidPlaces& solids, ProbeKind kind, Point3 p) {
    const double half = 0.5 * c.numerics.spacing;
    const double walls = c.channel.wall_height.value_or(wave_height(c));
    if (kind == ProbeKind::wave) p[2] = std::max(walls, c.total_depth()) - half;
    const auto solid = solids.resting_at(p);
    if (kind != ProbeKind::pressure || !solid) return solid;
    for (const double away : {-half, half}) {
        for (const std::size_t axis : {std::size_t{0}, std::size_t{1}, std::size_t{2}}) {
            if (axis == 1 && !in_space(c)) continue;
            Point3 beside = p;
            beside[axis] += away;
            // No water is there to see: the bed, or a side wall.
            const bool beyond_walls = in_space(c) && (beside[1] < 0.0 || beside[1] > c.channel.width);
            if (beside[2] < 0.0 || beyond_walls) continue;
            if (!solids.resting_at(beside)) return std::nullopt;
        }
    }
    return solid;
}

/// A probe of points of which one stands in a solid.
Findings in_solid(const Case& c, const Probe& probe) {
    const bool of_points = probe.kind == ProbeKind::velocity || probe.kind == ProbeKind::pressure ||
                           probe.kind == ProbeKind::wave;
    if (!of_points || c.solids.empty()) return {};
    const SolidPlaces solids(c);
    const auto at = [](const std::vector<double>& values, std::size_t i, double otherwise) {
        return values.empty() ? otherwise : values[std::min(i, values.size() - 1)];
    };
    const std::size_t points = std::max(probe.x.size(), probe.z.size());
    for (std::size_t i = 0; i < points; ++i) {
        const Point3 p{at(probe.x, i, 0.0), at(probe.y, i, c.channel.centreline()), at(probe.z, i, 0.0)};
        if (const auto solid = solid_over(c, solids, probe.kind, p)) {
            return found_if(true, R"(the point of "{}" at x = {}{} stands in the solid "{}")", probe.name,
                            shown_length(p[0]),
                            probe.kind == ProbeKind::wave ? "" : ", z = " + shown_length(p[2]),
                            c.solids[*solid].name);
        }
    }
    return {};
}

/// So many spacings a way must be wide for its discharge to be within a tenth.
constexpr int fewest_in_a_way = 10;

Findings narrow_way(const Case& c) {
    const auto narrows = narrowest_way(c, fewest_in_a_way);
    return found_if(narrows.has_value(), "the way past x = {} is {} spacings wide",
                    shown_length(narrows ? narrows->x : 0.0), narrows ? narrows->width : 0);
}

}  // namespace

CheckList solid_warnings() {
    return {{
        {{"solid.z", "solid.size", "numerics.spacing"},
         "a way beside, below or between solids that is less than ten spacings wide",
         "a jet behind an edge comes out about a spacing too high, and so much too large is its discharge (docs/open-ends.md, Under a gate)",
         "take a smaller spacing, or count with the error",
         narrow_way},
        {{"probe.x", "probe.z", "probe.name"},
         "a point of a velocity, pressure or wave probe in a solid",
         "no water comes there, and it records nothing, or what its neighbourhood has",
         "move it",
         in_solid},
        {{"turbulence.eddy_rate", "turbulence.closure", "solid.name"},
         "a weir in an open channel with a mixing length by the strain rate",
         "the water that is drawn together before a crest strains and hardly turns, and the eddy viscosity brakes it: a "
         "sharp-crested weir passes too much at its head (docs/open-ends.md, Weirs with a mixing length)",
         R"(choose closure = "none" over a bed that allows it, or eddy_rate = "rotation")",
         [](const Case& c, const Solid& solid) {
             const auto range = extent_of(c, solid, 2);
             const double spacing = c.numerics.spacing;
             const bool stands = range && range->low < spacing && range->high > 3.0 * spacing;
             return found_if(!in_space(c) && c.channel.ends == Ends::open && has_mixing_length(c) &&
                                 c.turbulence.eddy_rate == EddyRate::strain && solid.rests() &&
                                 !solid.part_of_bed && stands && range->high < highest_water(c) / 1.5,
                             "rises to {}", shown_length(range ? range->high : 0.0));
         }},
        {{"solid.motion", "channel.dimensions"},
         "a solid in three dimensions that moves faster than 1.5 sqrt(g H)",
         "such a jerk drives the water beside it, and adds energy to it (docs/theory.md, section 9, solids)",
         "verified up to sqrt(g H); let it move more slowly",
         [](const Case& c, const Solid& solid) {
             const double wave = std::sqrt(c.normal_gravity() * c.total_depth());
             return found_if(in_space(c) && largest_speed(c, solid) > 1.5 * wave,
                             "moves at {:.3g} m/s, and waves run at {:.3g} m/s", largest_speed(c, solid),
                             wave);
         }},
        {{"solid.name"},
         "a solid at rest that stands wholly in others",
         "no water touches it, and no force acts on it",
         "remove it, or correct its place",
         buried},
        {{"solid.z", "solid.place", "solid.centre"},
         "a solid at rest higher than half of the depth above the water",
         "no water comes there",
         "correct its place or its unit, or remove it",
         out_of_reach},
        {{"solid.level", "solid.diameter", "solid.name"},
         "layers of spheres that stand in each other",
         "grains do not: what two of them share counts once, and the bed has less room for water and other crests than one of such grains",
         "lift one of the layers (level)",
         spheres_in_spheres},
    }};
}

}  // namespace riffle::inline case_file
