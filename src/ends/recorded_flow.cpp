#include "ends/recorded_flow.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

namespace riffle::inline ends {

RecordedFlow::RecordedFlow(RecordedWater water) : water_(std::move(water)) {
    take_off_mean();
    const auto& time = water_.time;
    const std::size_t n = time.size();
    // The last moment goes over into the first one in the mean time between two.
    const double span = time.back() - time.front();
    period_ = n > 1 ? span * static_cast<double>(n) / static_cast<double>(n - 1)
                    : water_.length / std::max(bulk_velocity_, 1e-300);
    find_correlations();
}

std::size_t RecordedFlow::bytes() const {
    std::size_t bytes = mean_.capacity() * sizeof(double) + pairs_.capacity() * sizeof(pairs_[0]);
    for (const auto& moment : water_.velocity) bytes += moment.capacity() * sizeof(float);
    return bytes;
}

void RecordedFlow::take_off_mean() {
    const std::size_t nx = water_.cells[0];
    const std::size_t ny = water_.cells[1];
    const std::size_t nz = water_.cells[2];
    mean_columns_ = water_.repeats_across ? 1 : ny;
    mean_.assign(3 * mean_columns_ * nz, 0.0);
    const auto mean_of = [&](std::size_t iy, std::size_t iz) {
        return 3 * (iz * mean_columns_ + (water_.repeats_across ? 0 : iy));
    };
    const double share =
        static_cast<double>(mean_columns_) / static_cast<double>(nx * ny * water_.velocity.size());
    const auto for_cells = [&](std::vector<float>& moment, const auto& f) {
        for (std::size_t iz = 0; iz < nz; ++iz) {
            for (std::size_t iy = 0; iy < ny; ++iy) {
                for (std::size_t ix = 0; ix < nx; ++ix) {
                    f(&moment[3 * ((iz * ny + iy) * nx + ix)], &mean_[mean_of(iy, iz)]);
                }
            }
        }
    };
    double fastest = 0.0;
    for (auto& moment : water_.velocity) {
        for_cells(moment, [&](const float* velocity, double* mean) {
            for (std::size_t k = 0; k < 3; ++k) mean[k] += share * static_cast<double>(velocity[k]);
            fastest = std::max(fastest, static_cast<double>(velocity[0]));
        });
    }
    for (auto& moment : water_.velocity) {
        for_cells(moment, [](float* velocity, const double* mean) {
            for (std::size_t k = 0; k < 3; ++k) velocity[k] -= static_cast<float>(mean[k]);
        });
    }
    double largest = 0.0;
    const std::size_t places = mean_columns_ * nz;
    for (std::size_t i = 0; i < mean_.size(); i += 3) {
        bulk_velocity_ += mean_[i] / static_cast<double>(places);
        largest = std::max(largest, mean_[i]);
    }
    largest_ = largest / bulk_velocity_;
    fastest_ = fastest / bulk_velocity_;
}

void RecordedFlow::find_correlations() {
    const auto& time = water_.time;
    const std::size_t nx = water_.cells[0];
    const std::size_t ny = water_.cells[1];
    const std::size_t nz = water_.cells[2];
    const auto cells = static_cast<double>(nx * ny * nz);
    const double cell_length = water_.length / static_cast<double>(nx);
    for (std::size_t moment = 0; moment < time.size(); ++moment) {
        const std::size_t next = (moment + 1) % time.size();
        const double duration =
            next > moment ? time[next] - time[moment] : period_ - (time.back() - time.front());
        std::array<Pair, 3> pair{};
        for (std::size_t iz = 0; iz < nz; ++iz) {
            const double place = (static_cast<double>(iz) + 0.5) / static_cast<double>(nz);
            for (std::size_t iy = 0; iy < ny; ++iy) {
                const double y = water_.width * (static_cast<double>(iy) + 0.5) / static_cast<double>(ny);
                const double way = mean(y, place)[0] * duration;
                for (std::size_t ix = 0; ix < nx; ++ix) {
                    const double x = cell_length * (static_cast<double>(ix) + 0.5);
                    const Vec<3> first = departure(moment, x, y, place);
                    const Vec<3> second = departure(next, x + way, y, place);
                    for (std::size_t k = 0; k < 3; ++k) {
                        pair[k].first += first[k] * first[k] / cells;
                        pair[k].second += second[k] * second[k] / cells;
                        pair[k].product += first[k] * second[k] / cells;
                    }
                }
            }
        }
        pairs_.push_back(pair);
    }
}

RecordedFlow::Between RecordedFlow::between(double place, std::size_t cells, bool repeats) {
    const auto count = static_cast<double>(cells);
    const double at = place * count - 0.5;
    const double low = std::floor(at);
    const auto index = [&](double cell) {
        const double inside =
            repeats ? cell - count * std::floor(cell / count) : std::clamp(cell, 0.0, count - 1.0);
        return std::min(static_cast<std::size_t>(inside), cells - 1);
    };
    return {index(low), index(low + 1.0), at - low};
}

RecordedFlow::Between RecordedFlow::across(double y) const {
    return water_.width > 0.0 ? between(y / water_.width, water_.cells[1], water_.repeats_across)
                              : Between{0, 0, 0.0};
}

Vec<3> RecordedFlow::mean(double y, double place) const {
    const Between row = between(place, water_.cells[2], false);
    const Between column = mean_columns_ > 1 ? across(y) : Between{0, 0, 0.0};
    Vec<3> result{};
    for (std::size_t k = 0; k < 3; ++k) {
        const auto of = [&](std::size_t iz) {
            const double low = mean_[3 * (iz * mean_columns_ + column.low) + k];
            return low + column.share * (mean_[3 * (iz * mean_columns_ + column.high) + k] - low);
        };
        const double low = of(row.low);
        result[k] = low + row.share * (of(row.high) - low);
    }
    return result;
}

Vec<3> RecordedFlow::departure(std::size_t moment, double x, double y, double place) const {
    const std::size_t nx = water_.cells[0];
    const std::size_t ny = water_.cells[1];
    const std::size_t nz = water_.cells[2];
    const std::array<Between, 3> at{between(x / water_.length, nx, true), across(y),
                                    between(place, nz, false)};
    const std::vector<float>& velocity = water_.velocity[moment];
    Vec<3> result{};
    for (std::size_t corner = 0; corner < 8; ++corner) {
        std::array<std::size_t, 3> cell{};
        double weight = 1.0;
        for (std::size_t axis = 0; axis < 3; ++axis) {
            const bool high = ((corner >> axis) & 1U) != 0;
            cell[axis] = high ? at[axis].high : at[axis].low;
            weight *= high ? at[axis].share : 1.0 - at[axis].share;
        }
        const std::size_t first = 3 * ((cell[2] * ny + cell[1]) * nx + cell[0]);
        for (std::size_t k = 0; k < 3; ++k) result[k] += weight * static_cast<double>(velocity[first + k]);
    }
    return result;
}

double RecordedFlow::mean_at(double y, double place) const { return mean(y, place)[0] / bulk_velocity_; }

Vec<3> RecordedFlow::at(double time, double y, double place) const {
    const auto& times = water_.time;
    // Rounding may put the phase a little before the first moment.
    const double since = std::clamp(time - period_ * std::floor(time / period_), 0.0, period_);
    const auto later = times.begin() + 1;
    const auto moment =
        static_cast<std::size_t>(std::upper_bound(later, times.end(), times.front() + since) - later);
    const std::size_t next = (moment + 1) % times.size();
    const double end = next > moment ? times[next] - times.front() : period_;
    const double begin = times[moment] - times.front();
    const double share = (since - begin) / (end - begin);
    const Vec<3> flow = mean(y, place);
    // What stands at x at a moment comes to x = 0 in x / -u.
    const Vec<3> first = departure(moment, -flow[0] * (since - begin), y, place);
    const Vec<3> second = departure(next, flow[0] * (end - since), y, place);
    Vec<3> result{};
    for (std::size_t k = 0; k < 3; ++k) {
        const Pair& pair = pairs_[moment][k];
        const double wanted = (1.0 - share) * pair.first + share * pair.second;
        const double mixed = (1.0 - share) * (1.0 - share) * pair.first + share * share * pair.second +
                             2.0 * share * (1.0 - share) * pair.product;
        // Moments that contradict each other would be drawn to twice what they are.
        constexpr double most = 2.0;
        const double factor = mixed * most * most > wanted ? std::sqrt(wanted / mixed)
                              : wanted > 0.0               ? most
                                                           : 1.0;
        result[k] = (flow[k] + factor * ((1.0 - share) * first[k] + share * second[k])) / bulk_velocity_;
    }
    return result;
}

}  // namespace riffle::inline ends
