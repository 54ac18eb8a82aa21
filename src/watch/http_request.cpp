#include "watch/http_request.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <memory>

namespace riffle::inline watch {

namespace {

constexpr std::string_view white = " \t";

/// The next line of a text, without its end; the text goes on behind it.
std::string_view next_line(std::string_view& text) {
    const std::size_t end = text.find('\n');
    std::string_view line = text.substr(0, end);
    text.remove_prefix(end == std::string_view::npos ? text.size() : end + 1);
    if (!line.empty() && line.back() == '\r') line.remove_suffix(1);
    return line;
}

bool is_token(std::string_view name) {
    return !name.empty() && std::all_of(name.begin(), name.end(), [](char c) {
        return std::isalnum(static_cast<unsigned char>(c)) != 0 ||
               std::string_view("!#$%&'*+-.^_`|~").find(c) != std::string_view::npos;
    });
}

bool is_printable(std::string_view text) {
    return std::all_of(text.begin(), text.end(),
                       [](char c) { return c == '\t' || static_cast<unsigned char>(c) >= ' '; });
}

bool same_name(std::string_view a, std::string_view lower) {
    return a.size() == lower.size() && std::equal(a.begin(), a.end(), lower.begin(), [](char x, char y) {
               return std::tolower(static_cast<unsigned char>(x)) == y;
           });
}

/// The line "METHOD /path?query HTTP/1.1"; 0, or the status of the fault.
int read_line(std::string_view line, HttpRequest& request) {
    const std::size_t first = line.find(' ');
    const std::size_t last = line.rfind(' ');
    if (first == std::string_view::npos || first == last || !is_printable(line)) return 400;
    const std::string_view target = line.substr(first + 1, last - first - 1);
    const std::string_view version = line.substr(last + 1);
    if (!is_token(line.substr(0, first)) || target.empty() || target.front() != '/' ||
        target.find(' ') != std::string_view::npos) {
        return 400;
    }
    if (version != "HTTP/1.1" && version != "HTTP/1.0") return version.starts_with("HTTP/") ? 505 : 400;
    request.method = line.substr(0, first);
    request.path = target.substr(0, target.find_first_of("?#"));
    return 0;
}

int read_headers(std::string_view lines, HttpRequest& request) {
    int hosts = 0;
    while (!lines.empty()) {
        const std::string_view line = next_line(lines);
        if (line.empty()) break;
        const std::size_t colon = line.find(':');
        if (colon == std::string_view::npos || !is_token(line.substr(0, colon)) || !is_printable(line)) {
            return 400;
        }
        std::string_view value = line.substr(colon + 1);
        value.remove_prefix(std::min(value.find_first_not_of(white), value.size()));
        value = value.substr(0, value.find_last_not_of(white) + 1);
        const std::string_view name = line.substr(0, colon);
        if (same_name(name, "host")) {
            // Two of them are no request that a browser makes.
            request.host = ++hosts == 1 ? std::string(value) : std::string();
        } else if (same_name(name, "if-none-match")) {
            request.known_revision = value;
        }
    }
    return 0;
}

const char* phrase(int status) {
    switch (status) {
        case 200:
            return "OK";
        case 304:
            return "Not Modified";
        case 400:
            return "Bad Request";
        case 403:
            return "Forbidden";
        case 404:
            return "Not Found";
        case 405:
            return "Method Not Allowed";
        case 414:
            return "URI Too Long";
        case 431:
            return "Request Header Fields Too Large";
        case 505:
            return "HTTP Version Not Supported";
        default:
            return "Internal Server Error";
    }
}

}  // namespace

RequestReading read_request(std::string_view received) {
    RequestReading reading;
    const std::size_t line_end = received.find('\n');
    const std::size_t end = std::min(received.find("\r\n\r\n"), received.find("\n\n"));
    // With the empty line, so that it does not matter in which pieces a request comes in.
    const std::size_t head =
        end == std::string_view::npos ? received.size() : end + (received[end] == '\r' ? 4 : 2);
    if (head > largest_request) {
        reading.complete = true;
        reading.fault = line_end > largest_request ? 414 : 431;
        return reading;
    }
    if (end == std::string_view::npos) return reading;
    reading.complete = true;
    std::string_view lines = received.substr(0, end + 2);
    reading.fault = read_line(next_line(lines), reading.request);
    if (reading.fault == 0) reading.fault = read_headers(lines, reading.request);
    return reading;
}

PageAnswer fault_answer(int status) {
    PageAnswer answer;
    answer.status = status;
    answer.content_type = "text/plain; charset=utf-8";
    answer.text = std::make_shared<const std::string>(fmt::format("{}.\n", phrase(status)));
    answer.body = *answer.text;
    return answer;
}

std::string head_of(const PageAnswer& answer) {
    std::string head =
        fmt::format("HTTP/1.1 {} {}\r\nConnection: close\r\n", answer.status, phrase(answer.status));
    for (const auto& [name, value] : page_headers) head += fmt::format("{}: {}\r\n", name, value);
    head += fmt::format("Cache-Control: {}\r\n", answer.revision.empty() ? "no-store" : "no-cache");
    if (!answer.revision.empty()) head += fmt::format("ETag: {}\r\n", answer.revision);
    if (answer.status == 405) head += "Allow: GET\r\n";
    if (answer.status != 304) {
        head += fmt::format("Content-Type: {}\r\nContent-Length: {}\r\n", answer.content_type,
                            answer.body.size());
    }
    return head + "\r\n";
}

}  // namespace riffle::inline watch
