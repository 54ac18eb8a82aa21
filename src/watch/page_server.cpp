#include "watch/page_server.hpp"

#include <fmt/format.h>
#include <httplib.h>
#include <sys/socket.h>

#include <atomic>
#include <cerrno>
#include <chrono>
#include <string_view>
#include <system_error>
#include <thread>

#include "base/error.hpp"

namespace riffle {

namespace {

constexpr int ports_to_try = 20;
constexpr std::size_t threads = 4;
constexpr int patience = 5;  ///< with a slow reader or writer, s

std::string header(const httplib::Request& request, const char* name) {
    return request.get_header_value(name);
}

void fill(const PageAnswer& answer, httplib::Response& response) {
    response.status = answer.status;
    for (const auto& [name, value] : page_headers) response.set_header(name, value);
    response.set_header("Cache-Control", answer.revision.empty() ? "no-store" : "no-cache");
    if (!answer.revision.empty()) response.set_header("ETag", answer.revision);
    if (answer.status == 405) response.set_header("Allow", "GET");
    if (answer.body.empty()) return;
    // As a provider of known length the body is neither copied nor compressed.
    response.set_content_provider(answer.body.size(), std::string(answer.content_type),
                                  [answer](std::size_t from, std::size_t length, httplib::DataSink& sink) {
                                      return sink.write(answer.body.data() + from, length);
                                  });
}

std::string in_brackets(const std::string& address) {
    return address.find(':') == std::string::npos ? address : "[" + address + "]";
}

}  // namespace

struct PageServer::Impl {
    httplib::Server server;
};

PageServer::PageServer(WatchSite& site, const std::string& address, std::optional<int> port)
    : impl_(std::make_unique<Impl>()), address_(address) {
    // The library takes an empty address for all of this machine's.
    if (address.empty()) throw InputError("--listen: the address is empty; give one, for example 127.0.0.1");
    httplib::Server& server = impl_->server;
    // The library takes charge of the pool.
    server.new_task_queue = [] { return std::make_unique<httplib::ThreadPool>(threads).release(); };
    server.set_keep_alive_max_count(1);
    server.set_read_timeout(patience);
    server.set_write_timeout(patience);
    server.set_payload_max_length(0);
    // Without SO_REUSEPORT, which the library sets and with which two servers could share a port unawares.
    server.set_socket_options([](socket_t socket) {
        const int yes = 1;
        setsockopt(socket, SOL_SOCKET, SO_REUSEADDR, &yes, sizeof yes);
    });
    server.set_pre_routing_handler([&site](const httplib::Request& request, httplib::Response& response) {
        // Two Host headers are no request that a browser makes.
        const std::string host = request.get_header_value_count("Host") == 1 ? header(request, "Host") : "";
        const std::string known = header(request, "If-None-Match");
        fill(site.answer({request.method, request.path, host, known}), response);
        return httplib::Server::HandlerResponse::Handled;
    });

    errno = 0;
    if (port && *port == 0) {
        port_ = server.bind_to_any_port(address);
        if (port_ > 0) return;
    } else {
        const int first = port.value_or(default_watch_port), last = port ? first : first + ports_to_try - 1;
        for (port_ = first; port_ <= last; ++port_) {
            errno = 0;
            if (server.bind_to_port(address, port_)) return;
            if (errno != EADDRINUSE) break;
        }
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
            fmt::format("--port {}: this user may not listen on it; take one above 1023", port_));
    }
    throw InputError(
        fmt::format("--listen {}: cannot listen on this address{}; give an address of this machine, "
                    "127.0.0.1 for this machine alone or 0.0.0.0 for all of its networks",
                    address, reason != 0 ? " (" + std::generic_category().message(reason) + ")" : ""));
}

PageServer::~PageServer() = default;

std::string PageServer::url() const {
    const std::string host = address_ == "0.0.0.0" ? "127.0.0.1" : address_ == "::" ? "::1" : address_;
    return fmt::format("http://{}:{}/", in_brackets(host), port_);
}

void PageServer::serve(const std::function<bool()>& stop) {
    std::atomic<bool> ended = false;
    std::jthread listener([&] {
        impl_->server.listen_after_bind();
        ended = true;
    });
    while (!ended && !stop()) std::this_thread::sleep_for(std::chrono::milliseconds(100));
    const bool by_itself = ended;
    // A server that has not begun to listen yet does not hear the first call.
    while (!ended) {
        impl_->server.stop();
        std::this_thread::sleep_for(std::chrono::milliseconds(10));
    }
    if (by_itself)
        throw RunError("the web server has ended: the system no longer accepts connections on its port");
}

}  // namespace riffle
