#include "roughness/particle_bed_drag.hpp"

#include <algorithm>
#include <utility>
#include <vector>

#include "case/bed_patch.hpp"
#include "roughness/patch_area.hpp"
#include "roughness/row_mean_drag.hpp"
#include "roughness/wall_drag.hpp"

namespace riffle::inline roughness {

namespace {

/// Of a bed that is the same everywhere.
std::unique_ptr<const BedDrag> drag_of_one_bed(const Case& c, double row_height) {
    if (auto friction = make_wall_drag(c, row_height)) return row_mean_drag(std::move(friction), row_height);
    auto drag = make_bed_drag(c);
    return drag && c.numerics.drag_sampling == DragSampling::row ? row_mean_drag(std::move(drag), row_height)
                                                                 : std::move(drag);
}

/// The drag of a bed and of patches in it.
class PatchedDrag final : public BedDrag {
  public:
    PatchedDrag(const Case& c, double row_height)
        : width_(c.numerics.spacing), bed_(drag_of_one_bed(c, row_height)) {
        add_bounds(bed_.get());
        for (const BedPatch& patch : c.bed_patches) {
            patches_.push_back({PatchArea(c, patch), drag_of_one_bed(with_bed_of(c, patch), row_height)});
            add_bounds(patches_.back().drag.get());
        }
    }

    [[nodiscard]] double top() const override { return top_; }
    [[nodiscard]] bool varies_in_plan() const override { return true; }
    [[nodiscard]] bool varies_with_speed() const override { return with_speed_; }

    /// Of [bed].
    [[nodiscard]] double coefficient(double z) const override { return bed_ ? bed_->coefficient(z) : 0.0; }
    [[nodiscard]] double coefficient_at(double x, double y, double z) const override {
        double sum = 0.0;
        for_beds_at(x, y,
                    [&](const BedDrag& drag, double share) { sum += share * drag.coefficient_at(x, y, z); });
        return sum;
    }
    [[nodiscard]] double speed_factor_at(double x, double y, double z, double speed) const override {
        double resting = 0.0;
        double moving = 0.0;
        for_beds_at(x, y, [&](const BedDrag& drag, double share) {
            const double beta = share * drag.coefficient_at(x, y, z);
            resting += beta;
            moving += drag.varies_with_speed() && beta > 0.0 ? beta * drag.speed_factor(z, speed) : beta;
        });
        return resting > 0.0 ? moving / resting : 1.0;
    }

  private:
    struct Patch {
        PatchArea area;
        std::unique_ptr<const BedDrag> drag;
    };

    void add_bounds(const BedDrag* drag) {
        if (drag != nullptr) {
            top_ = std::max(top_, drag->top());
            with_speed_ = with_speed_ || drag->varies_with_speed();
        }
    }

    /// visit(drag, share) of each bed under a particle, with the part of it that is over that bed.
    template <class Visit>
    void for_beds_at(double x, double y, const Visit& visit) const {
        double outside = 1.0;
        for (const Patch& patch : patches_) {
            const double share = patch.area.share(x, y, width_);
            outside -= share;
            if (share > 0.0 && patch.drag) visit(*patch.drag, share);
        }
        if (outside > 0.0 && bed_) visit(*bed_, outside);
    }

    double width_;  ///< of a particle, m
    std::unique_ptr<const BedDrag> bed_;
    std::vector<Patch> patches_;
    double top_ = 0.0;
    bool with_speed_ = false;
};

}  // namespace

std::unique_ptr<const BedDrag> make_particle_bed_drag(const Case& c, double row_height) {
    if (c.bed_patches.empty()) return drag_of_one_bed(c, row_height);
    auto drag = std::make_unique<PatchedDrag>(c, row_height);
    return drag->top() > 0.0 ? std::move(drag) : nullptr;
}

}  // namespace riffle::inline roughness
