#pragma once

#include "case/case.hpp"

namespace riffle::inline case_file {

/// Whether the velocity gradient and the correction matrix enter the equations of a case.
[[nodiscard]] inline bool needs_gradients(const Case& c) {
    return c.turbulence.closure != ClosureKind::none || c.numerics.pressure_form == PressureForm::corrected;
}

}  // namespace riffle::inline case_file
