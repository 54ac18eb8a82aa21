#pragma once

#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "case/options.hpp"
#include "case/patches.hpp"

namespace riffle::inline case_file {

class SolidMesh;

// The keys of a case. Names, defaults, units and meanings stand in the key table (key_table.cpp). All values
// are SI. Axes: x down the bed, z normal to it, upward from the bed level z = 0.

/// [channel]
struct Channel {
    double slope = 0.0;    ///< S0 = tan(theta)
    double depth = 0.0;    ///< h_w, measured from the zero datum, m
    double length = 0.2;   ///< along x, m
    double width = 0.459;  ///< of the flume, m; with periodic sides the simulated width
    int dimensions = 2;    ///< 2: the x-z plane; 3: x, y across the channel from 0 at a side wall, z
    Ends ends = Ends::periodic;
    Sides sides = Sides::periodic;
    Top top = Top::free_surface;
    std::optional<double> wall_height;  ///< of upright end walls above the bed level, m; unset: 1.5 H
    double lid_velocity = 0.0;          ///< of the wall at the top along x, m/s

    /// Extent of the simulated water across the channel, m: half the width where the other half is its mirror
    /// image.
    [[nodiscard]] double simulated_width() const { return sides == Sides::half ? 0.5 * width : width; }
    /// Of what passes a section, the whole over what is simulated.
    [[nodiscard]] double whole_over_simulated() const { return sides == Sides::half ? 2.0 : 1.0; }
    /// Width that masses, forces and discharges are of, m: that, in two dimensions one metre.
    [[nodiscard]] double flow_width() const { return dimensions == 3 ? simulated_width() : 1.0; }
    /// Place of the channel's centreline across it, m.
    [[nodiscard]] double centreline() const { return 0.5 * width; }

    bool operator==(const Channel&) const = default;
};

/// [inflow]: what enters a channel with open ends at x = 0. One of the discharges, the depth, or in
/// supercritical flow both.
struct Inflow {
    std::optional<double> discharge;       ///< of the whole width, m3/s
    std::optional<double> unit_discharge;  ///< of a unit of the width, m2/s
    std::optional<double> depth;           ///< over the zero datum, m
    std::filesystem::path discharge_file;  ///< CSV with the columns time, and discharge or unit_discharge
    std::filesystem::path depth_file;      ///< CSV with the columns time, depth
    InflowProfile profile = InflowProfile::twin;
    double exponent = 7.0;                  ///< m of the power law u = U_max (z/H)^(1/m)
    double equivalent_roughness = 0.0;      ///< k_s of the log law, m
    std::filesystem::path profile_file;     ///< CSV with the columns z, u; z above the datum
    std::filesystem::path results;          ///< results file whose water enters
    std::optional<double> results_from;     ///< time from which on its snapshots are taken, s
    std::optional<double> relaxation_time;  ///< in which the discharge comes back after a wave, s

    [[nodiscard]] bool gives_discharge() const {
        return discharge || unit_discharge || !discharge_file.empty();
    }
    [[nodiscard]] bool gives_depth() const { return depth || !depth_file.empty(); }

    bool operator==(const Inflow&) const = default;
};

/// [outflow]: what rules the water at the other end of a channel with open ends, x = L.
struct Outflow {
    OutflowKind kind = OutflowKind::normal_depth;
    std::optional<double> depth;            ///< over the zero datum, m
    std::filesystem::path depth_file;       ///< CSV with the columns time, depth
    double weir_height = 0.0;               ///< of the crest over the zero datum, m
    double weir_coefficient = 0.62;         ///< C_d of q = (2/3) C_d sqrt(2 g) head^(3/2)
    std::filesystem::path rating_file;      ///< CSV with the columns depth, and discharge or unit_discharge
    std::optional<double> relaxation_time;  ///< in which the depth goes to what rules it, s

