#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "base/error.hpp"
#include "column/section.hpp"
#include "column/section_solver.hpp"

namespace riffle::inline column {

namespace {

SectionMoment moment(const SectionResult& r, double time) {
    return {time, r.depth_mean_velocity, r.centreline_velocity, r.wall_layer_velocity, r.side_wall_share};
}

}  // namespace

SectionResult advance_section(const Case& c, const SectionResult& start, double time,
                              const SectionOptions& options,
                              const std::function<void(const SectionMoment&)>& observe) {
    check_section(c);
    if (!(time >= 0.0) || !std::isfinite(time) || start.y.empty() || start.z.empty()) {
        throw InputError(fmt::format(
            "the transient section needs a start and a time of 0 s or more, the time is {:.6g} s", time));
    }
    const SectionGrid grid = make_section_grid(c, options.cells_across, options.cells_over_depth);
    const SectionBalance balance(c, grid);
    const Eigen::VectorXd& area = balance.area();
    const double total_area = area.sum();
    Eigen::VectorXd u = velocities_on(grid, start);
    for (Eigen::Index i = 0; i < u.size(); ++i) u(i) *= balance.porosity(i);
    const auto report = [&](double at) {
        if (observe) observe(moment(section_result(c, grid, balance, u), at));
    };
    report(0.0);

    // Verwer, Spee, Blom & Hundsdorfer (1999): L-stable for gamma = 1 +- 1/sqrt(2), and with + stiff modes
    // fade in the first stage too, which is of order 1 and measures the error.
    constexpr double gamma = 1.0 + 1.0 / std::numbers::sqrt2;
    SectionFactorisation factors;
    constexpr double smallest = 1e-12;  // m/s: a start at rest has no velocity to compare with
    double now = 0.0;
    double step = std::min(time, 1e-3);
    while (now < time) {
        // The last two steps share what is left: none is much shorter than the others.
        const double left = time - now;
        if (step >= left) {
            step = left;
        } else if (2.0 * step > left) {
            step = 0.5 * left;
        }
        const Eigen::VectorXd inertia = area / (gamma * step);
        factors.compute(balance.jacobian(u), inertia);
        const Eigen::VectorXd first = factors.solve(balance.residual(u)) / gamma;
        const Eigen::VectorXd carried = 2.0 * gamma * inertia.cwiseProduct(first);
        const Eigen::VectorXd second = factors.solve(balance.residual(u + first) - carried) / gamma;
        const Eigen::VectorXd next = u + 1.5 * first + 0.5 * second;
        const Eigen::VectorXd difference = 0.5 * (first + second);
        const double local = std::sqrt(area.dot(difference.cwiseAbs2()) / total_area);
        const double error = local / std::max(next.lpNorm<Eigen::Infinity>(), smallest);
        const bool accepted = std::isfinite(error) && error <= options.tolerance;
        if (accepted) {
            u = next;
            now = step == left ? time : now + step;
            report(now);
        }
        const double change = 0.8 * std::sqrt(options.tolerance / std::max(error, 1e-30));
        step *= std::isfinite(error) ? std::clamp(change, 0.2, 4.0) : 0.2;
        if (!(step > 1e-12 * time)) {
            throw InputError(
                "the transient section came to a halt: check fluid.kinematic_viscosity, channel.slope, "
                "bed.drag_coefficient and the [turbulence] constants of the case");
        }
    }
    return section_result(c, grid, balance, u);
}

}  // namespace riffle::inline column
