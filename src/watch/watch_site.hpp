#pragma once

#include <array>
#include <memory>
#include <string>
#include <string_view>
#include <utility>

#include "watch/host_check.hpp"
#include "watch/run_watcher.hpp"

namespace riffle::inline watch {

/// A request, as far as the page needs to know it.
struct PageRequest {
    std::string_view method;
    std::string_view path;            ///< without the query
    std::string_view host;            ///< the Host header
    std::string_view known_revision;  ///< the If-None-Match header
};

/// The answer to a request. The body lives as long as the answer.
struct PageAnswer {
    int status = 200;
    std::string_view content_type;
    std::string revision;  ///< ETag, with its quotes; empty: none, and nothing may be kept
    std::shared_ptr<const std::string> text;
    std::string_view body;
};

/// Headers of every answer: nothing from elsewhere is loaded, no other page may frame or read it, nothing
/// guessed. Plotly sets styles by attribute, so inline styles are allowed; inline scripts are not.
inline constexpr std::array<std::pair<const char*, const char*>, 5> page_headers = {{
    {"Content-Security-Policy",
     "default-src 'none'; script-src 'self'; style-src 'self' 'unsafe-inline'; connect-src 'self'; "
     "img-src data: blob:; base-uri 'none'; form-action 'none'; frame-ancestors 'none'"},
    {"X-Content-Type-Options", "nosniff"},
    {"Referrer-Policy", "no-referrer"},
    {"Cross-Origin-Resource-Policy", "same-origin"},
    {"Cross-Origin-Opener-Policy", "same-origin"},
}};

/// The site of `riffle watch`: a fixed list of paths. Nothing in a request names a file.
class WatchSite {
  public:
    /// `address`: what the server listens on.
    WatchSite(std::filesystem::path results, std::string_view address);

    /// Answer a request: 405 for any method but GET, 403 for a foreign Host, 404 for an unknown path, 304
    /// where the browser has the newest revision. From any thread.
    [[nodiscard]] PageAnswer answer(const PageRequest& request);

  private:
    RunWatcher watcher_;
    AllowedHosts hosts_;
};

}  // namespace riffle::inline watch
