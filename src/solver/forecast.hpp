#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "case/case.hpp"
#include "column/canal_flow.hpp"
#include "ends/flow_at_ends.hpp"

namespace riffle::inline solver {

/// What an instrument of a run will cost.
struct ProbeForecast {
    std::string name;
    std::string kind;
    bool standard = false;            ///< records without being asked for
    double sampling_frequency = 0.0;  ///< Hz
    std::size_t points = 0;           ///< of each sample
    double samples = 0.0;             ///< to end_time
    double bytes = 0.0;               ///< of its records, before compression
    double time_share = 0.0;          ///< of the time of the steps, measured with samples of the case itself
};

/// What follows from the keys of a patch of the bed.
struct BedPatchForecast {
    std::string name;
    std::string kind;
    double equivalent_roughness = 0.0;  ///< k_s, m; 0 without
    double velocity = 0.0;  ///< depth mean of the uniform flow over such a bed, m/s; 0 without one
};

/// What follows from the keys of a patch of the surface of a solid.
struct SurfacePatchForecast {
    std::string name;
    std::string solid;
    double equivalent_roughness = 0.0;  ///< k_s, m
};

/// What follows from the keys of a patch of vegetation.
struct VegetationForecast {
    std::string name;
    double frontal_area = 0.0;      ///< a, 1/m
    double solid_fraction = 0.0;    ///< phi
    double speed = 0.0;             ///< of the water between the stems, a likely one, m/s
    double drag_coefficient = 0.0;  ///< C_D at it
    double displacement = 0.0;      ///< where the mixing length above the stems begins, m; 0 of emergent ones
};

/// What follows from the keys of a porous zone.
struct PorousForecast {
    std::string name;
    double porosity = 0.0;
    double permeability = 0.0;     ///< K, m2; infinite where nothing resists
    double quadratic = 0.0;        ///< what multiplies |q| q in the resistance, 1/m
    double speed = 0.0;            ///< discharge of an area q, a likely one, m/s
    double reynolds = 0.0;         ///< of the grains, q d/nu, at it
    double quadratic_share = 0.0;  ///< of the resistance at it
};

/// What a part of the records of a run takes.
struct RecordForecast {
    std::string name;
    double bytes = 0.0;  ///< to end_time, before compression
};

/// What a run will need, for `riffle check`. The speed is measured by a few steps of the case itself.
struct Forecast {
    std::size_t particles = 0;
    std::size_t wall_particles = 0;
    std::vector<double> racks;      ///< where free bodies are held back before open ends, m
    double smoothing_length = 0.0;  ///< m
    double sound_speed = 0.0;       ///< m/s
    double maximum_velocity = 0.0;  ///< m/s
    double time_step = 0.0;         ///< s
    double end_time = 0.0;          ///< simulated: the given time, or the earliest end of a converged run, s
    double latest_end = 0.0;        ///< s
    double steps = 0.0;             ///< to end_time
    double updates_per_second = 0.0;  ///< measured, all threads
    double wall_seconds = 0.0;        ///< to end_time
    /// Largest resident memory of the whole run (VmHWM), to end_time; found by a rehearsal of what a run does
    /// at its samples.
    double memory_bytes = 0.0;
    double disk_bytes = 0.0;            ///< results and two checkpoints, before compression
    double replacing_bytes = 0.0;       ///< on top of it, while a file is written anew beside the old one
    std::vector<RecordForecast> parts;  ///< of disk_bytes
    std::optional<double> relaxation_time;
    std::vector<BedPatchForecast> bed_patches;
    std::vector<SurfacePatchForecast> surface_patches;
    std::vector<VegetationForecast> vegetation;
    std::vector<PorousForecast> porous;
    std::optional<CanalFlow> canal;  ///< of a canal of one cross-section
    std::optional<FlowAtEnds> ends;  ///< of open ends
    std::vector<EndFact> end_facts;  ///< of open ends, in words
    std::vector<ProbeForecast> probes;
    std::vector<std::string> probe_notes;  ///< what the standard instruments leave out, and why
};

/// Forecast a run on this machine (takes a fraction of a second for small cases).
[[nodiscard]] Forecast forecast_run(const Case& c, int threads);

}  // namespace riffle::inline solver
