#include "roughness/row_mean_drag.hpp"

#include <algorithm>
#include <array>
#include <cstddef>
#include <utility>
#include <vector>

namespace riffle::inline roughness {

namespace {

/// Intervals between the bed level and the top of the drag: the error of the linear interpolation is largest
/// at the crests, where the drag of a sphere sets in, some 4e-6 of the mean there over rows of d_h/7.
constexpr std::size_t intervals = 4096;

/// Integrals of the drag from the bed level to the ends of each interval, by the midpoints of 16 parts.
std::vector<double> integrals(const BedDrag& drag) {
    constexpr std::size_t parts = 16;
    const double part = drag.top() / static_cast<double>(intervals * parts);
    std::vector<double> sums{0.0};
    for (std::size_t i = 0; i < intervals; ++i) {
        double sum = 0.0;
        for (std::size_t k = 0; k < parts; ++k) {
            sum += drag.coefficient((static_cast<double>(i * parts + k) + 0.5) * part);
        }
        sums.push_back(sums.back() + sum * part);
    }
    return sums;
}

class RowMeanDrag final : public BedDrag {
  public:
    RowMeanDrag(std::unique_ptr<const BedDrag> drag, double row_height)
        : drag_(std::move(drag)),
          integral_(integrals(*drag_)),
          half_row_(0.5 * row_height),
          per_height_(static_cast<double>(intervals) / drag_->top()) {}

    [[nodiscard]] double coefficient(double z) const override {
        return (integral_to(z + half_row_) - integral_to(z - half_row_)) / (2.0 * half_row_);
    }

    [[nodiscard]] double coefficient_at(double x, double y, double z) const override {
        if (!drag_->varies_in_plan()) return coefficient(z);
        // Gauss-Legendre quadrature of four points.
        constexpr std::array<double, 2> place{0.339981043584856264803, 0.861136311594052575224};
        constexpr std::array<double, 2> weight{0.326072569768569630, 0.173927430231430370};
        double sum = 0.0;
        for (std::size_t k = 0; k < place.size(); ++k) {
            for (const double side : {-half_row_, half_row_}) {
                sum += weight[k] * drag_->coefficient_at(x, y, z + side * place[k]);
            }
        }
        return sum;
    }
    [[nodiscard]] bool varies_in_plan() const override { return drag_->varies_in_plan(); }
    [[nodiscard]] bool varies_with_speed() const override { return drag_->varies_with_speed(); }
    [[nodiscard]] double speed_factor(double z, double speed) const override {
        return drag_->speed_factor(z, speed);
    }

    [[nodiscard]] double top() const override { return drag_->top() + half_row_; }

  private:
    [[nodiscard]] double integral_to(double z) const {
        const double place = std::clamp(z * per_height_, 0.0, static_cast<double>(intervals));
        const std::size_t low = std::min(static_cast<std::size_t>(place), intervals - 1);
        return integral_[low] + (place - static_cast<double>(low)) * (integral_[low + 1] - integral_[low]);
    }

    std::unique_ptr<const BedDrag> drag_;
    std::vector<double> integral_;
    double half_row_;
    double per_height_;  ///< intervals per height, 1/m
};

}  // namespace

std::unique_ptr<const BedDrag> row_mean_drag(std::unique_ptr<const BedDrag> drag, double row_height) {
    return std::make_unique<RowMeanDrag>(std::move(drag), row_height);
}

}  // namespace riffle::inline roughness
