#include "roughness/wall_drag.hpp"

#include <utility>

#include "turbulence/wall_law.hpp"
#include "turbulence/wall_layer.hpp"

namespace riffle::inline roughness {

namespace {

class WallDrag final : public BedDrag {
  public:
    explicit WallDrag(WallLayer layer) : layer_(std::move(layer)) {}

    [[nodiscard]] double coefficient(double z) const override { return layer_.drag_coefficient(z); }
    [[nodiscard]] double top() const override { return layer_.drag_top(); }
    [[nodiscard]] bool varies_with_speed() const override { return true; }
    [[nodiscard]] double speed_factor(double z, double speed) const override {
        return layer_.speed_factor(z, speed);
    }

  private:
    WallLayer layer_;
};

}  // namespace

std::unique_ptr<const BedDrag> make_wall_drag(const Case& c, double row_height) {
    return has_wall_law(c) ? std::make_unique<WallDrag>(WallLayer(c, row_height)) : nullptr;
}

}  // namespace riffle::inline roughness
