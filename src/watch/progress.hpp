#pragma once

#include <cstdint>
#include <optional>
#include <string>

#include "record/run_results.hpp"
#include "report/report_data.hpp"

namespace riffle::inline watch {

/// How far a run has come, from its results file. SI.
struct Progress {
    bool complete = false;
    double time = 0.0;                   ///< simulated, s
    double end_time = 0.0;               ///< latest end, s
    std::optional<double> earliest_end;  ///< of a run until convergence: the shortest record that can pass, s
    std::int64_t steps = 0;
    double wall_seconds = 0.0;  ///< computing time so far, over all parts of the run, s
    double updates_per_second = 0.0;
    double time_step = 0.0;  ///< the last, s
    std::int64_t particles = 0;
    std::int64_t threads = 0;
    std::string instruction_set;
    bool converged = false;
    bool until_converged = false;
    std::string convergence;           ///< finding of the convergence test, in words
    std::optional<double> half_width;  ///< of the 95 % interval of the depth-mean velocity, over the mean
    std::optional<double> remaining_drift;  ///< bound of the drift still to come, over the mean
    double tolerance = 0.0;                 ///< of both
    std::optional<double> relaxation_time;  ///< of the flow, s
    double checkpoint_interval = 0.0;       ///< wall-clock time between two writes, s
};

/// Read it; `data` is the report's, of the same file.
[[nodiscard]] Progress read_progress(const RunResults& results, const ReportData& data);

/// Speed of a run: since the earlier of two writes where both are of one run that went on, else since the
/// start.
struct Speed {
    double steps_per_second = 0.0;
    double updates_per_second = 0.0;
    double time_per_second = 0.0;  ///< simulated over wall-clock time
};

/// The speed; nothing before the first step.
[[nodiscard]] std::optional<Speed> speed_of(const Progress& now, const std::optional<Progress>& earlier);

/// As JSON. Times left (s of wall clock, at the present speed) are counted from the last write.
[[nodiscard]] std::string progress_json(const Progress& now, const std::optional<Progress>& earlier);

}  // namespace riffle::inline watch
