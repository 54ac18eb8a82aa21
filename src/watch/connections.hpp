#pragma once

#include <chrono>
#include <condition_variable>
#include <cstdint>
#include <deque>
#include <functional>
#include <map>
#include <mutex>
#include <string>
#include <thread>
#include <utility>
#include <vector>

#include "watch/http_request.hpp"

namespace riffle::inline watch {

/// The connections of a web server, one request each. One thread looks after all of them, so that none can
/// keep the others waiting; answers, which may take long, are made by others. A request must come whole
/// within `patience`, and a reader must take something of its answer as often; where there are too many
/// connections the oldest gives way.
class Connections {
  public:
    using Answer = std::function<PageAnswer(const HttpRequest&)>;

    static constexpr std::size_t most = 64;
    static constexpr std::chrono::seconds patience = std::chrono::seconds(5);

    /// `listener`: a socket that listens and does not block; `answer` is called by several threads.
    Connections(int listener, Answer answer);
    ~Connections();
    Connections(const Connections&) = delete;
    Connections& operator=(const Connections&) = delete;

    /// Do what there is to do, waiting for it for a tenth of a second.
    void serve_once();

  private:
    using Clock = std::chrono::steady_clock;
    enum class State { reading, answering, writing, closing };
    struct Connection {
        int socket = -1;
        State state = State::reading;
        std::string received = {};
        std::string head = {};
        PageAnswer answer = {};
        std::size_t sent = 0;
        std::size_t ignored = 0;  ///< bytes that came after the request
        Clock::time_point deadline = {};
    };
    struct Made {
        std::uint64_t connection;
        PageAnswer answer;
    };

    void accept_new();
    void take_answers();
    /// Go on with a connection that is ready; false where it is at its end.
    bool go_on(std::uint64_t number, Connection& connection);
    bool read_more(std::uint64_t number, Connection& connection);
    static void begin_answer(Connection& connection, PageAnswer answer);
    static bool write_more(Connection& connection);
    static bool read_the_rest(Connection& connection);
    void close(std::uint64_t number);
    void make_answers();

    int listener_;
    Answer answer_;
    int wake_read_ = -1, wake_write_ = -1;             ///< a pipe: answers have been made
    std::map<std::uint64_t, Connection> connections_;  ///< by number: the oldest first
    std::uint64_t next_ = 0;

    std::mutex mutex_;  ///< of what follows
    std::condition_variable asked_;
    std::deque<std::pair<std::uint64_t, HttpRequest>> requests_;
    std::vector<Made> made_;
    bool ended_ = false;
    std::vector<std::jthread> threads_;
};

}  // namespace riffle::inline watch
