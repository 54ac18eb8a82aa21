#include "case/quiet_water.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <vector>

#include "case/flow_kind.hpp"
#include "case/solid_mesh.hpp"

namespace riffle::inline case_file {

namespace {

/// Of a face that is level or upright, all components of its normal but one are less than this share of it.
constexpr double straight = 1e-6;

/// Whether a vector has more than one component that counts.
template <std::size_t N>
bool is_inclined(const std::array<double, N>& v) {
    double most = 0.0;
    for (const double component : v) most = std::max(most, std::abs(component));
    return std::count_if(v.begin(), v.end(),
                         [most](double component) { return std::abs(component) > straight * most; }) > 1;
}

/// Time to settle before a run in three dimensions, s.
constexpr double quiet_settling_time = 2.0;

StartLattice quiet_lattice(const Case& c) {
    return c.channel.dimensions == 3 ? StartLattice::body_centred : StartLattice::hexagonal;
}

double quiet_smoothing_ratio(const Case& c) { return c.channel.dimensions == 3 ? 1.65 : 1.83; }

double quiet_correction_time(const Case& c) {
    constexpr double longest_of_most = 100.0;  // s
    return std::max(longest_of_most, 3.0 * c.run.time);
}

/// Whether a solid at rest stands above all of the water, where it cuts none of its rows.
bool stays_dry(const Case& c, const Solid& solid) {
    if (!solid.rests() || !c.start.water_x.empty()) return false;
    const SolidMesh* const mesh = c.channel.dimensions == 3 ? mesh_of(c, solid) : nullptr;
    const double lowest = mesh != nullptr   ? mesh->lower()[2]
                          : solid.z.empty() ? 0.0
                                            : *std::min_element(solid.z.begin(), solid.z.end());
    return lowest >= c.total_depth();
}

bool comes_back(const Solid& solid) {
    return solid.rests() || (solid.motion == SolidMotion::oscillating && solid.amplitude_angle == 0.0);
}

}  // namespace

bool has_inclined_faces(const Case& c, const Solid& solid) {
    if (c.channel.dimensions == 2) {
        for (std::size_t i = 0; i < solid.x.size(); ++i) {
            const std::size_t next = (i + 1) % solid.x.size();
            if (is_inclined<2>({solid.x[next] - solid.x[i], solid.z[next] - solid.z[i]})) {
                return true;
            }
        }
        return false;
    }
    const SolidMesh* const mesh = mesh_of(c, solid);
    if (mesh == nullptr) return false;
    const auto& triangles = mesh->tree().triangles();
    return std::any_of(triangles.begin(), triangles.end(),
                       [](const Triangle& t) { return is_inclined<3>(normal_of(t)); });
}

bool is_quiet_beside_inclined_faces(const Case& c) {
    return flow_kind(c) == FlowKind::tank && c.streamwise_gravity() == 0.0 && c.channel.lid_velocity == 0.0 &&
           c.channel.top == Top::free_surface && c.fluid.gravity > 0.0 &&
           std::all_of(c.solids.begin(), c.solids.end(), comes_back) &&
           std::any_of(c.solids.begin(), c.solids.end(), [&c](const Solid& solid) {
               return has_inclined_faces(c, solid) && !stays_dry(c, solid);
           });
}

void choose_for_quiet_water(Case& c, const GivenNumerics& given) {
    Numerics& n = c.numerics;
    if (n.preset != Preset::riffle || n.wall != WallKind::dummy || !is_quiet_beside_inclined_faces(c)) return;
    const bool space = c.channel.dimensions == 3;
    if (!given.lattice) c.start.lattice = quiet_lattice(c);
    // The smoothing length goes with that lattice alone.
    if (!given.smoothing_ratio && c.start.lattice == quiet_lattice(c)) {
        n.smoothing_ratio = quiet_smoothing_ratio(c);
    }
    if (!given.wall_layers) n.wall_layers = layers_of_kernel(n.smoothing_ratio);
    if (!given.pressure_correction_time && n.pressure_form == PressureForm::corrected) {
        n.pressure_correction_time = quiet_correction_time(c);
    }
    const bool still =
        std::all_of(c.solids.begin(), c.solids.end(), [](const Solid& solid) { return solid.rests(); });
    if (space && still && !given.settling_time && c.start.kind == StartKind::rest &&
        c.start.water_x.empty()) {
        c.start.settling_time = quiet_settling_time;
    }
}

std::optional<std::string> quiet_water_note(const Case& c) {
    if (!is_quiet_beside_inclined_faces(c)) return std::nullopt;
    const Numerics& n = c.numerics;
    std::vector<std::string> chosen;
    if (c.start.lattice == quiet_lattice(c)) {
        chosen.push_back(fmt::format(
            "{} lattice", c.start.lattice == StartLattice::hexagonal ? "hexagonal" : "body-centred"));
    }
    if (n.smoothing_ratio == quiet_smoothing_ratio(c)) {
        chosen.push_back(fmt::format("h = {} dx", n.smoothing_ratio));
    }
    if (n.pressure_correction_time == quiet_correction_time(c)) {
        chosen.push_back(
            fmt::format("mean of the pressure's correction over {:.4g} s", n.pressure_correction_time));
    }
    if (c.start.settling_time == quiet_settling_time) {
        chosen.push_back(fmt::format("{:.3g} s to settle before the run", c.start.settling_time));
    }
    if (chosen.empty()) return std::nullopt;
    return fmt::format("{}: the defaults beside inclined faces", fmt::join(chosen, ", "));
}

}  // namespace riffle::inline case_file
