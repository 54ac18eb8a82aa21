#include "report/surface_frames.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "base/error.hpp"
#include "record/flow_fields.hpp"
#include "statistics/record.hpp"

namespace riffle::inline report {

namespace {

/// Every n-th value of a list.
std::vector<double> every(const std::vector<double>& values, std::size_t n) {
    std::vector<double> result;
    for (std::size_t i = 0; i < values.size(); i += n) result.push_back(values[i]);
    return result;
}

}  // namespace

std::optional<SurfaceFrames> read_surface_frames(const RunResults& results, const Case& c,
                                                 std::size_t most_values, std::size_t most_frames) {
    const auto& of = fields::surface_map;
    if (c.channel.dimensions != 3 || c.channel.top != Top::free_surface || !results.has(of.elevation) ||
        !results.has(of.time)) {
        return std::nullopt;
    }
    const std::vector<double> time = results.values(of.time);
    const std::vector<double> x = results.values(of.x);
    const std::vector<double> y = results.values(of.y);
    const std::vector<std::size_t> shape = results.shape(of.elevation);
    const std::size_t points = x.size() * y.size();
    if (shape.size() != 3 || shape[0] < time.size() || shape[1] != y.size() || shape[2] != x.size()) {
        throw FileError(fmt::format("{}: the maps of the surface do not fit their axes: the file is damaged",
                                    results.path().string()));
    }
    constexpr std::size_t fewest_frames = 60;
    if (time.size() < 2 || points == 0) return std::nullopt;
    const std::size_t wanted = std::min(fewest_frames, time.size());
    std::size_t step = 1;
    const auto kept = [&] { return ((x.size() + step - 1) / step) * ((y.size() + step - 1) / step); };
    while (kept() > 4 && kept() * wanted > most_values) ++step;
    const std::size_t frames =
        std::clamp<std::size_t>(std::min(most_values / kept(), most_frames), 2, time.size());
    const std::size_t first = time.size() - frames;

    SurfaceFrames surface;
    surface.x = every(x, step);
    surface.y = every(y, step);
    surface.earlier_left_out = first > 0;
    surface.time.assign(time.begin() + static_cast<std::ptrdiff_t>(first), time.end());
    surface.elevation.reserve(frames * kept());
    for (std::size_t frame = first; frame < time.size(); ++frame) {
        const std::vector<double> whole = results.rows(of.elevation, frame, 1);
        std::vector<double> map;
        for (std::size_t iy = 0; iy < y.size(); iy += step) {
            for (std::size_t ix = 0; ix < x.size(); ix += step) map.push_back(whole[iy * x.size() + ix]);
        }
        const double mean = mean_of(map);
        for (double& elevation : map) elevation -= mean;
        surface.elevation.insert(surface.elevation.end(), map.begin(), map.end());
    }
    return surface;
}

}  // namespace riffle::inline report
