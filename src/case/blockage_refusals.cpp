#include "case/blockage.hpp"
#include "case/outline_check.hpp"
#include "case/refusals.hpp"
#include "case/units.hpp"

namespace riffle::inline case_file {

namespace {

Findings blocked(const Case& c) {
    const auto found = blockage(c);
    if (!found) {
        return {};
    }
    return {
        {.detail =
             fmt::format("{}: closes the channel: up to a level of {}, from x = 0 the water comes "
                         "no further than x = {}",
                         c.solids[found->solid].name, shown_length(found->level), shown_length(found->x)),
         .cure =
             c.channel.ends == Ends::open
                 ? "leave a way wider than the spacing, let a gate move away (motion), or, where the water "
                   "shall rise over it, give a [channel] depth nearer to its top, with the "
                   "lower water of the start by start.water_x and start.water_z"
                 : "",
         .item = found->solid}};
}

}  // namespace

CheckList blockage_refusals() {
    return {
        {
            {{"solid.z", "solid.size", "solid.diameter", "solid.file", "solid.name", "channel.ends",
              "channel.slope"},
             "solids at rest that leave no way along a channel with a slope or open ends, beside them, below them or over their tops",
             "what enters, or what the slope drives, has nowhere to go",
             R"(leave a way wider than the spacing, make it a weir, let a gate move away (motion), or divide a tank: [channel] ends = "walls")",
             blocked},
        },
        have_shapes};
}

}  // namespace riffle::inline case_file
