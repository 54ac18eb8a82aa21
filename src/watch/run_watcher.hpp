#pragma once

#include <chrono>
#include <cstdint>
#include <filesystem>
#include <memory>
#include <mutex>
#include <optional>
#include <string>

#include "watch/progress.hpp"
#include "watch/run_state.hpp"

namespace riffle::inline watch {

/// The results file that `path` means, whether it exists or not: itself if it names a .h5 file, else
/// results.h5 in it.
[[nodiscard]] std::filesystem::path results_file_to_watch(const std::filesystem::path& path);

/// What the page shows of one version of the results file.
struct WatchData {
    std::string revision;                     ///< names the version; no two versions share one
    std::shared_ptr<const std::string> json;  ///< `progress` and `report` (the report's data), or `error`
};

/// Follows a results file: reads each version of it once, and not again while it does not change; a file that
/// takes long to read less often, so that reading takes at most a tenth of the time. To be called from any
/// thread.
class RunWatcher {
  public:
    explicit RunWatcher(std::filesystem::path results);

    /// How the run stands now, JSON: `state`, `reason`, `revision` of the newest data, `age` of the results
    /// file (s), `write_interval` (s), `log` (its last lines), `results` (path).
    [[nodiscard]] std::string status_json();

    /// The newest data; of a file that is missing or cannot be read, the reason.
    [[nodiscard]] WatchData data();

  private:
    using Clock = std::chrono::steady_clock;
    /// What tells versions of a file apart, each being a file of its own renamed into place.
    struct Version {
        std::uint64_t device = 0, file = 0, size = 0;
        std::int64_t changed = 0;  ///< ns
        bool operator==(const Version&) const = default;
    };

    void refresh();
    void read();
    [[nodiscard]] static std::optional<Version> version_of(const std::filesystem::path& file);

    std::mutex mutex_;
    std::filesystem::path results_;
    std::optional<Version> version_;
    bool looked_ = false;
    WatchData data_;
    std::optional<Progress> progress_, earlier_;
    double write_interval_ = 60.0;
    Clock::time_point next_reading_ = Clock::now();
};

}  // namespace riffle::inline watch
