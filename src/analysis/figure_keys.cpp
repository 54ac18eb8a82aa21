#include "analysis/figure_keys.hpp"

#include <algorithm>
#include <map>
#include <vector>

#include "analysis/chapter_names.hpp"

namespace riffle::inline analysis {

namespace {

/// The keys of each chapter.
const std::map<std::string_view, std::vector<std::string_view>>& keys_of_chapters() {
    static const std::map<std::string_view, std::vector<std::string_view>> keys = {
        {chapters::course,
         {"level_lines", "level_history", "level_map", "front_history", "mode_history", "velocity_lines",
          "energy_history", "volume_history"}},
        {chapters::along,
         {"long_profile", "velocity_along", "froude_along", "end_discharges", "end_depths", "pool_falls",
          "pool_powers", "flood_passage", "flood_depths", "rating_loop", "tailwater_discharges",
          "tailwater_depths", "tailwater_loop"}},
        {chapters::statistics,
         {"velocity_history", "mean_level_history", "velocity_settling", "velocity_autocorrelation",
          "point_velocity_settling", "point_velocity_autocorrelation", "elevation_settling",
          "elevation_autocorrelation"}},
        {chapters::profiles,
         {"velocity_profile",
          "velocity_gradient_profile",
          "velocity_error_profile",
          "msep_profile",
          "stress_profile",
          "turbulence_intensity_profile",
          "eddies_and_noise",
          "stress_of_eddies",
          "pressure_profile",
          "pressure_departure_profile",
          "eddy_viscosity_profile",
          "mixing_length_profile",
          "drag_profile",
          "double_averaged_stress_profile",
          "double_averaged_velocity_profile",
          "form_induced_moment_profile",
          "friction_factor_parts",
          "mean_velocity_map",
          "mean_vertical_velocity_map",
          "mean_pressure_map",
          "mean_stress_map",
          "reynolds_stress_map",
          "measured_velocity_map",
          "velocity_departure_map"}},
        {chapters::fits, {"log_law", "fitted_laws", "fitted_stress", "friction_factor"}},
        {chapters::surface,
         {"surface_map", "surface_probability_density", "surface_frequency_spectrum",
          "surface_line_frequency_spectrum", "surface_wavenumber_spectrum", "surface_wave_spectrum",
          "surface_cross_correlation", "surface_correlation", "surface_station_lags",
          "surface_extreme_correlation", "surface_space_time_correlation", "surface_mean_map",
          "surface_deviation_map", "surface_families"}},
        {chapters::subsurface,
         {"integral_scale_profile", "velocity_spectrum", "vertical_velocity_spectrum",
          "streamwise_correlation", "streamwise_correlation_of_waves", "depth_correlation",
          "depth_cross_correlation", "quadrant_profile", "quadrant_holes", "ejection_upwelling_correlation"}},
        {chapters::forces,
         {"force_history", "force_instruments", "force_instruments_wall_normal", "flow_rate_history",
          "solid_forces", "solid_moments", "pressure_gauges"}},
        {chapters::energy, {"energy_budget"}},
        {chapters::section,
         {"section_velocity_map", "section_twin_map", "section_secondary_map", "section_stress_map",
          "section_resolved_stress_map", "centreline_velocity_profile",
          "centreline_vertical_velocity_profile", "centreline_stress_profile", "centreline_msep_profile",
          "station_velocity_profile", "station_stress_profile", "station_msep_profile",
          "station_msep_gradient_profile", "lateral_profile", "lateral_velocity"}},
        {chapters::secondary,
         {"secondary_strength_averaging", "secondary_streamfunction", "swirling_strength_map",
          "q_criterion_map"}},
        {chapters::bed,
         {"bed_stress_distribution", "bed_drag_distribution", "wall_stress_distribution", "drag_plan_map",
          "drag_section_map", "drag_side_map"}},
        {chapters::particles, {"fluctuation_history", "order_history", "density_history", "speed_history"}},
    };
    return keys;
}

}  // namespace

bool is_figure_key(std::string_view key, std::string_view chapter) {
    return std::any_of(keys_of_chapters().begin(), keys_of_chapters().end(), [&](const auto& each) {
        const auto& [name, keys] = each;
        return (chapter.empty() || chapter == name) && std::find(keys.begin(), keys.end(), key) != keys.end();
    });
}

}  // namespace riffle::inline analysis
