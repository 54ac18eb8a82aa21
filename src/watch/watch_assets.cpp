#include "watch/watch_assets.hpp"

// Ends of the embedded files, defined by the assembler listing that cmake/web.cmake writes.
extern "C" {
extern const char riffle_watch_html_begin[];
extern const char riffle_watch_html_end[];
extern const char riffle_watch_style_begin[];
extern const char riffle_watch_style_end[];
extern const char riffle_watch_script_begin[];
extern const char riffle_watch_script_end[];
}

namespace riffle::inline watch {

WatchAssets watch_assets() {
    return {{riffle_watch_html_begin, riffle_watch_html_end},
            {riffle_watch_style_begin, riffle_watch_style_end},
            {riffle_watch_script_begin, riffle_watch_script_end}};
}

}  // namespace riffle::inline watch
