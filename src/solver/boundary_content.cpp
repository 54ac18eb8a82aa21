#include "solver/boundary_content.hpp"

#include <array>
#include <cmath>
#include <map>
#include <numeric>
#include <utility>

#include "boundary/wall.hpp"
#include "case/bed_traits.hpp"
#include "case/solid_mesh.hpp"
#include "record/field_content.hpp"
#include "record/particle_fields.hpp"
#include "roughness/sphere_lattice.hpp"

namespace riffle::inline solver {

namespace {

template <int D>
void add_walls(const Case& c, std::vector<float>& points, std::vector<std::int32_t>& bodies) {
    const WallParticles<D> walls = wall_particles<D>(c);
    for (std::size_t i = 0; i < walls.size(); ++i) {
        points.push_back(static_cast<float>(walls.position[0][i]));
        points.push_back(static_cast<float>(across_of<D>(walls.position, i)));
        points.push_back(static_cast<float>(walls.position[D - 1][i]));
        bodies.push_back(walls.body.empty() ? resting_body : walls.body[i]);
    }
}

// The words of these fields are the same in two and three dimensions.
template <class T>
Dataset rows_of_three(const Field& field, std::vector<T> values) {
    const std::size_t rows = values.size() / 3;
    return dataset_of(field, 3, {rows, 3}, std::move(values));
}

Dataset column_of(const Field& field, std::vector<std::int32_t> values) {
    const std::size_t rows = values.size();
    return dataset_of(field, 3, {rows}, std::move(values));
}

/// The numbers of so many rows, which the index draws as points.
Dataset numbered(const Field& field, std::size_t rows) {
    std::vector<std::int32_t> values(rows);
    std::iota(values.begin(), values.end(), 0);
    return column_of(field, std::move(values));
}

}  // namespace

BoundaryContent::BoundaryContent(const Case& c) : motion_(c) {
    const bool space = c.channel.dimensions == 3;
    period_ = c.channel.ends == Ends::periodic ? c.channel.length : 0.0;
    width_ = space && c.channel.sides == Sides::periodic ? c.channel.simulated_width() : 0.0;
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
    if (has_spheres(c.bed)) {
        sphere_diameter_ = c.bed.sphere_diameter;
        for (const auto& centre : SphereLattice(c).centres(c.channel.length, c.channel.simulated_width())) {
            for (const double x : centre) sphere_.push_back(static_cast<float>(x));
        }
    }
}

void BoundaryContent::add(Content& content) const {
    if (!wall_.empty()) {
        content.datasets.push_back(rows_of_three(fields::walls.position, wall_));
        content.datasets.push_back(column_of(fields::walls.body, wall_body_));
        content.datasets.push_back(numbered(fields::walls.point, walls()));
    }
    if (!vertex_.empty()) {
        content.datasets.push_back(rows_of_three(fields::solids.vertices, vertex_));
        content.datasets.push_back(column_of(fields::solids.body, vertex_body_));
        add_field(content, fields::solids.names, names_);
    }
    if (!triangle_.empty()) content.datasets.push_back(rows_of_three(fields::solids.triangles, triangle_));
    if (!sphere_.empty()) {
        content.datasets.push_back(rows_of_three(fields::spheres.centre, sphere_));
        content.datasets.push_back(numbered(fields::spheres.point, spheres()));
        add_field(content, fields::spheres.diameter, sphere_diameter_);
    }
}

std::vector<float> BoundaryContent::displaced(const std::vector<float>& points,
                                              const std::vector<std::int32_t>& bodies,
                                              const std::vector<BodyState>& states) const {
    std::vector<float> moved = points;
    for (std::size_t i = 0; i < bodies.size(); ++i) {
        const BodyState& body = states[static_cast<std::size_t>(bodies[i])];
        if (body.turns) {
            Vec<3> start{points[3 * i], points[3 * i + 1], points[3 * i + 2]};
            start[0] = image_near(body.centre[0], start[0], period_);
            start[1] = image_near(body.centre[1], start[1], width_);
            const Vec<3> now = body.placed(start);
            for (std::size_t k = 0; k < 3; ++k) moved[3 * i + k] = static_cast<float>(now[k]);
            continue;
        }
        const Vec<3>& shift = body.displacement;
        for (std::size_t k = 0; k < 3; ++k) moved[3 * i + k] += static_cast<float>(shift[k]);
    }
    return moved;
}

std::size_t BoundaryContent::add_moved(Content& content, const std::string& snapshot, double time,
                                       std::span<const FreeBodyState> free) const {
    if (!motion_.displaces()) return 0;
    const std::vector<BodyState> states = motion_.at(time, free);
    const auto add = [&](const Field& field, std::vector<float> points) {
        content.datasets.push_back(rows_of_three(field, std::move(points)));
        content.datasets.back().path = field.path_in(snapshot);
    };
    add(fields::snapshot.wall_position, displaced(wall_, wall_body_, states));
    add(fields::snapshot.solid_vertices, displaced(vertex_, vertex_body_, states));
    return sizeof(float) * (wall_.size() + vertex_.size());
}

}  // namespace riffle::inline solver
