#pragma once

#include <array>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "case/case.hpp"

namespace riffle::inline particles {

/// The way on which a particle left the domain. Its number stands in results and checkpoints.
enum class Exit : std::int8_t {
    over_start,     ///< over the end wall at x = 0
    over_end,       ///< over the end wall at x = L
    over_side,      ///< over a side wall (three dimensions)
    above,          ///< through the top of the domain
    through_start,  ///< through the end wall at x = 0
    through_end,    ///< through the end wall at x = L
    through_side,   ///< through a side wall
    through_bed,    ///< below the bed
};

inline constexpr std::int64_t last_exit = static_cast<std::int64_t>(Exit::through_bed);

/// "over the end wall at x = 0", for messages.
[[nodiscard]] std::string_view exit_text(Exit exit);

/// A particle that has left the domain and is no longer simulated: an entry of the ledger. SI.
struct LostParticle {
    std::int32_t id = 0;
    double time = 0.0;
    double mass = 0.0;                 ///< in two dimensions per width, kg/m
    std::array<double, 3> position{};  ///< where it was taken out; y is 0 in two dimensions
    std::array<double, 3> velocity{};
    Exit exit = Exit::above;

    bool operator==(const LostParticle&) const = default;
};

/// The way out of a particle that stands beyond the walls, at (x, y, z) with its velocity. Beside the channel
/// it is traced back to the wall in free flight: higher than the wall there it flew over it.
[[nodiscard]] Exit exit_of(const Case& c, const std::array<double, 3>& position,
                           const std::array<double, 3>& velocity);

/// How much water has been lost.
struct LostWater {
    std::size_t particles = 0;
    double mass = 0.0;   ///< kg; in two dimensions per width, kg/m
    double share = 0.0;  ///< of all the water that there was
};
/// "3 particles (0.02 % of the water)".
[[nodiscard]] std::string lost_text(const LostWater& water);
/// Of a ledger; `remaining`: mass of the particles that are left.
[[nodiscard]] LostWater lost_water(const std::vector<LostParticle>& lost, double remaining);

/// "2 over the end wall at x = 1.61 m, 1 below the bed": how many left on which way.
[[nodiscard]] std::string exits_text(const std::vector<LostParticle>& lost);

}  // namespace riffle::inline particles
