#pragma once

#include <optional>
#include <vector>

#include "boundary/push.hpp"
#include "boundary/wall_motion.hpp"
#include "case/case.hpp"
#include "case/outline.hpp"

namespace riffle::inline boundary {

/// Keeps water out of the solids of a case, in two dimensions. The pressure of a wall does so, but at a sharp
/// edge, and at the line where the surface meets a solid that moves (where there is no pressure), single
/// particles pass a face by a fraction of the spacing.
class SolidContact {
  public:
    SolidContact() = default;
    explicit SolidContact(const Case& c);

    [[nodiscard]] bool empty() const { return bodies_.empty(); }
    /// Put a particle that is up to a spacing deep in a solid back onto the nearest face that water touches,
    /// and take from its velocity what still leads into the solid. `now`: the bodies, WallMotion::at().
    /// Returns how deep it was, m; 0 outside; beyond a spacing it stays where it is.
    double resolve(const std::vector<BodyState>& now, Vec<2>& position, Vec<2>& velocity,
                   const Push& push = {}) const;

    /// How deep a place is behind the outline of a solid, m; 0 outside.
    [[nodiscard]] double depth(std::size_t solid, const std::vector<BodyState>& now,
                               const Vec<2>& position) const;

  private:
    struct Body {
        Outline outline;
        std::vector<bool> wetted;  ///< by edge
        bool stands_on_bed = false;
        double left = 0.0;
        double right = 0.0;
    };
    /// The place of water in a body, where its outline stood at t = 0, beside it where the ends are periodic;
    /// unset outside.
    [[nodiscard]] std::optional<Vec<2>> inside(const Body& body, const BodyState& state,
                                               const Vec<2>& position) const;

    std::vector<Body> bodies_;
    double spacing_ = 0.0;
    double period_ = 0.0;  ///< 0: closed ends
};

}  // namespace riffle::inline boundary
