#include "solver/run_log.hpp"

#include <spdlog/logger.h>
#include <spdlog/sinks/basic_file_sink.h>

#include "base/error.hpp"
#include "base/visible_text.hpp"

namespace riffle {

struct RunLog::Impl {
    spdlog::logger logger;
};

RunLog::RunLog(const std::filesystem::path& path) {
    try {
        auto sink = std::make_shared<spdlog::sinks::basic_file_sink_st>(path.string());
        impl_ = std::make_unique<Impl>(Impl{spdlog::logger("run", std::move(sink))});
    } catch (const spdlog::spdlog_ex& e) {
        throw FileError("cannot write the log " + path.string() + ": " + e.what() +
                        "; choose a folder you may write to with -o");
    }
    impl_->logger.set_pattern("%Y-%m-%d %H:%M:%S %^%-7l%$ %v");
    impl_->logger.flush_on(spdlog::level::info);
    // A full disk must not stop the run through its log: the results report it.
    impl_->logger.set_error_handler([](const std::string&) {});
}

RunLog::~RunLog() = default;
RunLog::RunLog(RunLog&&) noexcept = default;
RunLog& RunLog::operator=(RunLog&&) noexcept = default;

void RunLog::info(const std::string& line) { impl_->logger.info("{}", visible_text(line, "\n\t")); }
void RunLog::warning(const std::string& line) { impl_->logger.warn("{}", visible_text(line, "\n\t")); }
void RunLog::error(const std::string& line) { impl_->logger.error("{}", visible_text(line, "\n\t")); }

}  // namespace riffle
