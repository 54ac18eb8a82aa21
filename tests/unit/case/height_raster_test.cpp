// Beds from GeoTIFF files. Those of rasters/ were written from bed.asc by gdal_translate (GDAL 3.6).

#include "case/height_raster.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <fstream>
#include <iterator>
#include <random>

#include "base/error.hpp"
#include "case/bed_heights.hpp"
#include "case/height_file.hpp"
#include "changed_cases.hpp"

namespace riffle::height_raster_test {
namespace {

std::string path_of(const std::string& name) {
    return std::string(RIFFLE_SOURCE_DIR) + "/tests/unit/case/rasters/" + name;
}

std::string content_of(const std::string& name) {
    std::ifstream file(path_of(name), std::ios::binary);
    return {std::istreambuf_iterator<char>(file), {}};
}

class HeightRaster : public testing::Test {
  protected:
    void SetUp() override {
        if (!reads_rasters()) GTEST_SKIP() << "built without libtiff";
    }

    static std::string fault_of(const std::string& content) {
        try {
            static_cast<void>(parse_height_raster(content, "bed.tif"));
        } catch (const FileError& e) {
            return e.what();
        }
        return "";
    }
};

TEST_F(HeightRaster, HoldsTheHeightsOfTheGridItWasWrittenFrom) {
    const HeightGrid expected = parse_height_grid(content_of("bed.asc"), "bed.asc");
    for (const char* name : {"strip64.tif", "tiled32.tif"}) {
        const HeightGrid grid = parse_height_grid(content_of(name), name);
        ASSERT_EQ(grid.columns, 12U) << name;
        ASSERT_EQ(grid.rows, 9U) << name;
        EXPECT_NEAR(grid.x, expected.x, 1e-8) << name;
        EXPECT_NEAR(grid.y, expected.y, 1e-8) << name;
        EXPECT_NEAR(grid.step_x, 0.025, 1e-12) << name;
        EXPECT_NEAR(grid.step_y, 0.025, 1e-12) << name;
        EXPECT_EQ(grid.unit, 1.0) << name;
        for (std::size_t i = 0; i < grid.z.size(); ++i) {
            EXPECT_EQ(std::isnan(grid.z[i]), std::isnan(expected.z[i])) << name << ' ' << i;
            if (!std::isnan(expected.z[i])) {
                EXPECT_NEAR(grid.z[i], expected.z[i], 1e-5) << name << ' ' << i;
            }
        }
    }
}

TEST_F(HeightRaster, HoldsWholeNumbers) {
    const HeightGrid grid = parse_height_grid(content_of("int16.tif"), "int16.tif");
    const HeightGrid expected = parse_height_grid(content_of("bed.asc"), "bed.asc");
    for (const std::size_t i : {0U, 5U, 50U, 107U}) {
        EXPECT_NEAR(grid.z[i], (expected.z[i] - 99.0) * 1e4, 0.51) << i;
    }
}

TEST_F(HeightRaster, KnowsItsUnitOfLength) {
    EXPECT_NEAR(parse_height_raster(content_of("feet.tif"), "feet.tif").unit.value_or(0.0), 0.3048006, 1e-6);
    // A bed refuses another unit than that of its file, in a plane too.
    for (const int dimensions : {3, 2}) {
        Case c = test::with_shape(SolidShape::bed);
        c.channel.dimensions = dimensions;
        Solid& solid = c.solids[0];
        solid.heights = path_of(dimensions == 3 ? "feet.tif" : "feet-row.tif");
        solid.origin = {500000.0, 5400000.0, 99.9};
        if (dimensions == 2) {
            solid.origin = {500000.0, 99.9};
        }
        try {
            static_cast<void>(bed_heights(c, solid));
            FAIL() << "expected a refusal";
        } catch (const InputError& e) {
            EXPECT_NE(std::string(e.what()).find("set unit = \"0.3048006 m\""), std::string::npos)
                << e.what();
        }
    }
}

TEST_F(HeightRaster, RefusesWhatHasNoPlaceInAPlane) {
    EXPECT_NE(fault_of(content_of("degrees.tif")).find("in degrees"), std::string::npos);
    // Without the tag of the tie point, whose number becomes that of nothing.
    std::string nowhere = content_of("feet.tif");
    const std::size_t at = nowhere.find(std::string("\x82\x84\x0c", 3));  // tag 33922, of doubles
    ASSERT_NE(at, std::string::npos);
    nowhere[at] = '\x70';
    EXPECT_NE(fault_of(nowhere).find("says not where it lies"), std::string::npos);
    EXPECT_NE(fault_of("II*").find("is not a TIFF file"), std::string::npos);
    EXPECT_NE(fault_of("").find("is not a TIFF file"), std::string::npos);
}

TEST_F(HeightRaster, SurvivesDamage) {
    std::mt19937 random(1);
    for (const char* name : {"strip64.tif", "tiled32.tif", "int16.tif"}) {
        const std::string whole = content_of(name);
        for (int turn = 0; turn < 2000; ++turn) {
            std::string damaged = whole;
            const std::size_t changes = 1 + random() % 4;
            for (std::size_t i = 0; i < changes; ++i) {
                damaged[random() % damaged.size()] = static_cast<char>(random() % 256);
            }
            if (turn % 5 == 0) damaged.resize(random() % damaged.size());
            try {
                static_cast<void>(parse_height_raster(damaged, name));
            } catch (const FileError&) {  // the one way to say no
            }
        }
    }
}

}  // namespace
}  // namespace riffle::height_raster_test
