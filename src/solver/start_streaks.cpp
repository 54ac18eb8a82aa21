#include "solver/start_streaks.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <numbers>
#include <random>

#include "base/unit_fraction.hpp"
#include "case/flow_kind.hpp"

namespace riffle::inline solver {

namespace {

/// Velocity along the flow over that of the rolls: so much of it the rolls have lifted in about h / u*.
constexpr double streak_over_roll = 2.0;

/// The wave number nearest to that of a length of which whole waves fit into an extent.
double whole_waves(double extent, double length) {
    return 2.0 * std::numbers::pi / extent * std::max(1.0, std::round(extent / length));
}

}  // namespace

bool starts_with_streaks(const Case& c) {
    if (c.channel.dimensions != 3 || !resolves_eddies(c)) return false;
    switch (c.start.kind) {
        case StartKind::uniform:
        case StartKind::column:
        case StartKind::section:
        case StartKind::power_law:
        case StartKind::backwater:
            return c.channel.ends == Ends::periodic || c.channel.ends == Ends::open;
        case StartKind::rest:
        case StartKind::results:
        case StartKind::standing_wave:
        case StartKind::taylor_green:
        case StartKind::isotropic:
            break;
    }
    return false;
}

StartStreaks::StartStreaks(const Case& c, double depth, double width)
    : across_(whole_waves(width, 2.0 * depth)), along_(whole_waves(c.channel.length, 3.0 * depth)) {
    meander_ = std::numbers::pi / (4.0 * across_);  // an eighth of a wave to either side
    // As the jitter's and the modes', but another sequence of numbers.
    std::mt19937_64 generator(static_cast<std::uint64_t>(c.start.seed) ^ 0xd1b54a32d192ed03ULL);
    const auto phase = [&] { return 2.0 * std::numbers::pi * unit_fraction(generator()); };
    phase_across_ = phase();
    phase_along_ = phase();
}

std::array<double, 3> StartStreaks::curl(const std::array<double, 3>& x, double envelope,
                                         const std::array<double, 3>& slope) const {
    // The potential is (P, 0, streak_over_roll P), P = envelope sin(across (y - shift(x))) / across.
    const double along = along_ * x[0] + phase_along_;
    const double shift = meander_ * std::sin(along);
    const double bend = meander_ * along_ * std::cos(along);
    const double angle = across_ * (x[1] - shift) + phase_across_;
    const double potential = std::sin(angle) / across_;
    const double rise = slope[1] * potential + envelope * std::cos(angle);
    const double change_along = slope[0] * potential - envelope * std::cos(angle) * bend;
    return {streak_over_roll * rise, slope[2] * potential - streak_over_roll * change_along, -rise};
}

}  // namespace riffle::inline solver
