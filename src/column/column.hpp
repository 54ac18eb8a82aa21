#pragma once

#include <optional>
#include <vector>

#include "case/case.hpp"
#include "case/flow_kind.hpp"
#include "hydraulics/log_law.hpp"

namespace riffle::inline column {

/// Profile of the steady column on its grid (cell centres, from the bed level up). SI.
struct ColumnProfile {
    std::vector<double> z;                  ///< height above the bed level
    std::vector<double> velocity;           ///< u, of the water in the pores of porous layers
    std::vector<double> velocity_gradient;  ///< du/dz, in porous layers that of the discharge of an area n u
    std::vector<double> shear_stress;       ///< rho (nu0 + nu_t) du/dz, Pa
    std::vector<double> mixing_length;      ///< l_m
    std::vector<double> eddy_viscosity;     ///< nu_t
    std::vector<double> porosity;           ///< share of water; empty without porous layers
};

/// The column twin of a case: steady uniform flow of the same model in one dimension.
struct ColumnResult {
    ColumnProfile profile;
    double depth_mean_velocity = 0;  ///< mean of u over the water above the datum
    double total_mean_velocity = 0;  ///< mean of u over the whole depth from the bed level
    double surface_velocity = 0;
    double friction_velocity = 0;  ///< sqrt(tau_crest / rho)
    LogLawFit log_law;             ///< fit of the profile to the rough log law
    double drag_share = 0;         ///< bed drag / weight component
    double wall_share = 0;        ///< wall friction at z = 0 / weight component (half of it under a top wall)
    double wall_force_share = 0;  ///< the same of all walls: under a top wall of that as well
    double vegetation_share = 0;  ///< drag of the vegetation / weight component
    double porous_share = 0;      ///< resistance of porous layers / weight component
    double friction_factor = 0;   ///< f (2.6)
    double manning = 0;           ///< n (2.7)
    double chezy = 0;             ///< C (2.8)
    double reynolds = 0;
    double froude = 0;
    double relaxation_time = 0;  ///< e-folding time of small departures from the steady state, s

    /// u at height z (linear interpolation on the fine grid; constant beyond its ends).
    [[nodiscard]] double velocity_at(double z) const;
};

/// Whether the case has a column twin; why_no_column() says why not.
[[nodiscard]] inline bool has_column(const Case& c) { return !why_no_column(c); }

/// Range of heights over the bed level, m.
struct HeightRange {
    double from = 0;
    double to = 0;
};

/// Range in which profiles over a rough bed are fitted to the log law, the same for measured, column and
/// particle profiles: from the crest to 0.7 h_w above the datum; over a bed by a wall law from 0.1 h_w. See
/// docs/column.md for the choice.
[[nodiscard]] HeightRange log_law_range(const Case& c);

/// Cells of the column's grid: halving the cells changes no printed value by more than 0.01 %.
inline constexpr int column_cells = 1000;

/// Solve the steady momentum balance g S0 + d/dz[(nu0 + l_m^2 |u'|) u'] - beta(z) u|u| = 0 of the case, with
/// the closure and the bed drag that the particles use. No flux at z = 0 for sphere and slip beds, u(0) = 0
/// for no-slip beds; no flux at the surface, u(H) = 0 under a top wall over a no-slip bed. The hydraulic
/// radius is that of a wide channel, the depth over the datum. Throws InputError where the case has no steady
/// uniform flow, with the reason (why_no_column()).
[[nodiscard]] ColumnResult solve_column(const Case& c, int cells = column_cells);

}  // namespace riffle::inline column
