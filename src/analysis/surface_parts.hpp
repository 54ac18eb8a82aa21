#pragma once

#include <optional>
#include <string>
#include <vector>

#include "analysis/celerity_correlation.hpp"
#include "analysis/figure.hpp"
#include "analysis/flow_record.hpp"
#include "analysis/gravity_capillary_waves.hpp"
#include "analysis/space_time.hpp"
#include "base/error.hpp"

namespace riffle::inline analysis {

// The parts of the chapter on the surface: from a record along a line, and from records at single places.

/// eta'(x, t) of a surface record at even times, the mean and the linear trend of each place taken away.
/// Along a periodic line the mean of each instant, too: there the water cannot lift the whole line, only its
/// slight compression does, as a slow and even breathing that would hide the waves.
struct SurfaceFluctuation {
    SpaceTime line;
    double interval = 0;         ///< s
    double level_deviation = 0;  ///< standard deviation of the mean along the line, m
};

/// Throws InputError for a record with gaps in time.
[[nodiscard]] SurfaceFluctuation surface_fluctuation(const SpaceTime& surface);

/// Whether a simulated surface is flat to a thousandth of the particle spacing, so that patterns of it are
/// those of the rows of particles and of rounding.
[[nodiscard]] bool is_flat(const FlowRecord& record, const SpaceTime& fluctuation);
[[nodiscard]] bool is_flat(const FlowRecord& record, double standard_deviation);

/// What the thesis' simulation of a flow condition, in as many dimensions, found of its surface.
struct ThesisSurface {
    double deviation = 0;  ///< standard deviation, m
    /// Of the celerity of the patterns from U, relative to it; in three dimensions it only says within 16 %.
    std::optional<double> celerity_difference;
};
/// Of the condition that a case is; nothing where it is none of 1, 2, 5 and 8.
[[nodiscard]] std::optional<ThesisSurface> thesis_surface(const Case& c);

/// "+0.3 % of the surface velocity 0.452 m/s".
[[nodiscard]] std::string beside_surface_velocity(double celerity, double surface_velocity);

/// Elevation at one place at even times, about its mean.
struct SurfaceStation {
    std::string name;
    double x = 0;
    double start = 0;     ///< time of the first sample, s
    double interval = 0;  ///< s
    std::vector<double> elevation;
};

/// The wave probes of a record from upstream down, whatever their order in it; those whose place is not known
/// stand last. Probes with gaps, with fewer than 16 samples or at the place of another one are left out,
/// which `warnings` then says.
[[nodiscard]] std::vector<SurfaceStation> stations_of_probes(const FlowRecord& record,
                                                             std::vector<std::string>& warnings);

/// Places on a line as if wave probes stood there: at the places of the probes of the record, or of fewer
/// than two of them at the line's first point, an eighth, a quarter and a half of its length.
[[nodiscard]] std::vector<SurfaceStation> stations_of_line(const SpaceTime& fluctuation,
                                                           const std::vector<ElevationProbe>& probes);

/// The waves that can travel on the flow of a record, on a current of the surface's velocity (the depth mean
/// where that is not known).
[[nodiscard]] GravityCapillaryWaves waves_on(const FlowRecord& record);

/// The maps of the surface, their points one after the other as if along a line that closes on itself: the
/// mean of each instant over the plan is taken away as that of a periodic line is.
[[nodiscard]] SpaceTime plan_record(const SurfaceMaps& maps);

/// Variance of the surface in plan by the way its components move: locked to the bed, carried along, waves.
void add_surface_families(const FlowRecord& record, Analysis& analysis);

/// Spectra in wavenumber and in wavenumber and frequency, with the dispersion relation of waves on the
/// current and the advection line.
void add_surface_spectra(const FlowRecord& record, const SurfaceFluctuation& surface, Analysis& analysis);

/// What the patterns of the surface are and how fast they travel: spatial correlation with Horoshenkov's
/// function (2.32), celerities by three methods.
void add_surface_patterns(const FlowRecord& record, const SurfaceFluctuation& surface, Analysis& analysis);

/// Correlation of the surface in space and time along a line, with the lines of advection.
void add_surface_space_time(const FlowRecord& record, const SpaceTime& line, Analysis& analysis);

/// What is left of the correlation from place to place where the patterns arrive.
void add_surface_extremes(const FlowRecord& record, const StationCelerity& found, Analysis& analysis);

/// The same from a few places at uneven distances, such as wave probes: spatial correlation and celerity.
void add_place_patterns(const FlowRecord& record, const std::vector<SurfaceStation>& stations,
                        Analysis& analysis);

/// Spectra in frequency at single places.
void add_station_spectra(const FlowRecord& record, const std::vector<SurfaceStation>& stations,
                         Analysis& analysis);

/// Temporal cross-correlations (4.7) between places, with their extremes and the celerity from them.
void add_station_correlations(const FlowRecord& record, const std::vector<SurfaceStation>& stations,
                              Analysis& analysis);

}  // namespace riffle::inline analysis
