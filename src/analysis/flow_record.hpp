#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "analysis/eddies_and_noise.hpp"
#include "analysis/figure.hpp"
#include "analysis/mean_flow.hpp"
#include "analysis/space_time.hpp"
#include "case/case.hpp"
#include "column/column.hpp"
#include "column/section_measurements.hpp"
#include "column/velocity_measurements.hpp"
#include "laboratory/profile_record.hpp"
#include "record/numbers.hpp"
#include "record/profiles.hpp"
#include "record/series_table.hpp"

namespace riffle::inline analysis {

/// Stretch of a record that averages are taken over, s.
struct TimeWindow {
    double from = 0;
    double to = 0;

    [[nodiscard]] bool holds(double time) const { return time >= from - 1e-9 && time <= to + 1e-9; }
    [[nodiscard]] double length() const { return to - from; }
};

/// Surface elevation against time at one place, m. The level it is counted from does not matter.
struct ElevationProbe {
    std::string name;
    double x = 0;
    std::vector<double> time, elevation;
    std::optional<double> y = std::nullopt;  ///< across the channel, where the record says
};

/// Velocities against time at points (x[i], z[i]): u[row * z.size() + i] at time[row], m/s. Heights above the
/// bed level. Not-a-number where the point lay outside of the water or the sample was lost. `v` and `w` may
/// be empty.
struct VelocityProbe {
    std::string name;
    std::vector<double> x, z, time, u, w;
    std::vector<double> y = {};  ///< across the channel; empty where the record does not say
    std::vector<double> v = {};  ///< across the channel, m/s; empty where it was not recorded

    /// The record of one point of `u` or `w`.
    [[nodiscard]] std::vector<double> point(const std::vector<double>& values, std::size_t i) const;
};

/// Time means and second moments on a grid of the x-z plane over the window: value[j * x.size() + i] at
/// (x[i], z[j]), m/s, m2/s2 and Pa. Not-a-number outside of the water.
struct VelocityGrid {
    std::string name;
    std::vector<double> x, z, u, w, uu, ww, uw;  ///< the last three: variances and covariance in time
    std::vector<double> pressure = {};           ///< Pa; empty where the record has none
    std::vector<double> shear_stress = {};       ///< tau_xz of viscosity and closure, Pa; so
    std::vector<double> uncertainty = {};        ///< standard uncertainty of u, m/s; so
    std::optional<double> y = std::nullopt;      ///< of the plane across the channel, where the record says
};

/// Velocities on a grid of the x-z plane against time: u[(row * z.size() + j) * x.size() + i] at (x[i], z[j])
/// and time[row], m/s. Not-a-number outside of the water, or where a vector was lost.
struct VelocityPlane {
    std::string name;
    std::vector<double> x, z, time;
    std::vector<double> u, w;
    std::optional<double> period = std::nullopt;  ///< after which the columns repeat along the channel, m

    /// w or u along the line at the height z[j].
    [[nodiscard]] SpaceTime line(const std::vector<double>& values, std::size_t j) const;
};

/// A quantity against time, such as the flow rate through a section, a force per unit width or the pressure
/// of a gauge.
struct ScalarProbe {
    std::string name;      ///< of the instrument
    std::string kind;      ///< "flow_rate", "force", "pressure"
    std::string quantity;  ///< name of the dataset, with the place where there are several
    std::string label;
    std::string unit;
    std::vector<double> time, value;
    std::optional<double> x = std::nullopt;  ///< place of the section along the channel, m; of others none
};

/// Plan maps of the surface of a three-dimensional run: elevation[(row * y.size() + iy) * x.size() + ix] at
/// time[row], m above the bed level.
struct SurfaceMaps {
    std::vector<double> x, y, time, elevation;
};

/// The section twin of a three-dimensional run between side walls: values[iz * y.size() + iy] over the
/// simulated width, and its numbers.
struct SectionTwin {
    std::vector<double> y, z, velocity, shear_stress;
    Numbers numbers;

    [[nodiscard]] bool empty() const { return velocity.empty(); }
    /// A number of `fields::section_numbers`.
    [[nodiscard]] std::optional<double> value(const Field& field) const { return numbers.find(field); }
};

/// What the chapters of an analysis are made from: a run's results file or records of a laboratory. Each part
/// is read when it is first asked for; a part that the record lacks is empty. Functions that read may throw
/// FileError.
class FlowRecord {
  public:
    FlowRecord() = default;
    virtual ~FlowRecord() = default;
    FlowRecord(const FlowRecord&) = delete;
    FlowRecord& operator=(const FlowRecord&) = delete;
    FlowRecord(FlowRecord&&) = delete;
    FlowRecord& operator=(FlowRecord&&) = delete;

