#include "case/surface_roughness.hpp"

#include <algorithm>
#include <cmath>

#include "case/bed_friction.hpp"
#include "case/patch_range.hpp"

namespace riffle::inline case_file {

namespace {

double roughness(const Case& c, double equivalent_roughness, std::optional<double> manning) {
    return manning ? roughness_of_surface_manning(c, *manning).value_or(c.total_depth())
                   : equivalent_roughness;
}

}  // namespace

std::optional<double> roughness_of_surface_manning(const Case& c, double manning) {
    const double depth = c.total_depth();
    const double kappa = c.turbulence.kappa;
    const double wanted = velocity_ratio_of_manning(manning, depth, c.fluid.gravity);
    // The rougher, the slower the water.
    const auto ratio = [&](double k_s) {
        return log_law_mean(depth, zero_height_of_roughness(k_s, kappa), kappa);
    };
    double low = 1e-9 * depth;
    double high = depth;
    if (!(ratio(low) >= wanted && ratio(high) <= wanted)) return std::nullopt;
    constexpr int halvings = 60;
    for (int i = 0; i < halvings; ++i) {
        const double middle = std::sqrt(low * high);
        (ratio(middle) > wanted ? low : high) = middle;
    }
    return std::sqrt(low * high);
}

double surface_roughness(const Case& c, const Solid& solid) {
    return roughness(c, solid.equivalent_roughness, solid.manning);
}

double surface_roughness(const Case& c, const SurfacePatch& patch) {
    return roughness(c, patch.equivalent_roughness.value_or(0.0), patch.manning);
}

std::vector<const SurfacePatch*> patches_on(const Case& c, const Solid& solid) {
    std::vector<const SurfacePatch*> found;
    for (const SurfacePatch& patch : c.surface_patches) {
        if (patch.solid == solid.name) found.push_back(&patch);
    }
    return found;
}

bool has_strips_alone(const Case& c, const Solid& solid) {
    const auto patches = patches_on(c, solid);
    return std::all_of(patches.begin(), patches.end(), [&](const SurfacePatch* patch) {
        return !is_outlined(*patch) && covers_length(c, *patch);
    });
}

double surface_roughness_at(const Case& c, const Solid& solid, double y) {
    for (const SurfacePatch* const patch : patches_on(c, solid)) {
        const PatchRange across = ranges_of(c, *patch)[1];
        if (y >= across.from && y <= across.to) return surface_roughness(c, *patch);
    }
    return surface_roughness(c, solid);
}

}  // namespace riffle::inline case_file
