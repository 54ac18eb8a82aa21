#include "column/momentum_balance.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>

#include "case/bed_traits.hpp"
#include "case/flow_kind.hpp"
#include "roughness/bed_drag.hpp"
#include "roughness/vegetation.hpp"
#include "turbulence/wall_law.hpp"

namespace riffle::inline column {

std::vector<double> Tridiagonal::solve(std::vector<double> b) const {
    const std::size_t n = diagonal.size();
    std::vector<double> pivot(diagonal);
    for (std::size_t i = 1; i < n; ++i) {
        const double factor = off[i - 1] / pivot[i - 1];
        pivot[i] -= factor * off[i - 1];
        b[i] -= factor * b[i - 1];
    }
    b[n - 1] /= pivot[n - 1];
    for (std::size_t i = n - 1; i-- > 0;) b[i] = (b[i] - off[i] * b[i + 1]) / pivot[i];
    return b;
}

MomentumBalance::MomentumBalance(const Case& c, const ColumnGrid& grid)
    : weight_(c.streamwise_gravity()),
      viscosity_(c.fluid.kinematic_viscosity),
      wall_below_(rests_at_bed(c)),
      wall_above_(is_no_slip(c.bed) && c.channel.top == Top::wall),
      depth_(grid.face.back()) {
    const std::size_t n = grid.centre.size();
    thickness_.resize(n);
    for (std::size_t i = 0; i < n; ++i) thickness_[i] = grid.face[i + 1] - grid.face[i];

    distance_.resize(n + 1);
    distance_[0] = grid.centre[0] - grid.face[0];
    for (std::size_t i = 1; i < n; ++i) distance_[i] = grid.centre[i] - grid.centre[i - 1];
    distance_[n] = grid.face[n] - grid.centre[n - 1];

    length_squared_.assign(n + 1, 0.0);
    cell_length_.assign(n, 0.0);
    if (const auto closure = make_channel_closure(c)) {
        closure->mixing_lengths(grid.face, length_squared_);
        for (double& l : length_squared_) l *= l;
        closure->mixing_lengths(grid.centre, cell_length_);
    }
    drag_coefficient_.assign(n, 0.0);
    if (const auto drag = make_bed_drag(c)) drag->coefficients(grid.centre, drag_coefficient_);
    if (const Vegetation* const stems = vegetation_everywhere(c)) {
        const VegetationPatch patch(c, *stems);
        stems_ = patch.drag();
        for (std::size_t i = 0; i < n; ++i) {
            stem_share_.push_back(patch.share_below_top(grid.centre[i], thickness_[i]));
        }
    }
    if (const PorousMedia porous(c); !porous.empty()) {
        for (const double z : grid.centre) media_.push_back(porous.at(0.0, 0.0, z));
        for (std::size_t i = 0; i <= n; ++i) {
            const double z = grid.face[i];
            face_ratio_.push_back(porous.at(0.0, 0.0, z).viscosity_ratio);
            const double limited = porous.limited(std::sqrt(length_squared_[i]), 0.0, 0.0, z);
            length_squared_[i] = limited * limited;
        }
        for (std::size_t i = 0; i < n; ++i) {
            cell_length_[i] = porous.limited(cell_length_[i], 0.0, 0.0, grid.centre[i]);
            drag_coefficient_[i] /= media_[i].porosity;
        }
    }
}

double MomentumBalance::face_gradient(const std::vector<double>& u, std::size_t i) const {
    const std::size_t n = u.size();
    if (i == 0) return wall_below_ ? u[0] / distance_[0] : 0.0;
    if (i == n) return wall_above_ ? -u[n - 1] / distance_[n] : 0.0;
    return (u[i] - u[i - 1]) / distance_[i];
}

std::vector<double> MomentumBalance::face_stress(const std::vector<double>& u) const {
    std::vector<double> stress(u.size() + 1);
    for (std::size_t i = 0; i < stress.size(); ++i) {
        const double gradient = face_gradient(u, i);
        stress[i] = (viscosity_ + length_squared_[i] * std::abs(gradient)) * gradient;
        if (!face_ratio_.empty()) stress[i] *= face_ratio_[i];
    }
    return stress;
}

std::vector<double> MomentumBalance::residual(const std::vector<double>& u) const {
    const std::vector<double> stress = face_stress(u);
    std::vector<double> force(u.size());
    for (std::size_t i = 0; i < u.size(); ++i) {
        force[i] = thickness_[i] * (weight_ - drag_coefficient_[i] * u[i] * std::abs(u[i])) + stress[i + 1] -
                   stress[i];
        if (stems_) force[i] -= thickness_[i] * stem_share_[i] * stems_->deceleration(u[i]);
        if (!media_.empty()) {
            const PorousMedia::At& at = media_[i];
            force[i] -= thickness_[i] * ((1.0 - at.porosity) * weight_ + at.along(std::abs(u[i])) * u[i]);
        }
    }
    return force;
}

Tridiagonal MomentumBalance::jacobian(const std::vector<double>& u) const {
    const std::size_t n = u.size();
    Tridiagonal matrix{std::vector<double>(n), std::vector<double>(n - 1)};
    for (std::size_t i = 0; i < n; ++i) {
        matrix.diagonal[i] = 2.0 * thickness_[i] * drag_coefficient_[i] * std::abs(u[i]);
        if (stems_) matrix.diagonal[i] += thickness_[i] * stem_share_[i] * stems_->deceleration_slope(u[i]);
        if (!media_.empty()) matrix.diagonal[i] += thickness_[i] * media_[i].along(2.0 * std::abs(u[i]));
    }
    for (std::size_t i = 0; i <= n; ++i) {
        const double stiffness =
            ratio(i) * (viscosity_ + 2.0 * length_squared_[i] * std::abs(face_gradient(u, i))) / distance_[i];
        if (i == 0) {
            if (wall_below_) matrix.diagonal[0] += stiffness;
        } else if (i == n) {
            if (wall_above_) matrix.diagonal[n - 1] += stiffness;
        } else {
            matrix.diagonal[i - 1] += stiffness;
            matrix.diagonal[i] += stiffness;
            matrix.off[i - 1] = -stiffness;
        }
    }
    return matrix;
}

double MomentumBalance::functional(const std::vector<double>& u) const {
    double sum = 0.0;
    for (std::size_t i = 0; i < u.size(); ++i) {
        const double speed = std::abs(u[i]);
        sum += thickness_[i] * (drag_coefficient_[i] * speed * speed * speed / 3.0 - weight_ * u[i]);
        if (stems_) sum += thickness_[i] * stem_share_[i] * stems_->deceleration_integral(u[i]);
        if (!media_.empty()) {
            const PorousMedia::At& at = media_[i];
            sum += thickness_[i] *
                   ((1.0 - at.porosity) * weight_ * u[i] + u[i] * u[i] * at.along(speed * 2.0 / 3.0) / 2.0);
        }
    }
    for (std::size_t i = 0; i <= u.size(); ++i) {
        const double gradient = std::abs(face_gradient(u, i));
        sum += ratio(i) * distance_[i] * gradient * gradient *
               (viscosity_ / 2.0 + length_squared_[i] * gradient / 3.0);
    }
    return sum;
}

double MomentumBalance::drag(const std::vector<double>& u) const {
    double sum = 0.0;
    for (std::size_t i = 0; i < u.size(); ++i) {
        sum += thickness_[i] * drag_coefficient_[i] * u[i] * std::abs(u[i]);
    }
    return sum;
}

double MomentumBalance::vegetation_drag(const std::vector<double>& u) const {
    double sum = 0.0;
    for (std::size_t i = 0; stems_ && i < u.size(); ++i) {
        sum += thickness_[i] * stem_share_[i] * stems_->deceleration(u[i]);
    }
    return sum;
}

double MomentumBalance::porous_drag(const std::vector<double>& u) const {
    double sum = 0.0;
    for (std::size_t i = 0; i < media_.size(); ++i) {
        sum += thickness_[i] * media_[i].along(std::abs(u[i])) * u[i];
    }
    return sum;
}

double MomentumBalance::weight() const {
    double water = depth_;
    for (std::size_t i = 0; i < media_.size(); ++i) water -= thickness_[i] * (1.0 - media_[i].porosity);
    return weight_ * water;
}

double MomentumBalance::gradient_in_cell(double stress, std::size_t cell) const {
    const double part = media_.empty() ? stress : stress / media_[cell].viscosity_ratio;
    return gradient_from_stress(part, cell_length_[cell]);
}

double MomentumBalance::gradient_from_stress(double stress, double mixing_length) const {
    const double square = mixing_length * mixing_length;
    const double size = std::abs(stress);
    // Root of l^2 g^2 + nu0 g - |stress| = 0 in the form that does not cancel for small l.
    const double carried = viscosity_ + std::sqrt(viscosity_ * viscosity_ + 4.0 * square * size);
    // Without viscosity nothing carries a stress where the mixing length is zero: there is none.
    return carried > 0.0 ? std::copysign(2.0 * size / carried, stress) : 0.0;
}

std::vector<double> MomentumBalance::first_guess() const {
    const std::size_t n = thickness_.size();
    // Stress of a flow whose friction acts at the walls, or at the top of the drag: linear in z.
    double drag_sum = 0.0;
    double drag_top = 0.0;
    double height = 0.0;
    for (std::size_t i = 0; i < n; ++i) {
        height += thickness_[i];
        double coefficient = drag_coefficient_[i];
        if (stems_) coefficient += stem_share_[i] * stems_->coefficient(stems_->speed_at(weight_));
        if (!media_.empty() && media_[i].along(1.0) > 0.0) {
            // As that of a law that is quadratic alone and has the same discharge under the weight.
            const PorousMedia::At& at = media_[i];
            const double root = std::sqrt(at.linear * at.linear + 4.0 * at.quadratic * weight_);
            const double q = 2.0 * weight_ / (at.linear + root);
            coefficient += weight_ / (q * q);
        }
        drag_sum += thickness_[i] * coefficient;
        if (coefficient > 0.0) drag_top = height;
    }
    const double neutral = wall_above_ ? 0.5 * depth_ : depth_;
    // Slip velocity from which the drag alone carries the weight.
    const double slip = drag_sum > 0.0 ? std::sqrt(weight_ * depth_ / drag_sum) : 0.0;
    std::vector<double> u(n);
    height = 0.0;
    double velocity = slip;
    for (std::size_t i = 0; i < n; ++i) {
        const bool in_drag = height < drag_top;
        const double stress = in_drag ? 0.0 : weight_ * (neutral - height);
        if (wall_below_ || i > 0) {
            velocity += distance_[i] * gradient_from_stress(stress, std::sqrt(length_squared_[i]));
        }
        u[i] = velocity;
        height += thickness_[i];
    }
    return u;
}

}  // namespace riffle::inline column
