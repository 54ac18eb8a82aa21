#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <optional>
#include <utility>
#include <vector>

#include "case/triangle.hpp"

namespace riffle::inline case_file {

/// Triangles in a tree of boxes, each around the two below it: a question about a place costs what stands
/// around that place, not the number of triangles. The answers do not depend on how the tree was cut: of
/// several triangles that are equally near, the first in the given order answers.
class TriangleTree {
  public:
    TriangleTree() = default;
    explicit TriangleTree(Triangles triangles);

    /// The triangles, in the order in which they were given.
    [[nodiscard]] const Triangles& triangles() const { return triangles_; }
    /// Corners of the box around all of them; without a triangle the lower one is above the upper one.
    [[nodiscard]] const Point3& lower() const { return bounds_.lower; }
    [[nodiscard]] const Point3& upper() const { return bounds_.upper; }
    /// Memory that it takes.
    [[nodiscard]] std::size_t bytes() const;

    struct Near {
        std::size_t triangle = 0;
        Point3 foot{};         ///< its nearest place
        double squared = 0.0;  ///< distance from there, squared, m2
    };
    /// The nearest place of those triangles that `accept(triangle, foot)` takes; nothing where none is nearer
    /// than `limit`, m. Triangles that are as near as each other may be asked for in any order.
    template <class Accept>
    [[nodiscard]] std::optional<Near> nearest(const Point3& p, double limit, const Accept& accept) const;
    [[nodiscard]] std::optional<Near> nearest(const Point3& p,
                                              double limit = std::numeric_limits<double>::infinity()) const {
        return nearest(p, limit, [](std::size_t, const Point3&) { return true; });
    }

    /// Call visit(triangle) for each one whose own box meets the box from `low` to `high` (its faces count),
    /// in no particular order. An infinite extent makes it a slab or a line.
    template <class Visit>
    void in_box(const Point3& low, const Point3& high, const Visit& visit) const;

    /// Call visit(i, j) for each two triangles, i before j, whose own boxes meet (their faces count), in no
    /// particular order.
    template <class Visit>
    void for_meeting_boxes(const Visit& visit) const;

    struct Crossing {
        std::size_t triangle = 0;
        double share = 0.0;   ///< of the way from `from` to `to`, 0 to 1
        bool inward = false;  ///< whether the way leads from the triangle's front to its back
    };
    /// The first triangle that the straight way from one point to another passes.
    [[nodiscard]] std::optional<Crossing> first_crossing(const Point3& from, const Point3& to) const;

  private:
    struct Box {
        Point3 lower{};
        Point3 upper{};

        [[nodiscard]] bool meets(const Point3& low, const Point3& high) const {
            return lower[0] <= high[0] && upper[0] >= low[0] && lower[1] <= high[1] && upper[1] >= low[1] &&
                   lower[2] <= high[2] && upper[2] >= low[2];
        }
        [[nodiscard]] bool meets(const Box& other) const { return meets(other.lower, other.upper); }
        [[nodiscard]] double squared_distance(const Point3& p) const {
            double sum = 0.0;
            for (std::size_t k = 0; k < 3; ++k) {
                const double outside = std::max({lower[k] - p[k], p[k] - upper[k], 0.0});
                sum += outside * outside;
            }
            return sum;
        }
    };
    /// A leaf holds order_[first .. first + count); of another node, count is 0, its first half is the next
    /// node, the second one node `first`.
    struct Node {
        Box box;
        std::uint32_t first = 0;
        std::uint32_t count = 0;
    };
    /// Halving 2^32 triangles down to leaves goes no deeper.
    static constexpr std::size_t deepest = 40;

    static Box box_of(const Triangle& t);
    void divide(std::size_t begin, std::size_t end, const std::vector<Point3>& centres);