    bool operator==(const Outflow&) const = default;
};

/// [bed]
struct Bed {
    BedKind kind = BedKind::spheres;
    double sphere_diameter = 0.025;  ///< D, m
    Packing packing = Packing::hexagonal;
    double roughness_height = 0.0;     ///< d_h, bed level to crest, m; 0 for plane beds
    double datum_below_crest = 0.004;  ///< m; 0 for plane beds
    double drag_coefficient = 0.8;     ///< C_d
    DragForm drag_form = DragForm::consistent;
    std::optional<double>
        sphere_ramp;  ///< 3D: length over which a sphere's drag sets in, m; see Case::sphere_ramp()
    std::optional<double> equivalent_roughness;  ///< k_s of a bed by roughness, m
    std::optional<double> manning;               ///< n at the depth of the case instead of it, s/m^(1/3)

    bool operator==(const Bed&) const = default;
};

/// [side_walls]: drag of the walls beside the water (three dimensions)
struct SideWalls {
    SideDragForm drag_form = SideDragForm::consistent;
    std::optional<double> layer;  ///< thickness of the layer it acts in, m; see Case::side_layer()
    std::optional<double> equivalent_roughness;  ///< k_s of the log law, m; unset: that of a bed by roughness

    bool operator==(const SideWalls&) const = default;
};

/// [turbulence]
struct Turbulence {
    ClosureKind closure = ClosureKind::ramp;
    double kappa = 0.41;
    double lambda = 0.09;                 ///< plateau of the ramp, l_m = lambda H
    std::optional<double> wake_strength;  ///< Coles' Pi of Nezu & Rodi's mixing length; see wake()
    double zero = 0.0;                    ///< height above the bed level where the mixing length starts, m
    double smagorinsky_constant = 0.12;   ///< C_s of the SPS closure
    std::optional<double> filter_width;   ///< Delta of the SPS closure, m; unset: spacing / sqrt(2)
    StressTerms stress_terms = StressTerms::full;
    EddyRate eddy_rate = EddyRate::strain;         ///< that times l_m^2 is the eddy viscosity
    ClosureDepth depth = ClosureDepth::automatic;  ///< of the mixing lengths; see uses_local_depth()
    double edge_zone = 0.5;       ///< gamma of Czernuszenko & Rylov: the edge zones are gamma H/2 wide
    double spanwise_ratio = 0.5;  ///< l_y / l_x of Czernuszenko & Rylov

    /// Coles' Pi in use: that of wide channels, 0.2, for Czernuszenko & Rylov, else none.
    [[nodiscard]] double wake() const {
        return wake_strength.value_or(closure == ClosureKind::czernuszenko_rylov ? 0.2 : 0.0);
    }

    bool operator==(const Turbulence&) const = default;
};

/// [fluid]
struct Fluid {
    double density = 1000.0;
    double kinematic_viscosity = 1.0e-6;
    double gravity = 9.81;

    bool operator==(const Fluid&) const = default;
};

/// [numerics]
struct Numerics {
    Preset preset = Preset::riffle;
    double spacing = 0.002;  ///< dx, m
    KernelKind kernel = KernelKind::wendland_c2;
    double smoothing_ratio = 1.5;       ///< h / dx
    std::optional<double> sound_speed;  ///< c0, m/s; unset: max(20 U_max, 10 sqrt(g H))
    EquationOfState equation_of_state = EquationOfState::linear;
    PressureForm pressure_form = PressureForm::corrected;
    ReferencePressure reference_pressure = ReferencePressure::none;
    double reference_depth_ratio = 2.5;  ///< depth whose weight the pairs carry beside it, over dx
    VelocityGradient velocity_gradient = VelocityGradient::corrected;
    KernelCorrection kernel_correction = KernelCorrection::kernel_gradient;  ///< of the corrected forms
    double pressure_correction_time = 0.0;  ///< of the mean that corrects the pressure, s; 0: none is taken
    DensityDiffusion density_diffusion = DensityDiffusion::fourtakas;
    double density_diffusion_coefficient = 0.1;
    double density_relaxation = 0.0;  ///< to the kernel's sum, over the strain rate; 0: none
    DensityFilter density_filter = DensityFilter::none;
    int density_filter_interval = 30;  ///< steps
    ViscosityForm viscosity = ViscosityForm::morris;
    EddyStress eddy_stress = EddyStress::two_point;
    DragSampling drag_sampling = DragSampling::row;
    double artificial_viscosity = 0.02;  ///< alpha of viscosity = "artificial"
    double tensile_correction = 0.0;     ///< epsilon of Monaghan (2000); 0: none
    double impact_dissipation = 0.0;     ///< eta of Zhang, Hu & Adams (2017); 0: none
    double acoustic_damping = 0.0;       ///< bulk viscosity over h c0; 0: none
    double xsph = 0.0;
    Stepping stepping = Stepping::leapfrog;
    StepRule step_rule = StepRule::acoustic;
    double courant_number = 0.7;
    std::optional<double> time_step;  ///< fixed step, s; unset: from the Courant number and the forces
    WallKind wall = WallKind::dummy;
    int wall_layers = 3;
    Precision precision = Precision::single_precision;
    std::optional<double>
        skin;  ///< of the neighbour lists, in units of h; unset: 0.3, in three dimensions 0.1

