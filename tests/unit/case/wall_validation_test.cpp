// What the kinds of walls do not go with, and what the message says about it.

#include "case_test.hpp"

namespace riffle {
namespace {

using test::error_of;
using test::smallest;

TEST(WallValidation, ModifiedDynamicWallsGoWithAnyBed) {
    const std::string text = smallest + "[numerics]\nwall = \"modified-dynamic\"\n";
    EXPECT_EQ(error_of(text), "");
    EXPECT_EQ(error_of(text, {{"bed.kind", "no-slip"},
                              {"bed.roughness_height", "0"},
                              {"bed.datum_below_crest", "0"}}),
              "");
}

}  // namespace
}  // namespace riffle
