#include "sweep/child_process.hpp"

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/wait.h>
#include <unistd.h>
#if defined(__linux__)
#include <sys/prctl.h>
#endif

#include <array>
#include <cerrno>
#include <csignal>
#include <cstdio>
#include <cstring>
#include <utility>

#include "base/error.hpp"

namespace riffle::inline sweep {

namespace {

void write_all(int pipe, const std::string& text) {
    std::size_t written = 0;
    while (written < text.size()) {
        const ssize_t count = ::write(pipe, text.data() + written, text.size() - written);
        if (count < 0 && errno != EINTR) {
            return;  // the parent is gone
        }
        written += count > 0 ? static_cast<std::size_t>(count) : 0;
    }
}

[[noreturn]] void run_child(const ChildProcess::Work& work, int pipe, pid_t parent) {
    (void)::setpgid(0, 0);
    // A parent that is gone must not end the run before it has written its checkpoint.
    (void)std::signal(SIGPIPE, SIG_IGN);
#if defined(__linux__)
    (void)::prctl(PR_SET_PDEATHSIG, SIGTERM);
#endif
    if (::getppid() != parent) ::_exit(static_cast<int>(ExitCode::run_failed));
    const int status = work([pipe](const std::string& text) { write_all(pipe, text); });
    // Not exit(): what the parent has buffered for its terminal is the parent's to write.
    ::_exit(status);
}

}  // namespace

ChildProcess::ChildProcess(const Work& work) {
    std::array<int, 2> ends{};
    if (::pipe(ends.data()) != 0) {
        throw RunError(fmt::format("no pipe to a further run: {}", std::strerror(errno)));
    }
    std::fflush(nullptr);
    const pid_t parent = ::getpid();
    process_ = ::fork();
    if (process_ == 0) {
        ::close(ends[0]);
        run_child(work, ends[1], parent);
    }
    const int reason = errno;
    ::close(ends[1]);
    pipe_ = ends[0];
    if (process_ < 0) {
        ::close(pipe_);
        throw RunError(
            fmt::format("no process for a further run: {}; try fewer with --jobs", std::strerror(reason)));
    }
    (void)::fcntl(pipe_, F_SETFL, O_NONBLOCK);
    (void)::fcntl(pipe_, F_SETFD, FD_CLOEXEC);
}

ChildProcess::~ChildProcess() {
    if (process_ > 0) {
        send(SIGTERM);
        while (::waitpid(process_, nullptr, 0) < 0 && errno == EINTR) {
        }
    }
    if (pipe_ >= 0) ::close(pipe_);
}

ChildProcess::ChildProcess(ChildProcess&& other) noexcept
    : process_(std::exchange(other.process_, -1)),
      pipe_(std::exchange(other.pipe_, -1)),
      status_(other.status_) {}

ChildProcess& ChildProcess::operator=(ChildProcess&& other) noexcept {
    std::swap(process_, other.process_);
    std::swap(pipe_, other.pipe_);
    std::swap(status_, other.status_);
    return *this;
}

std::string ChildProcess::heard() {
    std::string text;
    std::array<char, 4096> buffer{};
    while (true) {
        const ssize_t count = ::read(pipe_, buffer.data(), buffer.size());
        if (count > 0) {
            text.append(buffer.data(), static_cast<std::size_t>(count));
        } else if (count == 0 || errno != EINTR) {
            return text;
        }
    }
}

bool ChildProcess::ended() {
    if (process_ < 0) return true;
    int status = 0;
    if (::waitpid(process_, &status, WNOHANG) != process_) return false;
    process_ = -1;
    status_ = WIFEXITED(status) ? WEXITSTATUS(status) : 128 + WTERMSIG(status);
    return true;
}

void ChildProcess::send(int signal_number) {
    if (process_ > 0) (void)::kill(process_, signal_number);
}

}  // namespace riffle::inline sweep
