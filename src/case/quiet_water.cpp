#include "case/quiet_water.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>

#include "case/flow_kind.hpp"
#include "case/solid_mesh.hpp"

namespace riffle {

namespace {

/// Of a face that is level or upright, all components of its normal but one are less than this share of it.
constexpr double straight = 1e-6;

/// Whether a vector has more than one component that counts.
template <std::size_t N>
bool is_inclined(const std::array<double, N>& v) {
    double most = 0.0;
    for (const double component : v) {
        most = std::max(most, std::abs(component));
    }
    return std::count_if(v.begin(), v.end(),
                         [most](double component) { return std::abs(component) > straight * most; }) > 1;
}

bool comes_back(const Solid& solid) {
    return solid.motion == SolidMotion::fixed ||
           (solid.motion == SolidMotion::oscillating && solid.amplitude_angle == 0.0);
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
    if (mesh == nullptr) {
        return false;
    }
    const auto& triangles = mesh->tree().triangles();
    return std::any_of(triangles.begin(), triangles.end(),
                       [](const Triangle& t) { return is_inclined<3>(normal_of(t)); });
}

bool is_quiet_beside_inclined_faces(const Case& c) {
    return flow_kind(c) == FlowKind::tank && c.streamwise_gravity() == 0.0 && c.channel.lid_velocity == 0.0 &&
           c.channel.top == Top::free_surface && c.fluid.gravity > 0.0 &&
           std::all_of(c.solids.begin(), c.solids.end(), comes_back) &&
           std::any_of(c.solids.begin(), c.solids.end(),
                       [&c](const Solid& solid) { return has_inclined_faces(c, solid); });
}

void choose_for_quiet_water(Case& c, const GivenNumerics& given) {
    Numerics& n = c.numerics;
    if (n.preset != Preset::riffle || n.wall != WallKind::dummy || !is_quiet_beside_inclined_faces(c)) {
        return;
    }
    const bool space = c.channel.dimensions == 3;
    if (!given.lattice) {
        c.start.lattice = space ? StartLattice::body_centred : StartLattice::hexagonal;
    }
    if (!given.smoothing_ratio) {
        n.smoothing_ratio = space ? 1.65 : 1.83;
    }
    if (!given.wall_layers) {
        n.wall_layers = layers_of_kernel(n.smoothing_ratio);
    }
    if (!given.pressure_correction_time && n.pressure_form == PressureForm::corrected) {
        constexpr double longest_of_most = 100.0;  // s
        n.pressure_correction_time = std::max(longest_of_most, 3.0 * c.run.time);
    }
    const bool still = std::all_of(c.solids.begin(), c.solids.end(),
                                   [](const Solid& solid) { return solid.motion == SolidMotion::fixed; });
    if (space && still && !given.settling_time && c.start.kind == StartKind::rest &&
        c.start.water_x.empty()) {
        c.start.settling_time = 2.0;
    }
}

}  // namespace riffle
