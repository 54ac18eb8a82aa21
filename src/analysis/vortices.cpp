#include "analysis/vortices.hpp"
#include "base/not_a_number.hpp"

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>

namespace riffle::inline analysis {

namespace {

std::size_t stride_of(const CellBox& box, std::size_t axis) {
    std::size_t stride = 1;
    for (std::size_t i = 0; i < axis; ++i) stride *= box.cells[i];
    return stride;
}

/// The cell next to one along an axis, forwards or backwards; nothing beyond an end.
std::optional<std::size_t> neighbour(const CellBox& box, std::size_t cell, std::size_t axis, bool forwards) {
    const std::size_t count = box.cells[axis];
    if (count < 2) return std::nullopt;
    const std::size_t stride = stride_of(box, axis);
    const std::size_t at = cell / stride % count;
    if (forwards ? at + 1 < count : at > 0) return forwards ? cell + stride : cell - stride;
    if (!box.periodic[axis]) return std::nullopt;
    return forwards ? cell - (count - 1) * stride : cell + (count - 1) * stride;
}

}  // namespace

std::vector<double> derivative(const CellBox& box, const std::vector<double>& values, std::size_t axis) {
    std::vector<double> result(box.size(), not_a_number);
    for (std::size_t cell = 0; cell < result.size(); ++cell) {
        if (!std::isfinite(values[cell])) continue;
        double ends[2] = {values[cell], values[cell]};
        double steps = 0.0;
        for (const bool forwards : {false, true}) {
            const auto next = neighbour(box, cell, axis, forwards);
            if (!next || !std::isfinite(values[*next])) continue;
            ends[forwards ? 1 : 0] = values[*next];
            steps += 1.0;
        }
        if (steps > 0.0) result[cell] = (ends[1] - ends[0]) / (steps * box.spacing[axis]);
    }
    return result;
}

std::vector<double> plane_vorticity(const CellBox& plane, const std::vector<double>& first,
                                    const std::vector<double>& second) {
    std::vector<double> result = derivative(plane, second, 0);
    const std::vector<double> other = derivative(plane, first, 1);
    for (std::size_t i = 0; i < result.size(); ++i) result[i] -= other[i];
    return result;
}

std::vector<double> swirling_strength(const CellBox& plane, const std::vector<double>& first,
                                      const std::vector<double>& second) {
    const std::vector<double> a = derivative(plane, first, 0);
    const std::vector<double> b = derivative(plane, first, 1);
    const std::vector<double> c = derivative(plane, second, 0);
    const std::vector<double> d = derivative(plane, second, 1);
    std::vector<double> result(a.size());
    for (std::size_t i = 0; i < result.size(); ++i) {
        const double half = 0.5 * (a[i] - d[i]);
        const double discriminant = half * half + b[i] * c[i];
        result[i] = !std::isfinite(discriminant) ? not_a_number
                    : discriminant < 0.0         ? std::copysign(std::sqrt(-discriminant), c[i] - b[i])
                                                 : 0.0;
    }
    return result;
}

std::vector<double> q_criterion(const CellBox& box, const std::array<std::vector<double>, 3>& velocity) {
    // Q = -1/2 sum_ij (du_i/dx_j)(du_j/dx_i) + 1/2 (div u)^2; the means are nearly free of divergence, whose
    // part is left out as in the definition by |Omega|^2 - |S|^2.
    std::vector<double> result(box.size(), 0.0);
    for (std::size_t i = 0; i < 3; ++i) {
        for (std::size_t j = i; j < 3; ++j) {
            const std::vector<double> one = derivative(box, velocity[i], j);
            if (i == j) {
                for (std::size_t cell = 0; cell < result.size(); ++cell) {
                    result[cell] -= 0.5 * one[cell] * one[cell];
                }
                continue;
            }
            const std::vector<double> other = derivative(box, velocity[j], i);
            for (std::size_t cell = 0; cell < result.size(); ++cell) result[cell] -= one[cell] * other[cell];
        }
    }
    return result;
}

std::vector<std::vector<std::size_t>> connected_regions(const CellBox& box, const std::vector<bool>& marked,
                                                        std::size_t smallest) {
    std::vector<std::vector<std::size_t>> regions;
    std::vector<bool> seen(marked.size(), false);
    for (std::size_t start = 0; start < marked.size(); ++start) {
        if (!marked[start] || seen[start]) continue;
        std::vector<std::size_t> region{start};
        seen[start] = true;
        for (std::size_t at = 0; at < region.size(); ++at) {
            for (std::size_t axis = 0; axis < 3; ++axis) {
                for (const bool forwards : {false, true}) {
                    const auto next = neighbour(box, region[at], axis, forwards);
                    if (!next || !marked[*next] || seen[*next]) continue;
                    seen[*next] = true;
                    region.push_back(*next);
                }
            }
        }
        if (region.size() >= smallest) regions.push_back(std::move(region));
    }
    std::stable_sort(regions.begin(), regions.end(),
                     [](const auto& a, const auto& b) { return a.size() > b.size(); });
    return regions;
}

double root_mean_square(const std::vector<double>& values) {
    double squares = 0.0;
    double count = 0.0;
    for (const double value : values) {
        if (!std::isfinite(value)) continue;
        squares += value * value;
        count += 1.0;
    }
    return count > 0.0 ? std::sqrt(squares / count) : 0.0;
}

}  // namespace riffle::inline analysis
