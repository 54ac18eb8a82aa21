#include "watch/host_check.hpp"

#include <arpa/inet.h>
#include <netinet/in.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cctype>
#include <optional>

namespace riffle::inline watch {

namespace {

std::string lower(std::string_view text) {
    std::string result(text);
    std::transform(result.begin(), result.end(), result.begin(),
                   [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
    return result;
}

std::optional<in_addr> numeric_v4(const std::string& text) {
    in_addr address{};
    if (inet_pton(AF_INET, text.c_str(), &address) != 1) return std::nullopt;
    return address;
}

std::optional<in6_addr> numeric_v6(const std::string& text) {
    in6_addr address{};
    if (inet_pton(AF_INET6, text.c_str(), &address) != 1) return std::nullopt;
    return address;
}

bool is_numeric(const std::string& text) { return numeric_v4(text) || numeric_v6(text); }

std::string machine_name() {
    std::array<char, 256> name{};
    return gethostname(name.data(), name.size() - 1) == 0 ? std::string(name.data()) : std::string{};
}

/// The name in a Host header, without brackets and port; nothing if it is not of that form.
std::optional<std::string> name_of(std::string_view host) {
    std::string_view name = host, rest;
    if (!host.empty() && host.front() == '[') {
        const std::size_t close = host.find(']');
        if (close == std::string_view::npos) return std::nullopt;
        name = host.substr(1, close - 1);
        rest = host.substr(close + 1);
        if (!numeric_v6(std::string(name))) return std::nullopt;
    } else if (const std::size_t colon = host.find(':'); colon != std::string_view::npos) {
        name = host.substr(0, colon);
        rest = host.substr(colon);
    }
    if (!rest.empty()) {
        if (rest.front() != ':') return std::nullopt;
        rest.remove_prefix(1);
        const bool digits =
            std::all_of(rest.begin(), rest.end(), [](char c) { return c >= '0' && c <= '9'; });
        if (rest.empty() || rest.size() > 5 || !digits) return std::nullopt;
    }
    if (name.empty()) return std::nullopt;
    return lower(name);
}

}  // namespace

bool is_loopback(std::string_view address) {
    const std::string name = lower(address);
    if (name == "localhost") return true;
    if (const auto v4 = numeric_v4(name)) return ntohl(v4->s_addr) >> 24U == 127;
    const auto v6 = numeric_v6(name);
    return v6 && IN6_IS_ADDR_LOOPBACK(&*v6);
}

AllowedHosts::AllowedHosts(std::string_view address) : loopback_(is_loopback(address)) {
    if (loopback_) return;
    for (const std::string& name : {lower(address), lower(machine_name())}) {
        if (!name.empty()) names_.push_back(name);
    }
}

bool AllowedHosts::allow(std::string_view host) const {
    const auto name = name_of(host);
    if (!name) return false;
    if (is_loopback(*name)) return true;
    if (loopback_) return false;
    return is_numeric(*name) || std::find(names_.begin(), names_.end(), *name) != names_.end();
}

}  // namespace riffle::inline watch
