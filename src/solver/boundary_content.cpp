#include "solver/boundary_content.hpp"

#include <array>
#include <map>
#include <numeric>
#include <utility>

#include "boundary/wall.hpp"
#include "case/solid_mesh.hpp"
#include "roughness/sphere_lattice.hpp"
#include "solver/content.hpp"

namespace riffle {

namespace {

template <int D>
void add_walls(const Case& c, std::vector<float>& points, std::vector<std::int32_t>& bodies) {
    const WallParticles<D> walls = wall_particles<D>(c);
    for (std::size_t i = 0; i < walls.size(); ++i) {
        points.push_back(static_cast<float>(walls.position[0][i]));
        points.push_back(D == 3 ? static_cast<float>(walls.position[1][i]) : 0.0F);
        points.push_back(static_cast<float>(walls.position[D - 1][i]));
        bodies.push_back(walls.body.empty() ? resting_body : walls.body[i]);
    }
}

template <class T>
Dataset rows_of_three(std::string path, std::vector<T> values, std::string unit, std::string long_name) {
    const std::size_t rows = values.size() / 3;
    return {.path = std::move(path),
            .shape = {rows, 3},
            .values = std::move(values),
            .unit = std::move(unit),
            .long_name = std::move(long_name)};
}

Dataset column_of(std::string path, std::vector<std::int32_t> values, std::string long_name) {
    const std::size_t rows = values.size();
    return {.path = std::move(path),
            .shape = {rows},
            .values = std::move(values),
            .unit = "1",
            .long_name = std::move(long_name)};
}

/// The numbers of so many rows, which the index draws as points.
Dataset numbered(std::string path, std::size_t rows) {
    std::vector<std::int32_t> values(rows);
    std::iota(values.begin(), values.end(), 0);
    return column_of(std::move(path), std::move(values), "rows of the points, for the index");
}

}  // namespace

BoundaryContent::BoundaryContent(const Case& c) : motion_(c) {
    const bool space = c.channel.dimensions == 3;
    if (space) {
        add_walls<3>(c, wall_, wall_body_);
    } else {
        add_walls<2>(c, wall_, wall_body_);
    }
    for (std::size_t k = 0; k < c.solids.size(); ++k) {
        const Solid& solid = c.solids[k];
        names_ += (k > 0 ? "\n" : "") + solid.name;
        for (std::size_t i = 0; !space && i < solid.x.size(); ++i) {
            vertex_.insert(vertex_.end(),
                           {static_cast<float>(solid.x[i]), 0.0F, static_cast<float>(solid.z[i])});
            vertex_body_.push_back(first_solid + static_cast<std::int32_t>(k));
        }
        corners_.push_back(solid.x.size());
    }
    if (!space) return;
    const auto meshes = meshes_of(c);
    for (std::size_t k = 0; k < meshes->size(); ++k) {
        // The corners that triangles share are written once.
        std::map<Point3, std::int32_t> numbers;
        for (const auto& triangle : (*meshes)[k].tree().triangles()) {
            for (const Point3& corner : triangle) {
                const auto [place, fresh] =
                    numbers.try_emplace(corner, static_cast<std::int32_t>(vertex_body_.size()));
                if (fresh) {
                    for (const double x : corner) vertex_.push_back(static_cast<float>(x));
                    vertex_body_.push_back(first_solid + static_cast<std::int32_t>(k));
                }
                triangle_.push_back(place->second);
            }
        }
    }
    if (c.bed.kind == BedKind::spheres) {
        sphere_diameter_ = c.bed.sphere_diameter;
        for (const auto& centre : SphereLattice(c).centres(c.channel.length, c.channel.simulated_width())) {
            for (const double x : centre) sphere_.push_back(static_cast<float>(x));
        }
    }
}

void BoundaryContent::add(Content& content) const {
    if (!wall_.empty()) {
        content.datasets.push_back(rows_of_three("/boundaries/walls/position", wall_, "m",
                                                 "position (x, y, z) of the wall particles at t = 0"));
        content.datasets.push_back(
            column_of("/boundaries/walls/body", wall_body_,
                      "0: walls at rest, 1: the lid, 2 and on: the solids of the case"));
        content.datasets.push_back(numbered("/boundaries/walls/point", walls()));
    }
    if (!vertex_.empty()) {
        content.datasets.push_back(rows_of_three("/boundaries/solids/vertices", vertex_, "m",
                                                 "corners (x, y, z) of the surfaces of the solids at t = 0"));
        content.datasets.push_back(
            column_of("/boundaries/solids/body", vertex_body_,
                      "solid that a corner belongs to: 2 is the first one of the case"));
        add_attribute(content, "/boundaries/solids", "names", names_);
    }
    if (!triangle_.empty()) {
        content.datasets.push_back(rows_of_three("/boundaries/solids/triangles", triangle_, "1",
                                                 "triangles of the surfaces: rows of `vertices`"));
    }
    if (!sphere_.empty()) {
        content.datasets.push_back(rows_of_three("/boundaries/spheres/centre", sphere_, "m",
                                                 "centres (x, y, z) of the spheres of the bed"));
        content.datasets.push_back(numbered("/boundaries/spheres/point", spheres()));
        add_attribute(content, "/boundaries/spheres", "diameter", sphere_diameter_);
    }
}

std::vector<float> BoundaryContent::displaced(const std::vector<float>& points,
                                              const std::vector<std::int32_t>& bodies, double time) const {
    const std::vector<BodyState> states = motion_.at(time);
    std::vector<float> moved = points;
    for (std::size_t i = 0; i < bodies.size(); ++i) {
        const Vec<2>& shift = states[static_cast<std::size_t>(bodies[i])].displacement;
        moved[3 * i] += static_cast<float>(shift[0]);
        moved[3 * i + 2] += static_cast<float>(shift[1]);
    }
    return moved;
}

std::size_t BoundaryContent::add_moved(Content& content, const std::string& snapshot, double time) const {
    if (!motion_.displaces()) return 0;
    content.datasets.push_back(rows_of_three(snapshot + "/wall_position", displaced(wall_, wall_body_, time),
                                             "m", "position (x, y, z) of the wall particles"));
    content.datasets.push_back(rows_of_three(snapshot + "/solid_vertices",
                                             displaced(vertex_, vertex_body_, time), "m",
                                             "corners (x, y, z) of the surfaces of the solids"));
    return sizeof(float) * (wall_.size() + vertex_.size());
}

}  // namespace riffle
