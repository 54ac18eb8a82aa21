#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace riffle::inline watch {

/// Whether an address to listen on is reached from this machine alone: 127.0.0.0/8, ::1, or "localhost".
[[nodiscard]] bool is_loopback(std::string_view address);

/// The names under which browsers may ask for the page, against DNS rebinding: a page of somewhere else can
/// have its own name resolve to this machine, but then its browser still names that name in the Host header.
class AllowedHosts {
  public:
    /// `address`: what the server listens on. On loopback: localhost and loopback addresses. Otherwise any
    /// numeric address (which nobody can rebind), the address as given and the machine's own name too.
    explicit AllowedHosts(std::string_view address);

    /// Whether a Host header ("name", "name:port", "[v6]:port") names this server. The port is not compared:
    /// it differs behind a tunnel.
    [[nodiscard]] bool allow(std::string_view host) const;

  private:
    bool loopback_;
    std::vector<std::string> names_;
};

}  // namespace riffle::inline watch
