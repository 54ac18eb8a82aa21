#pragma once

#include <array>
#include <cstddef>
#include <vector>

#include "case/case.hpp"
#include "case/outline.hpp"
#include "case/plan_outline.hpp"
#include "case/soft_shape.hpp"

namespace riffle::inline case_file {

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
    [[nodiscard]] double top(double x) const;
    /// From its bottom to its top where that is lowest, no higher than the water.
    [[nodiscard]] SoftRange upright_within(const Case& c) const;
    /// Make the sides of a box hard that solids lie behind all over.
    void end_at_solids(const Case& c);

    double edge_;
    SoftRange along_;
    SoftRange across_;
    SoftRange upright_;
    SoftOutline from_the_side_;  ///< in place of along_ and upright_
    SoftOutline in_plan_;        ///< in place of along_ and across_
    std::vector<double> top_x_;  ///< empty: level
    std::vector<double> top_z_;
};

/// What a section along the channel cuts of a zone, at a place across it (m; in a plane not looked at), up to
/// a height of what is shown (m): its outline, or boxes, with the heights of its top at 200 places where they
/// change along it.
[[nodiscard]] std::vector<Outline> porous_cuts_along(const Case& c, const Porous& zone, double y, double top);

/// What a section across the channel cuts of a zone at a place along it, m: ranges over the width, and of
/// each its bottom and top, m, up to a height of what is shown.
struct PorousCut {
    PatchRange across;
    PatchRange upright;
};
[[nodiscard]] std::vector<PorousCut> porous_cuts_across(const Case& c, const Porous& zone, double x,
                                                        double top);

/// What a zone covers in plan.
[[nodiscard]] Outline plan_of(const Case& c, const Porous& zone);

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

/// Whether the zone has an outline along the channel, seen from its side, in place of a box or one in plan.
[[nodiscard]] inline bool is_seen_from_the_side(const Porous& zone) {
    return !zone.x.empty() && !zone.z.empty();
}

/// Thickness of the edge of a zone, m: `edge`, or so many smoothing lengths that a smooth step of it has the
/// standard deviation of the kernel.
[[nodiscard]] double porous_edge(const Case& c, const Porous& porous);

/// Whether a zone is the same all along the channel, and from side to side.
[[nodiscard]] bool covers_length(const Case& c, const Porous& porous);
[[nodiscard]] bool covers_width(const Case& c, const Porous& porous);

/// Whether a porous zone makes the flow change along the channel.
[[nodiscard]] bool porosity_varies_along(const Case& c);

}  // namespace riffle::inline case_file
