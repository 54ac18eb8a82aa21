#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include "case/case.hpp"
#include "case/conversion.hpp"
#include "case/flow_kind.hpp"
#include "case/key_table.hpp"
#include "case/presets.hpp"
#include "case/units.hpp"
#include "case/words.hpp"

namespace riffle {

namespace {

constexpr double rows_over_depth = 20.0;   ///< verified at 2 mm over a total depth of 46 mm and more
constexpr double rows_in_roughness = 4.0;  ///< verified at 2 mm in a roughness zone of 8 mm
// In three dimensions the lowest layers are mixed among the spheres anyway: verified with these.
constexpr double space_rows_over_depth = 10.0;
constexpr double space_rows_in_roughness = 2.0;
constexpr double velocity_to_maximum =
    1.4;                        ///< surface velocity over depth mean, at most, in the verified cases
constexpr double small = 1e-9;  ///< for the comparison of ratios given as decimals

bool near(double a, double b) { return std::abs(a - b) < small; }

/// One list of warnings over a valid case. The measurements behind each bound stand in docs/theory.md.
class Warnings {
  public:
    explicit Warnings(const Case& c) : c_(c) {}

    [[nodiscard]] std::vector<std::string> collect() && {
        resolution();
        kernel();
        pressure();
        sound_speed();
        viscosity_and_closure();
        stepping_and_walls();
        bed();
        beginning();
        without_effect();
        return std::move(list_);
    }

  private:
    template <class... Args>
    void add(fmt::format_string<Args...> format, Args&&... args) {
        list_.push_back(fmt::format(format, std::forward<Args>(args)...));
    }

    void resolution() {
        const double spacing = c_.numerics.spacing;
        if (c_.bed.kind != BedKind::spheres) {
            return;
        }
        const bool space = c_.channel.dimensions == 3;
        const double in_roughness = space ? space_rows_in_roughness : rows_in_roughness;
        const double over_depth = space ? space_rows_over_depth : rows_over_depth;
        if (spacing > c_.bed.roughness_height / in_roughness * (1 + small)) {
            add("numerics.spacing: {} leaves only {:.1f} rows in the roughness zone of {}; verified with "
                "{:.0f} and more ({} here)",
                shown_length(spacing), c_.bed.roughness_height / spacing,
                shown_length(c_.bed.roughness_height), in_roughness,
                shown_length(c_.bed.roughness_height / in_roughness));
        }
        if (spacing > c_.total_depth() / over_depth * (1 + small)) {
            add("numerics.spacing: {} leaves only {:.0f} rows over the depth; verified with more than "
                "{:.0f}{}",
                shown_length(spacing), c_.total_depth() / spacing, over_depth,
                space ? ""
                      : " (2 mm at depths from 40 mm), at 3 mm and 50 mm the layers of the flow broke up");
        }
    }

    void kernel() {
        const Numerics& n = c_.numerics;
        if (n.kernel == KernelKind::cubic_spline) {
            add("numerics.kernel: the cubic spline does not keep the particles in order, and the flow brakes "
                "(by a "
                "third within 6 s in condition 2 with the thesis' scheme); verified with \"wendland-c2\"");
        }
        if (n.kernel != KernelKind::wendland_c2 && n.kernel != KernelKind::cubic_spline) {
            add("numerics.kernel: \"{}\" is verified in laminar flow alone; verified with \"wendland-c2\"",
                word(n.kernel));
        }
        const bool hexagonal = c_.start.lattice == StartLattice::hexagonal && near(n.smoothing_ratio, 2.1);
        if (!near(n.smoothing_ratio, 1.5) && !near(n.smoothing_ratio, 2.0) && !hexagonal) {
            add("numerics.smoothing_ratio: verified with 1.5 and 2.0 (2.1 on the hexagonal lattice), not "
                "with {}",
                n.smoothing_ratio);
        }
    }

    void pressure() {
        const Numerics& n = c_.numerics;
        if (n.pressure_form == PressureForm::symmetric) {
            add("numerics.pressure_form: in the symmetric form any disorder of the particles turns 0.2-0.4 "
                "% of the pressure into a shear stress as large as the flow's own friction, which "
                "refinement does not cure; the mean velocity is then 4-30 % low. Use \"corrected\" unless "
                "this is what you study");
        }
        if (n.kernel_correction == KernelCorrection::kernel) {
            add("numerics.kernel_correction: \"kernel\" leaves the spurious shear stress of the symmetric "
                "form as "
                "it is (12 % of the bed stress in a stirred channel); verified with \"kernel-gradient\"");
        }
        if (n.has_riemann_problem()) {
            add("numerics.pressure_form: a Riemann form keeps the spurious shear stress of the symmetric "
                "one, and the mean velocity is low with it; use \"corrected\" unless this is what you "
                "study, and preset = \"violent\" for impacts");
        }
        if (n.density_diffusion == DensityDiffusion::molteni && c_.channel.top == Top::free_surface) {
            add("numerics.density_diffusion: \"molteni\" diffuses the hydrostatic difference too, and moves "
                "the level of the water by per cent within seconds; use \"fourtakas\" under gravity");
        }
        if (n.density_diffusion == DensityDiffusion::none && n.density_filter == DensityFilter::none) {
            add("numerics.density_diffusion: neither diffusion nor filter keeps the density free of noise");
        }
        const double delta = n.density_diffusion_coefficient;
        if (n.density_diffusion != DensityDiffusion::none && (delta < 0.02 - small || delta > 0.1 + small)) {
            add("numerics.density_diffusion_coefficient: verified from 0.02 to 0.1, not with {}", delta);
        }
        if (n.density_diffusion == DensityDiffusion::fourtakas && delta < 0.1 - small &&
            n.smoothing_ratio < 2.0) {
            add("numerics.density_diffusion_coefficient: with h = {} dx use 0.1; {} lets density and "
                "spacing drift apart in a disordered flow",
                n.smoothing_ratio, delta);
        }
        if (n.xsph > 0) {
            add("numerics.xsph: not verified with the other defaults; the verified value is 0");
        }
    }

