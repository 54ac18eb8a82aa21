#include "particles/case_size.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include "base/error.hpp"
#include "case/end_buffers.hpp"
#include "case/outline.hpp"
#include "case/units.hpp"
#include "particles/lattice.hpp"

namespace riffle::inline particles {

namespace {

/// What a particle of the water takes at least, with its part of the lists, and one of a wall.
constexpr double bytes_per_particle = 200.0;
constexpr double bytes_per_wall_particle = 100.0;
constexpr double bytes_per_place = 70.0;  ///< while the lattice is filled
constexpr double bytes_per_cell = 4.0;
constexpr double bytes_per_mean_cell = 100.0;

double length_of(const std::vector<double>& x, const std::vector<double>& z) {
    double sum = 0.0;
    for (std::size_t i = 0; i < std::min(x.size(), z.size()); ++i) {
        const std::size_t next = i + 1 < x.size() ? i + 1 : 0;
        sum += std::hypot(x[next] - x[i], z[next] - z[i]);
    }
    return sum;
}

double wall_count(const Case& c, double columns, double files, double rows) {
    const double dx = c.numerics.spacing;
    const double layers = c.numerics.wall_layers;
    if (c.channel.dimensions == 3) {
        const bool closed = c.channel.sides != Sides::periodic;
        return columns * layers * (2.0 * (files + 2.0 * layers) + (closed ? 3.0 * rows : 0.0));
    }
    double count = 2.0 * layers * (columns + 2.0 * layers);
    if (c.channel.ends == Ends::walls) {
        count += 2.0 * layers * std::max(1.5 * rows, c.channel.wall_height.value_or(0.0) / dx);
    }
    for (const Solid& solid : c.solids) count += layers * length_of(solid.x, solid.z) / dx;
    return count;
}

template <int D>
double grid_cells(const Case& c) {
    const Domain<D> domain = domain_of<D>(c);
    const double reach = 2.0 * c.numerics.smoothing_ratio * c.numerics.spacing;
    double cells = 1.0;
    for (int k = 0; k < D; ++k) cells *= std::max(1.0, domain.extent(k) / reach);
    return cells;
}

/// The cells of the mean field in three dimensions.
double mean_cells(const Case& c) {
    if (c.channel.dimensions == 2 || c.output.mean_field_interval <= 0.0) return 0.0;
    const double edge = c.output.mean_field_spacing.value_or(c.numerics.spacing);
    return std::max(1.0, c.channel.length / edge) * std::max(1.0, c.channel.simulated_width() / edge) *
           std::max(1.0, c.total_depth() / edge);
}

}  // namespace

CaseSize estimate_size(const Case& c) {
    const bool space = c.channel.dimensions == 3;
    const double dx = c.numerics.spacing;
    const double columns = std::max(1.0, (c.channel.length + 2.0 * buffer_length(c)) / dx);
    const double files = space ? std::max(1.0, c.channel.simulated_width() / dx) : 1.0;
    double top = c.total_depth();
    for (const double z : c.start.water_z) top = std::max(top, z);
    const double rows = std::max(1.0, top / dx);
    CaseSize size;
    size.places = columns * files * rows;
    size.walls = wall_count(c, columns, files, rows);
    const double mean = mean_cells(c);
    const double grid = space ? grid_cells<3>(c) : grid_cells<2>(c);
    size.cells = std::max(grid, mean);
    const double water =
        c.start.water_x.empty()
            ? size.places
            : std::min(size.places, std::abs(signed_area({c.start.water_x, c.start.water_z})) / (dx * dx));
    size.bytes = std::max(bytes_per_place * size.places,
                          bytes_per_particle * water + bytes_per_wall_particle * size.walls +
                              bytes_per_cell * grid + bytes_per_mean_cell * mean);
    return size;
}

std::string unit_slip(const Case& c) {
    // The finest cases have some hundreds of spacings over the depth, and the longest some thousands.
    constexpr double most_over_height = 2000.0;
    constexpr double most_along = 20000.0;
    struct Length {
        const char* key;
        double value;
        double most;
    };
    std::vector<Length> lengths{
        {"[channel] depth", c.channel.depth, most_over_height},
        {"[channel] length", c.channel.length, most_along},
        {"[channel] wall_height", c.channel.wall_height.value_or(0.0), most_over_height},
        {"[bed] roughness_height", c.bed.roughness_height, most_over_height}};
    if (c.channel.dimensions == 3) {
        lengths.push_back({"[channel] width", c.channel.width, most_along});
    }
    for (const double z : c.start.water_z) {
        lengths.push_back({"[start] water_z", z, most_over_height});
    }
    const double dx = c.numerics.spacing;
    const auto slips = [&](const Length& length) { return length.value > length.most * dx; };
    if (std::none_of(lengths.begin(), lengths.end(), slips)) return "";
    const Length& slip = *std::find_if(lengths.begin(), lengths.end(), slips);
    // A thousandth of the length would hold no flow: rather the spacing is too small.
    constexpr double fewest = 10.0;
    if (1e-3 * slip.value < fewest * dx) {
        return fmt::format(
            "[numerics] spacing is {}, of which {:.0f} stand over the depth and {:.0f} along the channel: "
            "is {} meant?",
            shown_length(dx), c.total_depth() / dx, c.channel.length / dx, shown_length(1000.0 * dx));
    }
    return fmt::format("{} is {}, {:.0f} spacings of {}: is {} meant? A number without unit is in metres",
                       slip.key, shown_length(slip.value), slip.value / dx, shown_length(dx),
                       shown_length(1e-3 * slip.value));
}

void check_size(const Case& c, bool confirmed, std::optional<std::size_t> available) {
    const CaseSize size = estimate_size(c);
    const std::string what = fmt::format(
        "{}: this case has about {:.3g} particles of water and {:.3g} of walls and takes {:.3g} GB "
        "of memory at least",
        c.path.empty() ? c.title : c.path.string(), size.places, size.walls, 1e-9 * size.bytes);
    const std::string slip = unit_slip(c);
    const std::string guess = slip.empty() ? "" : "\n" + slip;
    constexpr double countable = 2e9;
    if (!(size.places < countable && size.walls < countable && size.cells < countable)) {
        throw InputError(
            fmt::format("{}; no more than {:.1g} particles or cells ({:.3g} here) can be "
                        "counted.{}\nMake the channel shorter or the spacing larger",
                        what, countable, size.cells, guess));
    }
    if (confirmed) return;
    if (available && size.bytes > static_cast<double>(*available)) {
        throw InputError(
            fmt::format("{}, of which {:.3g} GB are free.{}\nMake the channel shorter or the "
                        "spacing larger; --large goes on all the same",
                        what, 1e-9 * static_cast<double>(*available), guess));
    }
    constexpr double many = 1e6;
    if (!slip.empty() && size.places + size.walls + size.cells > many) {
        throw InputError(
            fmt::format("{}.{}\nCorrect the unit; --large goes on if it is as meant", what, guess));
    }
}

}  // namespace riffle::inline particles
