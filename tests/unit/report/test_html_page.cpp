#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>
#include <stdexcept>
#include <string>

#include "base/markup.hpp"
#include "report/html_page.hpp"
#include "report/page_assets.hpp"

namespace riffle {
namespace {

using ::testing::HasSubstr;
using ::testing::Not;

TEST(HtmlPage, EscapesTextForHtml) {
    EXPECT_EQ(escape_markup("a<b & \"c\">"), "a&lt;b &amp; &quot;c&quot;&gt;");
}

TEST(HtmlPage, JsonInAScriptBlockCannotEndTheBlockAndStaysTheSame) {
    const nlohmann::json value = {{"text", "</script><script>alert(1)</script><!-- ünï -->"}};
    const std::string escaped = escape_json_for_script(value.dump());
    EXPECT_THAT(escaped, Not(HasSubstr("<")));
    EXPECT_EQ(nlohmann::json::parse(escaped), value);
}

TEST(HtmlPage, PartsAreNotReadAsPlaces) {
    EXPECT_EQ(fill_page("<{{a}}|{{b}}>", {{"a", "{{b}}"}, {"b", "x"}}), "<{{b}}|x>");
}

TEST(HtmlPage, APlaceWithoutAPartIsAnError) {
    EXPECT_THROW(static_cast<void>(fill_page("{{a}}", {})), std::logic_error);
    EXPECT_THROW(static_cast<void>(fill_page("{{a", {{"a", "x"}})), std::logic_error);
}

TEST(PageAssets, AreWholeAndAskForNothingOutside) {
    const PageAssets assets = page_assets();
    EXPECT_THAT(std::string(assets.html), ::testing::StartsWith("<!DOCTYPE html>"));
    EXPECT_THAT(std::string(assets.html), ::testing::EndsWith("</html>\n"));
    EXPECT_GT(assets.plotly.size(), 500'000U);
    for (const std::string_view part :
         {assets.html, assets.style, assets.script, assets.field, assets.page}) {
        EXPECT_FALSE(part.empty());
        EXPECT_THAT(std::string(part), Not(HasSubstr("http:")));
        EXPECT_THAT(std::string(part), Not(HasSubstr("https:")));
    }
    // Scripts stand inside a script block of the page.
    for (const std::string_view part : {assets.plotly, assets.script, assets.field, assets.page}) {
        EXPECT_EQ(part.find("</script"), std::string_view::npos);
    }
}

}  // namespace
}  // namespace riffle
