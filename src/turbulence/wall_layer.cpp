#include "turbulence/wall_layer.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>

#include "base/interpolation.hpp"
#include "turbulence/closure.hpp"
#include "turbulence/wall_law.hpp"

namespace riffle::inline turbulence {

namespace {

constexpr double rows_of_drag = 3.0;

constexpr std::size_t cells = 400;

/// How much the velocity of the layer lies below that at its top: the integral of slope (1 - t)(1 + 2 t +
/// bend t^2), which begins with the slope and the curvature of a logarithm.
double wall_layer_deficit(double slope, double bend, double t) {
    return slope * t * (1.0 + t * (0.5 + t * ((bend - 2.0) / 3.0 - 0.25 * bend * t)));
}

/// The layer at one friction velocity; lengths in m, velocities over u_*.
struct Layer {
    double height = 0.0;
    double drag_top = 0.0;
    double top = 0.0;
    double slope = 0.0;
    double bend = 0.0;
    double mean_square = 0.0;           ///< of the velocity
    double drag_coefficient = 0.0;      ///< at the bed, 1/m
    std::vector<double> z;              ///< of the faces of the cells
    std::vector<double> mixing_length;  ///< there

    /// The drag over that at the bed.
    [[nodiscard]] double drag_shape(double at) const { return std::max(0.0, 1.0 - at / drag_top); }
    [[nodiscard]] double velocity(double at) const {
        const double t = 1.0 - at / height;
        return top - wall_layer_deficit(slope, bend, t);
    }
    [[nodiscard]] double gradient(double at) const {
        const double t = 1.0 - at / height;
        return slope * (1.0 - t) * (1.0 + t * (2.0 + bend * t)) / height;
    }
};

/// Stress at the bed, over u_*^2, that is left where the flow above has the velocity of the law at the top of
/// the layer and a drag of `beta` acts below.
double stress_left(const Layer& layer, double depth, double viscous_length, double beta) {
    double velocity = layer.top;
    double stress = 1.0 - layer.height / depth;
    for (std::size_t i = cells; i-- > 0 && stress > 0.0;) {
        const double step = layer.z[i + 1] - layer.z[i];
        const double length = 0.5 * (layer.mixing_length[i] + layer.mixing_length[i + 1]);
        const double carried =
            viscous_length + std::sqrt(viscous_length * viscous_length + 4.0 * length * length * stress);
        const double gradient = carried > 0.0 ? 2.0 * stress / carried : 0.0;
        const double middle = velocity - 0.5 * step * gradient;
        const double drag = beta * layer.drag_shape(0.5 * (layer.z[i] + layer.z[i + 1]));
        stress -= step * (drag * middle * std::abs(middle) - 1.0 / depth);
        velocity -= step * gradient;
    }
    return stress;
}

/// beta that takes all of the stress. Where viscosity carries a part of it, near to a smooth wall, and where
/// the mixing length is cut, the layer's flow is not quite the one that was drawn: this beta keeps the
/// velocity at its top.
double drag_coefficient_of(const Layer& layer, double depth, double viscous_length, double guess) {
    double low = std::log(guess) - std::log(10.0);
    double high = std::log(guess) + std::log(10.0);
    constexpr int halvings = 44;
    for (int i = 0; i < halvings; ++i) {
        const double middle = 0.5 * (low + high);
        (stress_left(layer, depth, viscous_length, std::exp(middle)) > 0.0 ? low : high) = middle;
    }
    return std::exp(0.5 * (low + high));
}

Layer make_layer(const Case& c, double height, double drag_top, double friction_velocity) {
    const double depth = c.total_depth();
    const WallLaw law = *bed_wall_law(c, friction_velocity);
    const auto closure = make_wall_closure(c, law);
    const UniformProfile profile([&](double z) { return closure->mixing_length(z); }, law, depth);

    Layer layer;
    layer.height = height;
    layer.drag_top = drag_top;
    layer.top = profile.velocity(height);
    layer.slope = height * profile.gradient(height);
    // The mean over the layer is top - slope (1/2 + bend/30).
    layer.bend = 30.0 * ((layer.top - profile.mean(height)) / layer.slope - 0.5);
    double square_sum = 0.0;
    std::vector<double> drag_sum{0.0};
    layer.z.push_back(0.0);
    const double step = height / static_cast<double>(cells);
    for (std::size_t i = 0; i < cells; ++i) {
        const double middle = (static_cast<double>(i) + 0.5) * step;
        const double square = layer.velocity(middle) * layer.velocity(middle);
        square_sum += step * square;
        drag_sum.push_back(drag_sum.back() + step * layer.drag_shape(middle) * square);
        layer.z.push_back(static_cast<double>(i + 1) * step);
    }
    layer.mean_square = square_sum / height;
    const double at_top = closure->mixing_length(height);
    for (std::size_t i = 0; i <= cells; ++i) {
        const double stress = std::max(0.0, drag_sum[i] / drag_sum.back() - layer.z[i] / depth);
        const double gradient = layer.gradient(layer.z[i]);
        // No longer than at the top of the layer: at the bed itself there is no shear to carry the stress.
        const double square = stress / (gradient * gradient) - law.viscous_length / gradient;
        layer.mixing_length.push_back(i == 0 ? at_top : std::min(std::sqrt(std::max(0.0, square)), at_top));
    }
    layer.drag_coefficient = drag_coefficient_of(layer, depth, law.viscous_length, 1.0 / drag_sum.back());
    return layer;
}

}  // namespace

WallLayer::WallLayer(const Case& given, double row_height)
    : height_(rows_of_wall_layer * row_height),
      drag_top_(rows_of_drag * row_height),
      friction_velocity_(reference_friction_velocity(given)) {
    const Case c = with_fixed_roughness(given);
    const Layer layer = make_layer(c, height_, drag_top_, friction_velocity_);
    drag_coefficient_ = layer.drag_coefficient;
    top_ = layer.top;
    slope_ = layer.slope;
    bend_ = layer.bend;
    z_ = layer.z;
    mixing_length_ = layer.mixing_length;
    if (c.fluid.kinematic_viscosity <= 0.0) return;
    constexpr int octaves = 5;
    for (int half = -2 * octaves; half <= 2 * octaves; ++half) {
        const double ratio = std::exp2(0.5 * half);
        const Layer other = half == 0 ? layer : make_layer(c, height_, drag_top_, ratio * friction_velocity_);
        log_speed_.push_back(std::log(ratio * std::sqrt(other.mean_square / layer.mean_square)));
        log_factor_.push_back(std::log(other.drag_coefficient / layer.drag_coefficient));
    }
}

double WallLayer::drag_coefficient(double z) const {
    return z < 0.0 ? 0.0 : drag_coefficient_ * std::max(0.0, 1.0 - z / drag_top_);
}

double WallLayer::mixing_length(double z) const { return place_in(z_, z).in(mixing_length_); }

double WallLayer::velocity(double z) const {
    const double t = 1.0 - std::clamp(z / height_, 0.0, 1.0);
    return friction_velocity_ * (top_ - wall_layer_deficit(slope_, bend_, t));
}

double WallLayer::speed_factor(double z, double speed) const {
    if (log_speed_.empty() || !(speed > 0.0)) return 1.0;
    const double place = std::log(speed / velocity(z));
    return std::exp(place_in(log_speed_, place).in(log_factor_));
}

}  // namespace riffle::inline turbulence
