#include <cmath>

#include "base/error.hpp"
#include "case/solid_mesh.hpp"
#include "case/stl_file.hpp"
#include "feed.hpp"

namespace riffle::inputs {

Answer feed_stl(std::string_view input) {
    const std::string name = "input.stl";
    try {
        ClosedSurface surface = closed_surface(parse_stl(input, name), name);
        const std::size_t triangles = surface.triangles.size();
        const SolidMesh mesh(std::move(surface));
        const Point3 size = minus(mesh.upper(), mesh.lower());
        const double diagonal = std::sqrt(dot(size, size));
        if (!std::isfinite(mesh.volume()) || !std::isfinite(diagonal)) {
            throw Failure("a surface is taken whose size is no number");
        }
        // Places around and in it, and one outside, where it must not be.
        constexpr int places = 5;
        for (int i = 0; i < places * places * places; ++i) {
            const double shares[] = {(i % places + 0.37) / places, (i / places % places + 0.41) / places,
                                     (i / places / places + 0.53) / places};
            Point3 p{};
            for (std::size_t k = 0; k < 3; ++k) p[k] = mesh.lower()[k] + (1.2 * shares[k] - 0.1) * size[k];
            const bool inside = mesh.contains(p);
            const auto foot = mesh.nearest(p);
            if (!foot) {
                continue;  // all of it lies in other shells of it
            }
            const double length = std::sqrt(dot(foot->direction, foot->direction));
            if (!(foot->distance <= 2.0 * diagonal) ||
                !(std::abs(length - 1.0) < 1e-6 || foot->distance == 0.0)) {
                throw Failure("the nearest place of a surface is no place");
            }
            if (inside && (p[0] < mesh.lower()[0] || p[0] > mesh.upper()[0])) {
                throw Failure("a place outside is inside");
            }
        }
        if (mesh.contains({mesh.upper()[0] + diagonal, mesh.upper()[1], mesh.upper()[2]})) {
            throw Failure("a place outside is inside");
        }
        return triangles > 0 ? Answer::taken : Answer::refused;
    } catch (const FileError& e) {
        if (!std::string(e.what()).starts_with(name + ":")) {
            throw Failure(std::string("an error message without its place: ") + e.what());
        }
        return Answer::refused;
    }
}

}  // namespace riffle::inputs
