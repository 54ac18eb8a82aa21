#include "base/wrapped_text.hpp"

#include <gtest/gtest.h>

#include <sstream>
#include <string>

namespace riffle::wrapped_text_test {
namespace {

TEST(WrappedText, BreaksAtSpacesAndIndents) {
    EXPECT_EQ(wrapped_text("one two three", 2, 8), "one two\n  three");
    EXPECT_EQ(wrapped_text("  -o,--output    Folder of the results", 4, 24),
              "  -o,--output    Folder\n    of the results");
    EXPECT_EQ(wrapped_text("short", 4), "short");
    EXPECT_EQ(wrapped_text("", 4), "");
}

TEST(WrappedText, KeepsWordsWholeAndCountsCharacters) {
    EXPECT_EQ(wrapped_text("a /a/path/that/is/long b", 2, 8), "a\n  /a/path/that/is/long\n  b");
    EXPECT_EQ(columns_of("u' ± 0.1"), 8U);
    EXPECT_EQ(wrapped_text("±± ±± ±±", 0, 5), "±± ±±\n±±");
}

TEST(WrappedText, LosesNoWord) {
    const std::string words = "Departures from the steady flow die out with an e-folding time";
    for (std::size_t columns = 1; columns < 70; ++columns) {
        std::istringstream wrapped(wrapped_text(words, 3, columns));
        std::string joined;
        for (std::string word; wrapped >> word;) joined += (joined.empty() ? "" : " ") + word;
        EXPECT_EQ(joined, words) << columns;
    }
}

}  // namespace
}  // namespace riffle::wrapped_text_test
