#include "preview/solid_slices.hpp"

#include <algorithm>
#include <limits>
#include <utility>

#include "case/winding.hpp"

namespace riffle {

std::vector<SolidStretch> upright_stretches(const SolidMesh& mesh, double x, double y) {
    constexpr double infinity = std::numeric_limits<double>::infinity();
    // Beside round numbers, on which corners like to stand.
    const double u = x + 1.234567e-9 * (mesh.upper()[0] - mesh.lower()[0]);
    const double v = y + 2.718282e-9 * (mesh.upper()[1] - mesh.lower()[1]);
    std::vector<std::pair<double, int>> passes;
    mesh.tree().in_box({u, v, -infinity}, {u, v, infinity}, [&](std::size_t i) {
        const Triangle& t = mesh.tree().triangles()[i];
        if (const int turns = turns_around(t, u, v); turns != 0) {
            passes.emplace_back(height_at(t, u, v), turns);
        }
    });
    std::sort(passes.begin(), passes.end());
    std::vector<SolidStretch> stretches;
    int inside = 0;
    for (const auto& [z, turns] : passes) {
        const int now = inside - turns;  // the underside of a body goes around with the clock
        if (inside == 0 && now != 0) {
            stretches.push_back({z, z});
        } else if (inside != 0 && now == 0) {
            stretches.back().high = z;
        }
        inside = now;
    }
    return stretches;
}

std::vector<std::vector<SheetPoint>> slice_polygons(
    double from, double to, int count, const std::function<std::vector<SolidStretch>(double)>& at) {
    using Column = std::pair<double, std::vector<SolidStretch>>;
    std::vector<Column> columns;
    for (int i = 0; i <= count; ++i) {
        const double place = from + (to - from) * i / count;
        Column column{place, at(place)};
        if (!columns.empty() && columns.back().second.size() != column.second.size()) {
            Column left = columns.back();
            Column right = column;
            for (int halving = 0; halving < 40; ++halving) {
                const double middle = 0.5 * (left.first + right.first);
                Column between{middle, at(middle)};
                (between.second.size() == left.second.size() ? left : right) = std::move(between);
            }
            columns.push_back(std::move(left));
            columns.push_back(std::move(right));
        }
        columns.push_back(std::move(column));
    }
    std::vector<std::vector<SheetPoint>> polygons;
    for (std::size_t begin = 0; begin < columns.size();) {
        const std::size_t parts = columns[begin].second.size();
        std::size_t end = begin;
        while (end < columns.size() && columns[end].second.size() == parts) {
            ++end;
        }
        for (std::size_t part = 0; part < parts && end - begin > 1; ++part) {
            std::vector<SheetPoint> polygon;
            for (std::size_t i = begin; i < end; ++i) {
                polygon.push_back({columns[i].first, columns[i].second[part].high});
            }
            for (std::size_t i = end; i-- > begin;) {
                polygon.push_back({columns[i].first, columns[i].second[part].low});
            }
            polygons.push_back(std::move(polygon));
        }
        begin = end;
    }
    return polygons;
}

}  // namespace riffle
