#include "report/cost.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <functional>
#include <optional>

#include "case/flow_conditions.hpp"
#include "record/flow_fields.hpp"
#include "record/run_fields.hpp"
#include "report/run_facts.hpp"

namespace riffle::inline report {

namespace {

constexpr const char* unknown = "–";
constexpr double day = 86400.0;

/// A run of the thesis: its CPU time and what it simulated.
struct ThesisCost {
    double days = 0;
    double simulated = 0;  ///< s
    double particles = 0;
};

std::optional<ThesisCost> thesis_cost(const Case& c) {
    const std::optional<int> condition = flow_condition_of(c);
    if (!condition) return std::nullopt;
    const bool space = c.channel.dimensions == 3;
    const double simulated = space ? 6.0 : 130.0;
    switch (*condition) {
        case 1:
            return space ? ThesisCost{60, simulated, 800e3} : ThesisCost{5, simulated, 4123};
        case 2:
            return space ? ThesisCost{70, simulated, 953e3} : ThesisCost{6, simulated, 5054};
        case 5:
            return space ? ThesisCost{40, simulated, 506e3} : ThesisCost{8, simulated, 6916};
        case 8:
            return space ? ThesisCost{80, simulated, 980e3} : ThesisCost{11, simulated, 9177};
        default:
            return std::nullopt;
    }
}

/// Simulated time that the computing time of a run is for, s.
std::optional<double> simulated_time(const ReportData& data) {
    if (const auto time = find_value(data.summary, fields::summary.simulated_time)) return time;
    if (data.series.has(fields::time_series.time)) return recorded_time(data);
    return std::nullopt;
}

std::optional<double> seconds_per_second(const ReportData& data) {
    const auto seconds = find_value(data.summary, fields::summary.wall_clock_seconds);
    const auto time = simulated_time(data);
    if (!seconds || !time || !(*time > 0.0)) return std::nullopt;
    return *seconds / *time;
}

}  // namespace

std::vector<CostRow> cost_rows(const std::vector<ComparedRun>& runs) {
    using Text = std::function<std::optional<std::string>(const ReportData&)>;
    const auto attribute = [](const Field& field, std::string (*text)(double)) -> Text {
        return [field, text](const ReportData& data) -> std::optional<std::string> {
            const auto value = find_value(data.summary, field);
            return value ? std::optional<std::string>(text(*value)) : std::nullopt;
        };
    };
    std::vector<CostRow> rows;
    const auto add = [&](const char* key, const char* label, const Text& text) {
        CostRow row{key, label, {}};
        bool known = false;
        for (const ComparedRun& run : runs) {
            const std::optional<std::string> value = run.run ? text(*run.run) : std::nullopt;
            known = known || value.has_value();
            row.values.push_back(value.value_or(unknown));
        }
        if (known) rows.push_back(std::move(row));
    };
    add("dimensions", "dimensions",
        [](const ReportData& data) { return fmt::format("{}", data.flow.channel.dimensions); });
    add("particles", "particles", attribute(fields::summary.particles, grouped_number));
    add("steps", "time steps", attribute(fields::summary.steps, grouped_number));
    add("simulated_time", "simulated time", [](const ReportData& data) -> std::optional<std::string> {
        const auto time = simulated_time(data);
        return time ? std::optional<std::string>(fmt::format("{:.4g} s", *time)) : std::nullopt;
    });
    add("wall_clock_seconds", "computing time",
        attribute(fields::summary.wall_clock_seconds, computing_time_text));
    add("seconds_per_second", "computing time per simulated second",
        [](const ReportData& data) -> std::optional<std::string> {
            const auto rate = seconds_per_second(data);
            return rate ? std::optional<std::string>(computing_time_text(*rate)) : std::nullopt;
        });
    // Stated, not compared: its computer and its method were others.
    add("thesis", "the thesis' run of the condition, on its computer",
        [](const ReportData& data) -> std::optional<std::string> {
            const auto cost = thesis_cost(data.flow);
            if (!cost) return std::nullopt;
            return fmt::format("{:.0f} days for {:.0f} s, {} particles", cost->days, cost->simulated,
                               grouped_number(cost->particles));
        });
    // Runs in two dimensions alone have their cost among the facts of their own pages.
    const bool in_space = std::any_of(runs.begin(), runs.end(), [](const ComparedRun& run) {
        return run.run && run.run->flow.channel.dimensions == 3;
    });
    if (!in_space) return {};
    const bool costs_known = std::any_of(rows.begin(), rows.end(), [](const CostRow& row) {
        return row.key == "wall_clock_seconds" || row.key == "particles";
    });
    return costs_known ? rows : std::vector<CostRow>{};
}

}  // namespace riffle::inline report
