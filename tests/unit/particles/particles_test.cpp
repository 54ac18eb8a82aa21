#include "particles/particles.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <set>
#include <string>
#include <type_traits>

namespace riffle::particles_test {
namespace {

/// Water whose fields all differ from each other and from particle to particle, with a further field that has
/// values and one that has none.
template <int D>
Particles<D> numbered(std::size_t n) {
    Particles<D> p;
    p.add_field({"temperature", "K", "temperature"});
    p.add_field({"later", "1", "not known yet"});
    p.append(n);
    p.further[0].values.resize(n);
    int field = 0;
    p.for_each_field([&](const FieldInfo&, auto& values) {
        for (std::size_t i = 0; i < values.size(); ++i) {
            using Value = std::remove_reference_t<decltype(values[i])>;
            values[i] = static_cast<Value>(100 * field + static_cast<int>(i));
        }
        ++field;
    });
    return p;
}

template <int D>
void expect_field_of(const Particles<D>& p, const std::vector<std::int32_t>& before) {
    int field = 0;
    p.for_each_field([&](const FieldInfo& info, const auto& values) {
        if (info.name == "later") {
            EXPECT_TRUE(values.empty());
        } else {
            ASSERT_EQ(values.size(), before.size()) << info.name;
            for (std::size_t i = 0; i < before.size(); ++i) {
                EXPECT_EQ(values[i], 100.0 * field + before[i]) << info.name << " of particle " << i;
            }
        }
        ++field;
    });
}

TEST(Particles, SortAllFieldsAlikeAndDropWhatAnOrderLeavesOut) {
    auto plane = numbered<2>(5);
    plane.permute({4, 0, 3, 1, 2});
    expect_field_of(plane, {4, 0, 3, 1, 2});
    auto space = numbered<3>(5);
    space.permute({3, 1});
    expect_field_of(space, {3, 1});
    EXPECT_EQ(space.size(), 2U);
}

TEST(Particles, NewOnesHaveNumbersThatNoOtherEverHad) {
    Particles<2> p;
    p.add_field({"temperature", "K", "temperature"});
    p.add_field({"later", "1", "not known yet"});
    p.append(4);
    p.further[0].values.resize(4);
    std::set<std::int32_t> seen(p.id.begin(), p.id.end());
    p.permute({0, 1});  // 2 and 3 have gone
    const std::size_t first = p.append(3);
    EXPECT_EQ(first, 2U);
    EXPECT_EQ(p.size(), 5U);
    for (std::size_t i = first; i < p.size(); ++i) {
        EXPECT_TRUE(seen.insert(p.id[i]).second) << "number " << p.id[i] << " is taken";
        EXPECT_EQ(p.mass[i], 0.0);
    }
    EXPECT_EQ(p.further[0].values.size(), p.size());
    EXPECT_TRUE(p.further[1].values.empty());
}

TEST(Particles, FieldsHaveNamesUnitsAndMeaningsOfTheirOwn) {
    std::set<std::string> names;
    numbered<3>(1).for_each_field([&](const FieldInfo& info, const auto&) {
        EXPECT_TRUE(names.insert(info.name).second) << info.name;
        EXPECT_FALSE(info.unit.empty());
        EXPECT_FALSE(info.long_name.empty());
    });
    EXPECT_EQ(names.size(), 3U + 3U + 3U + 2U);
    EXPECT_GE(numbered<3>(1000).bytes(), 1000 * (9 * sizeof(double) + sizeof(std::int32_t)));
}

TEST(WallParticles, SortAllArraysAlike) {
    WallParticles<2> walls;
    double next = 0.0;
    WallParticles<2>::for_each_array(walls, [&](auto& values) {
        for (int i = 0; i < 3; ++i) {
            values.push_back(static_cast<std::remove_reference_t<decltype(values[0])>>(next + i));
        }
        next += 10.0;
    });
    const WallParticles<2> before = walls;
    walls.permute({2, 0, 1});
    std::vector<double> sorted;
    WallParticles<2>::for_each_array(walls, [&](const auto& values) {
        for (const auto value : values) sorted.push_back(static_cast<double>(value));
    });
    std::size_t place = 0;
    WallParticles<2>::for_each_array(before, [&](const auto& values) {
        for (const std::size_t i : {2U, 0U, 1U}) {
            EXPECT_EQ(sorted[place++], static_cast<double>(values[i]));
        }
    });
}

}  // namespace
}  // namespace riffle::particles_test
