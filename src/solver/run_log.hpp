#pragma once

#include <filesystem>
#include <memory>
#include <string>

namespace riffle::inline solver {

/// The log file of a run: lines with date, time and level; appended to on resume.
class RunLog {
  public:
    explicit RunLog(const std::filesystem::path& path);
    ~RunLog();
    RunLog(RunLog&&) noexcept;
    RunLog& operator=(RunLog&&) noexcept;
    RunLog(const RunLog&) = delete;
    RunLog& operator=(const RunLog&) = delete;

    void info(const std::string& line);
    void warning(const std::string& line);
    void error(const std::string& line);

  private:
    struct Impl;
    std::unique_ptr<Impl> impl_;
};

}  // namespace riffle::inline solver
