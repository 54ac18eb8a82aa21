#pragma once

#include <cstddef>
#include <string>
#include <string_view>

#include "watch/watch_site.hpp"

namespace riffle::inline watch {

/// Most bytes of a request, its line with all headers and the empty line: browsers send some hundred.
inline constexpr std::size_t largest_request = 8192;

/// A request as it came in.
struct HttpRequest {
    std::string method;
    std::string path;            ///< without the query
    std::string host;            ///< empty where there is none, or more than one
    std::string known_revision;  ///< the If-None-Match header
};

/// What has been received of a request.
struct RequestReading {
    bool complete = false;  ///< no more bytes are needed
    int fault = 0;          ///< status of the answer to what is no request, or one that is too long; else 0
    HttpRequest request = {};
};

/// Take apart the head of a request (RFC 9112) from the bytes received so far. A body is not looked at.
[[nodiscard]] RequestReading read_request(std::string_view received);

/// The answer to what is no request.
[[nodiscard]] PageAnswer fault_answer(int status);

/// Status line and headers of an answer, after which the connection is closed.
[[nodiscard]] std::string head_of(const PageAnswer& answer);

}  // namespace riffle::inline watch
