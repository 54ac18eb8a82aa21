#include "column/section.hpp"

#include <fmt/format.h>

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <cmath>
#include <optional>

#include "base/error.hpp"
#include "case/bed_traits.hpp"
#include "case/flow_kind.hpp"
#include "case/mirror_image.hpp"
#include "case/patch_range.hpp"
#include "column/column.hpp"
#include "column/section_solver.hpp"
#include "column/section_start.hpp"

namespace riffle::inline column {

namespace {

/// Velocity in each cell from its height.
template <class Profile>
Eigen::VectorXd from_profile(const SectionGrid& grid, Profile profile) {
    Eigen::VectorXd u(static_cast<Eigen::Index>(grid.size()));
    for (std::size_t iz = 0; iz < grid.rows(); ++iz) {
        u.segment(static_cast<Eigen::Index>(iz * grid.columns()), static_cast<Eigen::Index>(grid.columns()))
            .setConstant(profile(grid.z[iz]));
    }
    return u;
}

/// A flow whose friction is of the order of its weight.
Eigen::VectorXd first_guess(const Case& c, const SectionGrid& grid, const SectionBalance& balance) {
    const Eigen::VectorXd still = Eigen::VectorXd::Zero(static_cast<Eigen::Index>(grid.size()));
    if (balance.bed_force(still.array() + 1.0) > 0.0 && has_column(c)) {
        const ColumnResult column = solve_column(c);
        return from_profile(grid, [&column](double z) { return column.velocity_at(z); });
    }
    const Eigen::VectorXd one = still.array() + 1.0;
    return std::sqrt(balance.weight() / (balance.bed_force(one) + balance.wall_force(one) +
                                         balance.vegetation_force(one) + balance.porous_force(one))) *
           one;
}

/// Implicit Euler steps of growing length that turn into Newton's method: from any start they follow the
/// transient to the steady state, which is the only one, as the stresses and the drag rise with the flow.
/// `step_time`: the first step, s; a start close to the steady state can do with Newton's method alone.
/// Nothing where they do not get there.
std::optional<Eigen::VectorXd> approach_balance(const Case& c, const SectionBalance& balance,
                                                Eigen::VectorXd u, double step_time) {
    const auto size = [&balance](const Eigen::VectorXd& force) {
        return std::sqrt((force.array().square() / balance.area().array()).sum());
    };
    SectionFactorisation factors;
    Eigen::VectorXd force = balance.residual(u);
    double error = size(force);
    // Between slip walls the first guess is the solution, and what is left of the forces is rounding.
    const double rounding = 1e-11 * c.streamwise_gravity() * std::sqrt(balance.area().sum());
    double last_change = 1.0;
    constexpr int most_iterations = 200;
    for (int iteration = 0; iteration < most_iterations; ++iteration) {
        factors.compute(balance.jacobian(u), balance.area() / step_time);
        const Eigen::VectorXd change = factors.solve(force);
        const Eigen::VectorXd next = u + change;
        const Eigen::VectorXd next_force = balance.residual(next);
        const double next_error = size(next_force);
        if (!std::isfinite(next_error) || next_error > std::max(2.0 * error, rounding)) {
            step_time *= 0.01;
            continue;
        }
        const double relative = change.lpNorm<Eigen::Infinity>() / next.lpNorm<Eigen::Infinity>();
        u = next;
        force = next_force;
        step_time *= next_error < 0.1 * error ? 1e3 : 5.0;
        error = next_error;
        // Converged, or as far as rounding lets it.
        if (step_time > 1e9 && (relative < 1e-12 || (relative < 1e-10 && relative > 0.5 * last_change))) {
            return u;
        }
        last_change = relative;
    }
    return std::nullopt;
}

/// The steady velocities in the cells of a grid of so many cells; nothing where they are not found. A grid of
/// a third of them finds the way from the first guess at a tenth of the cost, and this one has its Newton
/// steps left.
std::optional<Eigen::VectorXd> solve_balance(const Case& c, const SectionGrid& grid,
                                             const SectionBalance& balance, int cells_across,
                                             int cells_over_depth) {
    constexpr int share = 3;
    constexpr int fewest_cells = 10;
    if (std::min(cells_across, cells_over_depth) >= share * fewest_cells) {
        const int across = cells_across / share;
        const int over_depth = cells_over_depth / share;
        const SectionGrid coarse = make_section_grid(c, across, over_depth);
        const SectionBalance coarse_balance(c, coarse);
        if (const auto start = solve_balance(c, coarse, coarse_balance, across, over_depth)) {
            // The result has the velocity in the pores of porous zones, the balance that of the discharge.
            Eigen::VectorXd u = velocities_on(grid, section_result(c, coarse, coarse_balance, *start));
            for (Eigen::Index i = 0; i < u.size(); ++i) u(i) *= balance.porosity(i);
            constexpr double steady = 1e9;  // s
            if (auto found = approach_balance(c, balance, u, steady)) return found;
        }
    }
    const Eigen::VectorXd u = first_guess(c, grid, balance);
    const double weight_makes_it_in = u.maxCoeff() / c.streamwise_gravity();
    return approach_balance(c, balance, u, weight_makes_it_in);
}

/// E-folding time of the slowest mode of small departures: the largest eigenvalue of J^-1 M, M the areas, by
/// Arnoldi's method, as the modes across a wide channel lie close together.
double slowest_decay_time(const SectionBalance& balance, const Eigen::VectorXd& u) {
    SectionFactorisation factors;
    factors.compute(balance.jacobian(u), Eigen::VectorXd::Zero(u.size()));
    const Eigen::Index most = std::min<Eigen::Index>(60, u.size());
    Eigen::MatrixXd basis(u.size(), most + 1);
    Eigen::MatrixXd hessenberg = Eigen::MatrixXd::Zero(most + 1, most);
    basis.col(0) = u.normalized();
    double time = 0.0;
    for (Eigen::Index k = 0; k < most; ++k) {
        Eigen::VectorXd next = factors.solve(balance.area().cwiseProduct(basis.col(k)));
        for (int pass = 0; pass < 2; ++pass) {  // twice is enough (Kahan, Parlett)
            const Eigen::VectorXd along = basis.leftCols(k + 1).transpose() * next;
            next -= basis.leftCols(k + 1) * along;
            hessenberg.col(k).head(k + 1) += along;
        }
        hessenberg(k + 1, k) = next.norm();
        const Eigen::EigenSolver<Eigen::MatrixXd> modes(hessenberg.topLeftCorner(k + 1, k + 1), false);
        const double estimate = modes.eigenvalues().real().maxCoeff();
        const bool converged = std::abs(estimate - time) <= 1e-10 * estimate;
        time = estimate;
        if (converged || !(hessenberg(k + 1, k) > 1e-14 * estimate)) break;
        basis.col(k + 1) = next / hessenberg(k + 1, k);
    }
    return time;
}

}  // namespace

namespace {

/// Why a part of the width has no section.
template <class Patch>
std::optional<std::string> lopsided(const Case& c, const std::vector<Patch>& patches, const char* what) {
    const Patch* const patch = without_image(c, patches);
    if (patch == nullptr) return std::nullopt;
    return fmt::format(
        "{} \"{}\" has no mirror image on the other side of the centreline, and the balance of the cross-section is "
        "solved over one half of a symmetric channel: set channel.sides = \"half\"",
        what, patch->name);
}

/// Why patches of the bed are not strips of plane beds, which a section may have.
std::optional<std::string> other_than_strips(const Case& c) {
    for (const BedPatch& patch : c.bed_patches) {
        if (!covers_length(c, patch)) {
            return fmt::format(
                "the patch \"{}\" of the bed does not lie all along the channel, so the flow changes along it: leave out "
                "its {}",
                patch.name, is_outlined(patch) ? "outline" : "x_from and x_to");
        }
        if (has_spheres(patch) || has_spheres(c.bed)) {
            return fmt::format(
                "the patch \"{}\" of the bed or what lies beside it is of spheres, and the balance of the cross-section "
                "has strips of plane beds alone: give them by equivalent_roughness or manning",
                patch.name);
        }
    }
    return std::nullopt;
}

/// So with porous zones.
std::optional<std::string> lopsided_porosity(const Case& c) {
    if (c.channel.sides == Sides::half || c.porous.empty()) return std::nullopt;
    const PorosityField field(c);
    const double width = c.channel.width;
    constexpr int places = 50;
    for (int i = 0; i < places; ++i) {
        for (int j = 0; j < places; ++j) {
            const double y = (i + 0.5) / places * width;
            const double z = (j + 0.5) / places * c.total_depth();
            if (std::abs(field.porosity(0.0, y, z) - field.porosity(0.0, width - y, z)) > 1e-6) {
                return "the porous zones are not the same on both sides of the centreline, and the balance of the "
                       "cross-section is solved over one half of a symmetric channel: set channel.sides = \"half\"";
            }
        }
    }
    return std::nullopt;
}

}  // namespace

std::optional<std::string> why_no_section(const Case& c) {
    // Side walls may hold back the water over a bed that does not; all else that rules out a uniform flow in
    // a column does so in a section.
    Case resisting = c;
    resisting.bed.kind = BedKind::no_slip;
    // What no other place of stems, patches or stones could change comes first.
    Case bare = resisting;
    bare.vegetation.clear();
    bare.bed_patches.clear();
    bare.porous.clear();
    if (auto reason = why_no_column(bare)) return reason;
    if (auto reason = lopsided(c, c.vegetation, "the vegetation")) return reason;
    if (auto reason = lopsided(c, c.bed_patches, "the patch of the bed")) return reason;
    if (auto reason = other_than_strips(c)) return reason;
    if (auto reason = lopsided_porosity(c)) return reason;
    std::erase_if(resisting.porous, [&c](const Porous& zone) { return covers_length(c, zone); });
    std::erase_if(resisting.vegetation, [&c](const Vegetation& patch) { return covers_length(c, patch); });
    resisting.bed_patches.clear();
    if (auto reason = why_no_column(resisting)) return reason;
    if (c.channel.top == Top::wall) {
        return "a wall closes the channel at its top (channel.top = \"wall\"), which the balance of a "
               "cross-section does not have: it needs channel.top = \"free-surface\"";
    }
    if (!c.has_side_walls()) {
        return "it has no side walls, and without them the flow does not vary over the cross-section: "
               "set channel.dimensions = 3 and channel.sides = \"walls\" or \"half\", or use riffle column";
    }
    if (c.turbulence.closure == ClosureKind::sps) {
        return "the SPS closure has no steady flow over the cross-section: its stress is far too small to "
               "carry the weight to the side walls, whose layers come to rest beside a flow of several "
               "m/s; choose turbulence.closure = \"czernuszenko-rylov\"";
    }
    // Whether there is friction does not depend on the grid.
    constexpr int coarse = 8;
    if (SectionBalance(c, make_section_grid(c, coarse, coarse)).has_friction()) return std::nullopt;
    return "nothing resists the flow down the slope, so it has no steady state: it needs a bed that does, "
           "spheres with bed.drag_coefficient > 0 or bed.kind = \"no-slip\"";
}

std::optional<Case> section_start_substitute(const Case& c) {
    if (c.start.kind != StartKind::section || c.turbulence.closure != ClosureKind::sps) return std::nullopt;
    Case substitute = c;
    substitute.turbulence = {};
    substitute.turbulence.closure = ClosureKind::czernuszenko_rylov;
    if (!has_section(substitute)) return std::nullopt;
    return substitute;
}

SectionResult solve_section(const Case& c, const SectionOptions& options) {
    check_section(c);
    const SectionGrid grid = make_section_grid(c, options.cells_across, options.cells_over_depth);
    const SectionBalance balance(c, grid);
    const auto steady = solve_balance(c, grid, balance, options.cells_across, options.cells_over_depth);
    if (!steady) {
        throw InputError(
            "the steady cross-section did not converge: check fluid.kinematic_viscosity, channel.slope, "
            "bed.drag_coefficient and the [turbulence] constants of the case");
    }
    const Eigen::VectorXd& u = *steady;
    SectionResult result = section_result(c, grid, balance, u);
    if (options.with_relaxation_time) result.relaxation_time = slowest_decay_time(balance, u);
    return result;
}

SectionResult start_section(const Case& c, SectionStart start, const SectionOptions& options) {
    check_section(c);
    const SectionGrid grid = make_section_grid(c, options.cells_across, options.cells_over_depth);
    const SectionBalance balance(c, grid);
    const double depth = c.total_depth();
    Eigen::VectorXd u = Eigen::VectorXd::Zero(static_cast<Eigen::Index>(grid.size()));
    if (start != SectionStart::rest) {
        const ColumnResult column = solve_column(c);
        const double power = 1.0 / c.start.exponent;
        if (start == SectionStart::column) {
            u = from_profile(grid, [&column](double z) { return column.velocity_at(z); });
        } else if (start == SectionStart::uniform) {
            u.setConstant(column.depth_mean_velocity);
        } else {
            const double largest = c.start.kind == StartKind::power_law && c.start.velocity
                                       ? *c.start.velocity
                                       : column.total_mean_velocity * (1.0 + power);
            u = from_profile(grid, [&](double z) { return largest * std::pow(z / depth, power); });
        }
        // The balance has the discharge of an area, these are velocities of the water.
        for (Eigen::Index i = 0; i < u.size(); ++i) u(i) *= balance.porosity(i);
    }
    return section_result(c, grid, balance, u);
}

}  // namespace riffle::inline column
