// What the kinds of walls do not go with, and what the message says about it.

#include "case_test.hpp"

namespace riffle::wall_options_test {
namespace {

using test::error_of;
using test::smallest;
using testing::AllOf;
using testing::HasSubstr;

std::string with_wall(const std::string& wall, const std::string& numerics = "") {
    return smallest + "[numerics]\nwall = \"" + wall + "\"\n" + numerics;
}

/// A smooth bed, and more.
std::vector<Override> smooth(const std::string& kind, const std::vector<Override>& more = {}) {
    std::vector<Override> all{
        {"bed.kind", kind}, {"bed.roughness_height", "0"}, {"bed.datum_below_crest", "0"}};
    all.insert(all.end(), more.begin(), more.end());
    return all;
}

const std::string symmetric = "pressure_form = \"symmetric\"\n";

TEST(WallValidation, RepulsiveWallsHaveNoNeighboursForTheCorrection) {
    EXPECT_THAT(error_of(with_wall("repulsive")),
                AllOf(HasSubstr("would take them for a free surface"),
                      HasSubstr("choose pressure_form = \"symmetric\" or \"riemann\"")));
    EXPECT_EQ(error_of(with_wall("repulsive", symmetric)), "");
    EXPECT_EQ(error_of(with_wall("repulsive", "pressure_form = \"riemann\"\n")), "");
}

TEST(WallValidation, RepulsiveWallsGiveNoFriction) {
    EXPECT_THAT(error_of(with_wall("repulsive", symmetric), smooth("no-slip")),
                HasSubstr("nothing holds the water back along it"));
    EXPECT_EQ(error_of(with_wall("modified-dynamic"), smooth("no-slip")), "");
}

TEST(WallValidation, RepulsiveWallsNeedAFreeSurface) {
    const std::vector<Override> plates =
        smooth("slip", {{"channel.top", "wall"}, {"start.kind", "rest"}, {"run.until", "1"}});
    EXPECT_THAT(error_of(with_wall("repulsive", symmetric), plates),
                HasSubstr("their force scales with the depth below a free surface"));
    EXPECT_EQ(error_of(with_wall("modified-dynamic"), plates), "");
}

TEST(WallValidation, APlaneOfSymmetryDoesNotPush) {
    const std::vector<Override> space{{"channel.dimensions", "3"},
                                      {"channel.length", "0.25"},
                                      {"channel.width", "0.2"},
                                      {"channel.sides", "half"},
                                      {"start.kind", "rest"}};
    EXPECT_THAT(error_of(with_wall("repulsive", symmetric), space), HasSubstr("a plane of symmetry"));
    EXPECT_EQ(error_of(with_wall("modified-dynamic"), space), "");
}

}  // namespace
}  // namespace riffle::wall_options_test
