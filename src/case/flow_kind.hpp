#pragma once

#include <optional>
#include <string>

#include "case/bed_traits.hpp"
#include "case/case.hpp"
#include "case/patch_range.hpp"

namespace riffle::inline case_file {

/// The kinds of flow that a case can describe. What a run is judged by, which chapters its analysis has and
/// what its report shows follow from the kind.
enum class FlowKind {
    uniform_channel,  ///< driven along a channel, the same everywhere along it
    /// driven along a channel and around bodies, over reaches of several roughnesses, or through patches of
    /// vegetation or porous zones
    channel_with_bodies,
    open_channel,   ///< water enters at one end and leaves at the other, around bodies or not
    tank,           ///< nothing drives a steady flow along it: dam breaks, gates, sloshing, paddles, cavities
    standing_wave,  ///< a wave that stands over a periodic reach
    periodic_box    ///< periodic in all directions, without bed and surface
};

[[nodiscard]] FlowKind flow_kind(const Case& c);

/// The word for machines, e.g. "channel-with-bodies".
[[nodiscard]] const char* flow_kind_word(FlowKind kind);

/// The name for readers, e.g. "channel with bodies".
[[nodiscard]] const char* flow_kind_name(FlowKind kind);

/// Whether the flow is driven along a channel and changes along it.
[[nodiscard]] inline bool varies_along(FlowKind kind) {
    return kind == FlowKind::channel_with_bodies || kind == FlowKind::open_channel;
}

/// Whether the flow is driven along a channel, so that it can come to a steady mean.
[[nodiscard]] inline bool is_channel(FlowKind kind) {
    return kind == FlowKind::uniform_channel || varies_along(kind);
}

/// Whether the water keeps within closed ends or repeats itself, and nothing drives it steadily.
[[nodiscard]] inline bool is_undriven(FlowKind kind) { return !is_channel(kind); }

/// Whether the bed ends at x = L, and the water falls over its edge.
[[nodiscard]] inline bool bed_ends(const Case& c) {
    return c.channel.ends == Ends::open && c.outflow.kind == OutflowKind::free_fall;
}

/// Whether water goes through a duct from end to end, between the bed and a wall at the top.
[[nodiscard]] inline bool is_duct(const Case& c) {
    return c.channel.ends == Ends::open && c.channel.top == Top::wall;
}

/// Whether the water rests at the side walls, as at the bed.
[[nodiscard]] inline bool rests_at_sides(const Case& c) { return c.has_side_walls() && is_no_slip(c.bed); }

/// Whether the water loses momentum along the channel downward alone, but for forces on its volume: to no
/// wall at the top, no side walls at which it rests, and nothing at its ends.
[[nodiscard]] inline bool only_bed_holds(const Case& c) {
    return c.channel.ends == Ends::periodic && c.channel.top != Top::wall && !rests_at_sides(c);
}

/// The same but for a wall at the top: the shear stress is a straight line from it to the bed.
[[nodiscard]] inline bool has_periodic_lid(const Case& c) {
    return c.channel.ends == Ends::periodic && c.channel.top == Top::wall && !rests_at_sides(c);
}

/// Whether solids stand in the flow that are not part of its bed.
[[nodiscard]] bool has_bodies(const Case& c);

/// Whether the surface is as high along all of the channel, to a spacing, so that the topmost layer of the
/// water is the one at the surface everywhere. Where it falls or rises along the channel that layer is of the
/// deepest reach. \param inflow_depth, outflow_depth means at open ends, m
[[nodiscard]] bool has_level_surface(const Case& c, std::optional<double> inflow_depth,
                                     std::optional<double> outflow_depth);

/// Whether solids make the bed rough.
[[nodiscard]] bool has_solid_bed(const Case& c);

/// Whether the bed has elements with crests, and a datum among them: spheres by their drag, or solids.
[[nodiscard]] inline bool has_rough_bed(const Case& c) { return has_spheres(c.bed) || has_solid_bed(c); }

/// Whether a bed holds the water back.
[[nodiscard]] bool bed_resists(const Bed& bed);

/// The vegetation that stands everywhere in the channel; nullptr where none does. No two patches stand at one
/// place.
[[nodiscard]] const Vegetation* vegetation_everywhere(const Case& c);

/// Whether what holds the water back changes along the channel: patches of the bed or of vegetation, or
/// porous zones.
[[nodiscard]] bool resistance_varies_along(const Case& c);

/// Whether more than patches of the bed from side to side makes the flow change along the channel or across
/// it, which the steady varied flow of `riffle backwater` does not have.
[[nodiscard]] bool varies_beyond_beds(const Case& c);

/// Whether the bed, or vegetation or a porous layer all over it, holds the water back.
[[nodiscard]] bool channel_resists(const Case& c);
/// Whether that does, or side walls with friction do.
[[nodiscard]] bool channel_or_walls_resist(const Case& c);

/// Whether the closure of a case is a mixing length, which grows from the bed and follows the depth.
[[nodiscard]] bool has_mixing_length(const Case& c);

/// Whether the mixing lengths follow the depth of the water at each place: where the case asks for it, or
/// leaves it open (turbulence.depth = "auto") and the flow varies along the channel, with bodies in it or
/// ends that the water passes.
[[nodiscard]] bool uses_local_depth(const Case& c);

/// Whether a model stands for eddies that the particles do not carry.
[[nodiscard]] inline bool has_closure(const Case& c) { return c.turbulence.closure != ClosureKind::none; }

/// Whether the particles carry the eddies, and the closure only what is smaller: the mean flow is then a mean
/// over time and plan, and no model of the mean flow is its limit.
[[nodiscard]] bool resolves_eddies(const Case& c);

/// Why the case has no steady uniform flow, the one that the column twin solves: a sentence with what to
/// change. Nothing where it has one.
[[nodiscard]] std::optional<std::string> why_no_column(const Case& c);

}  // namespace riffle::inline case_file
