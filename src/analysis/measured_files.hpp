#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "analysis/flow_record.hpp"
#include "laboratory/profile_record.hpp"
#include "laboratory/section_record.hpp"
#include "laboratory/velocity_field.hpp"

namespace riffle::inline analysis {

/// What a laboratory's file holds.
enum class LaboratoryKind {
    profile,   ///< over the height: a column z
    section,   ///< points across the channel: a column y
    field,     ///< of image velocimetry: columns x, z, u, w; or a folder of frames
    velocity,  ///< at a point over time: a column u
    waves,     ///< wave probes
};

/// By the names of its columns; a folder holds frames. Throws FileError where it cannot be read.
[[nodiscard]] LaboratoryKind laboratory_kind(const std::filesystem::path& path);

/// A profile as that of a run, with heights above the bed level; points without u are left out. `datum`: its
/// height above the bed level, m.
[[nodiscard]] Profiles profiles_of(const ProfileRecord& record, double datum, double density);

/// Means, variances and covariance in time of a field; of a single frame its values alone.
[[nodiscard]] VelocityGrid grid_of(const VelocityField& field, double datum);

/// The frames as velocities in time; without times an empty one.
[[nodiscard]] VelocityPlane plane_of(const VelocityField& field, double datum);

/// Means along the channel of a grid: u and w, their rms in time and the Reynolds stress (Pa), with the
/// half-width of u where its points have uncertainties.
[[nodiscard]] Profiles profiles_of(const VelocityGrid& grid, double density);

/// Read what a run is to be compared with into `measured`; what it had of the same kind is replaced. Throws
/// FileError, also for kinds that are no means: velocities at a point, wave probes.
void add_measured_file(const std::filesystem::path& path, const Case& c, FlowRecord::Measured& measured,
                       std::vector<std::string>& warnings);

}  // namespace riffle::inline analysis
