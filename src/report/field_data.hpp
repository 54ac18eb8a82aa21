#pragma once

#include <array>
#include <optional>
#include <string>
#include <vector>

#include "case/case.hpp"
#include "case/outline.hpp"
#include "record/run_results.hpp"

namespace riffle::inline report {

/// The particles of one snapshot, in three dimensions of a slice along the channel, with the surface and the
/// bodies at its time.
struct FieldFrame {
    double time = 0;
    std::vector<double> x, z, velocity, vertical_velocity, pressure, eddy_viscosity;
    std::vector<double> surface_x, surface_z;  ///< free surface at the nearest recorded time; may be empty
    std::vector<Outline> bodies;  ///< closed outlines; in three dimensions their cuts by the slice
};

/// A circle in the x-z plane, m.
struct Circle {
    double x = 0, z = 0, radius = 0;
};

/// A part of the water or of the bed with a resistance of its own.
struct FieldZone {
    std::string kind;  ///< "vegetation", "porous" or "bed"
    std::string name;
    Outline outline;  ///< of a plane bed a line along it
};

/// The picture of the flow field: a few snapshots from the start to the last one.
struct FieldPicture {
    std::vector<FieldFrame> frames;
    std::vector<Circle> spheres;   ///< of the bed, cut by the slice; three dimensions
    std::vector<FieldZone> zones;  ///< that the slice cuts
    double x_end = 0;              ///< particles with x below this are included, m
    bool left_out = false;         ///< whether that leaves some out
    double top = 0;                ///< height that holds all water and bodies, m
    std::optional<double> y;       ///< three dimensions: place across the channel of the slice, m
};

/// The vegetation, the porous zones and the patches of the bed of a case, in three dimensions those that the
/// plane at y (m) cuts, up to a height (m).
[[nodiscard]] std::vector<FieldZone> field_zones(const Case& c, double y, double top);

/// Height below the edge of a bed that ends over which the water is followed, m: two supports of the kernel;
/// 0 where the bed does not end.
[[nodiscard]] double falling_height(const Case& c);

/// Which snapshots a picture has.
enum class FieldFrames { none, last, all };

/// The picture from the snapshots of a results file; nothing where it has none.
[[nodiscard]] std::optional<FieldPicture> read_field(const RunResults& results, const Case& c,
                                                     FieldFrames frames);

}  // namespace riffle::inline report
