#include "roughness/covered_bed.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <utility>
#include <vector>

#include "case/stem_feet.hpp"

namespace riffle::inline roughness {

namespace {

/// Which part of the bed solids at rest cover: looked up once in the middles of cells half a spacing wide,
/// linear between them.
class Cover {
  public:
    Cover(const Case& c, double reach) {
        const double half = 0.5 * c.numerics.spacing;
        const auto axis = [half](double extent) {
            const double cells = std::max(1.0, std::round(extent / half));
            return Axis{extent / cells, static_cast<std::size_t>(cells)};
        };
        along_ = axis(c.channel.length);
        across_ = c.channel.dimensions == 3 ? axis(c.channel.width) : Axis{1.0, 1};
        share_.assign(along_.cells * across_.cells, 0.0);
        for (const Solid& solid : c.solids) {
            if (!solid.rests()) continue;
            for (std::size_t j = 0; j < across_.cells; ++j) {
                for (std::size_t i = 0; i < along_.cells; ++i) {
                    const auto extent = solid_extent(c, solid, along_.middle(i),
                                                     c.channel.dimensions == 3 ? across_.middle(j) : 0.0);
                    // One that hangs over the bed covers nothing, and over a film less than half a spacing
                    // thick the water is that of the bed.
                    if (!extent || extent->low > half || extent->high < half) continue;
                    share_[j * along_.cells + i] = 1.0;
                    matters_ = matters_ || extent->high < reach;
                }
            }
        }
    }

    /// Whether a solid is so low that water above it lies in the reach of the drag.
    [[nodiscard]] bool matters() const { return matters_; }

    [[nodiscard]] double at(double x, double y) const {
        const Between i = along_.between(x);
        const Between j = across_.between(y);
        const auto on_line = [&](std::size_t line) {
            const double* const values = &share_[line * along_.cells];
            return values[i.low] + i.share * (values[i.high] - values[i.low]);
        };
        const double here = on_line(j.low);
        return here + j.share * (on_line(j.high) - here);
    }

  private:
    struct Between {
        std::size_t low = 0;
        std::size_t high = 0;
        double share = 0.0;
    };
    struct Axis {
        double step = 1.0;
        std::size_t cells = 1;

        [[nodiscard]] double middle(std::size_t cell) const {
            return (static_cast<double>(cell) + 0.5) * step;
        }
        [[nodiscard]] Between between(double place) const {
            const double at = std::clamp(place / step - 0.5, 0.0, static_cast<double>(cells - 1));
            const auto low = static_cast<std::size_t>(at);
            return {low, std::min(low + 1, cells - 1), at - static_cast<double>(low)};
        }
    };

    Axis along_;
    Axis across_;
    std::vector<double> share_;  ///< [across, along]
    bool matters_ = false;
};

class CoveredDrag final : public BedDrag {
  public:
    CoveredDrag(std::unique_ptr<const BedDrag> drag, Cover cover)
        : drag_(std::move(drag)), cover_(std::move(cover)) {}

    [[nodiscard]] double coefficient(double z) const override { return drag_->coefficient(z); }
    [[nodiscard]] double top() const override { return drag_->top(); }
    [[nodiscard]] bool varies_in_plan() const override { return true; }
    [[nodiscard]] double coefficient_at(double x, double y, double z) const override {
        const double open = 1.0 - cover_.at(x, y);
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
    Cover cover_;
};

}  // namespace

std::unique_ptr<const BedDrag> drag_beside_solids(const Case& c, std::unique_ptr<const BedDrag> drag) {
    if (!drag || c.solids.empty()) return drag;
    Cover cover(c, drag->top());
    if (!cover.matters()) return drag;
    return std::make_unique<CoveredDrag>(std::move(drag), std::move(cover));
}

}  // namespace riffle::inline roughness
