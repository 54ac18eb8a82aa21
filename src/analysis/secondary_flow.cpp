#include "analysis/secondary_flow.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <span>

#include "base/not_a_number.hpp"
#include "statistics/jackknife.hpp"

namespace riffle::inline analysis {

namespace {

/// Mean square of the persistent part of some windows: products of different windows only, cell by cell.
double persistent_square(std::span<const SecondaryFlow> windows, std::size_t from, std::size_t to) {
    if (windows.empty()) return not_a_number;
    const std::size_t cells = windows.front().v.size();
    double sum = 0.0;
    double counted = 0.0;
    for (std::size_t cell = 0; cell < cells; ++cell) {
        double n = 0.0;
        double v = 0.0;
        double w = 0.0;
        double squares = 0.0;
        for (std::size_t k = 0; k < windows.size(); ++k) {
            if (k >= from && k < to) continue;  // left out
            const SecondaryFlow& window = windows[k];
            if (!std::isfinite(window.v[cell]) || !std::isfinite(window.w[cell])) continue;
            n += 1.0;
            v += window.v[cell];
            w += window.w[cell];
            squares += window.v[cell] * window.v[cell] + window.w[cell] * window.w[cell];
        }
        if (n < 2.0) continue;
        sum += (v * v + w * w - squares) / (n * (n - 1.0));
        counted += 1.0;
    }
    return counted > 0.0 ? sum / counted : not_a_number;
}

}  // namespace

SecondaryFlow secondary_flow(const MeanFlow& field, const FieldSums& section, double above, bool periodic) {
    SecondaryFlow flow{std::vector<double>(section.cells(), not_a_number),
                       std::vector<double>(section.cells(), not_a_number)};
    for (std::size_t iz = 0; iz < field.z.size(); ++iz) {
        if (field.z[iz] < above) continue;
        double sum = 0.0;
        double count = 0.0;
        for (std::size_t iy = 0; iy < field.y.size(); ++iy) {
            const std::size_t cell = field.at(iz, iy);
            flow.v[cell] = section.mean(FieldQuantity::spanwise_velocity, cell);
            flow.w[cell] = section.mean(FieldQuantity::vertical_velocity, cell);
            if (!std::isfinite(flow.v[cell])) continue;
            sum += flow.v[cell];
            count += 1.0;
        }
        if (!periodic || count == 0.0) continue;
        for (std::size_t iy = 0; iy < field.y.size(); ++iy) flow.v[field.at(iz, iy)] -= sum / count;
    }
    return flow;
}

SecondaryStrength strength_of(const SecondaryFlow& flow) {
    SecondaryStrength strength;
    double count = 0.0;
    for (std::size_t cell = 0; cell < flow.v.size(); ++cell) {
        const double speed = std::hypot(flow.v[cell], flow.w[cell]);
        if (!std::isfinite(speed)) continue;
        strength.mean += speed;
        strength.root_mean_square += speed * speed;
        strength.largest = std::max(strength.largest, speed);
        count += 1.0;
    }
    if (count == 0.0) return strength;
    strength.mean /= count;
    strength.root_mean_square = std::sqrt(strength.root_mean_square / count);
    return strength;
}

SecondarySurvival secondary_survival(const MeanFlow& field, double above, bool periodic) {
    SecondarySurvival result;
    const std::size_t windows = field.sections.size();
    for (std::size_t group = 1;;) {
        AveragedStrength mean{static_cast<double>(group) * field.interval, {}};
        double squares = 0.0;
        double groups = 0.0;
        for (std::size_t first = 0; first + group <= windows; first += group) {
            FieldSums sums = field.sections[first];
            for (std::size_t k = 1; k < group; ++k) sums.add(field.sections[first + k]);
            const SecondaryStrength one = strength_of(secondary_flow(field, sums, above, periodic));
            mean.strength.mean += one.mean;
            mean.strength.largest += one.largest;
            squares += one.root_mean_square * one.root_mean_square;
            groups += 1.0;
        }
        mean.strength.mean /= groups;
        mean.strength.largest /= groups;
        mean.strength.root_mean_square = std::sqrt(squares / groups);
        if (group == 1) result.single = squares / groups;
        result.averaged.push_back(mean);
        if (group == windows) break;
        group = std::min(2 * group, windows);
    }
    std::vector<SecondaryFlow> flows;
    for (const FieldSums& section : field.sections) {
        flows.push_back(secondary_flow(field, section, above, periodic));
    }
    result.persistent = {persistent_square(flows, windows, windows), std::numeric_limits<double>::infinity()};
    const std::size_t blocks = std::min(windows, MeanFlow::most_blocks);
    if (blocks < 3) return result;  // without one of two there is no product left
    std::vector<double> without_one;
    for (std::size_t b = 0; b < blocks; ++b) {
        without_one.push_back(persistent_square(flows, b * windows / blocks, (b + 1) * windows / blocks));
    }
    result.persistent.half_width = jackknife_half_width(without_one);
    return result;
}

std::vector<double> streamfunction(const MeanFlow& field, const SecondaryFlow& flow) {
    std::vector<double> psi(flow.v.size(), not_a_number);
    const double dz = field.cell_height();
    for (std::size_t iy = 0; iy < field.y.size(); ++iy) {
        double sum = 0.0;
        for (std::size_t iz = 0; iz < field.z.size(); ++iz) {
            const std::size_t cell = field.at(iz, iy);
            if (!std::isfinite(flow.v[cell])) continue;
            psi[cell] = sum + 0.5 * flow.v[cell] * dz;
            sum += flow.v[cell] * dz;
        }
    }
    return psi;
}

std::vector<double> depth_mean_streamfunction(const MeanFlow& field, const SecondaryFlow& flow) {
    const std::vector<double> psi = streamfunction(field, flow);
    std::vector<double> mean(field.y.size(), not_a_number);
    for (std::size_t iy = 0; iy < field.y.size(); ++iy) {
        double sum = 0.0;
        double count = 0.0;
        for (std::size_t iz = 0; iz < field.z.size(); ++iz) {
            if (!std::isfinite(psi[field.at(iz, iy)])) continue;
            sum += psi[field.at(iz, iy)];
            count += 1.0;
        }
        if (count > 0.0) mean[iy] = sum / count;
    }
    return mean;
}

std::vector<SecondaryCell> secondary_cells(const std::vector<double>& y, const FieldEstimates& psi,
                                           double width) {
    std::vector<SecondaryCell> cells;
    std::size_t last = 0;  // last place that belongs to the cell before
    for (std::size_t i = 0; i < y.size(); ++i) {
        if (!(std::abs(psi.value[i]) > psi.half_width[i])) continue;
        const bool positive = psi.value[i] > 0.0;
        if (cells.empty()) {
            cells.push_back({0.0, width, positive});
        } else if (cells.back().positive != positive) {
            const double between = 0.5 * (y[last] + y[i]);
            cells.back().to = between;
            cells.push_back({between, width, positive});
        }
        last = i;
    }
    return cells;
}

}  // namespace riffle::inline analysis
