#include "case/triangle_tree.hpp"

#include <cmath>
#include <numeric>
#include <utility>

namespace riffle::inline case_file {

namespace {

constexpr std::size_t leaf_size = 4;

}  // namespace

TriangleTree::Box TriangleTree::box_of(const Triangle& t) {
    Box box;
    for (std::size_t k = 0; k < 3; ++k) {
        box.lower[k] = std::min({t[0][k], t[1][k], t[2][k]});
        box.upper[k] = std::max({t[0][k], t[1][k], t[2][k]});
    }
    return box;
}

TriangleTree::TriangleTree(Triangles triangles)
    : triangles_(std::move(triangles)), order_(triangles_.size()) {
    bounds_.lower.fill(std::numeric_limits<double>::infinity());
    bounds_.upper.fill(-std::numeric_limits<double>::infinity());
    if (triangles_.empty()) return;
    std::iota(order_.begin(), order_.end(), std::uint32_t{0});
    std::vector<Point3> centres(triangles_.size());
    for (std::size_t i = 0; i < triangles_.size(); ++i) {
        for (std::size_t k = 0; k < 3; ++k) {
            centres[i][k] = triangles_[i][0][k] + triangles_[i][1][k] + triangles_[i][2][k];  // thrice
        }
    }
    nodes_.reserve(triangles_.size() / (leaf_size / 2) + 1);
    divide(0, triangles_.size(), centres);
    nodes_.shrink_to_fit();
    bounds_ = nodes_[0].box;
}

std::size_t TriangleTree::bytes() const {
    return triangles_.capacity() * sizeof(Triangle) + order_.capacity() * sizeof(std::uint32_t) +
           nodes_.capacity() * sizeof(Node);
}

/// Halves by the middle of the triangles' centres along their longest extent; it goes as deep as the
/// logarithm of their number.
void TriangleTree::divide(std::size_t begin, std::size_t end, const std::vector<Point3>& centres) {
    const std::size_t at = nodes_.size();
    nodes_.emplace_back();
    Box box = box_of(triangles_[order_[begin]]);
    Box middle{centres[order_[begin]], centres[order_[begin]]};
    for (std::size_t i = begin + 1; i < end; ++i) {
        const Box own = box_of(triangles_[order_[i]]);
        const Point3& centre = centres[order_[i]];
        for (std::size_t k = 0; k < 3; ++k) {
            box.lower[k] = std::min(box.lower[k], own.lower[k]);
            box.upper[k] = std::max(box.upper[k], own.upper[k]);
            middle.lower[k] = std::min(middle.lower[k], centre[k]);
            middle.upper[k] = std::max(middle.upper[k], centre[k]);
        }
    }
    nodes_[at].box = box;
    if (end - begin <= leaf_size) {
        nodes_[at].first = static_cast<std::uint32_t>(begin);
        nodes_[at].count = static_cast<std::uint32_t>(end - begin);
        return;
    }
    std::size_t axis = 0;
    for (std::size_t k = 1; k < 3; ++k) {
        if (middle.upper[k] - middle.lower[k] > middle.upper[axis] - middle.lower[axis]) axis = k;
    }
    const std::size_t half = begin + (end - begin) / 2;
    const auto place = [&](std::size_t i) { return order_.begin() + static_cast<std::ptrdiff_t>(i); };
    std::nth_element(place(begin), place(half), place(end), [&](std::uint32_t a, std::uint32_t b) {
        return std::pair(centres[a][axis], a) < std::pair(centres[b][axis], b);
    });
    divide(begin, half, centres);
    nodes_[at].first = static_cast<std::uint32_t>(nodes_.size());
    divide(half, end, centres);
}

std::optional<TriangleTree::Crossing> TriangleTree::first_crossing(const Point3& from,
                                                                   const Point3& to) const {
    std::optional<Crossing> first;
    const Point3 way = minus(to, from);
    Point3 low{};
    Point3 high{};
    for (std::size_t k = 0; k < 3; ++k) {
        low[k] = std::min(from[k], to[k]);
        high[k] = std::max(from[k], to[k]);
    }
    in_box(low, high, [&](std::size_t i) {
        const Triangle& t = triangles_[i];
        const Point3 normal = normal_of(t);
        const double before = dot(minus(from, t[0]), normal);
        const double after = dot(minus(to, t[0]), normal);
        if ((before > 0.0) == (after > 0.0)) return;
        // The way passes the triangle where it turns the same way around all three edges.
        int left = 0;
        int right = 0;
        for (std::size_t k = 0; k < 3; ++k) {
            const double turn = dot(way, cross(minus(t[k], from), minus(t[(k + 1) % 3], from)));
            left += turn > 0.0 ? 1 : 0;
            right += turn < 0.0 ? 1 : 0;
        }
        const double share = before / (before - after);
        const bool nearer = !first || share < first->share || (share == first->share && i < first->triangle);
        if ((left == 0 || right == 0) && nearer) {
            first = Crossing{i, share, before > 0.0};
        }
    });
    return first;
}

}  // namespace riffle::inline case_file
