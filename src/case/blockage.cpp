#include "case/blockage.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <vector>

#include "case/end_levels.hpp"
#include "case/outline_check.hpp"
#include "case/solid_places.hpp"

namespace riffle::inline case_file {

namespace {

/// Whether water must get through the channel.
bool must_pass(const Case& c) {
    return c.channel.top != Top::periodic &&
           (c.channel.ends == Ends::open ||
            (c.channel.ends == Ends::periodic && c.streamwise_gravity() != 0.0));
}

/// Cells as wide as the particles, of which those hold water that `open(place)`.
class Cells {
  public:
    Cells(const Case& c, double level, std::function<bool(const Point3&)> open)
        : open_(std::move(open)),
          size_{c.channel.length, c.channel.dimensions == 3 ? c.channel.simulated_width() : 0.0, level} {
        for (std::size_t k = 0; k < 3; ++k) {
            count_[k] = std::max(1, static_cast<int>(std::lround(size_[k] / c.numerics.spacing)));
        }
        const auto cells = static_cast<std::size_t>(count_[0]) * static_cast<std::size_t>(count_[1]) *
                           static_cast<std::size_t>(count_[2]);
        seen_.assign(cells, false);
    }

    /// How far water comes from x = 0 by open cells that touch each other, m; the length where it comes
    /// through.
    [[nodiscard]] double reach() {
        int furthest = 0;
        // The uppermost first: what does not reach the surface is passed at once.
        for (int row = count_[2] - 1; row >= 0; --row) {
            for (int file = 0; file < count_[1]; ++file) {
                furthest = std::max(furthest, reach_from({0, file, row}));
                if (furthest == count_[0]) return size_[0];
            }
        }
        return furthest * size_[0] / count_[0];
    }

  private:
    using Cell = std::array<int, 3>;

    /// Columns that are reached from a cell.
    int reach_from(const Cell& start) {
        int furthest = 0;
        std::vector<Cell> pending;
        const auto take = [&](const Cell& cell) {
            if (is_new(cell)) pending.push_back(cell);
        };
        take(start);
        while (!pending.empty()) {
            const auto [i, j, k] = pending.back();
            pending.pop_back();
            furthest = std::max(furthest, i + 1);
            if (furthest == count_[0]) break;
            // The last one is looked at first: straight on.
            for (const int along : {-1, 0, 1}) {
                for (const int across : {-1, 1, 0}) {
                    for (const int up : {-1, 1, 0}) {
                        take({i + along, j + across, k + up});
                    }
                }
            }
        }
        return furthest;
    }

    /// Whether it is an open cell that was not looked at before.
    bool is_new(const Cell& cell) {
        std::size_t number = 0;
        Point3 place{};
        for (std::size_t k = 0; k < 3; ++k) {
            if (cell[k] < 0 || cell[k] >= count_[k]) return false;
            number = number * static_cast<std::size_t>(count_[k]) + static_cast<std::size_t>(cell[k]);
            place[k] = (cell[k] + 0.5) / count_[k] * size_[k];
        }
        if (seen_[number]) return false;
        seen_[number] = true;
        return open_(place);
    }

    std::function<bool(const Point3&)> open_;
    Point3 size_;
    std::array<int, 3> count_{};
    std::vector<bool> seen_;
};

}  // namespace

double highest_way(const Case& c) {
    const double depth = c.total_depth();
    if (c.channel.top == Top::wall) return depth;
    if (c.channel.ends == Ends::open) {
        // Where a discharge comes in, the water rises until it finds a way; beside side walls as far as they
        // stand.
        const bool rises = has_end_tables(c) || (!c.inflow.gives_depth() && !c.has_side_walls());
        return rises ? level_with_room(c) : 1.5 * std::max(depth, highest_end_level(c));
    }
    // A level surface over the sloping bed, over all of it or, where the slope leaves the other end dry, over
    // a part.
    const double fall = std::abs(c.channel.slope) * c.channel.length;
    return fall <= 2.0 * depth ? depth + 0.5 * fall : std::sqrt(2.0 * depth * fall);
}

std::optional<Blockage> blockage(const Case& c) {
    if (!must_pass(c)) return std::nullopt;
    const double level = highest_way(c);
    const bool tall = std::any_of(c.solids.begin(), c.solids.end(), [&](const Solid& solid) {
        const auto upright = extent_of(c, solid, 2);
        return solid.rests() && upright && upright->high > level - c.numerics.spacing;
    });
    if (!tall) return std::nullopt;
    const SolidPlaces solids(c);
    // Among the first solids alone.
    const auto reach_among = [&](std::size_t count) {
        return Cells(c, level,
                     [&](const Point3& p) {
                         const auto solid = solids.resting_at(p);
                         return !solid || *solid >= count;
                     })
            .reach();
    };
    const double reach = reach_among(c.solids.size());
    if (reach >= c.channel.length) return std::nullopt;
    std::size_t last = c.solids.size() - 1;
    while (last > 0 && reach_among(last) < c.channel.length) --last;
    return Blockage{last, reach, level};
}

}  // namespace riffle::inline case_file
