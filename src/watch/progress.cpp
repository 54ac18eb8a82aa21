#include "watch/progress.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <nlohmann/json.hpp>

namespace riffle {

namespace {

using Json = nlohmann::ordered_json;

/// Relaxation times before the averages begin, and in all, of the shortest record that the convergence test
/// passes (solver/convergence.hpp).
constexpr double fewest_relaxation_times = 4.0;

double number(const ResultsReader& reader, const std::string& group, const char* name) {
    const auto value = reader.attribute(group, name);
    if (!value) return std::numeric_limits<double>::quiet_NaN();
    if (const auto* real = std::get_if<double>(&*value)) return *real;
    if (const auto* integer = std::get_if<std::int64_t>(&*value)) return static_cast<double>(*integer);
    return std::numeric_limits<double>::quiet_NaN();
}

double number_or(const ResultsReader& reader, const std::string& group, const char* name, double otherwise) {
    const double value = number(reader, group, name);
    return std::isfinite(value) ? value : otherwise;
}

std::int64_t count(const ResultsReader& reader, const char* name) {
    return static_cast<std::int64_t>(number_or(reader, "/summary", name, 0.0));
}

std::string text(const ResultsReader& reader, const char* name) {
    const auto value = reader.attribute("/summary", name);
    const auto* words = value ? std::get_if<std::string>(&*value) : nullptr;
    return words != nullptr ? *words : std::string{};
}

Json optional_json(const std::optional<double>& value) {
    return value && std::isfinite(*value) ? Json(*value) : Json(nullptr);
}

}  // namespace

Progress read_progress(const ResultsReader& reader, const ReportData& data) {
    const Case& c = data.flow;
    Progress p;
    p.complete = data.complete;
    p.time = number_or(reader, "/summary", "simulated_time", 0.0);
    p.end_time = c.run.time;
    p.steps = count(reader, "steps");
    p.wall_seconds = number_or(reader, "/summary", "wall_clock_seconds", 0.0);
    p.updates_per_second = number_or(reader, "/summary", "particle_updates_per_second", 0.0);
    p.time_step = number_or(reader, "/state", "time_step", 0.0);
    p.particles = count(reader, "particles");
    p.threads = count(reader, "threads");
    p.instruction_set = text(reader, "instruction_set");
    p.converged = number_or(reader, "/summary", "converged", 0.0) != 0.0;
    p.until_converged = c.run.until == RunUntil::converged;
    p.convergence = text(reader, "convergence");
    p.tolerance = c.run.tolerance;
    p.checkpoint_interval = c.output.checkpoint_interval;
    const auto relaxation = find_value(data.column_summary, "relaxation_time");
    if (relaxation && *relaxation > 0) p.relaxation_time = relaxation;
    if (p.until_converged && p.relaxation_time) {
        const double start =
            c.run.average_from.value_or((fewest_relaxation_times - 1.0) * *p.relaxation_time);
        p.earliest_end = std::min(p.end_time, start + *p.relaxation_time);
    }
    const double mean = number(reader, "/summary", "depth_mean_velocity");
    const double half = number(reader, "/summary", "depth_mean_velocity_half_width");
    if (std::isfinite(mean) && std::isfinite(half) && mean != 0) p.half_width = half / std::abs(mean);
    // The test leaves zero where the record is too short to tell.
    const double drift = number(reader, "/summary", "remaining_drift");
    if (std::isfinite(drift) && drift > 0) p.remaining_drift = drift;
    return p;
}

std::optional<Speed> speed_of(const Progress& now, const std::optional<Progress>& earlier) {
    Progress from;
    if (earlier && earlier->steps < now.steps && earlier->time < now.time &&
        earlier->wall_seconds < now.wall_seconds && earlier->particles == now.particles) {
        from = *earlier;
    }
    const auto steps = static_cast<double>(now.steps - from.steps);
    const double seconds = now.wall_seconds - from.wall_seconds;
    if (!(steps > 0) || !(seconds > 0)) return std::nullopt;
    Speed speed;
    speed.steps_per_second = steps / seconds;
    speed.time_per_second = (now.time - from.time) / seconds;
    // The file's own rate is the mean of the whole run; force evaluations go with the steps.
    if (now.wall_seconds > 0) {
        const double mean = static_cast<double>(now.steps) / now.wall_seconds;
        speed.updates_per_second = now.updates_per_second * speed.steps_per_second / mean;
    }
    return speed;
}

std::string progress_json(const Progress& now, const std::optional<Progress>& earlier) {
    const auto speed = speed_of(now, earlier);
    const auto left = [&](double end) {
        if (!speed || !(speed->time_per_second > 0)) return Json(nullptr);
        return Json(std::max(0.0, end - now.time) / speed->time_per_second);
    };
    Json object = {
        {"complete", now.complete},
        {"time", now.time},
        {"end_time", now.end_time},
        {"earliest_end", optional_json(now.earliest_end)},
        {"steps", now.steps},
        {"wall_seconds", now.wall_seconds},
        {"time_step", now.time_step},
        {"particles", now.particles},
        {"threads", now.threads},
        {"instruction_set", now.instruction_set},
        {"steps_per_second", optional_json(speed ? std::optional(speed->steps_per_second) : std::nullopt)},
        {"updates_per_second",
         optional_json(speed ? std::optional(speed->updates_per_second) : std::nullopt)},
        {"time_per_second", optional_json(speed ? std::optional(speed->time_per_second) : std::nullopt)},
        {"seconds_left", left(now.end_time)},
        {"seconds_left_at_least", now.earliest_end ? left(*now.earliest_end) : Json(nullptr)},
        {"converged", now.converged},
        {"until_converged", now.until_converged},
        {"convergence", now.convergence},
        {"half_width", optional_json(now.half_width)},
        {"remaining_drift", optional_json(now.remaining_drift)},
        {"tolerance", now.tolerance},
        {"relaxation_time", optional_json(now.relaxation_time)}};
    return object.dump(-1, ' ', false, Json::error_handler_t::replace);
}

}  // namespace riffle
