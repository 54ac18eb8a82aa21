#include "column/column.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numeric>

#include "base/error.hpp"
#include "base/interpolation.hpp"
#include "case/bed_traits.hpp"
#include "column/centreline.hpp"
#include "column/column_grid.hpp"
#include "column/momentum_balance.hpp"
#include "column/wide_channel.hpp"
#include "hydraulics/channel_laws.hpp"
#include "turbulence/closure.hpp"
#include "turbulence/wall_law.hpp"

namespace riffle::inline column {

namespace {

double inner_product(const std::vector<double>& a, const std::vector<double>& b) {
    return std::inner_product(a.begin(), a.end(), b.begin(), 0.0);
}

double largest(const std::vector<double>& x) {
    double value = 0.0;
    for (const double v : x) value = std::max(value, std::abs(v));
    return value;
}

void check_channel(const Case& c) {
    if (const auto reason = why_no_column(c)) throw InputError("the case has no column twin: " + *reason);
}

/// Newton's method on the convex functional of the balance, with step halving.
std::vector<double> solve_balance(const MomentumBalance& balance) {
    std::vector<double> u = balance.first_guess();
    double value = balance.functional(u);
    constexpr int most_iterations = 200;
    for (int iteration = 0; iteration < most_iterations; ++iteration) {
        const std::vector<double> force = balance.residual(u);
        const std::vector<double> step = balance.jacobian(u).solve(force);
        const double size = largest(step);
        if (!std::isfinite(size)) break;
        const bool close = size <= 1e-6 * largest(u);
        const double decrease = inner_product(force, step);
        std::vector<double> next(u.size());
        for (double fraction = 1.0;; fraction *= 0.5) {
            for (std::size_t i = 0; i < u.size(); ++i) next[i] = u[i] + fraction * step[i];
            const double next_value = balance.functional(next);
            // Close to the minimum the functional is flat to rounding: the full step is right.
            if (close || fraction < 1e-10 || next_value <= value - 1e-4 * fraction * decrease) {
                value = next_value;
                break;
            }
        }
        u.swap(next);
        if (size <= 1e-11 * largest(u)) return u;
    }
    throw InputError(
        "the steady column did not converge: check fluid.kinematic_viscosity, channel.slope, "
        "bed.drag_coefficient and the [turbulence] constants of the case");
}

/// E-folding time of the slowest mode of small departures, by inverse power iteration on the linearised
/// transient balance, thickness du'/dt = -J u'.
double slowest_decay_time(const MomentumBalance& balance, const std::vector<double>& u) {
    const Tridiagonal matrix = balance.jacobian(u);
    const std::vector<double>& mass = balance.thickness();
    std::vector<double> mode(u.size(), 1.0);
    double time = 0.0;
    constexpr int most_iterations = 500;
    for (int iteration = 0; iteration < most_iterations; ++iteration) {
        std::vector<double> weighted(mode.size());
        for (std::size_t i = 0; i < mode.size(); ++i) weighted[i] = mass[i] * mode[i];
        std::vector<double> next = matrix.solve(weighted);
        // Rayleigh quotient <mode, M J^-1 M mode>/<mode, M mode>.
        const double estimate = inner_product(weighted, next) / inner_product(weighted, mode);
        const double scale = largest(next);
        for (double& v : next) v /= scale;
        mode.swap(next);
        const bool converged = std::abs(estimate - time) <= 1e-10 * estimate;
        time = estimate;
        if (converged) break;
    }
    return time;
}

ColumnProfile make_profile(const Case& c, const ColumnGrid& grid, const MomentumBalance& balance,
                           const std::vector<double>& u, const std::vector<double>& stress) {
    const std::size_t n = u.size();
    ColumnProfile p;
    p.z = grid.centre;
    p.velocity = u;
    for (std::size_t i = 0; i < n; ++i) p.velocity[i] /= balance.porosity(i);
    if (!c.porous.empty()) {
        for (std::size_t i = 0; i < n; ++i) p.porosity.push_back(balance.porosity(i));
    }
    p.mixing_length = balance.cell_mixing_length();
    p.velocity_gradient.resize(n);
    p.shear_stress.resize(n);
    p.eddy_viscosity.resize(n);
    for (std::size_t i = 0; i < n; ++i) {
        // The stress is the smooth quantity; the gradient that carries it follows from the closure.
        const double at_centre = 0.5 * (stress[i] + stress[i + 1]);
        const double length = p.mixing_length[i];
        p.velocity_gradient[i] = balance.gradient_in_cell(at_centre, i);
        p.eddy_viscosity[i] = mixing_length_viscosity(length, std::abs(p.velocity_gradient[i]));
        p.shear_stress[i] = c.fluid.density * at_centre;
    }
    return p;
}

/// Mean over the water of the cells whose centre lies above `from`, which is a face of the grid.
double mean_above(const ColumnGrid& grid, const MomentumBalance& balance, const std::vector<double>& u,
                  double from) {
    double sum = 0.0;
    double length = 0.0;
    for (std::size_t i = 0; i < u.size(); ++i) {
        if (grid.centre[i] < from) continue;
        const double thickness = grid.face[i + 1] - grid.face[i];
        sum += u[i] * thickness;
        length += thickness * balance.porosity(i);
    }
    return sum / length;
}

/// Stress at height z, linear between the faces.
double stress_at(const ColumnGrid& grid, const std::vector<double>& stress, double z) {
    const auto above = std::lower_bound(grid.face.begin() + 1, grid.face.end() - 1, z);
    const auto i = static_cast<std::size_t>(above - grid.face.begin());
    const double fraction = (z - grid.face[i - 1]) / (grid.face[i] - grid.face[i - 1]);
    return stress[i - 1] + fraction * (stress[i] - stress[i - 1]);
}

}  // namespace

HeightRange log_law_range(const Case& c) {
    constexpr double share_of_depth = 0.7;
    // Near to a plane bed the law has the velocity zero at the bed, and its viscous layer.
    constexpr double from_plane_bed = 0.1;
    const double from = has_wall_law(c) ? from_plane_bed * c.channel.depth : c.crest();
    return {from, c.datum() + share_of_depth * c.channel.depth};
}

double ColumnResult::velocity_at(double z) const { return place_in(profile.z, z).in(profile.velocity); }

ColumnResult solve_column(const Case& c, int cells) {
    check_channel(c);
    const ColumnGrid grid = make_column_grid(c, cells);
    const MomentumBalance balance(c, grid);
    const double weight = c.porous.empty() ? c.streamwise_gravity() * c.total_depth() : balance.weight();
    const std::vector<double> u = solve_balance(balance);
    const std::vector<double> stress = balance.face_stress(u);

    ColumnResult result;
    result.profile = make_profile(c, grid, balance, u, stress);
    const ColumnProfile& p = result.profile;
    result.depth_mean_velocity = mean_above(grid, balance, u, c.datum());
    result.total_mean_velocity = mean_above(grid, balance, u, 0.0);
    const bool wall_above = is_no_slip(c.bed) && c.channel.top == Top::wall;
    const double to_surface = grid.face.back() - grid.centre.back();
    result.surface_velocity =
        wall_above ? 0.0
                   : (u.back() + p.velocity_gradient.back() * to_surface) / balance.porosity(u.size() - 1);
    result.friction_velocity = std::sqrt(std::abs(stress_at(grid, stress, c.crest())));
    // The friction of a bed by a wall law acts on the particles as a drag.
    const double at_bed = stress.front() / weight;
    result.drag_share = has_wall_law(c) ? at_bed : balance.drag(u) / weight;
    result.wall_share = has_wall_law(c) ? 0.0 : at_bed;
    result.wall_force_share = (wall_above ? 2.0 : 1.0) * result.wall_share;
    result.vegetation_share = balance.vegetation_drag(u) / weight;
    result.porous_share = balance.porous_drag(u) / weight;
    result.relaxation_time = slowest_decay_time(balance, u);
    const bool over_bed_alone = c.vegetation.empty() && c.porous.empty();
    if (over_bed_alone && has_log_law(c)) result.log_law = fit_column_profile(c, result);

    const WideChannel channel = wide_channel(c);
    const double mean = result.depth_mean_velocity;
    result.friction_factor = channel.friction_factor(mean);
    result.manning = channel.manning(mean);
    result.chezy = channel.chezy(mean);
    result.reynolds = channel.reynolds(mean);
    result.froude = channel.froude(mean);
    return result;
}

}  // namespace riffle::inline column
