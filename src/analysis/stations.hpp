#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "analysis/space_time.hpp"

namespace riffle::inline analysis {

/// Two stations, the second further downstream.
struct StationPair {
    std::size_t upstream = 0, downstream = 0;
    double distance = 0.0;  ///< m, > 0
};

/// All pairs of stations at different places, the closest first.
[[nodiscard]] std::vector<StationPair> pairs_by_distance(std::span<const StationRecord> stations);

/// The records less their means, over their standard deviations. Throws InputError beginning with `purpose`
/// for fewer than two stations, records of different lengths, or one without variance, naming its place.
[[nodiscard]] std::vector<StationRecord> normalised_stations(std::span<const StationRecord> stations,
                                                             const char* purpose);

}  // namespace riffle::inline analysis