    Triangles triangles_;
    std::vector<std::uint32_t> order_;
    std::vector<Node> nodes_;
    Box bounds_;
};

template <class Accept>
std::optional<TriangleTree::Near> TriangleTree::nearest(const Point3& p, double limit,
                                                        const Accept& accept) const {
    std::optional<Near> best;
    double least = limit * limit;
    struct Pending {
        std::uint32_t node = 0;
        double squared = 0.0;
    };
    std::array<Pending, 2 * deepest> stack;
    std::size_t waiting = 0;
    if (!nodes_.empty()) {
        stack[waiting++] = {0, nodes_[0].box.squared_distance(p)};
    }
    while (waiting > 0) {
        const Pending next = stack[--waiting];
        if (next.squared > least) continue;
        const Node& node = nodes_[next.node];
        if (node.count == 0) {
            const Pending a{next.node + 1, nodes_[next.node + 1].box.squared_distance(p)};
            const Pending b{node.first, nodes_[node.first].box.squared_distance(p)};
            stack[waiting++] = a.squared <= b.squared ? b : a;
            stack[waiting++] = a.squared <= b.squared ? a : b;  // the nearer one comes first
            continue;
        }
        for (std::uint32_t k = node.first; k < node.first + node.count; ++k) {
            const std::size_t i = order_[k];
            if (box_of(triangles_[i]).squared_distance(p) > least) continue;
            const Point3 foot = nearest_on(triangles_[i], p);
            const Point3 way = minus(foot, p);
            const double squared = dot(way, way);
            const bool nearer = squared < least || (squared == least && best && i < best->triangle);
            if (nearer && accept(i, foot)) {
                best = Near{i, foot, squared};
                least = squared;
            }
        }
    }
    return best;
}

template <class Visit>
void TriangleTree::in_box(const Point3& low, const Point3& high, const Visit& visit) const {
    std::array<std::uint32_t, 2 * deepest> stack;
    std::size_t waiting = 0;
    if (!nodes_.empty()) stack[waiting++] = 0;
    while (waiting > 0) {
        const std::uint32_t at = stack[--waiting];
        const Node& node = nodes_[at];
        if (!node.box.meets(low, high)) continue;
        if (node.count == 0) {
            stack[waiting++] = node.first;
            stack[waiting++] = at + 1;
            continue;
        }
        for (std::uint32_t k = node.first; k < node.first + node.count; ++k) {
            if (box_of(triangles_[order_[k]]).meets(low, high)) visit(static_cast<std::size_t>(order_[k]));
        }
    }
}

template <class Visit>
void TriangleTree::for_meeting_boxes(const Visit& visit) const {
    // Pairs of nodes whose triangles are still to be compared: of a node with itself, those in it.
    std::vector<std::pair<std::uint32_t, std::uint32_t>> pending;
    if (!nodes_.empty()) pending.emplace_back(0, 0);
    const auto compare = [&](const Node& a, const Node& b) {
        for (std::uint32_t k = a.first; k < a.first + a.count; ++k) {
            const Box box = box_of(triangles_[order_[k]]);
            for (std::uint32_t l = &a == &b ? k + 1 : b.first; l < b.first + b.count; ++l) {
                if (box.meets(box_of(triangles_[order_[l]]))) {
                    const auto [i, j] = std::minmax(order_[k], order_[l]);
                    visit(static_cast<std::size_t>(i), static_cast<std::size_t>(j));
                }
            }
        }
    };
    while (!pending.empty()) {
        const auto [first, second] = pending.back();
        pending.pop_back();
        const Node& a = nodes_[first];
        const Node& b = nodes_[second];
        if (first != second && !a.box.meets(b.box)) continue;
        if (a.count > 0 && b.count > 0) {
            compare(a, b);
        } else if (first == second) {
            pending.emplace_back(first + 1, first + 1);
            pending.emplace_back(a.first, a.first);
            pending.emplace_back(first + 1, a.first);
        } else if (a.count == 0) {
            pending.emplace_back(first + 1, second);
            pending.emplace_back(a.first, second);
        } else {
            pending.emplace_back(first, second + 1);
            pending.emplace_back(first, b.first);
        }
    }
}

}  // namespace riffle::inline case_file
