#include "watch/page_server.hpp"

#include <fmt/format.h>
#include <netdb.h>
#include <netinet/in.h>
#include <sys/socket.h>
#include <unistd.h>

#include <cerrno>
#include <memory>
#include <string_view>
#include <system_error>

#include "base/error.hpp"
#include "watch/connections.hpp"

namespace riffle::inline watch {

namespace {

constexpr int ports_to_try = 20;

std::string in_brackets(const std::string& address) {
    return address.find(':') == std::string::npos ? address : "[" + address + "]";
}

int port_of(int socket) {
    sockaddr_storage address{};
    socklen_t length = sizeof address;
    if (::getsockname(socket, reinterpret_cast<sockaddr*>(&address), &length) != 0) return 0;
    return ntohs(address.ss_family == AF_INET6 ? reinterpret_cast<const sockaddr_in6&>(address).sin6_port
                                               : reinterpret_cast<const sockaddr_in&>(address).sin_port);
}

/// A socket that listens on a port of an address, 0: any; negative where that cannot be, with errno.
int listen_on(const std::string& address, int port) {
    addrinfo hints{};
    hints.ai_socktype = SOCK_STREAM;
    hints.ai_flags = AI_PASSIVE | AI_NUMERICSERV;
    addrinfo* found = nullptr;
    errno = 0;
    if (::getaddrinfo(address.c_str(), std::to_string(port).c_str(), &hints, &found) != 0) return -1;
    const std::unique_ptr<addrinfo, void (*)(addrinfo*)> list(found, ::freeaddrinfo);
    for (const addrinfo* place = found; place != nullptr; place = place->ai_next) {
        const int socket =
            ::socket(place->ai_family, place->ai_socktype | SOCK_NONBLOCK | SOCK_CLOEXEC, place->ai_protocol);
        if (socket < 0) continue;
        const int yes = 1;
        (void)::setsockopt(socket, SOL_SOCKET, SO_REUSEADDR, &yes, sizeof yes);
        if (::bind(socket, place->ai_addr, place->ai_addrlen) == 0 && ::listen(socket, SOMAXCONN) == 0) {
            return socket;
        }
        const int reason = errno;
        ::close(socket);
        errno = reason;
    }
    return -1;
}

}  // namespace

PageServer::PageServer(WatchSite& site, const std::string& address, std::optional<int> port)
    : site_(site), address_(address) {
    if (address.empty()) throw InputError("--listen: the address is empty; give one, for example 127.0.0.1");
    const int first = port.value_or(default_watch_port);
    const int last = port ? first : first + ports_to_try - 1;
    int tried = first;
    do {
        listener_ = listen_on(address, tried);
    } while (listener_ < 0 && errno == EADDRINUSE && ++tried <= last);
    if (listener_ >= 0) {
        port_ = port_of(listener_);
        return;
    }
    const int reason = errno;
    if (reason == EADDRINUSE && port) {
        throw InputError(
            fmt::format("--port {}: something else listens on this port of {} already, perhaps another "
                        "`riffle watch`; give another port, or leave out --port to take the next that is "
                        "free",
                        *port, address));
    }
    if (reason == EADDRINUSE) {
        throw InputError(
            fmt::format("all ports from {} to {} of {} are taken; give a free one with --port, or end some "
                        "of the other `riffle watch`",
                        default_watch_port, default_watch_port + ports_to_try - 1, address));
    }
    if (reason == EACCES) {
        throw InputError(
            fmt::format("--port {}: this user may not listen on it; take one above 1023", tried));
    }
    throw InputError(
        fmt::format("--listen {}: cannot listen on this address{}; give an address of this machine, "
                    "127.0.0.1 for this machine alone or 0.0.0.0 for all of its networks",
                    address, reason != 0 ? " (" + std::generic_category().message(reason) + ")" : ""));
}

PageServer::~PageServer() {
    if (listener_ >= 0) ::close(listener_);
}

std::string PageServer::url() const {
    const std::string host = address_ == "0.0.0.0" ? "127.0.0.1" : address_ == "::" ? "::1" : address_;
    return fmt::format("http://{}:{}/", in_brackets(host), port_);
}

void PageServer::serve(const std::function<bool()>& stop) {
    Connections connections(listener_, [this](const HttpRequest& request) {
        return site_.answer({request.method, request.path, request.host, request.known_revision});
    });
    while (!stop()) connections.serve_once();
}

}  // namespace riffle::inline watch
