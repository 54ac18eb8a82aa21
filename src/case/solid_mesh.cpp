#include "case/solid_mesh.hpp"

#include <cmath>
#include <utility>

#include "case/bed_heights.hpp"
#include "case/bed_surface.hpp"
#include "case/mesh_file.hpp"
#include "case/self_crossing.hpp"
#include "case/solid_shapes.hpp"
#include "case/winding.hpp"

namespace riffle::inline case_file {

namespace {

ClosedSurface placed_free_form(const Solid& solid) {
    ClosedSurface surface = closed_surface(read_mesh(solid.file), solid.file.string());
    for (Triangle& triangle : surface.triangles) {
        for (Point3& corner : triangle) {
            for (std::size_t k = 0; k < 3; ++k) {
                corner[k] = solid.scale * corner[k] + (solid.place.empty() ? 0.0 : solid.place[k]);
            }
        }
    }
    return surface;
}

ClosedSurface surface_of_solid(const Case& c, const Solid& solid, std::vector<std::string>* notes) {
    switch (solid.shape) {
        case SolidShape::free_form:
            return placed_free_form(solid);
        case SolidShape::bed: {
            const BedHeights bed = bed_heights(c, solid);
            if (notes != nullptr) notes->insert(notes->end(), bed.notes.begin(), bed.notes.end());
            return closed_surface(bed_triangles(c, bed), solid.heights.string());
        }
        case SolidShape::section:
        case SolidShape::trapezoid:
        case SolidShape::compound:
        case SolidShape::pipe:
            return closed_surface(section_triangles(c, solid), "the section");
        case SolidShape::spheres:
            return closed_surface(sphere_layer_triangles(c, solid, notes), "the spheres");
        case SolidShape::box:
        case SolidShape::sphere:
        case SolidShape::cylinder:
        case SolidShape::rectangle:
        case SolidShape::circle:
            break;
    }
    return closed_surface(shape_triangles(c, solid), "the shape");
}

}  // namespace

SolidMesh::SolidMesh(const Case& c, const Solid& solid, std::vector<std::string>* notes)
    : SolidMesh(surface_of_solid(c, solid, notes)) {}

SolidMesh::SolidMesh(ClosedSurface surface)
    : tree_(std::move(surface.triangles)), several_shells_(surface.shells > 1) {
    if (!several_shells_) return;
    const Point3 size = minus(upper(), lower());
    Triangles lines;
    for (const Seam& seam : seams_of(tree_, weld_tolerance * std::sqrt(dot(size, size)))) {
        lines.push_back({seam.from, seam.to, seam.to});
        seams_outward_.push_back(seam.outward);
    }
    seams_ = TriangleTree(std::move(lines));
}

const SolidMesh* mesh_of(const Case& c, const Solid& solid) {
    return c.meshes ? &(*c.meshes)[static_cast<std::size_t>(&solid - c.solids.data())] : nullptr;
}

std::shared_ptr<const std::vector<SolidMesh>> meshes_of(const Case& c) {
    if (c.meshes) return c.meshes;
    auto meshes = std::make_shared<std::vector<SolidMesh>>();
    for (const Solid& solid : c.solids) meshes->emplace_back(c, solid);
    return meshes;
}

bool walls_end_at_surface(const Case& c) { return c.start.packed.value_or(false); }

double SolidMesh::volume() const {
    double sum = 0.0;
    for (const Triangle& t : tree_.triangles()) sum += dot(t[0], cross(t[1], t[2])) / 6.0;
    return sum;
}

bool SolidMesh::contains(const Point3& p) const {
    for (std::size_t k = 0; k < 3; ++k) {
        if (p[k] < lower()[k] || p[k] > upper()[k]) return false;
    }
    return winding_number(tree_, p, [](std::size_t) { return true; }) != 0;
}

bool SolidMesh::is_exposed(const Point3& place, const Point3& outward) const {
    const Point3 size = minus(upper(), lower());
    const double length = std::sqrt(dot(outward, outward));
    // Farther than rounding and the shift of the line in winding_number().
    const double away = length > 0.0 ? 1e-7 * std::sqrt(dot(size, size)) / length : 0.0;
    return !contains(
        {place[0] + away * outward[0], place[1] + away * outward[1], place[2] + away * outward[2]});
}

std::optional<SolidMesh::Foot> SolidMesh::nearest(const Point3& p, double limit) const {
    return nearest(p, limit, [](const Point3&) { return true; });
}

std::optional<SolidMesh::Foot> SolidMesh::nearest(const Point3& p, double limit,
                                                  const std::function<bool(const Point3&)>& takes) const {
    const auto near = tree_.nearest(p, limit, [&](std::size_t i, const Point3& foot) {
        return takes(foot) && (!several_shells_ || is_exposed(foot, normal_of(tree_.triangles()[i])));
    });
    const auto seam =
        seams_.nearest(p, near ? std::sqrt(near->squared) : limit, [&](std::size_t i, const Point3& foot) {
            return takes(foot) && is_exposed(foot, seams_outward_[i]);
        });
    if (!near && !seam) return std::nullopt;
    const bool on_seam = seam && (!near || seam->squared < near->squared);
    const TriangleTree::Near& nearest = on_seam ? *seam : *near;
    Foot result{std::sqrt(nearest.squared), minus(nearest.foot, p)};
    if (nearest.squared == 0.0) {
        result.direction =
            on_seam ? seams_outward_[nearest.triangle] : normal_of(tree_.triangles()[nearest.triangle]);
    }
    const double length = std::sqrt(dot(result.direction, result.direction));
    for (double& component : result.direction) component /= length;
    return result;
}

}  // namespace riffle::inline case_file
