#pragma once

#include <span>
#include <string>
#include <vector>

#include "boundary/boundary_planes.hpp"
#include "boundary/free_body.hpp"
#include "boundary/wall_motion.hpp"
#include "case/case.hpp"

namespace riffle::inline boundary {

/// Where free bodies are held back before open ends, as by racks that the water passes: the sections at the
/// ends know of water alone. Two planes across the channel, none without open ends or without free bodies.
[[nodiscard]] std::vector<BoundaryPlane> body_racks(const Case& c);

/// Tells when free bodies come to the racks.
class RackWatch {
  public:
    explicit RackWatch(const Case& c);

    /// Sentences about the bodies that have come to a rack since the last call; each body is told once of
    /// each. `free`: the states of the free bodies, in the order of the case; `time` in s.
    [[nodiscard]] std::vector<std::string> news(double time, std::span<const FreeBodyState> free);

  private:
    struct Body {
        std::string name;
        std::size_t solid = 0;
        std::vector<Point3> corners;  ///< at t = 0
        std::vector<bool> told;       ///< by rack
    };

    std::vector<BoundaryPlane> racks_;
    std::vector<Body> bodies_;
    WallMotion motion_;
};

}  // namespace riffle::inline boundary
