#include "laboratory/sampling.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "base/error.hpp"

namespace riffle::inline laboratory {

namespace {

/// Most samples of an even record over the times that there are: bursts of two minutes each hour are 30.
constexpr double largest_stretch = 50.0;

double median_difference(std::span<const double> times) {
    std::vector<double> differences;
    for (std::size_t i = 1; i < times.size(); ++i) differences.push_back(times[i] - times[i - 1]);
    const auto middle = differences.begin() + static_cast<std::ptrdiff_t>(differences.size() / 2);
    std::nth_element(differences.begin(), middle, differences.end());
    return *middle;
}

}  // namespace

EvenSampling find_even_sampling(std::span<const double> times, double tolerance,
                                const std::function<std::string(std::size_t)>& row_name) {
    if (times.size() < 2) throw FileError(fmt::format("{}: expected at least two times", row_name(0)));
    for (std::size_t i = 1; i < times.size(); ++i) {
        if (times[i] > times[i - 1]) continue;
        throw FileError(fmt::format("{}: expected a time after that of the row before, {} s, got {} s",
                                    row_name(i), times[i - 1], times[i]));
    }
    EvenSampling sampling;
    double interval = median_difference(times);
    sampling.slots.assign(times.size(), 0);
    // Sums for the line through times over places, both counted from the first: small numbers.
    double slot_sum = 0;
    double time_sum = 0;
    // Gaps become missing samples: one wrong time must not ask for more of them than fit the memory.
    const double most = largest_stretch * static_cast<double>(times.size());
    if (!((times.back() - times.front()) / interval <= most)) {
        std::size_t widest = 1;
        for (std::size_t i = 1; i < times.size(); ++i) {
            widest = times[i] - times[i - 1] > times[widest] - times[widest - 1] ? i : widest;
        }
        throw FileError(fmt::format(
            "{}: the time goes from {:.6g} s to {:.6g} s here, while half of the intervals are {:.6g} s or "
            "less: on an even record more than {:.0f} of 100 samples would be missing; correct the time, or "
            "give the stretches as files of their own",
            row_name(widest), times[widest - 1], times[widest], interval, 100.0 - 100.0 / largest_stretch));
    }
    for (std::size_t i = 1; i < times.size(); ++i) {
        const double steps = std::max(1.0, std::round((times[i] - times[i - 1]) / interval));
        sampling.slots[i] = sampling.slots[i - 1] + static_cast<std::size_t>(steps);
        slot_sum += static_cast<double>(sampling.slots[i]);
        time_sum += times[i] - times.front();
    }
    const auto n = static_cast<double>(times.size());
    double squares = 0;
    double products = 0;
    for (std::size_t i = 0; i < times.size(); ++i) {
        const double slot = static_cast<double>(sampling.slots[i]) - slot_sum / n;
        squares += slot * slot;
        products += slot * (times[i] - times.front() - time_sum / n);
    }
    interval = products / squares;
    sampling.frequency = 1.0 / interval;
    sampling.start = times.front() + time_sum / n - interval * slot_sum / n;
    sampling.samples = sampling.slots.back() + 1;
    std::size_t worst = 0;
    for (std::size_t i = 0; i < times.size(); ++i) {
        const double place = sampling.start + interval * static_cast<double>(sampling.slots[i]);
        const double departure = std::abs(times[i] - place) / interval;
        if (departure > sampling.largest_departure) {
            sampling.largest_departure = departure;
            worst = i;
        }
    }
    if (sampling.largest_departure > tolerance) {
        throw FileError(
            fmt::format("{}: the times are not evenly spaced: at {} s it is {:.2g} sampling intervals of "
                        "{:.6g} s off its place, {:.2g} are allowed; resample the record evenly, or leave "
                        "out the time column and give the sampling frequency",
                        row_name(worst), times[worst], sampling.largest_departure, interval, tolerance));
    }
    return sampling;
}

std::vector<double> on_even_grid(const EvenSampling& sampling, std::span<const double> values) {
    std::vector<double> result(sampling.samples, std::numeric_limits<double>::quiet_NaN());
    for (std::size_t i = 0; i < values.size(); ++i) result[sampling.slots[i]] = values[i];
    return result;
}

}  // namespace riffle::inline laboratory
