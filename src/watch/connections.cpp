#include "watch/connections.hpp"

#include <fcntl.h>
#include <poll.h>
#include <sys/socket.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <exception>
#include <system_error>

namespace riffle::inline watch {

namespace {

constexpr std::size_t answering_threads = 4;
constexpr int wait_milliseconds = 100;

/// What is taken of a body that nobody asked for before the connection is cut.
constexpr std::size_t ignored_bytes = std::size_t{64} << 10U;

bool is_only_busy(int error) { return error == EAGAIN || error == EWOULDBLOCK || error == EINTR; }

}  // namespace

Connections::Connections(int listener, Answer answer) : listener_(listener), answer_(std::move(answer)) {
    std::array<int, 2> ends{};
    if (::pipe2(ends.data(), O_NONBLOCK | O_CLOEXEC) != 0) {
        throw std::system_error(errno, std::generic_category(), "no pipe for the web server");
    }
    wake_read_ = ends[0];
    wake_write_ = ends[1];
    for (std::size_t n = 0; n < answering_threads; ++n) threads_.emplace_back([this] { make_answers(); });
}

Connections::~Connections() {
    {
        const std::lock_guard lock(mutex_);
        ended_ = true;
    }
    asked_.notify_all();
    threads_.clear();
    for (const auto& [number, connection] : connections_) ::close(connection.socket);
    ::close(wake_read_);
    ::close(wake_write_);
}

void Connections::make_answers() {
    while (true) {
        std::pair<std::uint64_t, HttpRequest> request;
        {
            std::unique_lock lock(mutex_);
            asked_.wait(lock, [&] { return ended_ || !requests_.empty(); });
            if (ended_) return;
            request = std::move(requests_.front());
            requests_.pop_front();
        }
        Made made{.connection = request.first, .answer = {}};
        try {
            made.answer = answer_(request.second);
        } catch (const std::exception&) {
            made.answer = fault_answer(500);
        }
        {
            const std::lock_guard lock(mutex_);
            made_.push_back(std::move(made));
        }
        // A pipe that is full wakes the other end too.
        (void)!::write(wake_write_, "x", 1);
    }
}

void Connections::take_answers() {
    std::array<char, 64> bytes{};
    while (::read(wake_read_, bytes.data(), bytes.size()) > 0) {
    }
    std::vector<Made> made;
    {
        const std::lock_guard lock(mutex_);
        made.swap(made_);
    }
    for (Made& one : made) {
        const auto found = connections_.find(one.connection);
        if (found == connections_.end()) continue;
        begin_answer(found->second, std::move(one.answer));
        if (!write_more(found->second)) close(one.connection);
    }
}

void Connections::accept_new() {
    while (true) {
        const int socket = ::accept4(listener_, nullptr, nullptr, SOCK_NONBLOCK | SOCK_CLOEXEC);
        if (socket < 0) return;
        if (connections_.size() >= most) {
            // Those that wait for an answer of ours are not to blame.
            const auto oldest = std::find_if(connections_.begin(), connections_.end(), [](const auto& entry) {
                return entry.second.state != State::answering;
            });
            if (oldest == connections_.end()) {
                ::close(socket);
                return;
            }
            close(oldest->first);
        }
        connections_[next_++] = {.socket = socket, .deadline = Clock::now() + patience};
    }
}

void Connections::close(std::uint64_t number) {
    const auto found = connections_.find(number);
    if (found == connections_.end()) return;
    ::close(found->second.socket);
    connections_.erase(found);
}

void Connections::serve_once() {
    std::vector<pollfd> sockets = {{listener_, POLLIN, 0}, {wake_read_, POLLIN, 0}};
    std::vector<std::uint64_t> numbers;
    for (const auto& [number, connection] : connections_) {
        if (connection.state == State::answering) continue;
        const bool writing = connection.state == State::writing;
        sockets.push_back({connection.socket, static_cast<short>(writing ? POLLOUT : POLLIN), 0});
        numbers.push_back(number);
    }
    if (::poll(sockets.data(), sockets.size(), wait_milliseconds) < 0 && errno != EINTR) {
        throw std::system_error(errno, std::generic_category(), "the web server");
    }
    for (std::size_t i = 0; i < numbers.size(); ++i) {
        if (sockets[i + 2].revents == 0) continue;
        const auto found = connections_.find(numbers[i]);
        if (found != connections_.end() && !go_on(found->first, found->second)) close(numbers[i]);
    }
    take_answers();
    if (sockets[0].revents != 0) accept_new();
    const Clock::time_point now = Clock::now();
    for (auto entry = connections_.begin(); entry != connections_.end();) {
        const auto number = entry->first;
        const bool late = entry->second.state != State::answering && now > entry->second.deadline;
        ++entry;
        if (late) close(number);
    }
}

bool Connections::go_on(std::uint64_t number, Connection& connection) {
    switch (connection.state) {
        case State::reading:
            return read_more(number, connection);
        case State::writing:
            return write_more(connection);
        case State::closing:
            return read_the_rest(connection);
        case State::answering:
            break;
    }
    return true;
}

bool Connections::read_more(std::uint64_t number, Connection& connection) {
    std::array<char, 2048> bytes{};
    const ssize_t count = ::recv(connection.socket, bytes.data(), bytes.size(), 0);
    if (count < 0) return is_only_busy(errno);
    if (count == 0) return false;
    connection.received.append(bytes.data(), static_cast<std::size_t>(count));
    RequestReading reading = read_request(connection.received);
    if (!reading.complete) return true;
    connection.received = {};
    if (reading.fault != 0) {
        begin_answer(connection, fault_answer(reading.fault));
        return write_more(connection);
    }
    connection.state = State::answering;
    {
        const std::lock_guard lock(mutex_);
        requests_.emplace_back(number, std::move(reading.request));
    }
    asked_.notify_one();
    return true;
}

void Connections::begin_answer(Connection& connection, PageAnswer answer) {
    connection.head = head_of(answer);
    connection.answer = std::move(answer);
    connection.state = State::writing;
    connection.deadline = Clock::now() + patience;
}

bool Connections::write_more(Connection& connection) {
    const std::string_view head = connection.head;
    const std::string_view body = connection.answer.body;
    while (connection.sent < head.size() + body.size()) {
        const std::string_view rest = connection.sent < head.size()
                                          ? head.substr(connection.sent)
                                          : body.substr(connection.sent - head.size());
        const ssize_t count = ::send(connection.socket, rest.data(), rest.size(), MSG_NOSIGNAL);
        if (count < 0) return is_only_busy(errno);
        connection.sent += static_cast<std::size_t>(count);
        connection.deadline = Clock::now() + patience;
    }
    // A connection that is closed with bytes unread takes the answer with it.
    (void)::shutdown(connection.socket, SHUT_WR);
    connection.state = State::closing;
    return true;
}

bool Connections::read_the_rest(Connection& connection) {
    std::array<char, 4096> bytes{};
    const ssize_t count = ::recv(connection.socket, bytes.data(), bytes.size(), 0);
    if (count < 0) return is_only_busy(errno);
    connection.ignored += static_cast<std::size_t>(count);
    return count > 0 && connection.ignored <= ignored_bytes;
}

}  // namespace riffle::inline watch
