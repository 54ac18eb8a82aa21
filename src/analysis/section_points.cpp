#include "analysis/section_points.hpp"

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <numeric>

namespace riffle::inline analysis {

namespace {

constexpr double same_place = 1e-6;  // m
constexpr std::size_t fewest = 3;

double at(const std::vector<double>& values, std::size_t i) {
    return values.empty() ? std::numeric_limits<double>::quiet_NaN() : values[i];
}

/// Numbers of the points in groups of the same `key`, sorted by key, in each by `order`.
std::vector<std::vector<std::size_t>> groups_of(const std::vector<double>& key,
                                                const std::vector<double>& order,
                                                const std::vector<std::size_t>& chosen) {
    std::vector<std::size_t> sorted = chosen;
    std::sort(sorted.begin(), sorted.end(), [&](std::size_t a, std::size_t b) { return key[a] < key[b]; });
    std::vector<std::vector<std::size_t>> groups;
    for (const std::size_t i : sorted) {
        if (groups.empty() || key[i] - key[groups.back().front()] > same_place) groups.emplace_back();
        groups.back().push_back(i);
    }
    for (auto& group : groups) {
        std::sort(group.begin(), group.end(),
                  [&](std::size_t a, std::size_t b) { return order[a] < order[b]; });
    }
    return groups;
}

std::vector<std::size_t> chosen_points(const SectionPoints& points, bool with_height) {
    std::vector<std::size_t> chosen;
    for (std::size_t i = 0; i < points.y.size(); ++i) {
        if (std::isfinite(points.z[i]) == with_height) chosen.push_back(i);
    }
    return chosen;
}

template <class Group>
void add_point(Group& group, const SectionPoints& points, std::size_t i) {
    group.velocity.push_back(at(points.velocity, i));
    group.uncertainty.push_back(at(points.uncertainty, i));
    group.reynolds_stress.push_back(at(points.reynolds_stress, i));
}

}  // namespace

std::vector<MeasuredStation> measured_stations(const SectionPoints& points) {
    std::vector<MeasuredStation> stations;
    for (const auto& group : groups_of(points.y, points.z, chosen_points(points, true))) {
        if (group.size() < fewest) continue;
        MeasuredStation station;
        station.y = points.y[group.front()];
        for (const std::size_t i : group) {
            station.z.push_back(points.z[i]);
            add_point(station, points, i);
        }
        stations.push_back(std::move(station));
    }
    return stations;
}

std::vector<MeasuredRow> measured_rows(const SectionPoints& points) {
    std::vector<MeasuredRow> rows;
    for (const auto& group : groups_of(points.z, points.y, chosen_points(points, true))) {
        if (group.size() < fewest) continue;
        MeasuredRow row;
        row.z = points.z[group.front()];
        for (const std::size_t i : group) {
            row.y.push_back(points.y[i]);
            add_point(row, points, i);
        }
        rows.push_back(std::move(row));
    }
    return rows;
}

MeasuredRow measured_depth_means(const SectionPoints& points) {
    MeasuredRow row;
    row.z = std::numeric_limits<double>::quiet_NaN();
    std::vector<std::size_t> means = chosen_points(points, false);
    std::sort(means.begin(), means.end(),
              [&](std::size_t a, std::size_t b) { return points.y[a] < points.y[b]; });
    for (const std::size_t i : means) {
        row.y.push_back(points.y[i]);
        add_point(row, points, i);
    }
    return row;
}

const SectionPoints& points_beside(const FlowRecord& record) {
    return record.origin() == Origin::measured ? record.section_points() : record.measured().section;
}

}  // namespace riffle::inline analysis
