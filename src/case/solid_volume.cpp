#include "case/solid_volume.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>

#include "case/outline.hpp"
#include "case/solid_mesh.hpp"

namespace riffle::inline case_file {

namespace {

/// Integrals over simplices that have one corner at the origin.
struct Integrals {
    double volume = 0.0;
    std::array<double, 3> first{};
    std::array<double, 9> second{};

    /// Add a simplex of a volume with so many further corners: a triangle with two, a tetrahedron with three.
    /// The integral of x is the volume times the mean of the corners, that of x_k x_l
    /// V/((n + 1)(n + 2)) (sum over the corners of c_k c_l + S_k S_l), S the sum of the corners.
    template <std::size_t N>
    void add(double simplex, const std::array<Point3, N>& corners) {
        constexpr double n = N;
        Point3 sum{};
        for (const Point3& corner : corners) {
            for (std::size_t k = 0; k < 3; ++k) sum[k] += corner[k];
        }
        volume += simplex;
        for (std::size_t k = 0; k < 3; ++k) {
            first[k] += simplex * sum[k] / (n + 1.0);
            for (std::size_t l = 0; l < 3; ++l) {
                double products = sum[k] * sum[l];
                for (const Point3& corner : corners) products += corner[k] * corner[l];
                second[3 * k + l] += simplex * products / ((n + 1.0) * (n + 2.0));
            }
        }
    }
};

/// About the centroid, corners having been counted from `origin`.
SolidVolume about_centroid(const Integrals& sums, const Point3& origin) {
    SolidVolume result{.volume = sums.volume};
    Point3 middle{};
    for (std::size_t k = 0; k < 3; ++k) {
        middle[k] = sums.first[k] / sums.volume;
        result.centroid[k] = origin[k] + middle[k];
    }
    for (std::size_t k = 0; k < 3; ++k) {
        for (std::size_t l = 0; l < 3; ++l) {
            result.spread[3 * k + l] = sums.second[3 * k + l] - sums.volume * middle[k] * middle[l];
        }
    }
    return result;
}

SolidVolume of_outline(const Solid& solid) {
    const Outline outline{solid.x, solid.z};
    const Point3 origin{outline.x[0], 0.0, outline.z[0]};
    const double sense = signed_area(outline) < 0.0 ? -1.0 : 1.0;
    Integrals sums;
    for (std::size_t i = 0; i < outline.size(); ++i) {
        const std::size_t j = outline.next(i);
        const std::array<Point3, 2> corners{minus({outline.x[i], 0.0, outline.z[i]}, origin),
                                            minus({outline.x[j], 0.0, outline.z[j]}, origin)};
        sums.add(sense * 0.5 * (corners[0][0] * corners[1][2] - corners[0][2] * corners[1][0]), corners);
    }
    return about_centroid(sums, origin);
}

SolidVolume of_mesh(const SolidMesh& mesh) {
    const Point3& origin = mesh.lower();
    Integrals sums;
    for (const Triangle& t : mesh.tree().triangles()) {
        const std::array<Point3, 3> corners{minus(t[0], origin), minus(t[1], origin), minus(t[2], origin)};
        sums.add(dot(corners[0], cross(corners[1], corners[2])) / 6.0, corners);
    }
    return about_centroid(sums, origin);
}

}  // namespace

std::array<double, 9> SolidVolume::inertia() const {
    const double trace = spread[0] + spread[4] + spread[8];
    std::array<double, 9> result{};
    for (std::size_t k = 0; k < 9; ++k) result[k] = (k % 4 == 0 ? trace : 0.0) - spread[k];
    return result;
}

SolidVolume solid_volume(const Case& c, const Solid& solid) {
    if (c.channel.dimensions == 2) return of_outline(solid);
    const SolidMesh* const mesh = mesh_of(c, solid);
    return mesh != nullptr ? of_mesh(*mesh) : of_mesh(SolidMesh(c, solid));
}

double reach_from(const Case& c, const Solid& solid, const std::array<double, 3>& point) {
    double squared = 0.0;
    const auto look = [&](const Point3& place) {
        const Point3 apart = minus(place, point);
        squared = std::max(squared, dot(apart, apart));
    };
    for (std::size_t i = 0; c.channel.dimensions == 2 && i < solid.x.size(); ++i) {
        look({solid.x[i], 0.0, solid.z[i]});
    }
    if (c.channel.dimensions == 3) {
        const auto look_at = [&](const SolidMesh& mesh) {
            for (const Triangle& t : mesh.tree().triangles()) std::for_each(t.begin(), t.end(), look);
        };
        const SolidMesh* const read = mesh_of(c, solid);
        read != nullptr ? look_at(*read) : look_at(SolidMesh(c, solid));
    }
    return std::sqrt(squared);
}

std::array<double, 3> moment_point(const Case& c, const Solid& solid) {
    if (solid.moment_about.empty()) return solid_volume(c, solid).centroid;
    return {solid.moment_about[0], solid.moment_about.size() == 3 ? solid.moment_about[1] : 0.0,
            solid.moment_about.back()};
}

}  // namespace riffle::inline case_file
