#include "case/height_grid.hpp"

#include <algorithm>
#include <cstdint>
#include <deque>

namespace riffle::inline case_file {

namespace {

constexpr std::size_t no_index = static_cast<std::size_t>(-1);

/// Calls take(neighbour) for each of the four neighbours of a point that the grid has.
template <class Take>
void for_neighbours(const HeightGrid& grid, std::size_t i, const Take& take) {
    const std::size_t column = i % grid.columns;
    const std::size_t row = i / grid.columns;
    if (column > 0) take(i - 1);
    if (column + 1 < grid.columns) take(i + 1);
    if (row > 0) take(i - grid.columns);
    if (row + 1 < grid.rows) take(i + grid.columns);
}

/// Steps from each missing point to the nearest known one; 0 for known points.
std::vector<std::uint32_t> steps_to_known(const HeightGrid& grid) {
    constexpr std::uint32_t far = std::numeric_limits<std::uint32_t>::max();
    std::vector<std::uint32_t> steps(grid.z.size(), far);
    std::deque<std::size_t> front;
    for (std::size_t i = 0; i < grid.z.size(); ++i) {
        if (!std::isnan(grid.z[i])) {
            steps[i] = 0;
            front.push_back(i);
        }
    }
    while (!front.empty()) {
        const std::size_t i = front.front();
        front.pop_front();
        for_neighbours(grid, i, [&](std::size_t j) {
            if (steps[j] == far) {
                steps[j] = steps[i] + 1;
                front.push_back(j);
            }
        });
    }
    return steps;
}

/// Parts of the missing points that hang together.
std::size_t count_holes(const HeightGrid& grid, const std::vector<std::size_t>& missing) {
    std::vector<char> seen(grid.z.size(), 0);
    std::size_t holes = 0;
    for (const std::size_t first : missing) {
        if (seen[first] != 0) continue;
        ++holes;
        seen[first] = 1;
        std::vector<std::size_t> open{first};
        while (!open.empty()) {
            const std::size_t i = open.back();
            open.pop_back();
            for_neighbours(grid, i, [&](std::size_t j) {
                if (std::isnan(grid.z[j]) && seen[j] == 0) {
                    seen[j] = 1;
                    open.push_back(j);
                }
            });
        }
    }
    return holes;
}

}  // namespace

FilledHoles fill_holes(HeightGrid& grid) {
    std::vector<std::size_t> missing;
    for (std::size_t i = 0; i < grid.z.size(); ++i) {
        if (std::isnan(grid.z[i])) missing.push_back(i);
    }
    FilledHoles filled{.heights = missing.size()};
    if (missing.empty() || missing.size() == grid.z.size()) return filled;
    filled.holes = count_holes(grid, missing);
    const std::vector<std::uint32_t> steps = steps_to_known(grid);
    const std::size_t middle = *std::max_element(missing.begin(), missing.end(),
                                                 [&](auto a, auto b) { return steps[a] < steps[b]; });
    // A hole one point wide reaches over two steps of the grid from what is known to what is known.
    filled.widest = 2.0 * steps[middle] * std::max(grid.step_x, grid.step_y);
    filled.x = grid.x + grid.step_x * static_cast<double>(middle % grid.columns);
    const std::size_t row = middle / grid.columns;
    filled.y = grid.y + grid.step_y * static_cast<double>(row);

    // From the edge inward each starts as the mean of what is known by then.
    std::stable_sort(missing.begin(), missing.end(), [&](auto a, auto b) { return steps[a] < steps[b]; });
    const auto mean_around = [&](std::size_t i) {
        double sum = 0.0;
        int count = 0;
        for_neighbours(grid, i, [&](std::size_t j) {
            if (!std::isnan(grid.z[j])) {
                sum += grid.z[j];
                ++count;
            }
        });
        return sum / count;
    };
    double low = std::numeric_limits<double>::infinity();
    double high = -low;
    for (const double z : grid.z) {
        low = std::isnan(z) ? low : std::min(low, z);
        high = std::isnan(z) ? high : std::max(high, z);
    }
    for (const std::size_t i : missing) grid.z[i] = mean_around(i);
    constexpr int most_sweeps = 20000;
    for (int sweep = 0; sweep < most_sweeps; ++sweep) {
        double change = 0.0;
        for (const std::size_t i : missing) {
            const double step = 1.7 * (mean_around(i) - grid.z[i]);  // over-relaxed
            grid.z[i] += step;
            change = std::max(change, std::abs(step));
        }
        if (change <= 1e-7 * (high - low)) break;
    }
    return filled;
}

FilledHoles fill_holes(HeightLine& line) {
    FilledHoles filled;
    const std::size_t points = line.z.size();
    for (std::size_t begin = 0; begin < points;) {
        if (!std::isnan(line.z[begin])) {
            ++begin;
            continue;
        }
        std::size_t end = begin;
        while (end < points && std::isnan(line.z[end])) ++end;
        filled.heights += end - begin;
        const std::size_t left = begin == 0 ? no_index : begin - 1;
        const std::size_t right = end == points ? no_index : end;
        if (left == no_index && right == no_index) return filled;
        ++filled.holes;
        const double from = line.x[left == no_index ? begin : left];
        const double to = line.x[right == no_index ? end - 1 : right];
        // At an end of the line a hole has one side only.
        const double width = (left == no_index || right == no_index ? 2.0 : 1.0) * (to - from);
        if (width >= filled.widest) {
            filled.widest = width;
            filled.x = 0.5 * (from + to);
        }
        for (std::size_t i = begin; i < end; ++i) {
            if (left == no_index || right == no_index) {
                line.z[i] = line.z[left == no_index ? right : left];
            } else {
                line.z[i] = line.z[left] + (line.z[right] - line.z[left]) * (line.x[i] - from) / (to - from);
            }
        }
        begin = end;
    }
    return filled;
}

double height_between(const HeightGrid& grid, double x, double y) {
    const auto locate = [](double place, double first, double step, std::size_t count) {
        const double steps = std::clamp((place - first) / step, -0.5, static_cast<double>(count) - 0.5);
        const std::size_t low =
            std::min(static_cast<std::size_t>(std::max(steps, 0.0)), count < 2 ? 0 : count - 2);
        return std::pair(low, count < 2 ? 0.0 : steps - static_cast<double>(low));
    };
    const auto [i, s] = locate(x, grid.x, grid.step_x, grid.columns);
    const auto [j, t] = locate(y, grid.y, grid.step_y, grid.rows);
    const std::size_t right = std::min(i + 1, grid.columns - 1);
    const std::size_t above = std::min(j + 1, grid.rows - 1);
    return (1.0 - t) * ((1.0 - s) * grid.at(i, j) + s * grid.at(right, j)) +
           t * ((1.0 - s) * grid.at(i, above) + s * grid.at(right, above));
}

double height_between(const HeightLine& line, double x) {
    const std::size_t points = line.x.size();
    if (points == 1) return line.z.front();
    const double before = 0.5 * (line.x[1] - line.x[0]);
    const double behind = 0.5 * (line.x[points - 1] - line.x[points - 2]);
    const double at = std::clamp(x, line.x.front() - before, line.x.back() + behind);
    const auto after = std::upper_bound(line.x.begin() + 1, line.x.end() - 1, at);
    const auto j = static_cast<std::size_t>(after - line.x.begin());
    const double share = (at - line.x[j - 1]) / (line.x[j] - line.x[j - 1]);
    return line.z[j - 1] + share * (line.z[j] - line.z[j - 1]);
}

}  // namespace riffle::inline case_file
