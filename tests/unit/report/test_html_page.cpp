#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>
#include <stdexcept>
#include <string>

#include "base/markup.hpp"
#include "report/html_page.hpp"
#include "report/page_assets.hpp"

namespace riffle::html_page_test {
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
    for (const std::string_view page : {assets.report, assets.comparison}) {
        EXPECT_THAT(std::string(page), ::testing::StartsWith("<!DOCTYPE html>"));
        EXPECT_THAT(std::string(page), ::testing::EndsWith("</html>\n"));
        // Nothing from outside can be loaded or run.
        EXPECT_THAT(std::string(page), HasSubstr("default-src 'none'"));
    }
    EXPECT_GT(assets.plotly.size(), 500'000U);
    const std::string_view report_script = assets.report_script;
    const std::string_view comparison_script = assets.comparison_script;
    for (const std::string_view part :
         {assets.report, assets.comparison, assets.style, report_script, comparison_script}) {
        EXPECT_FALSE(part.empty());
        EXPECT_THAT(std::string(part), Not(HasSubstr("http:")));
        EXPECT_THAT(std::string(part), Not(HasSubstr("https:")));
    }
    // Scripts stand inside a script block of the page.
    for (const std::string_view part : {assets.plotly, report_script, comparison_script}) {
        EXPECT_EQ(part.find("</script"), std::string_view::npos);
    }
}

}  // namespace
}  // namespace riffle::html_page_test
