#include "report/page_assets.hpp"

#include <initializer_list>

// Ends of the embedded files, defined by the assembler listing that cmake/web.cmake writes.
extern "C" {
extern const char riffle_page_report_html_begin[];
extern const char riffle_page_report_html_end[];
extern const char riffle_page_comparison_html_begin[];
extern const char riffle_page_comparison_html_end[];
extern const char riffle_page_style_begin[];
extern const char riffle_page_style_end[];
extern const char riffle_page_plotly_begin[];
extern const char riffle_page_plotly_end[];
extern const char riffle_page_shared_begin[];
extern const char riffle_page_shared_end[];
extern const char riffle_page_field_begin[];
extern const char riffle_page_field_end[];
extern const char riffle_page_moving_surface_begin[];
extern const char riffle_page_moving_surface_end[];
extern const char riffle_page_report_begin[];
extern const char riffle_page_report_end[];
extern const char riffle_page_comparison_begin[];
extern const char riffle_page_comparison_end[];
}

namespace riffle::inline report {

namespace {

std::string joined(std::initializer_list<std::string_view> scripts) {
    std::string text;
    for (const std::string_view script : scripts) text.append(script).append("\n");
    return text;
}

}  // namespace

PageAssets page_assets() {
    const std::string_view shared{riffle_page_shared_begin, riffle_page_shared_end};
    return {{riffle_page_report_html_begin, riffle_page_report_html_end},
            {riffle_page_comparison_html_begin, riffle_page_comparison_html_end},
            {riffle_page_style_begin, riffle_page_style_end},
            {riffle_page_plotly_begin, riffle_page_plotly_end},
            joined({shared,
                    {riffle_page_field_begin, riffle_page_field_end},
                    {riffle_page_moving_surface_begin, riffle_page_moving_surface_end},
                    {riffle_page_report_begin, riffle_page_report_end}}),
            joined({shared, {riffle_page_comparison_begin, riffle_page_comparison_end}}),
            joined({shared}),
            {riffle_page_field_begin, riffle_page_field_end}};
}

}  // namespace riffle::inline report
