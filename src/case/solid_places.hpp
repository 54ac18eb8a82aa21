#pragma once

#include <cstddef>
#include <memory>
#include <optional>
#include <vector>

#include "case/case.hpp"
#include "case/outline.hpp"
#include "case/plan_outline.hpp"
#include "case/triangle.hpp"

namespace riffle::inline case_file {

/// Which places of a channel solids take up at the start: of those whose shapes are known, and in two
/// dimensions with their images beyond periodic ends.
class SolidPlaces {
  public:
    explicit SolidPlaces(const Case& c);

    /// Whether a place lies in a solid; in two dimensions y does not count.
    [[nodiscard]] bool holds(std::size_t solid, const Point3& p) const;
    /// The first solid at rest, but for `left_out`, that a place lies in.
    [[nodiscard]] std::optional<std::size_t> resting_at(
        const Point3& p, std::optional<std::size_t> left_out = std::nullopt) const;

  private:
    const Case& c_;
    double period_ = 0.0;            ///< along the channel, m; 0: none
    std::vector<Outline> outlines_;  ///< two dimensions; empty where they are none
};

/// The part of a section of a channel, at x and up to a height (m), whose places are open: of the middles of
/// so many equal parts over the height and, in three dimensions, across.
template <class Open>
[[nodiscard]] double open_share(const Case& c, double x, double height, int rows, int files,
                                const Open& is_open) {
    const double width = c.channel.simulated_width();
    int open = 0;
    for (int file = 0; file < files; ++file) {
        for (int row = 0; row < rows; ++row) {
            const Point3 place{x, width * (file + 0.5) / files, height * (row + 0.5) / rows};
            open += is_open(place) ? 1 : 0;
        }
    }
    return static_cast<double>(open) / (files * rows);
}

/// Where there may be water along an axis, but for solids, m: beyond is a wall. Without bounds where the
/// channel repeats, or is open to the air.
[[nodiscard]] PatchRange water_range(const Case& c, std::size_t axis);

/// Whether there may be water at a place, but for solids.
[[nodiscard]] bool is_in_channel(const Case& c, const Point3& p);

}  // namespace riffle::inline case_file