    [[nodiscard]] virtual std::string name() const = 0;
    [[nodiscard]] virtual std::string source() const = 0;
    [[nodiscard]] virtual Origin origin() const = 0;  ///< simulated or measured

    /// The case that the flow belongs to; null where none is known.
    [[nodiscard]] virtual const Case* flow() const = 0;
    /// Its column twin; null where it has none.
    [[nodiscard]] virtual const ColumnResult* column() const { return nullptr; }
    /// Speed of sound of simulated water, m/s; none of measured one.
    [[nodiscard]] virtual std::optional<double> sound_speed() const { return std::nullopt; }
    /// The window of the averages.
    [[nodiscard]] virtual TimeWindow window() const = 0;

    /// Whole-flow quantities against time over the whole record, as in `/time_series`.
    [[nodiscard]] virtual const SeriesTable& series() const;
    /// Time averages over the window.
    [[nodiscard]] virtual const Profiles& profiles() const;
    /// Surface elevation above the bed level along a line within the window; without rows where there is
    /// none.
    [[nodiscard]] virtual const SpaceTime& surface() const;
    [[nodiscard]] virtual const std::vector<ElevationProbe>& elevation_probes() const;
    [[nodiscard]] virtual const std::vector<VelocityProbe>& velocity_probes() const;
    [[nodiscard]] virtual const std::vector<VelocityGrid>& velocity_grids() const;
    [[nodiscard]] virtual const std::vector<VelocityPlane>& velocity_planes() const;
    [[nodiscard]] virtual const std::vector<ScalarProbe>& scalar_probes() const;
    // Of runs in three dimensions.
    [[nodiscard]] virtual const MeanFlow& mean_field() const;
    [[nodiscard]] virtual const EddiesAndNoise& eddies_and_noise() const;
    [[nodiscard]] virtual const SurfaceMaps& surface_maps() const;
    [[nodiscard]] virtual const SectionTwin& section_twin() const;

    /// The points of a cross-section that a laboratory record holds.
    [[nodiscard]] virtual const SectionPoints& section_points() const;

    /// What was measured and is compared with: the velocity profile from points of a file, or the rough log
    /// law (2.3) of the measured u_* and k_s; beside it what other files hold. Heights above the bed level.
    struct Measured {
        VelocityMeasurements profile;
        bool from_law = false;
        /// The whole file of the profile, with what else it holds; z above the datum.
        std::optional<ProfileRecord> file = std::nullopt;
        std::string note;  ///< why there is none, where one was named
        Profiles
            turbulence;  ///< rms of the fluctuations and Reynolds stress of the same file, if it has them
        SectionPoints section;  ///< of a cross-section
        VelocityGrid field;     ///< means of image velocimetry
    };
    [[nodiscard]] virtual const Measured& measured() const;

    /// What the reader must know of the record: a window shorter than asked for, parts left out.
    [[nodiscard]] virtual std::vector<std::string> warnings() const { return {}; }
};

/// The part of a series within the window; empty if there is no such series.
[[nodiscard]] std::vector<double> within_window(const FlowRecord& record, const Field& field);

/// The record with the most samples, the first of them, of a scalar instrument of that quantity, and of that
/// instrument where it is named; null where none has two samples.
[[nodiscard]] const ScalarProbe* find_scalar(const FlowRecord& record, const std::string& quantity,
                                             const std::string& instrument = "");

/// The record of a quantity at the section at an open end, 1: the inflow, 2: the outflow; null where there is
/// none.
[[nodiscard]] const ScalarProbe* find_at_end(const FlowRecord& record, const Field& quantity, int end);

/// Depth of the water above the datum that lengths are scaled with, m: that of the case, and between open
/// ends, where that is of the start alone, the mean of the recorded surface.
[[nodiscard]] double water_depth(const FlowRecord& record);

/// Velocity that the flow is scaled with, m/s: the simulated depth-mean velocity over the window; of a
/// laboratory profile its own depth mean above the datum (profile_depth_mean), of other laboratory records
/// the measured one of their case. 0 where none is known.
[[nodiscard]] double bulk_velocity(const FlowRecord& record);

/// Velocity of the water at the surface, m/s: that of the topmost point of the mean profile in the upper
/// fifth of the depth. Patterns travel with it. 0 where none is known, and where the level varies along the
/// channel.
[[nodiscard]] double surface_velocity(const FlowRecord& record);

/// Friction velocity that the flow is scaled with, m/s: from the stress at the crests of the run
/// (thesis 4.6), else the measured one, else sqrt(g h S0). 0 where none is known.
[[nodiscard]] double friction_velocity_of(const FlowRecord& record);

}  // namespace riffle::inline analysis
