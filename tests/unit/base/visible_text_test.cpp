#include "base/visible_text.hpp"

#include <gtest/gtest.h>

namespace riffle::visible_text_test {
namespace {

TEST(VisibleText, LeavesWhatIsShown) {
    for (const char* text : {"", "plain",
                             "d\xc3\xa9"
                             "bit 5 m\xc2\xb3/s",
                             "\xe6\xb0\xb4", "\xf0\x9f\x8c\x8a"}) {
        EXPECT_EQ(visible_text(text), text);
        EXPECT_FALSE(hidden_character(text).has_value());
    }
}

TEST(VisibleText, ShowsWhatATerminalWouldObey) {
    EXPECT_EQ(visible_text("\x1b[2J"), "<U+001B>[2J");
    EXPECT_EQ(visible_text(std::string_view("a\0b", 3)), "a<U+0000>b");
    EXPECT_EQ(visible_text("a\nb\tc"), "a<U+000A>b<U+0009>c");
    EXPECT_EQ(visible_text("a\nb\tc", "\n\t"), "a\nb\tc");
    EXPECT_EQ(visible_text("a\x7f"), "a<U+007F>");
    EXPECT_EQ(visible_text("\xc2\x9b"
                           "31m"),
              "<U+009B>31m");                                       // a control sequence in one letter
    EXPECT_EQ(visible_text("a\xe2\x80\xaeslat"), "a<U+202E>slat");  // right to left
}

TEST(VisibleText, ShowsBytesThatAreNoText) {
    EXPECT_EQ(visible_text("a\xff"), "a<the byte 0xff>");
    EXPECT_EQ(visible_text("\xc3"), "<the byte 0xc3>");                        // cut off
    EXPECT_EQ(visible_text("\xc0\x80"), "<the byte 0xc0><the byte 0x80>");     // NUL in two bytes
    EXPECT_EQ(visible_text("\xed\xa0\x80").substr(0, 15), "<the byte 0xed>");  // half of a pair of UTF-16
    const auto hidden = hidden_character("ab\x1b");
    ASSERT_TRUE(hidden.has_value());
    EXPECT_EQ(hidden->place, 2U);
}

}  // namespace
}  // namespace riffle::visible_text_test