    bool operator==(const Numerics&) const = default;

    /// Whether the pressure of a pair is that of a Riemann problem.
    [[nodiscard]] bool has_riemann_problem() const {
        return pressure_form == PressureForm::riemann ||
               pressure_form == PressureForm::riemann_non_conservative;
    }
    /// The skin in use.
    [[nodiscard]] double skin_in(int dimensions) const { return skin.value_or(dimensions == 3 ? 0.1 : 0.3); }
};

/// [start]
struct Start {
    StartKind kind = StartKind::column;
    std::optional<double> velocity;  ///< uniform: U; power-law: U_max; wave and vortex: amplitude. m/s
    double exponent = 3.0;           ///< m of U = U_max (z/H)^(1/m)
    double amplitude = 0.0;          ///< standing wave: of the surface, m
    std::filesystem::path file;      ///< results: the file to start from; isotropic: the energy spectrum
    StartLattice lattice = StartLattice::square;
    std::vector<double> water_x;  ///< corners of the outline of the water at the start, m; empty: all up to
    std::vector<double> water_z;  ///< the depth
    double jitter = 0.0;          ///< random displacement of the lattice, in units of the spacing
    /// Whether the particles are moved to fill the water evenly; none: starts_packed().
    std::optional<bool> packed;
    double settling_time = 0.0;  ///< over which a drag takes the motion out of the water, s
    /// Random velocity without divergence, root mean square of a component, m/s; none: start_perturbation().
    std::optional<double> perturbation;
    long long seed = 1;

    bool operator==(const Start&) const = default;
};

/// [stirring]: a body force of travelling vortex modes of zero mean, a test of the pressure form under
/// disorder.
struct Stirring {
    double acceleration = 0.0;  ///< amplitude F, m/s2
    int modes = 3;
    std::optional<double> celerity;  ///< of the modes, m/s; unset: depth-mean velocity of the column

    bool operator==(const Stirring&) const = default;
};

/// [run]
struct Run {
    RunUntil until = RunUntil::converged;
    double time = 60.0;        ///< until = "time": simulated end time, s; "converged": the latest end
    double tolerance = 0.005;  ///< relative half-width of the 95 % interval of the depth-mean velocity
    std::optional<double> average_from;  ///< start of the averaging window, s; unset: chosen by the test

    bool operator==(const Run&) const = default;
};

/// [output]
struct Output {
    double series_interval = 0.02;   ///< s
    double surface_interval = 0.01;  ///< s; 100 Hz: waves of 20 Hz are sampled five times a period
    SurfaceDetection surface_detection = SurfaceDetection::volume_fraction;
    std::optional<double> surface_threshold;  ///< of the detection; unset: usual_surface_threshold()
    double profile_interval = 0.01;           ///< s between samples of the time averages
    double snapshot_interval = 1.0;           ///< s; 0: none
    double checkpoint_interval = 60.0;        ///< s of wall-clock time
    double progress_interval = 1.0;           ///< s of wall-clock time
    bool standard_probes = true;  ///< whether the instruments of the case's kind record without asking
    // Three dimensions.
    double mean_field_interval = 5.0;  ///< s, length of the averaging windows of the mean field; 0: none
    std::optional<double> mean_field_spacing;  ///< m, cells of the mean field; unset: the particle spacing
    double surface_map_interval = 0.1;         ///< s between plan maps of the surface; 0: none
    // Snapshots: what of which part of the water.
    std::string snapshot_fields = "velocity pressure density eddy_viscosity";  ///< beside position and id
    std::vector<double> snapshot_x;                                            ///< m, from and to; empty: all
    std::vector<double> snapshot_y;
    std::vector<double> snapshot_z;
    int compression = 4;  ///< of the results file, deflate level 0 to 9

