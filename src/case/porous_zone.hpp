#pragma once

#include <array>
#include <cstddef>
#include <limits>
#include <vector>

#include "case/case.hpp"
#include "case/outline.hpp"

namespace riffle::inline case_file {

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
[[nodiscard]] double share_within(double distance, double edge);

/// Where a porous zone is. Edges at walls and ends of the channel, at bed and sides and at solids have no
/// thickness: the porosity is that of the medium up to them.
class PorousZone {
  public:
    PorousZone(const Case& c, const Porous& porous);

    /// The share of a place (y of a plane is not looked at) that the zone has, 0 to 1.
    [[nodiscard]] double share(double x, double y, double z) const;
    /// Whether a place lies within, its edges taken as sharp.
    [[nodiscard]] bool holds(double x, double y, double z) const;
    /// Height of its top at a place along the channel, m; infinite where it reaches above all water, negative
    /// infinity where the zone is not.
    [[nodiscard]] double top_at(double x) const;
    [[nodiscard]] double edge() const { return edge_; }

  private:
    /// Distance within the outline, negative outside, m; its edges at the bounds of the channel not counted.
    [[nodiscard]] double within_outline(double x, double z) const;
    [[nodiscard]] double top(double x) const;
    /// Make the sides of a box hard that solids lie behind all over.
    void end_at_solids(const Case& c);

    double edge_;
    SoftRange along_;
    SoftRange across_;
    SoftRange upright_;
    Outline outline_;               ///< empty: a box
    std::vector<bool> inner_edge_;  ///< of the outline, by edge: whether there is water beyond it
    std::vector<double> top_x_;     ///< empty: level
    std::vector<double> top_z_;
    double length_;  ///< of a periodic channel; 0
};

/// The outline of a zone in a plane along the channel, up to a height of what is shown (m): its own one, or
/// that of its box, with the heights of its top at 200 places where they change along it.
[[nodiscard]] Outline porous_outline(const Case& c, const Porous& zone, double top);

/// The porosity of all of a case.
class PorosityField {
  public:
    explicit PorosityField(const Case& c);

    /// The porosity at a place: 1 in the open water.
    [[nodiscard]] double porosity(double x, double y, double z) const;
    template <std::size_t D>
    [[nodiscard]] double porosity(const std::array<double, D>& place) const {
        return porosity(place[0], D == 3 ? place[1] : 0.0, place[D - 1]);
    }
    [[nodiscard]] const std::vector<PorousZone>& zones() const { return zones_; }
    /// 1 - n of the medium of each zone.
    [[nodiscard]] const std::vector<double>& solid() const { return solid_; }
    [[nodiscard]] bool empty() const { return zones_.empty(); }

  private:
    std::vector<PorousZone> zones_;
    std::vector<double> solid_;  ///< 1 - n of each
};

/// Thickness of the edge of a zone, m: `edge`, or so many smoothing lengths that a smooth step of it has the
/// standard deviation of the kernel.
[[nodiscard]] double porous_edge(const Case& c, const Porous& porous);

/// Whether a section along the channel goes through a zone: at a place across it, m, in space.
[[nodiscard]] bool is_cut_at(const Case& c, const Porous& zone, double y);

/// Whether a zone is the same all along the channel, and from side to side.
[[nodiscard]] bool covers_length(const Case& c, const Porous& porous);
[[nodiscard]] bool covers_width(const Case& c, const Porous& porous);

/// Whether a porous zone makes the flow change along the channel.
[[nodiscard]] bool porosity_varies_along(const Case& c);

}  // namespace riffle::inline case_file
