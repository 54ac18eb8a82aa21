#include "roughness/vegetation.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "case/bed_friction.hpp"
#include "case/flow_kind.hpp"

namespace riffle::inline roughness {

namespace {

/// The mixing length of a canopy, below and above the tops of its stems.
class CanopyClosure final : public Closure {
  public:
    CanopyClosure(std::unique_ptr<const Closure> of_bed, std::unique_ptr<const Closure> plain, const Case& c,
                  const Vegetation& stems)
        : of_bed_(std::move(of_bed)),
          plain_(std::move(plain)),
          depth_(c.total_depth()),
          top_(stems.height),
          raised_(displacement_height(stems) - c.turbulence.zero),
          wake_(stems.stem_diameter) {}

    [[nodiscard]] double mixing_length(double z) const override { return mixing_length_in(z, depth_); }
    [[nodiscard]] double mixing_length_in(double z, double depth) const override {
        const auto raised = [&](double height) {
            return plain_->mixing_length_in(height - raised_, depth - raised_);
        };
        if (z >= top_) return raised(z);
        const double of_stems = top_ < depth ? std::max(raised(top_), wake_) : wake_;
        return std::min(of_bed_->mixing_length_in(z, depth), of_stems);
    }
    void mixing_lengths(std::span<const double> z, std::span<double> result) const override {
        for (std::size_t i = 0; i < z.size(); ++i) result[i] = mixing_length(z[i]);
    }
    [[nodiscard]] bool varies_across() const override { return of_bed_->varies_across(); }
    [[nodiscard]] double side_factor(double y) const override { return of_bed_->side_factor(y); }
    [[nodiscard]] double spanwise_ratio() const override { return of_bed_->spanwise_ratio(); }

  private:
    std::unique_ptr<const Closure> of_bed_;
    std::unique_ptr<const Closure> plain_;  ///< without the part of a wall
    double depth_;
    double top_;
    double raised_;  ///< displacement height over the height where the closure's length begins
    double wake_;    ///< of the stems' wakes
};

}  // namespace

VegetationPatch::VegetationPatch(const Case& c, const Vegetation& stems)
    : drag_(stems, c.fluid.kinematic_viscosity), top_(stems.height), area_(c, stems), ground_(c, stems) {}

double VegetationPatch::share_below_top(double z, double row_height) const {
    return std::clamp((top_ - z) / row_height + 0.5, 0.0, 1.0);
}

std::vector<VegetationPatch> vegetation_patches(const Case& c) {
    std::vector<VegetationPatch> patches;
    for (const Vegetation& stems : c.vegetation) patches.emplace_back(c, stems);
    return patches;
}

ReferenceDrag reference_drag(const Case& c, const Vegetation& stems) {
    const StemDrag drag(stems, c.fluid.kinematic_viscosity);
    ReferenceDrag reference;
    if (c.streamwise_gravity() > 0.0) {
        reference.speed = drag.speed_at(c.streamwise_gravity());
    } else if (const auto discharge = c.inflow_unit_discharge()) {
        reference.speed = *discharge / c.total_depth();
    } else {
        reference.speed = 0.1 * std::sqrt(c.fluid.gravity * c.total_depth());
    }
    reference.drag_coefficient = drag.drag_coefficient(reference.speed);
    return reference;
}

std::unique_ptr<const Closure> make_canopy_closure(const Case& c, const Vegetation& stems,
                                                   std::unique_ptr<const Closure> of_bed) {
    if (of_bed == nullptr || !has_mixing_length(c) || displacement_height(stems) <= c.turbulence.zero) {
        return of_bed;
    }
    Case plain = c;
    if (has_wall_law(c)) plain.bed.kind = BedKind::slip;
    return std::make_unique<CanopyClosure>(std::move(of_bed), make_closure(plain), c, stems);
}

std::unique_ptr<const Closure> make_channel_closure(const Case& c) {
    auto closure = make_closure(c);
    const Vegetation* const stems = vegetation_everywhere(c);
    return stems != nullptr ? make_canopy_closure(c, *stems, std::move(closure)) : std::move(closure);
}

}  // namespace riffle::inline roughness