    void sound_speed() {
        if (!c_.numerics.sound_speed) {
            return;  // chosen to fit
        }
        const double speed = *c_.numerics.sound_speed;
        const double compression = c_.normal_gravity() * c_.total_depth() / (speed * speed);
        constexpr double allowed_compression = 0.02;
        if (compression > allowed_compression) {
            add("numerics.sound_speed: at {} m/s the water's own weight compresses it by {:.1f} % at the "
                "bed; take at least {:.2g} m/s (10 sqrt(g H))",
                speed, 100 * compression, 10 * std::sqrt(c_.normal_gravity() * c_.total_depth()));
        }
        const double from_measured = c_.measured.depth_mean_velocity.value_or(0.0) * velocity_to_maximum;
        const double velocity = std::max(from_measured, std::abs(c_.start.velocity.value_or(0.0)));
        if (speed < 10 * velocity) {
            add("numerics.sound_speed: {} m/s is less than 10 times the largest velocity of about {:.2g} "
                "m/s; the density would vary by more than 1 %",
                speed, velocity);
        }
    }

    void viscosity_and_closure() {
        const Numerics& n = c_.numerics;
        if (n.viscosity == ViscosityForm::monaghan_gingold) {
            add("numerics.viscosity: \"monaghan-gingold\" is too weak in layered shear, by 11 % at h = 1.5 "
                "dx and 4 % at 2 dx (Wendland); \"morris\" is within 0.3 %");
        }
        if (n.viscosity == ViscosityForm::artificial) {
            add("numerics.viscosity: \"artificial\" is no viscosity of the water: it grows with c0 and h, "
                "and a shear flow with it does not converge to the profile of fluid.kinematic_viscosity");
        }
        if (c_.turbulence.closure == ClosureKind::none) {
            if (c_.bed.kind == BedKind::spheres) {
                add("turbulence.closure: a rough bed without a closure gives velocities far above any real "
                    "flow");
            }
            return;
        }
        if (n.eddy_stress == EddyStress::stress_divergence) {
            add("numerics.eddy_stress: with \"stress-divergence\" the velocity zigzags from row to row; "
                "verified with \"two-point\"");
        }
        if (c_.turbulence.closure == ClosureKind::sps) {
            add("turbulence.closure: the constant-C_s model at this resolution gives a stress far below "
                "the weight of the water above, so the velocity does not settle at a real value; it is "
                "offered to show this. Use a mixing length (\"ramp\", \"nezu-rodi\", \"nikuradse\")");
            if (c_.has_side_walls()) {
                add("turbulence.closure: between side walls the constant-C_s model has no steady flow, and "
                    "the run no cross-section twin{}",
                    c_.start.kind == StartKind::section
                        ? "; it starts from that of the same channel with \"czernuszenko-rylov\""
                        : "");
            }
        }
        if (c_.bed.kind == BedKind::no_slip) {
            add("bed.kind: a no-slip bed with a mixing length is under-resolved at this kind of spacing (2 "
                "% in the mean velocity at 2 mm)");
        }
    }

