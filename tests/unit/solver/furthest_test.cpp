#include "solver/furthest.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <random>
#include <vector>

namespace riffle::furthest_test {
namespace {

TEST(Furthest, LeavesTwoDropsOut) {
    Furthest found;
    for (const double x : {1.0, 5.0, 2.0, 9.0, 2.5, 3.0}) {
        found.add(x);
    }
    EXPECT_EQ(found.furthest(), 9.0);
    EXPECT_EQ(found.front(), 3.0);
}

TEST(Furthest, OfFewIsTheLast) {
    Furthest found;
    found.add(-4.0);
    EXPECT_EQ(found.front(), -4.0);
    found.add(-6.0);
    EXPECT_EQ(found.furthest(), -4.0);
    EXPECT_EQ(found.front(), -6.0);
}

TEST(Furthest, OfPartsIsThatOfAll) {
    std::mt19937_64 generator(5);
    std::uniform_real_distribution<double> place(-1.0, 1.0);
    for (int trial = 0; trial < 100; ++trial) {
        std::vector<double> values(50);
        std::array<Furthest, 7> parts;
        for (std::size_t i = 0; i < values.size(); ++i) {
            values[i] = place(generator);
            parts[i % parts.size()].add(values[i]);
        }
        Furthest all;
        for (const Furthest& part : parts) all.add(part);
        std::sort(values.rbegin(), values.rend());
        EXPECT_EQ(all.furthest(), values[0]);
        EXPECT_EQ(all.front(), values[2]);
    }
}

}  // namespace
}  // namespace riffle::furthest_test
