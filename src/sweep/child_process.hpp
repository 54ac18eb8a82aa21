#pragma once

#include <sys/types.h>
#include <functional>
#include <string>

namespace riffle::inline sweep {

/// Work done in a process of its own, which tells the parent by lines of text how it gets on.
///
/// The child is a fork of this process, so `work` sees what the parent has read, and the parent must not have
/// started threads before. It is in a process group of its own, so that Ctrl-C reaches the parent alone,
/// which passes it on once; it gets SIGTERM when the parent dies.
class ChildProcess {
  public:
    using Tell = std::function<void(const std::string& text)>;
    /// Returns the exit status; must not throw.
    using Work = std::function<int(const Tell& tell)>;

    /// Throws RunError where the system has no process left.
    explicit ChildProcess(const Work& work);
    ~ChildProcess();
    ChildProcess(ChildProcess&& other) noexcept;
    ChildProcess& operator=(ChildProcess&& other) noexcept;
    ChildProcess(const ChildProcess&) = delete;
    ChildProcess& operator=(const ChildProcess&) = delete;

    /// What the child has told since the last call; does not wait.
    [[nodiscard]] std::string heard();

    /// Whether the child has ended; does not wait.
    [[nodiscard]] bool ended();

    /// Exit status of an ended child; 128 + n where signal n ended it.
    [[nodiscard]] int status() const { return status_; }

    /// Send a signal, unless it has ended.
    void send(int signal_number);

  private:
    pid_t process_ = -1;  ///< -1: ended
    int pipe_ = -1;
    int status_ = 0;
};

}  // namespace riffle::inline sweep