    void stepping_and_walls() {
        const Numerics& n = c_.numerics;
        const bool one_evaluation =
            n.stepping == Stepping::semi_implicit_euler || n.stepping == Stepping::leapfrog;
        const double verified = one_evaluation ? 0.8 : n.stepping == Stepping::verlet ? 0.2 : 0.4;
        if (!n.time_step && n.courant_number > verified + small) {
            add("numerics.courant_number: {} is more than {}, the largest value verified with \"{}\"",
                n.courant_number, verified, word(n.stepping));
        }
        const bool eddies =
            c_.channel.dimensions == 3 && (c_.turbulence.closure == ClosureKind::sps ||
                                           c_.turbulence.closure == ClosureKind::none || resolves_eddies(c_));
        if (n.stepping == Stepping::semi_implicit_euler && eddies && c_.run.time > 1.0 &&
            c_.channel.slope > 0.0) {
            add("numerics.stepping: water whose particles are in disorder swells with \"{}\", in three "
                "dimensions by about 0.25 % a second; \"leapfrog\" keeps its volume",
                word(n.stepping));
        }
        const bool layered = n.wall == WallKind::dummy || n.wall == WallKind::modified_dynamic;
        if (layered && c_.channel.top != Top::periodic &&
            n.wall_layers * n.spacing < 2 * n.smoothing_ratio * n.spacing * (1 - small)) {
            add("numerics.wall_layers: {} layers do not fill the kernel (2 h = {} dx); take {}",
                n.wall_layers, 2 * n.smoothing_ratio, std::ceil(2 * n.smoothing_ratio));
        }
        if (n.wall == WallKind::modified_dynamic && n.density_diffusion == DensityDiffusion::none &&
            n.density_filter == DensityFilter::none) {
            add("numerics.wall: \"modified-dynamic\" walls carry the noise of the density beside them on "
                "into the wall; without density diffusion the pressure of still water scattered by 14 % and "
                "its level rose by 7 % in 2 s");
        }
        if (n.wall == WallKind::repulsive) {
            add("numerics.wall: \"repulsive\" walls hold the water and give no more: no friction, and "
                "between end walls they stir still water to 9 % of sqrt(g H); verified with \"dummy\" walls");
        }
        if (n.wall == WallKind::dynamic && n.preset == Preset::riffle) {
            add("numerics.wall: verified with \"dummy\" walls, which act by their pressure only");
        }
    }

    void bed() {
        if (c_.bed.kind == BedKind::spheres && c_.bed.drag_form == DragForm::thesis) {
            add("bed.drag_form: the form printed in the thesis scales as 1 / spacing, so the flow changes "
                "with the resolution; \"consistent\" does not");
        }
        if (!c_.measured.uniform) {
            add("measured.uniform: the measured flow was not uniform; a uniform simulation need not agree "
                "with it");
        }
    }

    /// Whether a solid that is not lifted holds the water at one edge of its outline, over its whole height.
    [[nodiscard]] bool is_held(double edge, double height) const {
        const double touch = 2.0 * c_.numerics.spacing;
        return std::any_of(c_.solids.begin(), c_.solids.end(), [&](const Solid& solid) {
            if (solid.x.empty() || solid.z.empty() || solid.velocity_z > 0.0) {
                return false;
            }
            const auto [left, right] = std::minmax_element(solid.x.begin(), solid.x.end());
            const double top = *std::max_element(solid.z.begin(), solid.z.end());
            return *left - touch <= edge && edge <= *right + touch && top + touch >= height;
        });
    }

    /// Whether the water falls, or meets a wall of a tank that it does not fill.
    [[nodiscard]] bool breaks() const {
        const auto& x = c_.start.water_x;
        const auto& z = c_.start.water_z;
        if (x.empty() || c_.channel.ends != Ends::walls) {
            return false;
        }
        const auto [left, right] = std::minmax_element(x.begin(), x.end());
        const auto [low, high] = std::minmax_element(z.begin(), z.end());
        // The front of a breaking dam without friction runs at twice sqrt(g h) (Ritter 1892).
        const double gap = std::max(is_held(*left, *high) ? 0.0 : *left,
                                    is_held(*right, *high) ? 0.0 : c_.channel.length - *right);
        const double front = 2.0 * std::sqrt(c_.normal_gravity() * *high);
        const bool arrives = gap > c_.numerics.spacing && c_.run.time * front > gap;
        return arrives || *low > c_.numerics.spacing;
    }

    void beginning() {
        if (breaks() && c_.numerics.preset != Preset::violent) {
            add("numerics.preset: in this run water breaks against a wall or falls; such flows are verified "
                "with "
                "preset = \"violent\", and with \"{}\" spray may end the run and pressures scatter",
                word(c_.numerics.preset));
        }
        if (c_.start.lattice == StartLattice::body_centred && c_.start.kind != StartKind::rest) {
            add("start.lattice: \"body-centred\" has no layers that slide in a shear flow (spurious stress "
                "of 1.3 % against 0.2 % in a cell of spheres at 5 mm); verified with \"square\"");
        }
        constexpr double verified_jitter = 0.25;
        if (c_.start.jitter > verified_jitter) {
            add("start.jitter: verified up to {} spacings; a start at 0.4 failed", verified_jitter);
        }
    }

    /// Keys that differ from their default though nothing uses them.
    void without_effect() {
        Case defaults;
        defaults.numerics = preset_numerics(c_.numerics.preset, c_.channel.dimensions);
        for (const SectionKeys& section : key_table()) {
            for (const Key& key : section.keys) {
                if (!key.applies.strictly && !key_applies(key, c_) && key.get(c_) != key.get(defaults)) {
                    add("{} = {} has no effect: it is used only with {} = \"{}\"", key.id(),
                        value_text(key, key.get(c_)), key.applies.id, fmt::join(key.applies.words, "\", \""));
                }
            }
        }
    }

    const Case& c_;
    std::vector<std::string> list_;
};

}  // namespace

std::vector<std::string> case_warnings(const Case& c) { return Warnings(c).collect(); }

}  // namespace riffle
