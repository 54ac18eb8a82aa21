// Solids in three dimensions: STL files, what is refused of them, and the questions to a closed surface.

#include "case/solid_mesh.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <fstream>
#include <string>
#include <vector>

#include "base/error.hpp"
#include "case/mesh_file.hpp"
#include "case/self_crossing.hpp"
#include "case_test.hpp"
#include "temporary_folder.hpp"

namespace riffle::solid_mesh_test {
namespace {

using test::error_of;
using testing::HasSubstr;

/// The twelve triangles of the box from a to b.
Triangles box(const Point3& a, const Point3& b) {
    Triangles triangles;
    const auto corner = [&](int bits) {
        return Point3{(bits & 1) != 0 ? b[0] : a[0], (bits & 2) != 0 ? b[1] : a[1],
                      (bits & 4) != 0 ? b[2] : a[2]};
    };
    const int faces[6][4] = {{0, 2, 3, 1}, {4, 5, 7, 6}, {0, 1, 5, 4},
                             {2, 6, 7, 3}, {0, 4, 6, 2}, {1, 3, 7, 5}};
    for (const auto& f : faces) {
        triangles.push_back({corner(f[0]), corner(f[1]), corner(f[2])});
        triangles.push_back({corner(f[0]), corner(f[2]), corner(f[3])});
    }
    return triangles;
}

Triangles turned(Triangles triangles) {
    for (Triangle& t : triangles) std::swap(t[1], t[2]);
    return triangles;
}

Triangles joined(Triangles a, const Triangles& b) {
    a.insert(a.end(), b.begin(), b.end());
    return a;
}

std::string text_of(const Triangles& triangles) {
    std::string text = "solid a box\n";
    for (const auto& t : triangles) {
        text += "facet normal 0 0 0\nouter loop\n";
        for (const Point3& p : t) {
            text += "vertex " + std::to_string(p[0]) + " " + std::to_string(p[1]) + " " +
                    std::to_string(p[2]) + "\n";
        }
        text += "endloop\nendfacet\n";
    }
    return text + "endsolid a box\n";
}

std::string binary_of(const Triangles& triangles) {
    std::string content = "solid, but in binary all the same";
    content.resize(80, ' ');
    const auto count = static_cast<std::uint32_t>(triangles.size());
    content.append(reinterpret_cast<const char*>(&count), 4);
    for (const auto& t : triangles) {
        content.append(12, '\0');
        for (const Point3& p : t) {
            for (const double x : p) {
                const auto number = static_cast<float>(x);
                content.append(reinterpret_cast<const char*>(&number), 4);
            }
        }
        content.append(2, '\0');
    }
    return content;
}

std::filesystem::path file_of(const std::string& content) {
    const std::string name = testing::UnitTest::GetInstance()->current_test_info()->name();
    auto file = test::folder_of_this_process() / (name + ".stl");
    std::ofstream(file, std::ios::binary) << content;
    return file;
}

ClosedSurface surface_of(const std::string& content) {
    const auto file = file_of(content);
    return closed_surface(read_mesh(file), file.string());
}

std::string fault_of(const std::string& content) {
    try {
        static_cast<void>(surface_of(content));
    } catch (const FileError& e) {
        return e.what();
    }
    return "";
}

SolidMesh mesh_of(const Triangles& triangles) { return SolidMesh(closed_surface(triangles, "mesh.stl")); }

TEST(StlFile, TextAndBinaryAreTheSame) {
    const Triangles triangles = box({0.0, 0.0, 0.0}, {2.0, 1.0, 0.5});
    const ClosedSurface text = surface_of(text_of(triangles));
    EXPECT_EQ(text.triangles, triangles);
    EXPECT_EQ(text.shells, 1U);
    EXPECT_EQ(surface_of(binary_of(triangles)).triangles, triangles);
    EXPECT_NEAR(SolidMesh(text).volume(), 1.0, 1e-12);
}

TEST(StlFile, ASurfaceInsideOutIsTurned) {
    EXPECT_NEAR(SolidMesh(surface_of(text_of(turned(box({0.0, 0.0, 0.0}, {2.0, 1.0, 0.5}))))).volume(), 1.0,
                1e-12);
}

TEST(StlFile, AllSolidsOfATextAreRead) {
    const auto small = text_of(box({0.0, 0.0, 0.0}, {1.0, 1.0, 1.0}));
    const auto other = text_of(box({2.0, 0.0, 0.0}, {3.0, 1.0, 1.0}));
    const ClosedSurface both = surface_of(small + other);
    EXPECT_EQ(both.shells, 2U);
    EXPECT_NEAR(SolidMesh(both).volume(), 2.0, 1e-12);
    EXPECT_THAT(fault_of(small + "something else\n"), HasSubstr("expected `solid` or the end of the file"));
}

// Programs round a corner that several triangles share in each of them.
TEST(StlFile, CornersThatNearlyAgreeAreOne) {
    Triangles triangles = box({0.0, 0.0, 0.0}, {2.0, 1.0, 0.5});
    double shift = 1e-15;
    for (Triangle& t : triangles) {
        for (Point3& corner : t) {
            for (double& x : corner) {
                x += shift = -shift * 1.1;  // up to 3e-14
            }
        }
    }
    EXPECT_NEAR(SolidMesh(closed_surface(triangles, "box.stl")).volume(), 1.0, 1e-9);
    // A triangle whose corners fall together goes, and the surface stays closed.
    Triangles with_sliver = box({0.0, 0.0, 0.0}, {2.0, 1.0, 0.5});
    const Triangle first = with_sliver[0];
    Point3 beside = first[1];
    beside[0] += 1e-9;
    with_sliver[0][1] = beside;
    with_sliver.push_back({first[0], first[1], beside});
    const ClosedSurface mended = closed_surface(with_sliver, "box.stl");
    EXPECT_EQ(mended.triangles.size(), 12U);
    EXPECT_NEAR(SolidMesh(mended).volume(), 1.0, 1e-9);
    // What lies farther apart than the tolerance is a gap.
    Triangles open = box({0.0, 0.0, 0.0}, {2.0, 1.0, 0.5});
    open[0][0][0] += 3.0 * weld_tolerance * std::sqrt(4.0 + 1.0 + 0.25);
    EXPECT_THROW(static_cast<void>(closed_surface(open, "box.stl")), FileError);
}

TEST(StlFile, FaultsNameFileAndTriangle) {
    const Triangles whole = box({0.0, 0.0, 0.0}, {2.0, 1.0, 0.5});
    Triangles open = whole;
    open.erase(open.begin() + 4);
    EXPECT_THAT(fault_of(text_of(open)), HasSubstr("the surface is not closed"));
    EXPECT_THAT(fault_of(text_of(open)), HasSubstr("FaultsNameFileAndTriangle.stl: triangle "));
    Triangles one_turned = whole;
    std::swap(one_turned[6][0], one_turned[6][1]);
    EXPECT_THAT(fault_of(text_of(one_turned)), HasSubstr("turned over"));
    Triangles flat = whole;
    flat[3][2] = flat[3][1];
    EXPECT_THAT(fault_of(text_of(flat)), HasSubstr("the surface is not closed"));
    EXPECT_THAT(fault_of(text_of(Triangles(4, flat[3]))), HasSubstr("holds no triangle with an area"));
    std::string wrong = text_of(whole);
    wrong.replace(wrong.find("vertex") + 7, 1, "x");
    EXPECT_THAT(fault_of(wrong),
                HasSubstr(".stl:4: triangle 1: expected `vertex` and three numbers, found `x"));
    const std::string binary = binary_of(whole);
    EXPECT_THAT(fault_of(binary.substr(0, binary.size() - 10)), HasSubstr("cut short"));
    EXPECT_THAT(fault_of("solid x\nendsolid\n"), HasSubstr("holds no triangle"));
    const std::string text = text_of(whole);
    EXPECT_THAT(fault_of(text.substr(0, 300)), HasSubstr("cut short: `endfacet` is missing"));
    EXPECT_THAT(fault_of(text.substr(0, text.find("endsolid"))),
                HasSubstr("cut short: `endsolid` is missing"));
    std::string infinite = binary;
    const float nan = std::nanf("");
    constexpr std::size_t third_triangle = 84 + 50 * 2;
    std::memcpy(&infinite[third_triangle + 12], &nan, 4);
    EXPECT_THAT(fault_of(infinite), HasSubstr("triangle 3: a coordinate is not a finite number"));
}

/// The sides and ends of a prism over an outline in x and y, 1 high; those of one that crosses itself are
/// closed as well. Sides: two triangles after each other for each edge.
Triangles prism(const std::vector<std::array<double, 2>>& outline) {
    Triangles triangles;
    const std::size_t n = outline.size();
    const auto corner = [&](std::size_t i, double z) {
        return Point3{outline[i % n][0], outline[i % n][1], z};
    };
    for (std::size_t i = 0; i < n; ++i) {
        triangles.push_back({corner(i, 0.0), corner(i + 1, 0.0), corner(i + 1, 1.0)});
        triangles.push_back({corner(i, 0.0), corner(i + 1, 1.0), corner(i, 1.0)});
    }
    for (std::size_t i = 1; i + 1 < n; ++i) {
        triangles.push_back({corner(0, 0.0), corner(i + 1, 0.0), corner(i, 0.0)});
        triangles.push_back({corner(0, 1.0), corner(i, 1.0), corner(i + 1, 1.0)});
    }
    return triangles;
}

// A bow tie: its first and third side pass through each other at (0.5, 0.5).
TEST(StlFile, ASurfaceThatCrossesItselfIsRefused) {
    const std::string fault = fault_of(text_of(prism({{0.0, 0.0}, {1.0, 1.0}, {1.0, 0.0}, {0.0, 1.0}})));
    EXPECT_THAT(fault,
                HasSubstr("ASurfaceThatCrossesItselfIsRefused.stl: triangle 1: passes through triangle "));
    EXPECT_THAT(fault, HasSubstr(" at (0.5, 0.5, 0."));
    EXPECT_THAT(fault, HasSubstr("mend it in the program that made it"));
    // A tongue from the one side of a hexagon out through the other, by more than what counts as the same
    // place; one that only touches it does not cross.
    const auto with_tongue = [](double tip) {
        return text_of(
            prism({{0.0, 0.0}, {2.0, 0.0}, {2.0, 1.0}, {1.2, 1.0}, {1.0, tip}, {0.8, 1.0}, {0.0, 1.0}}));
    };
    EXPECT_THAT(fault_of(with_tongue(-0.01)), HasSubstr("the surface crosses itself"));
    EXPECT_EQ(fault_of(with_tongue(0.0)), "");
    EXPECT_EQ(fault_of(with_tongue(0.01)), "");
}

// Two corners of a star of triangles about one corner are enough to pass through each other.
TEST(StlFile, TrianglesWithOneCornerInCommonMayCross) {
    const Point3 o{0.0, 0.0, 0.0};
    const TriangleTree crossing(
        {{o, {1.0, 1.0, 0.0}, {1.0, -1.0, 0.0}}, {o, {1.0, 0.2, 1.0}, {1.0, 0.1, -1.0}}});
    const auto all = [](std::size_t, std::size_t) { return true; };
    const auto found = self_crossing(crossing, 1e-6, all);
    ASSERT_TRUE(found.has_value());
    EXPECT_NEAR(found->place[2], 0.0, 1e-12);
    EXPECT_NEAR(found->place[1] / found->place[0], 0.15, 1e-12);
    const TriangleTree apart(
        {{o, {1.0, 1.0, 0.0}, {1.0, -1.0, 0.0}}, {o, {-1.0, 0.2, 1.0}, {-1.0, 0.1, -1.0}}});
    EXPECT_FALSE(self_crossing(apart, 1e-6, all).has_value());
}

TEST(SolidMesh, KnowsInsideAndTheNearestPlace) {
    const SolidMesh mesh = mesh_of(box({0.0, 0.0, 0.0}, {2.0, 1.0, 0.5}));
    for (const double x : {-0.1, 0.1, 1.0, 1.9, 2.1}) {
        for (const double y : {-0.1, 0.25, 0.5, 0.9, 1.1}) {
            for (const double z : {-0.1, 0.1, 0.25, 0.4, 0.6}) {
                const bool inside = x > 0.0 && x < 2.0 && y > 0.0 && y < 1.0 && z > 0.0 && z < 0.5;
                EXPECT_EQ(mesh.contains({x, y, z}), inside) << x << " " << y << " " << z;
                const double dx = std::max({-x, x - 2.0, 0.0});
                const double dy = std::max({-y, y - 1.0, 0.0});
                const double dz = std::max({-z, z - 0.5, 0.0});
                const double exact = inside ? std::min({x, 2.0 - x, y, 1.0 - y, z, 0.5 - z})
                                            : std::sqrt(dx * dx + dy * dy + dz * dz);
                EXPECT_NEAR(mesh.nearest({x, y, z})->distance, exact, 1e-12);
            }
        }
    }
    const auto foot = mesh.nearest({1.0, 0.5, 0.4});
    EXPECT_NEAR(foot->direction[2], 1.0, 1e-12);
    EXPECT_FALSE(mesh.nearest({1.0, 0.5, 0.4}, 0.09).has_value());
}

// A point in two shells is as much in the solid as one in a single one.
TEST(SolidMesh, ShellsThatOverlapAreOneSolid) {
    const Triangles a = box({0.0, 0.0, 0.0}, {2.0, 1.0, 1.0});
    const Triangles b = box({1.0, 0.25, 0.25}, {3.0, 0.75, 2.0});
    for (const Triangles& shells : {joined(a, b), joined(turned(a), b), joined(a, turned(b))}) {
        const SolidMesh mesh = mesh_of(shells);
        EXPECT_TRUE(mesh.contains({0.5, 0.5, 0.5}));
        EXPECT_TRUE(mesh.contains({1.5, 0.5, 0.5}));  // in both
        EXPECT_TRUE(mesh.contains({2.5, 0.5, 0.5}));
        EXPECT_FALSE(mesh.contains({2.5, 0.1, 0.5}));
        // The face of b at x = 1 lies in a, where no water is.
        EXPECT_NEAR(mesh.nearest({1.05, 0.5, 0.5})->distance, 0.5, 1e-12);
        // In both, beside the corner in which they meet: its line is the way out, though it is no edge of
        // either.
        const auto corner = mesh.nearest({1.9, 0.7, 0.5});
        ASSERT_TRUE(corner.has_value());
        EXPECT_NEAR(corner->distance, std::hypot(0.1, 0.05), 1e-12);
        EXPECT_NEAR(corner->direction[0], 0.1 / std::hypot(0.1, 0.05), 1e-12);
        EXPECT_NEAR(corner->direction[1], 0.05 / std::hypot(0.1, 0.05), 1e-12);
        // On the line itself, out of both.
        const auto on_line = mesh.nearest({2.0, 0.75, 0.5});
        EXPECT_NEAR(on_line->distance, 0.0, 1e-12);
        EXPECT_GT(on_line->direction[0] + on_line->direction[1], 0.99);
    }
}

TEST(SolidMesh, AShellInAnotherIsSolidOrAHollowByItsSense) {
    const Triangles outer = box({0.0, 0.0, 0.0}, {3.0, 3.0, 3.0});
    const Triangles inner = box({1.0, 1.0, 1.0}, {2.0, 2.0, 2.0});
    EXPECT_TRUE(mesh_of(joined(outer, inner)).contains({1.5, 1.5, 1.5}));
    const SolidMesh hollow = mesh_of(joined(outer, turned(inner)));
    EXPECT_FALSE(hollow.contains({1.5, 1.5, 1.5}));
    EXPECT_TRUE(hollow.contains({0.5, 1.5, 1.5}));
    EXPECT_NEAR(hollow.volume(), 26.0, 1e-12);
    EXPECT_NEAR(hollow.nearest({0.9, 1.5, 1.5})->distance, 0.1, 1e-12);  // the wall of the hollow
}

/// What is said of a channel in three dimensions with a solid, beside its STL file; `ends`: lines after those
/// of [channel].
std::string said_of_solid(const std::filesystem::path& file, const std::string& lines,
                          const std::string& ends = "") {
    const auto path = file.parent_path() / "solid_case.toml";
    std::ofstream(path)
        << "[channel]\nslope = 0\ndepth = \"50 mm\"\nlength = \"200 mm\"\nwidth = \"100 mm\"\n"
           "dimensions = 3\n"
        << ends
        << "[bed]\nkind = \"slip\"\n[turbulence]\nclosure = \"none\"\n"
           "[start]\nkind = \"rest\"\n[run]\nuntil = \"1 s\"\n[[solid]]\nname = \"stone\"\n"
        << lines;
    try {
        static_cast<void>(read_case(path));
    } catch (const Error& e) {
        return e.what();
    }
    return "";
}

// Which shape it has is asked of the file that was read: one that is not there is told once.
TEST(SolidsInSpace, StayAwayFromOpenEnds) {
    const auto file = file_of(text_of(box({0.0, 0.0, 0.0}, {40.0, 30.0, 20.0})));
    const auto said = [&](const std::string& name, const std::string& place) {
        return said_of_solid(file, "file = \"" + name + "\"\nscale = \"1 mm\"\nplace = " + place + "\n",
                             "ends = \"open\"\n[inflow]\nunit_discharge = 0.01\nprofile = "
                             "\"uniform\"\n[outflow]\nkind = \"free\"\n");
    };
    const std::string name = file.filename().string();
    EXPECT_EQ(said(name, "[0.08, 0.02, 0]"), "");
    EXPECT_THAT(said(name, "[0.001, 0.02, 0]"), HasSubstr("it reaches to x = 1 mm"));
    EXPECT_THAT(said(name, "[0.158, 0.02, 0]"), HasSubstr("it reaches to x = 198 mm"));
    const std::string missing = said("none.stl", "[0.08, 0.02, 0]");
    EXPECT_THAT(missing, HasSubstr("solid_case.toml:"));
    EXPECT_EQ(missing.find("no such STL file"), missing.rfind("no such STL file"));
}

TEST(SolidsInSpace, NeedAFileAndAPlaceInTheChannel) {
    const auto file = file_of(text_of(box({0.0, 0.0, 0.0}, {40.0, 30.0, 20.0})));
    const auto text = [&](const std::string& lines) { return said_of_solid(file, lines); };
    const std::string name = "file = \"" + file.filename().string() + "\"\n";
    EXPECT_THAT(text(""), HasSubstr("file is missing"));
    EXPECT_THAT(text(name), HasSubstr("fills the whole channel"));
    EXPECT_THAT(text(name + "scale = \"1 mm\"\nplace = [0, 0, 1]\n"),
                HasSubstr("lies outside of the channel"));
    EXPECT_EQ(text(name + "scale = \"1 mm\"\nplace = [0.05, 0.02, 0]\n"), "");
    EXPECT_EQ(text(name + "scale = \"5 mm\"\nplace = [0, -0.02, -0.06]\n"),
              "");  // all of the length and width
    EXPECT_THAT(text(name + "scale = \"1 mm\"\nplace = [0.18, 0.02, 0]\n"),
                HasSubstr("across its periodic ends"));
    EXPECT_THAT(text(name + "scale = \"1 mm\"\nplace = [0.05]\n"), HasSubstr("expected three: x, y and z"));
    EXPECT_THAT(text(name + "scale = \"0.1 mm\"\n"), HasSubstr("less than 3 layers"));
    const std::string stone = name + "scale = \"1 mm\"\nplace = [0.05, 0.02, 0]\nmotion = \"constant\"\n";
    EXPECT_EQ(text(stone + "velocity_y = 0.02\n"), "");
    EXPECT_THAT(text(stone), HasSubstr("moves at no velocity"));
    EXPECT_THAT(text(stone + "velocity_z = -0.01\n"), HasSubstr("reaches the bed before the end of the run"));
    EXPECT_THAT(text(name + "x = [0, 1, 2]\n"), HasSubstr("x goes only with channel.dimensions"));
    EXPECT_THAT(text("file = \"none.stl\"\n"), HasSubstr("there is no such STL file"));
}

}  // namespace
}  // namespace riffle::solid_mesh_test
