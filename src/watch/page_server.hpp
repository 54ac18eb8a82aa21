#pragma once

#include <functional>
#include <optional>
#include <string>

#include "watch/watch_site.hpp"

namespace riffle::inline watch {

/// Port of `riffle watch` unless another is asked for.
inline constexpr int default_watch_port = 8437;

/// The web server of a site: HTTP/1.1, GET only, a connection per request.
class PageServer {
  public:
    /// Take hold of a port of an address; from then on browsers may connect. Without `port`:
    /// default_watch_port, or the next of twenty that is free; 0: any free one. Throws InputError where that
    /// cannot be, naming what to do.
    PageServer(WatchSite& site, const std::string& address, std::optional<int> port);
    ~PageServer();
    PageServer(const PageServer&) = delete;
    PageServer& operator=(const PageServer&) = delete;
    PageServer(PageServer&&) = delete;
    PageServer& operator=(PageServer&&) = delete;

    [[nodiscard]] int port() const { return port_; }

    /// Address of the page for a browser on this machine.
    [[nodiscard]] std::string url() const;

    /// Answer requests until `stop` says so; it is asked ten times a second.
    void serve(const std::function<bool()>& stop);

  private:
    WatchSite& site_;
    std::string address_;
    int listener_ = -1;
    int port_ = 0;
};

}  // namespace riffle::inline watch
