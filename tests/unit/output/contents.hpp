#pragma once

#include <bit>
#include <cmath>
#include <cstdint>
#include <limits>
#include <string>
#include <vector>

#include "output/dataset.hpp"

namespace riffle::test {

inline std::vector<double> wave(std::size_t count, double phase = 0) {
    std::vector<double> values(count);
    for (std::size_t i = 0; i < count; ++i) values[i] = std::sin(phase + 0.37 * static_cast<double>(i));
    return values;
}

/// A state such as a run's: arrays in double, numbers, text, the time.
inline Content state(std::size_t particles, double time) {
    std::vector<std::int64_t> id(particles);
    for (std::size_t i = 0; i < particles; ++i) id[i] = static_cast<std::int64_t>(particles - i);
    Content content;
    content.datasets = {
        {"/case/text", {}, "[channel]\nslope = 0.004 # ‰\n", "1", "case"},
        {"/particles/density_deviation", {particles}, wave(particles, time), "1", "rho/rho0 - 1"},
        {"/particles/id", {particles}, id, "1", "number"},
        {"/particles/position", {particles, 2}, wave(2 * particles, time + 1), "m", "position"},
        {"/random/state", {4}, std::vector<std::uint8_t>{0, 1, 254, 255}, "1", "random state"},
        {"/step", {}, std::vector<std::int64_t>{INT64_MAX}, "1", "steps done"},
    };
    content.attributes = {{"/", "riffle_version", "0.1.0"},
                          {"/", "time", time},
                          {"/particles", "count", static_cast<std::int64_t>(particles)}};
    return content;
}

/// Equal to the bit, NaN and the sign of zero included.
inline bool same_bits(const std::vector<double>& a, const std::vector<double>& b) {
    if (a.size() != b.size()) return false;
    for (std::size_t i = 0; i < a.size(); ++i) {
        if (std::bit_cast<std::uint64_t>(a[i]) != std::bit_cast<std::uint64_t>(b[i])) return false;
    }
    return true;
}

inline bool same(const Dataset& a, const Dataset& b) {
    if (a.path != b.path || a.shape != b.shape || a.unit != b.unit || a.long_name != b.long_name) {
        return false;
    }
    const auto* doubles_a = std::get_if<std::vector<double>>(&a.values);
    const auto* doubles_b = std::get_if<std::vector<double>>(&b.values);
    if (doubles_a != nullptr && doubles_b != nullptr) return same_bits(*doubles_a, *doubles_b);
    return a.values == b.values;
}

inline bool same(const Content& a, const Content& b) {
    if (a.datasets.size() != b.datasets.size() || a.attributes.size() != b.attributes.size()) return false;
    for (std::size_t i = 0; i < a.datasets.size(); ++i) {
        if (!same(a.datasets[i], b.datasets[i])) return false;
    }
    for (std::size_t i = 0; i < a.attributes.size(); ++i) {
        const Attribute& x = a.attributes[i];
        const Attribute& y = b.attributes[i];
        if (x.path != y.path || x.name != y.name || x.value != y.value) return false;
    }
    return true;
}

}  // namespace riffle::test
