#include "solver/run_log.hpp"

#include <fcntl.h>
#include <spdlog/logger.h>
#include <spdlog/sinks/basic_file_sink.h>

#include <system_error>
#include <utility>

#include "base/error.hpp"
#include "base/memory.hpp"
#include "base/visible_text.hpp"
#include "output/file_descriptor.hpp"

namespace riffle::inline solver {

struct RunLog::Impl {
    explicit Impl(spdlog::logger opened) : logger(std::move(opened)) {}
    ~Impl() { OutOfMemoryEnd::tell_in(-1); }
    Impl(const Impl&) = delete;
    Impl& operator=(const Impl&) = delete;

    spdlog::logger logger;
    FileDescriptor last_words;  ///< for the line of a process that gets no more memory
};

RunLog::RunLog(const std::filesystem::path& path) {
    try {
        auto sink = std::make_shared<spdlog::sinks::basic_file_sink_st>(path.string());
        impl_ = std::make_unique<Impl>(spdlog::logger("run", std::move(sink)));
    } catch (const spdlog::spdlog_ex& e) {
        throw FileError("cannot write the log " + path.string() + ": " + e.what() +
                        "; choose a folder you may write to with -o");
    }
    impl_->logger.set_pattern("%Y-%m-%d %H:%M:%S %^%-7l%$ %v");
    impl_->logger.flush_on(spdlog::level::info);
    try {
        impl_->last_words = FileDescriptor(path, O_WRONLY | O_APPEND);
        OutOfMemoryEnd::tell_in(impl_->last_words.get());
    } catch (const std::system_error&) {
        // The message then goes to the terminal alone.
    }
    // A full disk must not stop the run through its log: the results report it.
    impl_->logger.set_error_handler([](const std::string&) {});
}

RunLog::~RunLog() = default;
RunLog::RunLog(RunLog&&) noexcept = default;
RunLog& RunLog::operator=(RunLog&&) noexcept = default;

void RunLog::info(const std::string& line) { impl_->logger.info("{}", visible_text(line, "\n\t")); }
void RunLog::warning(const std::string& line) { impl_->logger.warn("{}", visible_text(line, "\n\t")); }
void RunLog::error(const std::string& line) { impl_->logger.error("{}", visible_text(line, "\n\t")); }

}  // namespace riffle::inline solver
