#pragma once

#include <string>
#include <vector>

#include "analysis/figure.hpp"
#include "analysis/flow_record.hpp"

namespace riffle {

// The parts of the chapter on the vertical profiles.

/// A figure of the chapter without curves: a quantity over the height above the bed level.
[[nodiscard]] Figure profile_figure(std::string key, std::string title, std::string caption,
                                    std::string source, Axis x);

/// A curve of such a figure.
[[nodiscard]] Curve profile_curve(std::string name, Origin origin, const std::vector<double>& values,
                                  const std::vector<double>& z, Mark mark = Mark::line);

/// What the curves of the measured profile are called.
[[nodiscard]] std::string measured_curve_name(const FlowRecord::Measured& measured);

/// Departure of u and du/dz from the measured profile and the column twin, with the thesis' MSEP.
void add_profile_errors(const FlowRecord& record, const Profiles& p, Analysis& analysis);

}  // namespace riffle
