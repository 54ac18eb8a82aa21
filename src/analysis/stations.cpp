#include "analysis/stations.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "base/error.hpp"
#include "statistics/record.hpp"

namespace riffle::inline analysis {

std::vector<StationPair> pairs_by_distance(std::span<const StationRecord> stations) {
    std::vector<StationPair> pairs;
    for (std::size_t a = 0; a < stations.size(); ++a) {
        for (std::size_t b = 0; b < stations.size(); ++b) {
            const double distance = stations[b].x - stations[a].x;
            if (distance > 0.0) pairs.push_back({a, b, distance});
        }
    }
    std::stable_sort(pairs.begin(), pairs.end(),
                     [](const StationPair& a, const StationPair& b) { return a.distance < b.distance; });
    return pairs;
}

std::vector<StationRecord> normalised_stations(std::span<const StationRecord> stations, const char* purpose) {
    if (stations.size() < 2) throw InputError(fmt::format("{}: at least two stations are needed", purpose));
    std::vector<StationRecord> result(stations.begin(), stations.end());
    for (StationRecord& station : result) {
        if (station.values.size() != stations.front().values.size()) {
            throw InputError(fmt::format(
                "{}: {} samples at x = {:.6g} m, {} at {:.6g} m; take the same times", purpose,
                station.values.size(), station.x, stations.front().values.size(), stations.front().x));
        }
        const double mean = mean_of(station.values);
        double squares = 0.0;
        double count = 0.0;
        for (double& v : station.values) {
            v -= mean;
            if (std::isnan(v)) continue;
            squares += v * v;
            count += 1.0;
        }
        if (!(squares > 0.0)) {
            throw InputError(fmt::format(
                "{}: the record at x = {:.6g} m does not vary; leave the station out", purpose, station.x));
        }
        for (double& v : station.values) v /= std::sqrt(squares / count);
    }
    return result;
}

}  // namespace riffle::inline analysis
