#pragma once

#include <string>
#include <vector>

#include "analysis/figure.hpp"
#include "analysis/flow_record.hpp"
#include "analysis/section_parts.hpp"

namespace riffle::inline analysis {

// The parts of the chapter on the vertical profiles.

/// A figure of the chapter without curves: a quantity over the height above the bed level.
[[nodiscard]] Figure profile_figure(std::string key, std::string title, std::string caption,
                                    std::string source, Axis x);

/// A curve of such a figure.
[[nodiscard]] Curve profile_curve(std::string name, Origin origin, const std::vector<double>& values,
                                  const std::vector<double>& z, Mark mark = Mark::line);

/// What the curves of the measured profile are called.
[[nodiscard]] std::string measured_curve_name(const FlowRecord::Measured& measured);

/// A curve of the column twin, thinned to what a figure can show.
[[nodiscard]] Curve column_curve(const ColumnProfile& column, const std::vector<double>& values);

/// The twin beside a profile over the whole plan: the column's, between side walls the section's mean over
/// the width, where `of_section` names it.
void add_twin(const FlowRecord& record, const std::vector<double> ColumnProfile::*of_column,
              const std::vector<double> SectionTwin::*of_section, Figure& figure);

/// A further measured quantity times a factor, with its 95 % half-widths where the file of the profile gives
/// its uncertainty: from that file, of a measured field from its means along the bed (`values`). Nothing
/// where it was not measured, or between side walls (between_side_walls()).
void add_measured_turbulence(const FlowRecord& record, ProfileQuantity quantity,
                             std::vector<double> Profiles::*values, std::string name, double factor,
                             int variant, Figure& figure);

/// Departure of u and du/dz from the measured profile and the column twin, with the thesis' MSEP.
void add_profile_errors(const FlowRecord& record, const Profiles& p, Analysis& analysis);

/// Mean level of the surface over the window of the profiles, m; the depth where none was recorded.
[[nodiscard]] double mean_level_of(const FlowRecord& record, const Profiles& p);

/// Shear stress on horizontal planes and its parts, with the analytic line and what was measured.
void add_stresses(const FlowRecord& record, const Profiles& p, Analysis& analysis);

/// Eddy viscosity of the closure and of the column twin.
void add_closure(const FlowRecord& record, const Profiles& p, Analysis& analysis);

/// The mixing length: of the particles what their eddy viscosity and gradient come to, and that of the
/// column.
void add_mixing_length(const FlowRecord& record, const Profiles& p, Analysis& analysis);

/// The drag term of the momentum equation, of beds of spheres.
void add_drag(const FlowRecord& record, const Profiles& p, Analysis& analysis);

/// What the friction factor of a uniform flow without side walls is made of: viscous, closure's, turbulent,
/// form-induced stress (`form`, of form_induced_stress()), and what the scheme adds.
void add_friction_parts(const FlowRecord& record, const Profiles& p, const FieldEstimates& form,
                        Analysis& analysis);

/// Turbulence intensities over the friction velocity, with Nezu's curves and what was measured.
void add_intensities(const FlowRecord& record, const Profiles& p, Analysis& analysis);

/// Of a run whose eddies move: which part of its fluctuations and of their stress neighbours share, and which
/// is the noise of the particles.
void add_eddies_and_noise(const FlowRecord& record, Analysis& analysis);

/// Whether the water of a flow that nothing drives stands level on the average of the profiles' window, so
/// that its layers have one depth.
[[nodiscard]] bool stands_level(const FlowRecord& record, const Profiles& p);

/// Pressure against hydrostatic, and its departure.
void add_pressure(const FlowRecord& record, const Profiles& p, Analysis& analysis);

}  // namespace riffle::inline analysis
