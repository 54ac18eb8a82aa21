#include "watch/progress.hpp"

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>

#include "record/particle_fields.hpp"
#include "record/run_fields.hpp"
#include "record/twin_fields.hpp"

namespace riffle::inline watch {

namespace {

using Json = nlohmann::ordered_json;

/// Relaxation times before the averages begin, and in all, of the shortest record that the convergence test
/// passes (solver/convergence.hpp).
constexpr double fewest_relaxation_times = 4.0;

Json optional_json(const std::optional<double>& value) {
    return value && std::isfinite(*value) ? Json(*value) : Json(nullptr);
}

}  // namespace

Progress read_progress(const RunResults& results, const ReportData& data) {
    const Case& c = data.flow;
    const auto& of = fields::summary;
    const auto number = [&](const Field& field) { return find_value(data.summary, field).value_or(0.0); };
    const auto count = [&](const Field& field) { return static_cast<std::int64_t>(number(field)); };
    Progress p;
    p.complete = data.complete;
    p.time = number(of.simulated_time);
    p.end_time = c.run.time;
    p.steps = count(of.steps);
    p.wall_seconds = number(of.wall_clock_seconds);
    p.updates_per_second = number(of.particle_updates_per_second);
    p.time_step = results.number(fields::clock.time_step).value_or(0.0);
    p.particles = count(of.particles);
    p.threads = count(of.threads);
    p.instruction_set = results.text(of.instruction_set);
    p.converged = number(of.converged) != 0.0;
    p.until_converged = c.run.until == RunUntil::converged;
    p.convergence = results.text(of.convergence);
    p.tolerance = c.run.tolerance;
    p.checkpoint_interval = c.output.checkpoint_interval;
    p.relaxation_time = find_value(data.summary, of.relaxation_time);
    if (p.until_converged && p.relaxation_time) {
        const double start =
            c.run.average_from.value_or((fewest_relaxation_times - 1.0) * *p.relaxation_time);
        p.earliest_end = std::min(p.end_time, start + *p.relaxation_time);
    }
    const double mean = number(of.depth_mean_velocity);
    const auto half = find_value(data.summary, of.depth_mean_velocity_half_width);
    if (half && mean != 0) p.half_width = *half / std::abs(mean);
    // The test leaves zero where the record is too short to tell.
    if (number(of.remaining_drift) > 0) p.remaining_drift = number(of.remaining_drift);
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

}  // namespace riffle::inline watch
