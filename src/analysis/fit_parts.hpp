#pragma once

#include <functional>
#include <optional>
#include <string>

#include "analysis/figure.hpp"
#include "analysis/flow_record.hpp"
#include "hydraulics/law_fits.hpp"

namespace riffle::inline analysis {

// The parts of the chapter on the laws fitted to profiles.

/// What the fits start from.
struct FittedFlow {
    VelocityPoints points;                    ///< heights above the bed level; zero plane at the datum
    double depth = 0;                         ///< from the datum to the mean surface, m
    FitRange log_law_range;                   ///< of the log law
    FitRange whole_range;                     ///< of the laws for the whole depth
    std::optional<double> friction_velocity;  ///< from the stress, m/s
    double friction_velocity_half_width = 0;
};

/// A finding of the chapter from a fitted number; lopsided intervals stand in its remark.
[[nodiscard]] Finding fitted(std::string key, std::string label, std::string unit, const FittedValue& value);

/// Add to a roughness that was found the given one of a bed by its roughness, else the measured one.
[[nodiscard]] Finding against_roughness(Finding finding, const Case& c, std::string remark = {});

/// Say that a law could not be fitted, and why.
void warn_of_failure(Analysis& analysis, const char* law, const FitQuality& fit);

/// The curve of a fitted law of the height over the zero plane, over the range that it was fitted to.
[[nodiscard]] Curve law_curve(const char* name, int variant, const FittedFlow& flow, const FitQuality& fit,
                              const std::function<double(double)>& law);

/// The roughness that the profile has with the friction velocity of its stress.
void add_roughness_of_stress(const FlowRecord& record, const FittedFlow& flow, Analysis& analysis);

/// Von Karman's constant with that friction velocity.
void add_kappa(const FlowRecord& record, const FittedFlow& flow, Analysis& analysis);

/// The laws of flow with cells of secondary flow (thesis 2.24, 2.27): their curves in `laws`, a figure of the
/// stress, and where in a cell each puts the profile.
void add_secondary_flow_laws(const FlowRecord& record, const FittedFlow& flow, Figure& laws,
                             Analysis& analysis);

}  // namespace riffle::inline analysis
