#include "column/calibration_parameter.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>

#include "base/error.hpp"
#include "case/bed_traits.hpp"
#include "case/closure_traits.hpp"
#include "case/flow_kind.hpp"

namespace riffle::inline column {

namespace {

bool plane(const Case& c) { return has_roughness(c.bed); }
bool spheres(const Case& c) { return has_spheres(c.bed); }

bool has_kappa(const Case& c) { return traits_of(c.turbulence.closure).has_kappa; }

const std::array table{
    CalibrationParameter{
        "roughness_height", "bed.roughness_height", "m",
        [](Case& c) -> double& { return c.bed.roughness_height; },
        // What a valid case allows, the datum above the bed and the zone resolved by the
        // particles, with room for the difference quotients.
        [](const Case& c) { return std::max(1.01 * c.bed.datum_below_crest, c.numerics.spacing); },
        [](const Case& c) { return c.bed.sphere_diameter; }, nullptr, spheres, "bed.kind = \"spheres\""},
    CalibrationParameter{"drag_coefficient", "bed.drag_coefficient", "",
                         [](Case& c) -> double& { return c.bed.drag_coefficient; },
                         [](const Case&) { return 0.01; }, [](const Case&) { return 10.0; }, nullptr, spheres,
                         "bed.kind = \"spheres\""},
    CalibrationParameter{"lambda", "turbulence.lambda", "",
                         [](Case& c) -> double& { return c.turbulence.lambda; },
                         [](const Case&) { return 0.01; }, [](const Case& c) { return c.turbulence.kappa; },
                         nullptr, [](const Case& c) { return c.turbulence.closure == ClosureKind::ramp; },
                         "turbulence.closure = \"ramp\""},
    CalibrationParameter{"kappa", "turbulence.kappa", "",
                         [](Case& c) -> double& { return c.turbulence.kappa; },
                         [](const Case& c) {
                             const bool ramp = c.turbulence.closure == ClosureKind::ramp;
                             return std::max(0.2, ramp ? c.turbulence.lambda : 0.0);
                         },
                         [](const Case&) { return 0.8; }, nullptr, has_kappa,
                         R"(turbulence.closure = "ramp", "nezu-rodi" or "czernuszenko-rylov")"},
    CalibrationParameter{"zero_plane", "turbulence.zero", "m",
                         [](Case& c) -> double& { return c.turbulence.zero; },
                         [](const Case&) { return 0.0; }, [](const Case& c) { return c.crest(); },
                         [](const Case& c) { return c.crest(); },
                         [](const Case& c) { return spheres(c) && has_mixing_length(c); },
                         "bed.kind = \"spheres\" and a mixing length"},
    CalibrationParameter{
        "smagorinsky_constant", "turbulence.smagorinsky_constant", "",
        [](Case& c) -> double& { return c.turbulence.smagorinsky_constant; },
        [](const Case&) { return 0.01; }, [](const Case&) { return 10.0; }, nullptr,
        [](const Case& c) { return c.turbulence.closure == ClosureKind::sps && !c.has_side_walls(); },
        "turbulence.closure = \"sps\" without side walls"},
    CalibrationParameter{
        "edge_zone", "turbulence.edge_zone", "", [](Case& c) -> double& { return c.turbulence.edge_zone; },
        [](const Case&) { return 0.05; },
        // The zones beside both walls must not overlap.
        [](const Case& c) { return std::min(4.0, c.channel.width / c.total_depth()); }, nullptr,
        [](const Case& c) {
            return c.turbulence.closure == ClosureKind::czernuszenko_rylov && c.has_side_walls();
        },
        "turbulence.closure = \"czernuszenko-rylov\" between side walls"},
    CalibrationParameter{"equivalent_roughness", "bed.equivalent_roughness", "m",
                         [](Case& c) -> double& { return c.bed.equivalent_roughness.value(); },
                         [](const Case&) { return 1e-6; },
                         [](const Case& c) { return 0.5 * c.channel.depth; }, nullptr,
                         [](const Case& c) { return plane(c) && c.bed.equivalent_roughness.has_value(); },
                         "bed.kind = \"roughness\" with bed.equivalent_roughness"},
    CalibrationParameter{"manning", "bed.manning", "s/m^(1/3)",
                         [](Case& c) -> double& { return c.bed.manning.value(); },
                         [](const Case&) { return 1e-3; }, [](const Case&) { return 0.1; }, nullptr,
                         [](const Case& c) { return plane(c) && c.bed.manning.has_value(); },
                         "bed.kind = \"roughness\" with bed.manning"},
};

}  // namespace

std::span<const CalibrationParameter> calibration_parameter_table() { return table; }

const CalibrationParameter& find_calibration_parameter(const std::string& name) {
    const auto* const found = std::find_if(table.begin(), table.end(),
                                           [&](const CalibrationParameter& p) { return p.name == name; });
    if (found == table.end()) {
        std::string known;
        for (const CalibrationParameter& p : table) {
            known += fmt::format("{}{}", known.empty() ? "" : ", ", p.name);
        }
        throw InputError(fmt::format("unknown parameter \"{}\" to fit: choose among {}", name, known));
    }
    return *found;
}

}  // namespace riffle::inline column
