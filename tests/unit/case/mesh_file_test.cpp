// Surfaces from OBJ and PLY files, whole and damaged.

#include "case/mesh_file.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cstring>
#include <string>

#include "base/error.hpp"
#include "case/obj_file.hpp"
#include "case/ply_file.hpp"
#include "case/solid_mesh.hpp"
#include "temporary_folder.hpp"

namespace riffle::mesh_file_test {
namespace {

using testing::HasSubstr;

// A box of 2 x 1 x 0.5 by six faces of four corners.
const std::string obj_box =
    "# a box\no box\n"
    "v 0 0 0\nv 2 0 0\nv 2 1 0\nv 0 1 0\nv 0 0 0.5\nv 2 0 0.5\nv 2 1 0.5\nv 0 1 0.5\n"
    "vn 0 0 1\ns off\n"
    "f 4//1 3//1 2//1 1//1\nf 5 6 7 8\nf 1/1 2/1 6/1 5/1\nf 2 3 7 6\nf -6 -5 -1 \\\n -2\nf 4 1 5 8 # last\n";

const std::string ply_rows =
    "0 0 0\n2 0 0\n2 1 0\n0 1 0\n0 0 0.5\n2 0 0.5\n2 1 0.5\n0 1 0.5\n"
    "4 3 2 1 0\n4 4 5 6 7\n4 0 1 5 4\n4 1 2 6 5\n4 2 3 7 6\n4 3 0 4 7\n";

std::string ply_head(const std::string& format, const std::string& vertices = "8",
                     const std::string& faces = "6") {
    return "ply\nformat " + format + " 1.0\ncomment a box\nelement vertex " + vertices +
           "\nproperty float x\nproperty float y\nproperty float z\nelement face " + faces +
           "\nproperty list uchar int vertex_indices\nend_header\n";
}

std::string with_bytes_of(float value, bool big) {
    std::string bytes(sizeof value, '\0');
    std::memcpy(bytes.data(), &value, sizeof value);
    if (big) std::reverse(bytes.begin(), bytes.end());
    return bytes;
}

std::string with_bytes_of(int value, bool big) {
    std::string bytes(sizeof value, '\0');
    std::memcpy(bytes.data(), &value, sizeof value);
    if (big) std::reverse(bytes.begin(), bytes.end());
    return bytes;
}

std::string binary_box(bool big) {
    std::string text = ply_head(big ? "binary_big_endian" : "binary_little_endian");
    for (int corner = 0; corner < 8; ++corner) {
        const int around = corner % 4;
        text += with_bytes_of(around == 1 || around == 2 ? 2.0F : 0.0F, big) +
                with_bytes_of(around > 1 ? 1.0F : 0.0F, big) + with_bytes_of(corner > 3 ? 0.5F : 0.0F, big);
    }
    for (const auto& face : {std::array{3, 2, 1, 0}, std::array{4, 5, 6, 7}, std::array{0, 1, 5, 4},
                             std::array{1, 2, 6, 5}, std::array{2, 3, 7, 6}, std::array{3, 0, 4, 7}}) {
        text += '\4';
        for (const int corner : face) text += with_bytes_of(corner, big);
    }
    return text;
}

double volume_of(const Triangles& triangles) {
    EXPECT_EQ(triangles.size(), 12U);
    return SolidMesh(closed_surface(triangles, "box")).volume();
}

template <class Parse>
std::string fault_of(const Parse& parse, const std::string& content) {
    try {
        static_cast<void>(parse(content, "box.x"));
    } catch (const FileError& e) {
        return e.what();
    }
    return "";
}
std::string obj_fault(const std::string& content) { return fault_of(parse_obj, content); }
std::string ply_fault(const std::string& content) { return fault_of(parse_ply, content); }

std::string replaced(std::string text, const std::string& from, const std::string& to) {
    return text.replace(text.find(from), from.size(), to);
}

TEST(MeshFile, KindsAreReadByTheirEnding) {
    const auto& folder = test::folder_of_this_process();
    test::put_bytes(folder / "box.OBJ", obj_box);
    test::put_bytes(folder / "box.ply", ply_head("ascii") + ply_rows);
    test::put_bytes(folder / "box.dae", obj_box);
    EXPECT_NEAR(volume_of(read_mesh(folder / "box.OBJ")), 1.0, 1e-12);
    EXPECT_NEAR(volume_of(read_mesh(folder / "box.ply")), 1.0, 1e-12);
    EXPECT_THROW(static_cast<void>(read_mesh(folder / "none.obj")), FileError);
    try {
        static_cast<void>(read_mesh(folder / "box.dae"));
        FAIL();
    } catch (const FileError& e) {
        EXPECT_THAT(e.what(), HasSubstr(".stl, .obj or .ply"));
    }
}

TEST(MeshFile, AllFormatsOfPlyAreTheSame) {
    const Triangles text = parse_ply(ply_head("ascii") + ply_rows, "box.ply");
    EXPECT_EQ(parse_ply(binary_box(false), "box.ply"), text);
    EXPECT_EQ(parse_ply(binary_box(true), "box.ply"), text);
    EXPECT_EQ(parse_obj(obj_box, "box.obj").size(), text.size());
    // What a surface does not need is passed over.
    const std::string head =
        replaced(replaced(ply_head("ascii"), "property float z\n", "property float z\nproperty uchar red\n"),
                 "element face", "element extra 2\nproperty list uchar float weights\nelement face");
    const std::string rows =
        std::string(
            "0 0 0 9\n2 0 0 9\n2 1 0 9\n0 1 0 9\n0 0 0.5 9\n2 0 0.5 9\n2 1 0.5 9\n0 1 0.5 9\n"
            "0\n2 0.5 0.5\n") +
        ply_rows.substr(ply_rows.find("4 3 2"));
    EXPECT_EQ(parse_ply(head + rows, "box.ply"), text);
}

// A face in the form of an L, whose fan from the first corner would lie outside of it.
TEST(MeshFile, FacesNeedNotBeConvex) {
    std::string obj;
    for (const char* z : {" 0\n", " 1\n"}) {
        for (const char* xy : {"1 1", "1 2", "0 2", "0 0", "2 0", "2 1"}) obj += std::string("v ") + xy + z;
    }
    obj += "f 6 5 4 3 2 1\nf 7 8 9 10 11 12\n";
    for (int i = 1; i <= 6; ++i) {
        const int j = i % 6 + 1;
        obj += "f " + std::to_string(i) + " " + std::to_string(j) + " " + std::to_string(j + 6) + " " +
               std::to_string(i + 6) + "\n";
    }
    const SolidMesh mesh(closed_surface(parse_obj(obj, "l.obj"), "l.obj"));
    EXPECT_NEAR(mesh.volume(), 3.0, 1e-12);
    EXPECT_FALSE(mesh.contains({1.5, 1.5, 0.5}));
    EXPECT_NEAR(mesh.nearest({1.5, 1.5, 0.5})->distance, 0.5, 1e-12);
}

TEST(MeshFile, FaultsOfObjNameTheLine) {
    EXPECT_THAT(obj_fault(replaced(obj_box, "v 2 0 0", "v 2 nan 0")),
                HasSubstr("box.x:4: expected `v` and three numbers, found `nan`"));
    EXPECT_THAT(obj_fault(replaced(obj_box, "v 2 0 0", "v 2 0")), HasSubstr("found 2"));
    EXPECT_THAT(obj_fault(replaced(obj_box, "v 2 0 0", "v 2 0 1e999")), HasSubstr("box.x:4"));
    EXPECT_THAT(obj_fault(replaced(obj_box, "f 5 6 7 8", "f 5 6 7 9")), HasSubstr("corner 9, and 8 stand"));
    EXPECT_THAT(obj_fault(replaced(obj_box, "f 5 6 7 8", "f 5 6 7 -9")), HasSubstr("corner -9"));
    EXPECT_THAT(obj_fault(replaced(obj_box, "f 5 6 7 8", "f 5 6 7 0")), HasSubstr("corner 0"));
    EXPECT_THAT(obj_fault(replaced(obj_box, "f 5 6 7 8", "f 5 6")), HasSubstr("has 2 corners"));
    EXPECT_THAT(obj_fault(replaced(obj_box, "f 5 6 7 8", "f 5 6 8 7")), HasSubstr("crosses itself"));
    EXPECT_THAT(obj_fault(replaced(obj_box, "s off", "curv 0 1 1 2")), HasSubstr("found `curv`"));
    EXPECT_THAT(obj_fault("v 0 0 0\n"), HasSubstr("holds no face"));
    EXPECT_THAT(obj_fault("\x89PNG\r\n"), HasSubstr("not an OBJ file"));
    EXPECT_THAT(obj_fault(obj_box + "f 1 2 \\"), HasSubstr("cut short"));
}

TEST(MeshFile, FaultsOfPlySayWhere) {
    const std::string whole = ply_head("ascii") + ply_rows;
    EXPECT_THAT(ply_fault(replaced(whole, "ply\n", "plx\n")), HasSubstr("box.x:1: expected `ply`"));
    EXPECT_THAT(ply_fault(ply_head("ascii2") + ply_rows), HasSubstr("box.x:2: expected `format`"));
    EXPECT_THAT(ply_fault(replaced(whole, "end_header", "comment")), HasSubstr("expected"));
    EXPECT_THAT(ply_fault(ply_head("ascii").substr(0, 60)), HasSubstr("box.x"));
    EXPECT_THAT(ply_fault(replaced(whole, "float x", "float w")), HasSubstr("no x, y and z"));
    EXPECT_THAT(ply_fault(replaced(whole, "vertex_indices", "other")), HasSubstr("no list vertex_indices"));
    EXPECT_THROW(static_cast<void>(closed_surface(
                     parse_ply(replaced(whole, "2 0 0\n", "2 nan 0\n"), "box.ply"), "box.ply")),
                 FileError);
    EXPECT_THAT(ply_fault(replaced(whole, "2 0 0\n", "2 x 0\n")), HasSubstr("box.x:12: expected a number"));
    EXPECT_THAT(ply_fault(replaced(whole, "2 0 0\n", "2 0\n")), HasSubstr("holds 2 numbers: expected more"));
    EXPECT_THAT(ply_fault(replaced(whole, "2 0 0\n", "2 0 0 0\n")), HasSubstr("holds 4 numbers: expected 3"));
    EXPECT_THAT(ply_fault(replaced(whole, "4 4 5 6 7", "4 4 5 6 8")), HasSubstr("names vertex 8"));
    EXPECT_THAT(ply_fault(replaced(whole, "4 4 5 6 7", "4 4 5 6 0.5")), HasSubstr("names vertex 0.5"));
    EXPECT_THAT(ply_fault(replaced(whole, "4 4 5 6 7", "4 4 5 6 -1")), HasSubstr("names vertex -1"));
    EXPECT_THAT(ply_fault(replaced(whole, "4 4 5 6 7", "9 4 5 6 7")), HasSubstr("announces 9 items"));
    EXPECT_THAT(ply_fault(replaced(whole, "4 4 5 6 7", "2 4 5")), HasSubstr("has 2 corners"));
    EXPECT_THAT(ply_fault(whole.substr(0, whole.size() - 10)), HasSubstr("box.x:"));
    EXPECT_THAT(ply_fault(whole + "1 2 3\n"), HasSubstr("something follows"));
    const std::string binary = binary_box(true);
    EXPECT_THAT(ply_fault(binary.substr(0, binary.size() - 3)), HasSubstr("cut short"));
    EXPECT_THAT(ply_fault(binary + "x"), HasSubstr("something follows"));
}

// Counts that are no counts take no memory.
TEST(MeshFile, HugeCountsOfPlyAreRefused) {
    for (const char* format : {"ascii", "binary_little_endian"}) {
        EXPECT_THAT(ply_fault(ply_head(format, "4000000000000") + ply_rows), HasSubstr("cut short"));
        EXPECT_THAT(ply_fault(ply_head(format, "8", "9000000000000000000") + ply_rows),
                    HasSubstr("cut short"));
        EXPECT_THAT(ply_fault(ply_head(format, "-1") + ply_rows), HasSubstr("found -1 rows"));
    }
    EXPECT_THAT(ply_fault("ply\nformat ascii 1.0\nelement vertex 99999999\nend_header\n0\n"),
                HasSubstr("without a property"));
    std::string list = ply_head("binary_little_endian", "0", "1") + "\x03";
    list = replaced(list, "list uchar", "list uint");
    EXPECT_THAT(ply_fault(list + "\xff\xff\xff"), HasSubstr("cut short"));
}

}  // namespace
}  // namespace riffle::mesh_file_test
