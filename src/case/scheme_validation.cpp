#include "case/scheme_validation.hpp"

#include <fmt/format.h>

#include <utility>

#include "case/words.hpp"

namespace riffle {

void validate_scheme(const Case& c, const Places& places, Problems& problems) {
    const Numerics& n = c.numerics;
    const auto add = [&](const std::vector<std::string>& keys, std::string message) {
        problems.add(places.of_first(keys), std::move(message));
    };
    if (n.tensile_correction > 0.0 && n.pressure_form != PressureForm::symmetric) {
        add({"numerics.tensile_correction", "numerics.pressure_form"},
            fmt::format(
                "[numerics] tensile_correction = {} goes with pressure_form = \"symmetric\", whose clumping "
                "it cures, not with \"{}\": set it to 0 or choose \"symmetric\"",
                n.tensile_correction, word(n.pressure_form)));
    }
    if (n.tensile_correction > 0.0 && n.kernel != KernelKind::cubic_spline) {
        add({"numerics.tensile_correction", "numerics.kernel"},
            fmt::format(
                "[numerics] tensile_correction = {} is made for kernel = \"cubic-spline\", whose gradient "
                "vanishes at the centre faster than particles approach, not for \"{}\": set it to 0",
                n.tensile_correction, word(n.kernel)));
    }
    if (n.viscosity == ViscosityForm::artificial && n.pressure_form == PressureForm::riemann) {
        add({"numerics.viscosity", "numerics.pressure_form"},
            "[numerics] viscosity = \"artificial\" with pressure_form = \"riemann\": both damp approaching "
            "particles, the one by alpha, the other by the Riemann problem; choose \"morris\" for the one or "
            "\"corrected\" for the other");
    }
    if (n.viscosity == ViscosityForm::artificial && c.turbulence.closure != ClosureKind::none &&
        n.eddy_stress == EddyStress::two_point) {
        add({"numerics.viscosity", "turbulence.closure"},
            fmt::format(
                "[numerics] viscosity = \"artificial\" acts between approaching particles alone, so the eddy "
                "viscosity of closure = \"{}\" cannot act through it: set [numerics] eddy_stress = "
                "\"stress-divergence\", or [turbulence] closure = \"none\", or choose \"morris\"",
                word(c.turbulence.closure)));
    }
}

}  // namespace riffle
