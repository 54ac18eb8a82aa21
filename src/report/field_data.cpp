#include "report/field_data.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <utility>

#include "analysis/bodies.hpp"
#include "analysis/run_snapshots.hpp"
#include "case/bed_traits.hpp"
#include "case/end_buffers.hpp"
#include "case/flow_kind.hpp"
#include "case/patch_range.hpp"
#include "case/porous_zone.hpp"
#include "case/refusals.hpp"
#include "case/stem_feet.hpp"
#include "particles/lattice.hpp"
#include "record/flow_fields.hpp"
#include "record/particle_fields.hpp"
#include "report/solid_cuts.hpp"
#include "roughness/sphere_lattice.hpp"

namespace riffle::inline report {

namespace {

constexpr std::size_t most_particles = 20'000;  ///< of a frame
constexpr std::size_t most_in_all = 150'000;    ///< of all frames together
constexpr std::size_t most_frames = 40;

/// The members of a frame that have a value for each particle.
constexpr std::array particle_values = {&FieldFrame::x,        &FieldFrame::z,
                                        &FieldFrame::velocity, &FieldFrame::vertical_velocity,
                                        &FieldFrame::pressure, &FieldFrame::eddy_viscosity};

/// Keep the particles that `keeps` says by their number.
template <class Keeps>
void keep_particles(FieldFrame& frame, const Keeps& keeps) {
    const std::size_t n = frame.x.size();
    std::vector<std::size_t> kept;
    for (std::size_t i = 0; i < n; ++i) {
        if (keeps(i)) kept.push_back(i);
    }
    for (std::vector<double> FieldFrame::*const member : particle_values) {
        std::vector<double>& values = frame.*member;
        if (values.size() != n) continue;
        for (std::size_t i = 0; i < kept.size(); ++i) values[i] = values[kept[i]];
        values.resize(kept.size());
    }
}

/// A slice of a three-dimensional run along the channel, m.
struct Slice {
    double y;
    double thickness;
};

/// That of the particles which start next to the centreline: between two files of them a slice would have
/// none or both.
Slice slice_of(const Case& c) {
    const Lattice lattice = lattice_of(c);
    const double file = std::min(std::floor(c.channel.centreline() / lattice.dy), lattice.files - 1.0);
    return {(file + 0.5) * lattice.dy, lattice.dy};
}

FieldFrame read_frame(const RunResults& results, const std::string& group, const Case& c) {
    const auto& of = fields::snapshot;
    const auto values = [&](const Field& field) { return results.values({group, field}); };
    FieldFrame frame;
    frame.time = results.number({group, of.time}).value_or(0.0);
    auto position = components(values(of.position));
    frame.x = std::move(position[0]);
    frame.z = std::move(position[2]);
    auto velocity = components(values(of.velocity));
    frame.velocity = std::move(velocity[0]);
    frame.vertical_velocity = std::move(velocity[2]);
    frame.pressure = values(of.pressure);
    frame.eddy_viscosity = values(of.eddy_viscosity);
    if (c.channel.dimensions == 3) {
        const std::vector<double>& y = position[1];
        const Slice slice = slice_of(c);
        keep_particles(frame,
                       [&](std::size_t i) { return std::abs(y[i] - slice.y) <= 0.5 * slice.thickness; });
    }
    return frame;
}

/// The free surface at the recorded time nearest to each frame's, if one lies within half a record interval
/// (records every 0.01 s by default; snapshots fall between them).
void add_surfaces(const RunResults& results, FieldPicture& picture) {
    const auto& of = fields::surface;
    if (!results.has(of.elevation)) return;
    const std::vector<double> x = results.values(of.x);
    const std::vector<double> time = results.values(of.time);
    if (time.empty() || x.empty()) return;
    const double interval = time.size() > 1 ? time[1] - time[0] : 0.0;
    for (FieldFrame& frame : picture.frames) {
        const auto distance = [&](double t) { return std::abs(t - frame.time); };
        const auto nearest = std::min_element(time.begin(), time.end(),
                                              [&](double a, double b) { return distance(a) < distance(b); });
        if (distance(*nearest) > 0.51 * interval + 1e-9) continue;
        frame.surface_x = x;
        frame.surface_z = results.rows(of.elevation, static_cast<std::size_t>(nearest - time.begin()), 1);
    }
}

/// Keep the particles with x below the value under which `most_particles` of the fullest frame lie.
void shorten(FieldPicture& picture) {
    for (const FieldFrame& frame : picture.frames) {
        if (frame.x.size() <= most_particles) continue;
        std::vector<double> sorted = frame.x;
        std::nth_element(sorted.begin(), sorted.begin() + static_cast<std::ptrdiff_t>(most_particles),
                         sorted.end());
        picture.x_end = std::min(picture.x_end, sorted[most_particles]);
        picture.left_out = true;
    }
    if (!picture.left_out) return;
    for (FieldFrame& frame : picture.frames) {
        const std::vector<double> x = frame.x;
        keep_particles(frame, [&](std::size_t i) { return x[i] < picture.x_end; });
        std::size_t kept = 0;
        for (std::size_t i = 0; i < frame.surface_x.size(); ++i) {
            if (frame.surface_x[i] >= picture.x_end) continue;
            frame.surface_x[kept] = frame.surface_x[i];
            frame.surface_z[kept++] = frame.surface_z[i];
        }
        frame.surface_x.resize(kept);
        frame.surface_z.resize(kept);
    }
}

/// The snapshots to show: evenly spread, the first and the last among them.
std::vector<std::string> chosen_snapshots(const RunResults& results, const Case& c, FieldFrames which) {
    std::vector<std::string> names;
    for (const std::string& name : results.children(snapshots_group)) {
        const std::string group = std::string(snapshots_group) + "/" + name;
        if (results.has({group, fields::snapshot.position})) names.push_back(group);
    }
    if (names.empty()) return names;
    if (which == FieldFrames::last) return {names.back()};
    const std::size_t particles =
        std::clamp<std::size_t>(read_frame(results, names.back(), c).x.size(), 1, most_particles);
    const std::size_t frames = std::clamp<std::size_t>(most_in_all / particles, 1, most_frames);
    if (names.size() <= frames) return names;
    std::vector<std::string> chosen;
    for (std::size_t i = 0; i + 1 < frames; ++i) {
        chosen.push_back(names[i * (names.size() - 1) / (frames - 1)]);
    }
    chosen.push_back(names.back());
    return chosen;
}

/// The spheres of the bed that the plane at y cuts.
std::vector<Circle> sphere_cuts(const Case& c, double y) {
    std::vector<Circle> circles;
    if (!has_spheres(c.bed)) return circles;
    const double radius = 0.5 * c.bed.sphere_diameter;
    for (const auto& centre : SphereLattice(c).centres(c.channel.length, c.channel.simulated_width())) {
        const double beside = std::abs(centre[1] - y);
        if (beside < radius) {
            circles.push_back({centre[0], centre[2], std::sqrt(radius * radius - beside * beside)});
        }
    }
    return circles;
}

/// Outlines of the solids in a snapshot: those that it holds, for free bodies go where no law says.
std::vector<Outline> outlines_in(const RunResults& results, const std::string& group, const Case& c,
                                 double time) {
    std::vector<Outline> outlines = outlines_at(c, time);
    const std::vector<double> vertices = results.values({group, fields::snapshot.solid_vertices});
    std::size_t corners = 0;
    for (const Outline& outline : outlines) corners += outline.size();
    if (vertices.size() != 3 * corners) return outlines;
    auto place = vertices.begin();
    for (Outline& outline : outlines) {
        for (std::size_t i = 0; i < outline.size(); ++i, place += 3) {
            outline.x[i] = *place;
            outline.z[i] = *(place + 2);
        }
    }
    return outlines;
}

}  // namespace

std::vector<FieldZone> field_zones(const Case& c, double y, double top) {
    std::vector<FieldZone> zones;
    const auto box = [](const PatchRange& along, double height) {
        return height > 0.0
                   ? Outline{{along.from, along.to, along.to, along.from}, {0.0, 0.0, height, height}}
                   : Outline{{along.from, along.to}, {0.0, 0.0}};
    };
    // As far as the picture reaches.
    const auto canopy = [&](const Vegetation& patch, const PatchRange& along) {
        Outline outline =
            canopy_outline(patch, along.from, along.to, [&](double x) { return stem_foot(c, patch, x, y); });
        for (double& z : outline.z) z = std::min(z, top);
        return outline;
    };
    for (const Vegetation& patch : c.vegetation) {
        for (const PatchRange& along : stretches_of(c, patch, 0, y)) {
            zones.push_back({"vegetation", patch.name, canopy(patch, along)});
        }
    }
    for (const Porous& zone : c.porous) {
        for (Outline& cut : porous_cuts_along(c, zone, y, top)) {
            zones.push_back({"porous", zone.name, std::move(cut)});
        }
    }
    for (const BedPatch& patch : c.bed_patches) {
        for (const PatchRange& along : stretches_of(c, patch, 0, y)) {
            zones.push_back({"bed", patch.name, box(along, patch.roughness_height.value_or(0.0))});
        }
    }
    return zones;
}

double falling_height(const Case& c) { return bed_ends(c) ? end_support(c) : 0.0; }

std::optional<FieldPicture> read_field(const RunResults& results, const Case& c, FieldFrames frames) {
    if (frames == FieldFrames::none) return std::nullopt;
    const bool space = c.channel.dimensions == 3;
    FieldPicture picture;
    if (space) picture.y = slice_of(c).y;
    for (const std::string& group : chosen_snapshots(results, c, frames)) {
        FieldFrame frame = read_frame(results, group, c);
        if (frame.x.empty()) continue;
        frame.bodies =
            space ? solid_cuts(results, group, *picture.y) : outlines_in(results, group, c, frame.time);
        picture.frames.push_back(std::move(frame));
    }
    if (picture.frames.empty()) return std::nullopt;
    picture.x_end = c.channel.length + 2.0 * falling_height(c);
    add_surfaces(results, picture);
    shorten(picture);
    if (space) picture.spheres = sphere_cuts(c, *picture.y);
    for (const FieldFrame& frame : picture.frames) {
        for (const double z : frame.z) picture.top = std::max(picture.top, z + 0.5 * c.numerics.spacing);
        // A gate or a pier that stands high out of the water need not be seen whole.
        for (const Outline& body : frame.bodies) {
            for (const double z : body.z) {
                picture.top = std::max(picture.top, std::min(z, 1.5 * c.total_depth()));
            }
        }
    }
    picture.zones = field_zones(c, picture.y.value_or(0.0), picture.top);
    return picture;
}

}  // namespace riffle::inline report
