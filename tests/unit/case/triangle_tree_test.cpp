// The tree of triangles: the answers are those of a search through all of them, at a bounded cost.

#include "case/triangle_tree.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>
#include <set>
#include <utility>

namespace riffle::triangle_tree_test {
namespace {

/// Small triangles anywhere in a unit cube, some of them twice, some flat.
Triangles scattered(std::size_t count) {
    std::mt19937_64 generator(7);
    const auto random = [&] { return static_cast<double>(generator() >> 11U) * 0x1.0p-53; };
    Triangles triangles;
    for (std::size_t i = 0; i < count; ++i) {
        const Point3 a{random(), random(), random()};
        Triangle t{a, a, a};
        for (std::size_t k = 1; k < 3; ++k) {
            for (double& x : t[k]) x += 0.1 * (random() - 0.5);
        }
        if (i % 50 == 0) t[2] = t[1];
        triangles.push_back(i % 40 == 1 ? triangles[i / 2] : t);
    }
    return triangles;
}

std::vector<Point3> places(std::size_t count) {
    std::mt19937_64 generator(11);
    const auto random = [&] { return 1.4 * static_cast<double>(generator() >> 11U) * 0x1.0p-53 - 0.2; };
    std::vector<Point3> points;
    for (std::size_t i = 0; i < count; ++i) {
        points.push_back({random(), random(), random()});
    }
    return points;
}

double squared_between(const Point3& a, const Point3& b) { return dot(minus(a, b), minus(a, b)); }

TEST(TriangleTree, FindsAllPairsWhoseBoxesMeet) {
    const Triangles all = scattered(700);
    std::set<std::pair<std::size_t, std::size_t>> expected;
    const auto meet = [&](std::size_t i, std::size_t j) {
        bool meets = true;
        for (std::size_t k = 0; k < 3; ++k) {
            const auto [low, high] = std::minmax({all[i][0][k], all[i][1][k], all[i][2][k]});
            const auto [below, above] = std::minmax({all[j][0][k], all[j][1][k], all[j][2][k]});
            meets = meets && low <= above && below <= high;
        }
        return meets;
    };
    for (std::size_t i = 0; i < all.size(); ++i) {
        for (std::size_t j = i + 1; j < all.size(); ++j) {
            if (meet(i, j)) expected.emplace(i, j);
        }
    }
    std::set<std::pair<std::size_t, std::size_t>> found;
    TriangleTree(all).for_meeting_boxes(
        [&](std::size_t i, std::size_t j) { EXPECT_TRUE(found.emplace(i, j).second); });
    EXPECT_GT(expected.size(), 100U);
    EXPECT_EQ(found, expected);
}

TEST(TriangleTree, FindsTheNearestOfAll) {
    const Triangles all = scattered(700);
    const TriangleTree tree(all);
    for (const Point3& p : places(300)) {
        std::size_t nearest = 0;
        for (std::size_t i = 1; i < all.size(); ++i) {
            if (squared_between(nearest_on(all[i], p), p) < squared_between(nearest_on(all[nearest], p), p)) {
                nearest = i;
            }
        }
        const auto found = tree.nearest(p);
        ASSERT_TRUE(found.has_value());
        EXPECT_EQ(found->triangle, nearest);  // of two that are the same, the first
        EXPECT_EQ(found->foot, nearest_on(all[nearest], p));
        const double distance = std::sqrt(found->squared);
        EXPECT_FALSE(tree.nearest(p, 0.999 * distance).has_value());
        EXPECT_TRUE(tree.nearest(p, 1.001 * distance).has_value());
        const auto second = tree.nearest(p, 1.0, [&](std::size_t i, const Point3&) { return i != nearest; });
        EXPECT_TRUE(!second || (second->triangle != nearest && second->squared >= found->squared));
    }
}

TEST(TriangleTree, FindsAllThatMeetABox) {
    const Triangles all = scattered(500);
    const TriangleTree tree(all);
    for (const Point3& p : places(100)) {
        const Point3 high{p[0] + 0.2, p[1] + 0.1, p[2] + 0.3};
        std::vector<int> visits(all.size(), 0);
        tree.in_box(p, high, [&](std::size_t i) { ++visits[i]; });
        for (std::size_t i = 0; i < all.size(); ++i) {
            bool meets = true;
            for (std::size_t k = 0; k < 3; ++k) {
                const auto [low, up] = std::minmax({all[i][0][k], all[i][1][k], all[i][2][k]});
                meets = meets && low <= high[k] && up >= p[k];
            }
            EXPECT_EQ(visits[i], meets ? 1 : 0);
        }
    }
}

TEST(TriangleTree, FindsWhereAWayFirstPasses) {
    // Two sheets across x, at 1 and at 2.
    const auto sheet = [](double x) { return Triangle{{{x, -1.0, -1.0}, {x, 3.0, -1.0}, {x, -1.0, 3.0}}}; };
    const TriangleTree tree({sheet(2.0), sheet(1.0)});
    const auto there = tree.first_crossing({0.0, 0.1, 0.2}, {4.0, 0.1, 0.2});
    ASSERT_TRUE(there.has_value());
    EXPECT_EQ(there->triangle, 1U);
    EXPECT_NEAR(there->share, 0.25, 1e-12);
    EXPECT_FALSE(there->inward);  // the sheets look along x
    const auto back = tree.first_crossing({4.0, 0.1, 0.2}, {0.0, 0.1, 0.2});
    ASSERT_TRUE(back.has_value());
    EXPECT_EQ(back->triangle, 0U);
    EXPECT_TRUE(back->inward);
    EXPECT_FALSE(tree.first_crossing({0.0, 0.1, 0.2}, {0.9, 0.1, 0.2}).has_value());
    EXPECT_FALSE(tree.first_crossing({0.0, 2.9, 2.9}, {4.0, 2.9, 2.9}).has_value());  // beside
}

TEST(TriangleTree, HoldsNoneOrManyInOnePlace) {
    EXPECT_FALSE(TriangleTree(Triangles{}).nearest({0.0, 0.0, 0.0}).has_value());
    const TriangleTree tree(Triangles(10000, Triangle{{{0.0, 0.0, 0.0}, {1.0, 0.0, 0.0}, {0.0, 1.0, 0.0}}}));
    EXPECT_EQ(tree.nearest({0.2, 0.2, 1.0})->triangle, 0U);
}

}  // namespace
}  // namespace riffle::triangle_tree_test