    bool operator==(const Output&) const = default;
};

/// [measured]: what to compare with. Unset where unknown.
struct Measured {
    std::optional<double> depth_mean_velocity;
    std::optional<double> friction_velocity;
    std::optional<double> equivalent_roughness;
    std::optional<double> discharge;
    std::optional<double> surface_standard_deviation;
    std::filesystem::path velocity_profile;  ///< CSV with columns z, u [, u_uncertainty]; z above the datum
    bool uniform = true;                     ///< whether the measured flow was uniform
    std::string source;

    bool operator==(const Measured&) const = default;
};

/// [[probe]]: an instrument that records while the run goes on. Which members a kind uses is said in the key
/// table.
struct Probe {
    std::string name;
    ProbeKind kind = ProbeKind::velocity;
    double sampling_frequency = 0.0;  ///< Hz
    double start = 0.0;               ///< simulated time from which it records, s
    std::vector<double> x;            ///< m; velocity: one, or as many as z
    std::vector<double> y;            ///< m, three dimensions: one, or as many as x; empty: the centreline
    std::vector<double> z;            ///< m above the bed level; velocity: one, or as many as x
    double sampling_length = 0.0;     ///< velocity: height of the measuring volume, m; 0: a point
    std::optional<double> spacing;    ///< surface line, grid: between points, m; unset: from the particles'
    std::optional<double> x_from;     ///< grid, m; unset: the whole channel, bed to surface
    std::optional<double> x_to;
    std::optional<double> z_from;
    std::optional<double> z_to;
    double averaging_time = 1.0;  ///< grid: length of a window, s
    std::string solid;            ///< pressure: name of the solid that it sits on and moves with; empty: none
    double diameter = 0.0;        ///< pressure: of its round face, whose mean it gives, m; 0: a point

