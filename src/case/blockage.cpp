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
    }

    /// How far water comes from x = 0 by open cells that touch each other, m; the length where it comes
    /// through. `wide`: by squares of so many open cells upward and, in space, across; upward they may reach
    /// over the level.
    [[nodiscard]] double reach(int wide = 1) {
        wide_ = {size_[1] > 0.0 ? wide : 1, wide};
        const auto cells = [this](int levels) {
            return static_cast<std::size_t>(count_[0]) * static_cast<std::size_t>(count_[1]) *
                   static_cast<std::size_t>(levels);
        };
        seen_.assign(cells(count_[2]), false);
        known_.resize(std::max(known_.size(), cells(count_[2] + wide)), unknown);
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
    static constexpr signed char unknown = -1;

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

    /// Of a cell in the channel, which may lie over the level; by levels, so that those above come last.
    [[nodiscard]] std::size_t number_of(const Cell& cell) const {
        return (static_cast<std::size_t>(cell[2]) * static_cast<std::size_t>(count_[1]) +
                static_cast<std::size_t>(cell[1])) *
                   static_cast<std::size_t>(count_[0]) +
               static_cast<std::size_t>(cell[0]);
    }

    /// Whether it is an open square that was not looked at before, by its lowest cell.
    bool is_new(const Cell& cell) {
        const bool outside = cell[0] < 0 || cell[0] >= count_[0] || cell[1] < 0 ||
                             cell[1] + wide_[0] > count_[1] || cell[2] < 0 || cell[2] >= count_[2];
        if (outside || seen_[number_of(cell)]) return false;
        seen_[number_of(cell)] = true;
        for (int up = 0; up < wide_[1]; ++up) {
            for (int across = 0; across < wide_[0]; ++across) {
                if (!is_open({cell[0], cell[1] + across, cell[2] + up})) return false;
            }
        }
        return true;
    }

    bool is_open(const Cell& cell) {
        signed char& known = known_[number_of(cell)];
        if (known == unknown) {
            Point3 place{};
            for (std::size_t k = 0; k < 3; ++k) place[k] = (cell[k] + 0.5) / count_[k] * size_[k];
            known = open_(place) ? 1 : 0;
        }
        return known == 1;
    }

    std::function<bool(const Point3&)> open_;
    Point3 size_;
    std::array<int, 3> count_{};
    std::array<int, 2> wide_{1, 1};  ///< of the squares, across and upward
    std::vector<bool> seen_;
    std::vector<signed char> known_;  ///< whether cells are open
};

/// Whether a solid at rest reaches up to where the water might pass over all of them.
bool has_tall_solid(const Case& c, double level) {
    return std::any_of(c.solids.begin(), c.solids.end(), [&](const Solid& solid) {
        const auto upright = extent_of(c, solid, 2);
        return solid.rests() && upright && upright->high > level - c.numerics.spacing;
    });
}

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
    if (!has_tall_solid(c, level)) return std::nullopt;
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

std::optional<Narrows> narrowest_way(const Case& c, int most) {
    if (!must_pass(c) || !has_tall_solid(c, highest_way(c))) return std::nullopt;
    const SolidPlaces solids(c);
    Cells cells(c, highest_way(c), [&](const Point3& p) { return !solids.resting_at(p); });
    double reach = cells.reach(most);
    if (reach >= c.channel.length) return std::nullopt;
    for (int wide = most - 1; wide > 0; --wide) {
        const double narrower = cells.reach(wide);
        if (narrower >= c.channel.length) return Narrows{wide, reach};
        reach = narrower;
    }
    return std::nullopt;
}

}  // namespace riffle::inline case_file
