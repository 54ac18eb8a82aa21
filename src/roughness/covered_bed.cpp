#include "roughness/covered_bed.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <utility>
#include <vector>

#include "case/stem_feet.hpp"
#include "roughness/plan_table.hpp"

namespace riffle::inline roughness {

namespace {

/// Share of the bed that solids at rest cover: looked up once in the middles of cells half a spacing wide.
struct Cover {
    PlanTable share;
    bool matters = false;  ///< whether a solid is so low that water above it lies in the reach of the drag
};

Cover cover_of(const Case& c, double reach) {
    const double half = 0.5 * c.numerics.spacing;
    const auto middles = [half](double extent) {
        const double cells = std::max(1.0, std::round(extent / half));
        return PlanTable::Axis{0.5 * extent / cells, extent / cells, static_cast<std::size_t>(cells)};
    };
    const auto along = middles(c.channel.length);
    const auto across = c.channel.dimensions == 3 ? middles(c.channel.width) : PlanTable::Axis{};
    std::vector<double> share(along.count * across.count, 0.0);
    bool matters = false;
    for (const Solid& solid : c.solids) {
        if (!solid.rests()) continue;
        for (std::size_t j = 0; j < across.count; ++j) {
            for (std::size_t i = 0; i < along.count; ++i) {
                const auto extent = solid_extent(c, solid, along.at(i), across.at(j));
                // One that hangs over the bed covers nothing, and over a film less than half a spacing thick
                // the water is that of the bed.
                if (!extent || extent->low > half || extent->high < half) continue;
                share[j * along.count + i] = 1.0;
                matters = matters || extent->high < reach;
            }
        }
    }
    return {{along, across, std::move(share)}, matters};
}

class CoveredDrag final : public BedDrag {
  public:
    CoveredDrag(std::unique_ptr<const BedDrag> drag, PlanTable covered)
        : drag_(std::move(drag)), covered_(std::move(covered)) {}

    [[nodiscard]] double coefficient(double z) const override { return drag_->coefficient(z); }
    [[nodiscard]] double top() const override { return drag_->top(); }
    [[nodiscard]] bool varies_in_plan() const override { return true; }
    [[nodiscard]] double coefficient_at(double x, double y, double z) const override {
        const double open = 1.0 - covered_.at(x, y);
        return open > 0.0 ? open * drag_->coefficient_at(x, y, z) : 0.0;
    }
    [[nodiscard]] bool varies_with_speed() const override { return drag_->varies_with_speed(); }
    [[nodiscard]] double speed_factor(double z, double speed) const override {
        return drag_->speed_factor(z, speed);
    }
    [[nodiscard]] double speed_factor_at(double x, double y, double z, double speed) const override {
        return drag_->speed_factor_at(x, y, z, speed);
    }

  private:
    std::unique_ptr<const BedDrag> drag_;
    PlanTable covered_;
};

}  // namespace

std::unique_ptr<const BedDrag> drag_beside_solids(const Case& c, std::unique_ptr<const BedDrag> drag) {
    if (!drag || c.solids.empty()) return drag;
    Cover cover = cover_of(c, drag->top());
    if (!cover.matters) return drag;
    return std::make_unique<CoveredDrag>(std::move(drag), std::move(cover.share));
}

}  // namespace riffle::inline roughness