    bool operator==(const Probe&) const = default;
};

/// [[solid]]: a body that the water flows around: an outline in two dimensions, a closed surface in three.
struct Solid {
    std::string name;
    SolidShape shape = SolidShape::free_form;
    std::vector<double> x;  ///< 2D: corners of its outline, m, in either sense of rotation; of all shapes
    std::vector<double> z;  ///< 2D: m above the bed level
    std::filesystem::path file;  ///< 3D: file of its closed surface
    double scale = 1.0;          ///< 3D: length of the file's unit, m
    std::vector<double> place;   ///< 3D: x, y, z of the file's origin, m; empty: the channel's origin
    std::vector<double> centre;  ///< x, y, z of its centre, m; in 2D x, z
    std::vector<double> size;    ///< box: along x, y, z, m; rectangle: along x, z
    double angle = 0.0;          ///< box: turned about its upright axis; rectangle: about its centre. Degrees
    double diameter = 0.0;       ///< sphere, cylinder, circle; of each of the spheres, m
    double length = 0.0;         ///< cylinder, m
    SolidAxis axis = SolidAxis::z;           ///< of a cylinder
    std::filesystem::path heights;           ///< bed: file of its heights
    double unit = 1.0;                       ///< bed: length of the file's unit, m
    std::optional<double> height_unit;       ///< bed: of its heights, m; unset: the same
    std::vector<double> origin;              ///< bed: place in the file that comes to the channel's origin
    double blend = 0.0;                      ///< bed: length over which its ends are made to meet, m
    std::optional<double> largest_hole;      ///< bed: widest hole that is filled, m
    std::vector<double> y;                   ///< section: places across the channel, m
    std::vector<double> levels;              ///< section: heights there, m
    double bottom_width = 0.0;               ///< trapezoid, compound, m
    double bank_slope = 1.0;                 ///< of their banks, horizontal over vertical
    std::optional<double> bank_height;       ///< of their banks above the bottom, m; unset: up to the sides
    std::optional<double> floodplain_width;  ///< compound: of each, m; unset: up to the sides
    SolidPacking packing = SolidPacking::hexagonal;  ///< spheres
    std::optional<double> level;  ///< spheres: height of their centres, m; unset: they lie on the bed
    long long seed = 1;           ///< spheres, random
    std::vector<double> smaller_diameters;  ///< spheres, random: further sizes, m
    std::vector<double> area_shares;  ///< their shares of the plan, from the largest on but the smallest
    SolidSurface surface = SolidSurface::no_slip;
    double equivalent_roughness = 0.0;  ///< k_s of a surface by the log law, m; 0: smooth
    std::optional<double> manning;      ///< n at the depth of the case instead of it, s/m^(1/3)
    bool part_of_bed = false;           ///< whether the flow over it is one over a rough bed
    std::vector<double> moment_about;   ///< x, y, z of a point of it at t = 0, m; in 2D x, z; empty: centroid
    SolidMotion motion = SolidMotion::fixed;
    double start = 0.0;          ///< time at which it starts to move, s
    std::optional<double> stop;  ///< time at which it stops, s; unset: never
    double velocity_x = 0.0;     ///< constant: m/s
    double velocity_y = 0.0;     ///< 3D
    double velocity_z = 0.0;
    double amplitude_x = 0.0;  ///< oscillating: x = amplitude sin(2 pi frequency (t - start)), m
    double amplitude_y = 0.0;  ///< 3D
    double amplitude_z = 0.0;
    double frequency = 0.0;         ///< Hz
    double angular_velocity = 0.0;  ///< constant, or free at its start: about its axis, rad/s
    double amplitude_angle = 0.0;   ///< oscillating: degrees
    std::vector<double> times;      ///< table: s
    std::vector<double> shifts_x;   ///< table: from its place at t = 0, m; empty: none
    std::vector<double> shifts_y;   ///< 3D
    std::vector<double> shifts_z;
    std::vector<double> angles;          ///< table: degrees; empty: none
    std::vector<double> rotation_axis;   ///< 3D: direction; empty: y
    std::vector<double> rotation_about;  ///< point at t = 0, m; in 2D x, z; empty: the centroid
    std::optional<double> density;       ///< free: kg/m3
    std::optional<double> mass;          ///< free: kg; in 2D kg/m
    std::vector<double> centre_of_mass;  ///< free: at t = 0, m; in 2D x, z; empty: the centroid
    std::vector<double> inertia;         ///< free: about x, y, z, kg m2; in 2D one, kg m; empty: of the shape
    bool moves_x = true;                 ///< free: which of its degrees of freedom it has
    bool moves_y = true;
    bool moves_z = true;
    bool turns_x = true;
    bool turns_y = true;
    bool turns_z = true;
    double spring_x = 0.0;  ///< free: stiffness of a spring to its place at t = 0, N/m; in 2D per width
    double spring_y = 0.0;
    double spring_z = 0.0;
    double restitution = 0.5;  ///< free: of contact
    double friction = 0.3;     ///< free: of contact

    /// Whether it stands still all the time.
    [[nodiscard]] bool rests() const { return motion == SolidMotion::fixed; }
    /// Whether the water moves it, and no law that is known before.
    [[nodiscard]] bool is_free() const { return motion == SolidMotion::free; }

    bool operator==(const Solid&) const = default;
};

/// The value at which a way of finding the surface sees it, unless the case says otherwise: half of what the
/// volume fraction (1) and the divergence of the position (the number of dimensions) are in the water, and a
/// density ratio of 0.9. Of the depth sum, which has none, 0.
[[nodiscard]] double usual_surface_threshold(SurfaceDetection detection, int dimensions);

/// First letters of the names of the instruments that record without asking; no other may begin so.
inline constexpr const char* standard_probe_prefix = "standard_";

/// A case: everything that defines a run. The only source of a run's parameters.
struct Case {
    std::string title;
    std::string description;
    Channel channel;
    Inflow inflow;
    Outflow outflow;
    Bed bed;
    SideWalls side_walls;
    Turbulence turbulence;
    Fluid fluid;
    Numerics numerics;
    Start start;
    Stirring stirring;
    Run run;
    Output output;
    Measured measured;
    std::vector<Probe> probes;
    std::vector<Solid> solids;
    std::vector<BedPatch> bed_patches;
    std::vector<SurfacePatch> surface_patches;
    std::vector<Vegetation> vegetation;
    std::vector<Porous> porous;

