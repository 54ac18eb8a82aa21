#pragma once

#include <cstddef>
#include <span>
#include <utility>

#include "column/section.hpp"
#include "ends/velocity_shape.hpp"
#include "particles/domain.hpp"

namespace riffle::inline ends {

/// The velocity of the water that enters a channel over the mean velocity of its section, by the place y
/// across the channel (m) and the height over the depth, z/H.
class EnteringFlow {
  public:
    EnteringFlow() = default;
    EnteringFlow(const EnteringFlow&) = delete;
    EnteringFlow& operator=(const EnteringFlow&) = delete;
    virtual ~EnteringFlow() = default;

    /// Along the channel, in the mean over time.
    [[nodiscard]] virtual double mean_at(double y, double place) const = 0;
    /// (u, v, w) at a time, s.
    [[nodiscard]] virtual Vec<3> at(double /*time*/, double y, double place) const {
        return {mean_at(y, place), 0.0, 0.0};
    }
    /// The largest along the channel, in the mean over time.
    [[nodiscard]] virtual double largest() const = 0;
    /// The largest along the channel at any time.
    [[nodiscard]] virtual double fastest() const { return largest(); }
    /// Mean along the channel over so many rows above each other, at the places y of the files beside each
    /// other: a discharge in streams is exact with the flow over it.
    [[nodiscard]] virtual double mean_of_streams(double time, int rows, std::span<const double> files) const;
    /// Bytes that it holds.
    [[nodiscard]] virtual std::size_t bytes() const { return 0; }
};

/// A profile over the height, the same all across the channel and for all time.
class ProfileFlow final : public EnteringFlow {
  public:
    explicit ProfileFlow(VelocityShape shape) : shape_(std::move(shape)) {}

    [[nodiscard]] double mean_at(double /*y*/, double place) const override { return shape_.at(place); }
    [[nodiscard]] double largest() const override { return shape_.largest(); }
    [[nodiscard]] double mean_of_streams(double /*time*/, int rows,
                                         std::span<const double> /*files*/) const override {
        return shape_.mean_of_rows(rows);
    }

  private:
    VelocityShape shape_;
};

/// The flow of a cross-section twin, of water of this depth (m).
class SectionFlow final : public EnteringFlow {
  public:
    SectionFlow(SectionResult section, double depth) : section_(std::move(section)), depth_(depth) {}

    [[nodiscard]] double mean_at(double y, double place) const override {
        return section_.velocity_at(y, place * depth_) / section_.bulk_velocity;
    }
    [[nodiscard]] double largest() const override {
        return section_.maximum_velocity / section_.bulk_velocity;
    }

  private:
    SectionResult section_;
    double depth_;
};

}  // namespace riffle::inline ends
