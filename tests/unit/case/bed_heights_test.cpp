// Beds from measured heights: files, holes, what the spacing resolves, periodic ends.

#include "case/bed_heights.hpp"

#include <fmt/format.h>

#include <cmath>
#include <functional>
#include <numbers>

#include "case/bed_surface.hpp"
#include "case/end_buffers.hpp"
#include "case/height_file.hpp"
#include "case/solid_mesh.hpp"
#include "case_test.hpp"
#include "changed_cases.hpp"
#include "temporary_folder.hpp"

namespace riffle::bed_heights_test {
namespace {

using testing::HasSubstr;

std::string asc(std::size_t columns, std::size_t rows, double cell,
                const std::function<double(double, double)>& z) {
    std::string text =
        fmt::format("NCOLS {}\nnrows {}\nxllcorner 0\nyllcorner 0\ncellsize {}\nNODATA_value -9999\n",
                    columns, rows, cell);
    for (std::size_t row = rows; row-- > 0;) {
        for (std::size_t column = 0; column < columns; ++column) {
            text += fmt::format("{:.6f} ", z((static_cast<double>(column) + 0.5) * cell,
                                             (static_cast<double>(row) + 0.5) * cell));
        }
        text += "\n";
    }
    return text;
}

/// A case in three dimensions, 60 x 40 mm by 2 mm, over a bed from this content of a file in millimetres.
Case over(const std::string& content, const std::string& name = "bed.asc") {
    const auto& folder = test::folder_of_this_process();
    test::put_bytes(folder / name, content);
    Case c = test::tank();
    c.path = folder / "case.toml";
    c.channel.dimensions = 3;
    c.channel.ends = Ends::walls;
    c.channel.sides = Sides::walls;
    c.channel.length = 0.06;
    c.channel.width = 0.04;
    c.numerics.spacing = 0.002;
    c.numerics.wall_layers = 3;
    Solid bed;
    bed.name = "bed";
    bed.shape = SolidShape::bed;
    bed.heights = folder / name;
    bed.unit = 0.001;
    c.solids = {bed};
    return c;
}

std::string fault_of(const Case& c) {
    try {
        static_cast<void>(bed_heights(c, c.solids[0]));
    } catch (const Error& e) {
        return e.what();
    }
    return "";
}

std::string file_fault(const std::string& content, const std::string& name) {
    try {
        static_cast<void>(parse_height_grid(content, name));
    } catch (const FileError& e) {
        return e.what();
    }
    return "";
}

double plane(double x, double y) { return 5.0 + 0.1 * x + 0.05 * y; }

std::string replaced(std::string text, const std::string& from, const std::string& to) {
    return text.replace(text.find(from), from.size(), to);
}

// A plane stays one, whether the data are finer or coarser than the spacing.
TEST(BedHeights, APlaneIsKept) {
    for (const double cell : {0.5, 1.0, 2.0, 4.0}) {
        const Case c =
            over(asc(static_cast<std::size_t>(60 / cell), static_cast<std::size_t>(40 / cell), cell, plane));
        const BedHeights bed = bed_heights(c, c.solids[0]);
        ASSERT_EQ(bed.columns, 30U);
        ASSERT_EQ(bed.rows, 20U);
        for (std::size_t row = 1; row < bed.rows; ++row) {
            for (std::size_t column = 1; column < bed.columns; ++column) {
                EXPECT_NEAR(1e3 * bed.at(column, row),
                            plane(2.0 * static_cast<double>(column), 2.0 * static_cast<double>(row)), 1e-5);
            }
        }
    }
}

// Waves shorter than the spacing are not seen as longer ones.
TEST(BedHeights, WhatTheSpacingDoesNotResolveIsAveraged) {
    const Case c = over(asc(
        240, 160, 0.25, [](double x, double) { return 5.0 + std::sin(2.0 * std::numbers::pi * x / 1.0); }));
    const BedHeights bed = bed_heights(c, c.solids[0]);
    for (std::size_t column = 1; column < bed.columns; ++column) {
        EXPECT_NEAR(bed.at(column, 10), 0.005, 0.2e-3);
    }
}

TEST(BedHeights, PointsAreAGridInAnyOrder) {
    const std::string grid = asc(15, 10, 4.0, plane);
    std::string points = "z, y, x\n# scanned\n";
    for (int i = 0; i < 150; ++i) {
        const int k = 7 * i % 150;
        const double x = 2.0 + 4.0 * (k % 15);
        const int row = k / 15;
        const double y = 2.0 + 4.0 * row;
        points += fmt::format("{:.6f}, {}, {}\n", plane(x, y), y, x);
    }
    const HeightGrid a = parse_height_grid(grid, "a.asc");
    const HeightGrid b = parse_height_grid(points, "b.csv");
    EXPECT_EQ(a.z, b.z);
    EXPECT_EQ(a.x, b.x);
    EXPECT_EQ(a.step_y, b.step_y);
}

// Cells of 10/3 mm written to a tenth of a millimetre stand on a regular grid.
TEST(BedHeights, PlacesThatWereRoundedAreAGrid) {
    std::string points;
    for (int j = 0; j < 4; ++j) {
        for (int i = 0; i < 200; ++i) {
            points += fmt::format("{:.1f} {:.1f} {}\n", i / 0.3, j / 0.3, 1 + i % 2);
        }
    }
    const HeightGrid grid = parse_height_grid(points, "third.xyz");
    EXPECT_NEAR(grid.step_x, 10.0 / 3.0, 1e-3);
    EXPECT_EQ(grid.z.size(), 800U);
}

TEST(BedHeights, HolesAreFilledFromTheirEdgesAndTold) {
    const std::string gap = asc(30, 20, 2.0, [](double x, double y) {
        return std::hypot(x - 31.0, y - 21.0) < 0.1 ? -9999.0 : plane(x, y);
    });
    Case c = over(gap);
    const BedHeights bed = bed_heights(c, c.solids[0]);
    EXPECT_NEAR(1e3 * bed.at(15, 10), plane(30.0, 20.0), 1e-4);  // a membrane in a plane is the plane
    EXPECT_THAT(bed.notes[1],
                HasSubstr("1 of 600 heights were missing, in 1 hole, the widest 4 mm around (31 mm, "
                          "21 mm)"));
    c.solids[0].largest_hole = 0.003;
    EXPECT_THAT(fault_of(c), HasSubstr("is 4 mm wide, and up to 3 mm are filled"));
    EXPECT_THAT(fault_of(c), HasSubstr("largest_hole = \"4 mm\""));
}

TEST(BedHeights, ABedThatDoesNotFitIsRefusedWithACure) {
    const std::string whole = asc(30, 20, 2.0, plane);
    Case c = over(whole);
    c.channel.length = 0.08;
    EXPECT_THAT(fault_of(c),
                HasSubstr("from x = 0 mm to 60 mm in the channel, which reaches from 0 to 80 mm"));
    EXPECT_THAT(fault_of(c), HasSubstr("shorter than 60 mm"));
    c = over(whole);
    c.solids[0].unit = 1.0;
    EXPECT_THAT(fault_of(c), HasSubstr("its points stand 2 m apart, and the channel is"));
    EXPECT_THAT(fault_of(c), HasSubstr("did you mean unit = \"1 mm\"?"));
    c.solids[0].unit = 1e-5;
    EXPECT_THAT(fault_of(c), HasSubstr("did you mean unit = \"1 mm\"?"));
    c = over(replaced(whole, "xllcorner 0", "xllcorner 1000"));
    EXPECT_THAT(fault_of(c),
                HasSubstr("set the value for x in origin, the place in the file that comes to the "
                          "channel's begin, to 1000"));
    c.solids[0].origin = {1000.0, 0.0, 0.0};
    EXPECT_EQ(fault_of(c), "");
    c.solids[0].origin = {1000.0, 0.0, 8.0};
    EXPECT_THAT(fault_of(c), HasSubstr("below the bed level z = 0"));
    c.solids[0].origin = {1000.0, 0.0, -90.0};
    EXPECT_THAT(fault_of(c), HasSubstr("stands above the water everywhere"));
    c = over(whole);
    c.solids[0].height_unit = 1.0;
    EXPECT_THAT(fault_of(c), HasSubstr("did you mean height_unit = \"1 mm\"?"));
    c.solids[0].height_unit = 1e-6;
    EXPECT_THAT(fault_of(c), HasSubstr("far less than the particle spacing"));
}

TEST(BedHeights, PeriodicEndsMustMeet) {
    Case c = over(asc(30, 20, 2.0, plane));
    c.channel.ends = Ends::periodic;
    EXPECT_THAT(fault_of(c),
                HasSubstr("do not repeat at the periodic ends of the channel: they differ by up to 6 mm"));
    EXPECT_THAT(fault_of(c), HasSubstr("blend = \""));
    c.solids[0].blend = 0.02;
    const BedHeights bed = bed_heights(c, c.solids[0]);
    for (std::size_t row = 0; row <= bed.rows; ++row) {
        EXPECT_NEAR(bed.at(0, row), bed.at(bed.columns, row), 1e-12);
    }
    // Away from the ends nothing has changed.
    EXPECT_NEAR(1e3 * bed.at(15, 10), plane(30.0, 20.0), 1e-6);
    // One that repeats needs no blend.
    Case even = over(asc(30, 20, 2.0, [](double x, double) {
        return 8.0 + 3.0 * std::cos(2.0 * std::numbers::pi * x / 30.0);
    }));
    even.channel.ends = Ends::periodic;
    even.channel.sides = Sides::periodic;
    EXPECT_EQ(fault_of(even), "");
}

// The body is closed, stands under all of the channel, and encloses what lies below the heights.
// Where water enters and leaves the bed is the same along the channel, as it is in the mean there, and a
// little farther on it is that of the file.
TEST(BedHeights, OpenEndsAreTheSameAlongTheChannel) {
    const auto stones = [](double x, double y) {
        return 6.0 + 0.02 * x + 0.1 * y + 2.0 * std::sin(1.3 * x) * std::cos(0.9 * y);
    };
    Case c = over(asc(120, 20, 2.0, stones));
    c.channel.length = 0.24;
    c.channel.ends = Ends::open;
    const BedHeights bed = bed_heights(c, c.solids[0]);
    const auto watched = static_cast<std::size_t>(std::lround(watched_stretch(c) / bed.step_x));
    ASSERT_LT(2 * watched + 5, bed.columns / 2);
    for (std::size_t row = 0; row <= bed.rows; ++row) {
        const double y = 1e3 * bed.step_y * static_cast<double>(row);
        for (std::size_t i = 0; i <= watched; ++i) {
            EXPECT_NEAR(bed.at(i, row), bed.at(0, row), 1e-12);
            EXPECT_NEAR(bed.at(bed.columns - i, row), bed.at(bed.columns, row), 1e-12);
        }
        // The stones are gone, and the slope across has stayed.
        EXPECT_NEAR(1e3 * bed.at(0, row), 6.0 + 0.1 * y, 1.3) << y;
    }
    EXPECT_GT(bed.at(bed.columns, 10), bed.at(0, 10));  // each end has its own height
    Case walls = c;
    walls.channel.ends = Ends::walls;
    const BedHeights file = bed_heights(walls, walls.solids[0]);
    for (std::size_t row = 0; row <= bed.rows; ++row) {
        EXPECT_EQ(bed.at(bed.columns / 2, row), file.at(bed.columns / 2, row));
    }
    EXPECT_THAT(bed.notes, testing::Contains(HasSubstr("made the same along the channel over")));
}

TEST(BedHeights, TheSurfaceIsClosedAndReachesBeyondTheChannel) {
    const Case c = over(asc(30, 20, 2.0, plane));
    const SolidMesh mesh(c, c.solids[0]);
    EXPECT_LT(mesh.lower()[0], -0.006);
    EXPECT_GT(mesh.upper()[1], 0.046);
    EXPECT_LT(mesh.lower()[2], -0.006);
    EXPECT_TRUE(mesh.contains({0.03, 0.02, 0.0089}));
    EXPECT_FALSE(mesh.contains({0.03, 0.02, 0.0091}));
    const auto foot = mesh.nearest({0.03, 0.02, 0.02});
    EXPECT_NEAR(foot->distance, 0.011 / std::hypot(1.0, 0.1, 0.05), 1e-6);
}

TEST(BedHeights, FaultsOfFilesNameTheLine) {
    const std::string grid = asc(3, 2, 1.0, plane);
    EXPECT_THAT(file_fault(replaced(grid, "5.225", "x.225"), "a.asc"),
                HasSubstr("a.asc:7: expected a height, found `x."));
    EXPECT_THAT(file_fault(replaced(grid, "nrows 2", "nrows 3"), "a.asc"),
                HasSubstr("cut short: holds 6 of the 3 x 3"));
    EXPECT_THAT(file_fault(replaced(grid, "nrows 2", "nrows 1"), "a.asc"),
                HasSubstr("more heights than the 3 x 1"));
    EXPECT_THAT(file_fault(replaced(grid, "nrows 2", "nrows 900000000"), "a.asc"), HasSubstr("cut short"));
    EXPECT_THAT(file_fault(replaced(grid, "nrows 2", "nrows 1e300"), "a.asc"), HasSubstr("`nrows`"));
    EXPECT_THAT(file_fault(replaced(grid, "cellsize 1", "cellsize 0"), "a.asc"), HasSubstr("cellsize"));
    EXPECT_THAT(file_fault(replaced(grid, "cellsize", "cell"), "a.asc"),
                HasSubstr("a.asc:5: expected ncols"));
    EXPECT_THAT(file_fault("", "a.asc"), HasSubstr("cellsize"));
    EXPECT_THAT(file_fault("0 0 1\n1 0 1\n0 1 1\n1 1\n", "a.xyz"), HasSubstr("a.xyz:4: expected 3 numbers"));
    EXPECT_THAT(file_fault("x [mm],y [mm],z [mm]\n0,0,1\n1,0,1\n", "a.csv"),
                HasSubstr("a.csv:1: expected columns of the names x, y, z without units"));
    EXPECT_THAT(file_fault("0,5;0;1\n", "a.csv"), HasSubstr("decimals have a point"));
    EXPECT_THAT(file_fault("x,y,h\n0,0,1\n", "a.csv"), HasSubstr("`z` is missing"));
    EXPECT_THAT(file_fault("0 0 1\n1 0 1\n0 1 1\n1 1 1\n1 1 2\n", "a.xyz"),
                HasSubstr("a.xyz:5: a second point at the place of line 4"));
    EXPECT_THAT(file_fault("0 0 1\n1 0.1 1\n2.3 1 1\n3.1 0.4 1\n", "a.xyz"), HasSubstr("not evenly apart"));
    EXPECT_THAT(file_fault("0 0 1\n1 0 1\n2 0 1\n", "a.xyz"), HasSubstr("the same y"));
    EXPECT_THAT(file_fault("0 0 nan\n1 0 nan\n0 1 nan\n1 1 nan\n", "a.xyz"), HasSubstr("holds no height"));
    std::string scattered;
    for (int i = 0; i < 50; ++i) {
        scattered += fmt::format("{} {} 1\n", 1000 * i + i * i, 1001 * (7 * i % 50) + i);
    }
    EXPECT_THAT(file_fault(scattered, "a.xyz"), HasSubstr("regular grid"));
}

// In two dimensions the bed becomes an outline that the text of the case holds: results need no other file.
TEST(BedHeights, InTwoDimensionsItBecomesAnOutline) {
    const auto& folder = test::folder_of_this_process();
    std::string points;
    for (int i = 0; i <= 40; ++i) {
        points += fmt::format("{} {:.4f}\n", 5 * i, 6.0 + 2.0 * std::cos(2.0 * std::numbers::pi * i / 20.0));
    }
    test::put_bytes(folder / "bed.xyz", points);
    const std::string text =
        test::smallest + "[start]\nkind = \"rest\"\n[run]\nuntil = \"1 s\"\n" +
        "[[solid]]\nname = \"dunes\"\nshape = \"bed\"\nheights = \"bed.xyz\"\nunit = \"1 mm\"\n";
    const Case c = parse_case(text, "case.toml", folder / "case.toml");
    ASSERT_EQ(c.solids.size(), 1U);
    EXPECT_GT(c.solids[0].x.size(), 20U);
    EXPECT_FALSE(c.solid_notes.empty());
    const Case again = parse_case(c.text, "results");
    EXPECT_TRUE(again.same_parameters(c));
    EXPECT_EQ(again.text, c.text);
}

}  // namespace
}  // namespace riffle::bed_heights_test
