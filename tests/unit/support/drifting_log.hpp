#pragma once

#include <fmt/format.h>

#include <string>

namespace riffle::test {

/// A log of half the density of water, 40 by 20 mm, that drifts with a uniform stream (m/s) 60 mm deep
/// between open ends.
inline std::string drifting_log(double velocity) {
    return fmt::format(
        "[channel]\nslope = 0\ndepth = 0.06\nlength = 0.4\nends = \"open\"\n[inflow]\nunit_discharge = {0}\n"
        "profile = \"uniform\"\n[outflow]\nkind = \"depth\"\ndepth = 0.06\n[bed]\nkind = \"slip\"\n[turbulence]\n"
        "closure = \"none\"\n[numerics]\nspacing = 0.004\n[start]\nkind = \"uniform\"\n[run]\nuntil = \"2 s\"\n"
        "[[solid]]\nname = \"log\"\nshape = \"rectangle\"\ncentre = [0.1, 0.06]\nsize = [0.04, 0.02]\n"
        "motion = \"free\"\ndensity = 500\nvelocity_x = {1}\nsurface = \"slip\"\n",
        0.06 * velocity, velocity);
}

}  // namespace riffle::test
