#include "report/page_assets.hpp"

// Ends of the embedded files, defined by the assembler listing that cmake/web.cmake writes.
extern "C" {
extern const char riffle_page_html_begin[];
extern const char riffle_page_html_end[];
extern const char riffle_page_style_begin[];
extern const char riffle_page_style_end[];
extern const char riffle_page_plotly_begin[];
extern const char riffle_page_plotly_end[];
extern const char riffle_page_figures_begin[];
extern const char riffle_page_figures_end[];
extern const char riffle_page_field_begin[];
extern const char riffle_page_field_end[];
extern const char riffle_page_script_begin[];
extern const char riffle_page_script_end[];
}

namespace riffle {

PageAssets page_assets() {
    return {{riffle_page_html_begin, riffle_page_html_end},
            {riffle_page_style_begin, riffle_page_style_end},
            {riffle_page_plotly_begin, riffle_page_plotly_end},
            {riffle_page_figures_begin, riffle_page_figures_end},
            {riffle_page_field_begin, riffle_page_field_end},
            {riffle_page_script_begin, riffle_page_script_end}};
}

}  // namespace riffle
