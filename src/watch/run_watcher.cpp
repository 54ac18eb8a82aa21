#include "watch/run_watcher.hpp"

#include <fmt/format.h>
#include <sys/stat.h>

#include <algorithm>
#include <exception>
#include <iterator>
#include <nlohmann/json.hpp>
#include <set>
#include <system_error>
#include <utility>

#include "analysis/analysis_json.hpp"
#include "analysis/chapters.hpp"
#include "analysis/run_record.hpp"
#include "base/error.hpp"
#include "output/folder_lock.hpp"
#include "report/report_data.hpp"
#include "report/report_json.hpp"

namespace riffle::inline watch {

namespace {

namespace fs = std::filesystem;
using Json = nlohmann::ordered_json;

/// Times as long as a reading took until the next may begin.
constexpr double rest_per_reading = 9.0;

/// Readings in a row for one in which the file is not replaced meanwhile.
constexpr int most_readings = 3;

std::string dump(const Json& object) { return object.dump(-1, ' ', false, Json::error_handler_t::replace); }

std::optional<double> age_of(const fs::path& file) {
    std::error_code error;
    const auto written = fs::last_write_time(file, error);
    if (error) return std::nullopt;
    const std::chrono::duration<double> age = fs::file_time_type::clock::now() - written;
    return std::max(0.0, age.count());
}

std::shared_ptr<const std::string> error_json(const std::string& message) {
    return std::make_shared<const std::string>(dump({{"error", message}}));
}

/// The chapters that follow a run as it goes; the others need its end to be worth their time.
Analysis watched_analysis(const RunRecord& record) {
    Analysis analysis;
    analysis.name = record.name();
    analysis.source = record.source();
    const std::set<std::string> followed = {"course", "along", "statistics", "profiles", "particles"};
    for (const Chapter& chapter : analysis_chapters()) {
        if (followed.count(chapter.name) == 0 || !applies(chapter, record)) continue;
        Analysis part = analyse(record, chapter.name);
        std::move(part.findings.begin(), part.findings.end(), std::back_inserter(analysis.findings));
        std::move(part.figures.begin(), part.figures.end(), std::back_inserter(analysis.figures));
    }
    return analysis;
}

}  // namespace

fs::path results_file_to_watch(const fs::path& path) {
    std::error_code error;
    if (path.extension() == ".h5" && !fs::is_directory(path, error)) return path;
    return path / "results.h5";
}

RunWatcher::RunWatcher(fs::path results) : results_(std::move(results)) {}

std::optional<RunWatcher::Version> RunWatcher::version_of(const fs::path& file) {
    struct stat facts {};
    if (stat(file.c_str(), &facts) != 0) return std::nullopt;
    return Version{facts.st_dev, facts.st_ino, static_cast<std::uint64_t>(facts.st_size),
                   std::int64_t{facts.st_mtim.tv_sec} * 1'000'000'000 + facts.st_mtim.tv_nsec};
}

void RunWatcher::read() {
    for (int reading = 1;; ++reading) {
        version_ = version_of(results_);
        if (!version_) {
            data_ = {"none", std::make_shared<const std::string>("{}")};
            progress_.reset();
            return;
        }
        data_.revision = fmt::format("{:x}-{:x}-{:x}-{:x}", version_->device, version_->file, version_->size,
                                     version_->changed);
        std::optional<Progress> progress;
        try {
            const RunRecord record(results_);
            const ReportData report = collect_report_data(record.results(), FieldFrames::last);
            const Analysis analysis = watched_analysis(record);
            progress = read_progress(record.results(), report);
            const auto& before = progress_ && progress_->steps != progress->steps ? progress_ : earlier_;
            data_.json = std::make_shared<const std::string>(fmt::format(
                R"({{"title":{},"progress":{},"report":{},"analyses":{}}})", dump(Json(report.title)),
                progress_json(*progress, before), page_json(report, analysis), analysis_to_json({analysis})));
        } catch (const Error& error) {
            data_.json = error_json(error.what());
        } catch (const std::exception& error) {
            data_.json = error_json(
                fmt::format("{}: reading the results failed: {}", results_.string(), error.what()));
        }
        // The report and the progress are read one after the other, and should be of one file.
        if (version_of(results_) != version_ && reading < most_readings) continue;
        if (progress_ && progress && progress_->steps != progress->steps) earlier_ = progress_;
        progress_ = progress;
        return;
    }
}

void RunWatcher::refresh() {
    const auto version = version_of(results_);
    if (looked_ && version == version_) return;
    if (looked_ && version && Clock::now() < next_reading_) return;
    const auto start = Clock::now();
    read();
    looked_ = true;
    next_reading_ =
        Clock::now() + std::chrono::duration_cast<Clock::duration>(rest_per_reading * (Clock::now() - start));
    if (!progress_) return;
    write_interval_ = progress_->checkpoint_interval;
    // A run writes less often where writing takes long: its own clock tells.
    if (earlier_) {
        write_interval_ = std::max(write_interval_, progress_->wall_seconds - earlier_->wall_seconds);
    }
}

std::string RunWatcher::status_json() {
    const std::lock_guard lock(mutex_);
    refresh();
    // A copy of the results under another name has no log of its own.
    const bool in_place = results_.filename() == "results.h5";
    const fs::path log = results_.parent_path() / "run.log";
    RunSigns signs;
    signs.results = version_.has_value();
    signs.complete = progress_ && progress_->complete;
    if (in_place) signs.log = last_line_of(log);
    if (in_place) signs.lock = FolderLock::standing(folder_of(results_), FolderLock::Work::run);
    signs.seconds_since_write = age_of(results_);
    signs.write_interval = write_interval_;
    const RunStanding standing = judge_state(signs);
    return dump({{"state", word(standing.state)},
                 {"reason", standing.reason},
                 {"revision", data_.revision},
                 {"age", signs.seconds_since_write ? Json(*signs.seconds_since_write) : Json(nullptr)},
                 {"write_interval", write_interval_},
                 {"log", in_place ? last_lines_of(log, 12) : std::vector<std::string>()},
                 {"results", results_.string()}});
}

WatchData RunWatcher::data() {
    const std::lock_guard lock(mutex_);
    refresh();
    return data_;
}

}  // namespace riffle::inline watch