    /// File it was read from; empty for a text without a file. Relative file names in a case are relative to
    /// the folder of its file, and are made absolute when it is read.
    std::filesystem::path path;
    /// How messages speak of it: its file, or "the case".
    [[nodiscard]] std::string name() const { return path.empty() ? "the case" : path.string(); }
    std::string text;  ///< complete TOML text of the case, overrides applied: reading it gives this case

    /// The surfaces of the solids in three dimensions, where they were read with the case; see meshes_of().
    std::shared_ptr<const std::vector<SolidMesh>> meshes;

    /// What was made of the data of solids, for people: resampled, filled, blended. Empty where nothing was.
    std::vector<std::string> solid_notes;

    std::vector<std::string> probe_places;  ///< where each probe stands, for messages: "case.toml:12:1"

    /// Whether both cases define the same run: all parameters, but not where they were read from.
    [[nodiscard]] bool same_parameters(const Case& other) const;

    /// Total depth H = h_w + d_h - datum_below_crest over the bed level, m.
    [[nodiscard]] double total_depth() const {
        return channel.depth + bed.roughness_height - bed.datum_below_crest;
    }
    /// Height of the zero datum above the bed level, m.
    [[nodiscard]] double datum() const { return bed.roughness_height - bed.datum_below_crest; }
    /// Height of the roughness crest above the bed level, m.
    [[nodiscard]] double crest() const { return bed.roughness_height; }
    /// Length over which the drag of a sphere sets in, m: a tenth of the diameter; the spacing in the form of
    /// the thesis.
    [[nodiscard]] double sphere_ramp() const {
        return bed.sphere_ramp.value_or(bed.drag_form == DragForm::thesis ? numerics.spacing
                                                                          : 0.1 * bed.sphere_diameter);
    }
    /// Thickness of the layer in which the side walls' drag acts, m.
    [[nodiscard]] double side_layer() const {
        constexpr double rows = 3.0;
        return side_walls.layer.value_or(bed.roughness_height > 0.0 ? bed.roughness_height
                                                                    : rows * numerics.spacing);
    }
    /// Whether the case has side walls.
    [[nodiscard]] bool has_side_walls() const {
        return channel.dimensions == 3 && channel.sides != Sides::periodic;
    }
    /// Whether the case has side walls with drag, which carry a part of the water's weight.
    [[nodiscard]] bool has_side_wall_drag() const {
        return has_side_walls() && side_walls.drag_form != SideDragForm::none;
    }
    /// Discharge of a unit of the width that the case gives at the inflow, m2/s; none where a file does, or
    /// the depth.
    [[nodiscard]] std::optional<double> inflow_unit_discharge() const;
    /// Component of gravity down the bed, g sin(theta), m/s2.
    [[nodiscard]] double streamwise_gravity() const;
    /// Component of gravity normal to the bed, g cos(theta), m/s2.
    [[nodiscard]] double normal_gravity() const;
};

/// One `--set section.key=value` of the command line; value in TOML syntax, bare words taken as strings.
struct Override {
    std::string key;
    std::string value;
};

/// Read and validate a case file, apply the overrides. Throws InputError naming file, line, key, what was
/// expected and what to do (nearest known name for an unknown one); FileError if it cannot be read.
[[nodiscard]] Case read_case(const std::filesystem::path& path, const std::vector<Override>& overrides = {});

/// The same from text; `name` stands for the file in messages. `path` is the file the text belongs to: files
/// named in the case must then exist. Without it (the text of a results file, say) they need not, so that a
/// results file can be analysed where the files it was made from are gone.
[[nodiscard]] Case parse_case(const std::string& text, const std::string& name,
                              const std::filesystem::path& path = {},
                              const std::vector<Override>& overrides = {});

/// Warnings for a valid case that leaves the envelope in which the scheme was verified (docs/theory.md).
[[nodiscard]] std::vector<std::string> case_warnings(const Case& c);

}  // namespace riffle::inline case_file
