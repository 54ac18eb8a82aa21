#include "preview/solid_slices.hpp"

#include <utility>

namespace riffle::inline preview {

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
        while (end < columns.size() && columns[end].second.size() == parts) ++end;
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

}  // namespace riffle::inline preview
