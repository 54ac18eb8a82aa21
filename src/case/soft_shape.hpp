#pragma once

#include <algorithm>
#include <array>
#include <limits>
#include <vector>

#include "case/outline.hpp"

namespace riffle::inline case_file {

// Shapes whose edges have a thickness: over it the share of a place that lies within goes from 0 to 1.

/// A range along an axis whose ends are as sharp as an edge of some thickness: what lies at its ends as half
/// in it. An end at infinity is none.
struct SoftRange {
    double from = -std::numeric_limits<double>::infinity();
    double to = std::numeric_limits<double>::infinity();
    double period = 0.0;     ///< after which it comes again, m; 0: never
    bool hard_from = false;  ///< an end at a solid: all of a place within, nothing of one beyond
    bool hard_to = false;

    /// The share of a place that lies within, for an edge of this thickness, m. Its integral is the length of
    /// the range.
    [[nodiscard]] double share(double place, double edge) const;
    [[nodiscard]] bool holds(double place) const;
};

/// The share of a place at so far a distance within a surface (negative: outside, m) that lies within, for an
/// edge of this thickness: 1/2 at the surface, 1 from half of the thickness on; smooth.
[[nodiscard]] inline double share_within(double distance, double edge) {
    const double t = std::clamp(distance / edge + 0.5, 0.0, 1.0);
    return t * t * (3.0 - 2.0 * t);
}

/// Where the water of a channel ends along the two axes of an outline.
struct WaterBounds {
    std::array<double, 2> from{-std::numeric_limits<double>::infinity(),
                               -std::numeric_limits<double>::infinity()};  ///< m
    std::array<double, 2> to{std::numeric_limits<double>::infinity(),
                             std::numeric_limits<double>::infinity()};
    std::array<double, 2> periods{};  ///< after which an outline comes again, m; 0: never
};

/// An outline with such edges. The share of a place is the part of the water there that lies within, each
/// place taken as a square of the edge's thickness with most weight in its middle: shares of outlines beside
/// each other have the sum 1, at corners and bounds too, and those of a rectangle that is thicker than its
/// edges are the product of two SoftRange. Beyond an edge at a solid there is no water.
class SoftOutline {
  public:
    SoftOutline() = default;  ///< without corners: none
    /// `at_solid`: by edge, from the corner of its number to the next; `edge`: the thickness, m; `touch`: how
    /// far beyond an edge at a solid a particle may stand, m.
    SoftOutline(Outline outline, std::vector<bool> at_solid, const WaterBounds& bounds, double edge,
                double touch);

    [[nodiscard]] bool empty() const { return outline_.size() == 0; }
    [[nodiscard]] const Outline& outline() const { return outline_; }
    /// The share of a place that lies within.
    [[nodiscard]] double share(double first, double second) const;
    [[nodiscard]] bool holds(double first, double second) const;

  private:
    /// Of the outline itself, without its images, over all of the place.
    [[nodiscard]] double own_share(double first, double second) const;
    /// The part of a place that is not behind the edges at solids; 0 behind one.
    [[nodiscard]] double before_solids(double first, double second) const;
    [[nodiscard]] std::size_t strip_of(double second) const;

    Outline outline_;
    std::vector<bool> at_solid_;  ///< empty: no edge is
    WaterBounds bounds_;
    double turn_ = 1.0;  ///< -1: clockwise
    std::array<double, 2> first_range_{};
    std::array<double, 2> second_range_{};
    std::vector<std::array<double, 2>> images_;  ///< how far along the axes it and its images next door stand
    /// The edges that strips along the first axis feel, a strip's width each.
    std::vector<std::vector<std::size_t>> strips_;
    double strip_ = 0.0;  ///< that width, m
    double edge_ = 0.0;
    double touch_ = 0.0;
};

}  // namespace riffle::inline case_file
