#include "case/flow_kind.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "case/bed_traits.hpp"
#include "case/closure_traits.hpp"
#include "case/cross_section.hpp"
#include "case/porous_zone.hpp"

namespace riffle::inline case_file {

namespace {

/// Why patches of the bed leave no flow that is the same at all places of a height.
std::optional<std::string> patchy_bed(const Case& c) {
    if (c.bed_patches.empty()) return std::nullopt;
    const bool strips = std::all_of(c.bed_patches.begin(), c.bed_patches.end(),
                                    [&c](const BedPatch& patch) { return covers_length(c, patch); });
    return fmt::format(
        "the patch \"{}\" of the bed is not as rough as the rest of it, and a column has one bed{}: what to compare with "
        "far from its edges are the uniform flows of the cases with one bed each",
        c.bed_patches.front().name,
        strips ? " (that of `riffle section` has strips of plane beds, between side walls)" : "");
}

/// Why patches of vegetation leave no flow that is the same at all places of a height.
std::optional<std::string> patchy_vegetation(const Case& c) {
    for (const Vegetation& patch : c.vegetation) {
        if (!covers_length(c, patch)) {
            return fmt::format(
                "the vegetation \"{}\" stands in a part of the channel's length, so the water is held back and let "
                "go again along it: the uniform flow to compare with is that of the case without {}",
                patch.name, is_outlined(patch) ? "its outline" : "x_from and x_to");
        }
        if (!covers_width(c, patch)) {
            return fmt::format(
                "the vegetation \"{}\" stands in a part of the channel's width, so the flow differs across it, "
                "which the balance of a column does not have (that of `riffle section` does, between side walls)",
                patch.name);
        }
    }
    return std::nullopt;
}

/// Why porous zones leave none.
std::optional<std::string> patchy_porosity(const Case& c) {
    for (const Porous& zone : c.porous) {
        if (!covers_length(c, zone)) {
            return fmt::format(
                "the porous zone \"{}\" is not the same all along the channel: the uniform flow to compare with is "
                "that of a layer, without {} and with a level top",
                zone.name,
                is_outlined(zone) || is_seen_from_the_side(zone) ? "its outline" : "x_from and x_to");
        }
        if (!covers_width(c, zone)) {
            return fmt::format(
                "the porous zone \"{}\" stands in a part of the channel's width, so the flow differs across it, "
                "which the balance of a column does not have",
                zone.name);
        }
    }
    return std::nullopt;
}

/// Whether vegetation or porous zones stand in a part of the channel's length.
bool stands_in_part_of_length(const Case& c) {
    return porosity_varies_along(c) ||
           std::any_of(c.vegetation.begin(), c.vegetation.end(),
                       [&c](const Vegetation& patch) { return !covers_length(c, patch); });
}

/// Whether a porous layer all over the channel holds the water back.
bool layer_resists(const Case& c) {
    return std::any_of(c.porous.begin(), c.porous.end(), [&c](const Porous& zone) {
        const bool resists =
            zone.permeability || zone.laminar_coefficient > 0.0 || zone.inertial_coefficient > 0.0;
        return resists && zone.porosity < 1.0 && covers_length(c, zone) && covers_width(c, zone);
    });
}

/// Whether the flow goes around a solid and not over it as over a bed.
bool is_body(const Solid& solid) { return !solid.part_of_bed; }

bool is_driven(const Case& c) { return c.streamwise_gravity() > 0.0 || c.channel.lid_velocity != 0.0; }

}  // namespace

bool has_bodies(const Case& c) { return std::any_of(c.solids.begin(), c.solids.end(), is_body); }

bool has_solid_bed(const Case& c) { return !std::all_of(c.solids.begin(), c.solids.end(), is_body); }

bool bed_resists(const Bed& bed) {
    if (has_spheres(bed)) return bed.drag_coefficient > 0.0 && bed.roughness_height > 0.0;
    return is_no_slip(bed) || traits_of(bed.kind).wall_law;
}

const Vegetation* vegetation_everywhere(const Case& c) {
    const auto found = std::find_if(c.vegetation.begin(), c.vegetation.end(), [&c](const Vegetation& patch) {
        return covers_length(c, patch) && covers_width(c, patch) && patch.stands_on.empty();
    });
    return found != c.vegetation.end() ? &*found : nullptr;
}

bool resistance_varies_along(const Case& c) {
    return std::any_of(c.bed_patches.begin(), c.bed_patches.end(),
                       [&c](const BedPatch& patch) { return !covers_length(c, patch); }) ||
           stands_in_part_of_length(c);
}

bool varies_beyond_beds(const Case& c) {
    return std::any_of(c.bed_patches.begin(), c.bed_patches.end(),
                       [&c](const BedPatch& patch) { return !covers_width(c, patch); }) ||
           stands_in_part_of_length(c);
}

bool channel_resists(const Case& c) {
    return bed_resists(c.bed) || vegetation_everywhere(c) != nullptr || layer_resists(c);
}

bool channel_or_walls_resist(const Case& c) {
    // Of a canal with open ends the section holds the water back, as in its uniform flow.
    return channel_resists(c) || c.has_side_wall_drag() ||
           (c.channel.ends == Ends::open && canal_of(c) != nullptr);
}

FlowKind flow_kind(const Case& c) {
    if (c.channel.top == Top::periodic) return FlowKind::periodic_box;
    if (c.start.kind == StartKind::standing_wave) return FlowKind::standing_wave;
    if (c.channel.ends == Ends::open) return FlowKind::open_channel;
    if (c.channel.ends != Ends::periodic || !is_driven(c)) return FlowKind::tank;
    if (has_bodies(c) || resistance_varies_along(c)) return FlowKind::channel_with_bodies;
    return c.start.water_x.empty() ? FlowKind::uniform_channel : FlowKind::tank;
}

const char* flow_kind_word(FlowKind kind) {
    switch (kind) {
        case FlowKind::uniform_channel:
            return "uniform-channel";
        case FlowKind::channel_with_bodies:
            return "channel-with-bodies";
        case FlowKind::open_channel:
            return "open-channel";
        case FlowKind::tank:
            return "tank";
        case FlowKind::standing_wave:
            return "standing-wave";
        case FlowKind::periodic_box:
            break;
    }
    return "periodic-box";
}

const char* flow_kind_name(FlowKind kind) {
    switch (kind) {
        case FlowKind::uniform_channel:
            return "uniform channel";
        case FlowKind::channel_with_bodies:
            return "channel with bodies";
        case FlowKind::open_channel:
            return "channel with open ends";
        case FlowKind::tank:
            return "closed tank or transient flow";
        case FlowKind::standing_wave:
            return "standing wave";
        case FlowKind::periodic_box:
            break;
    }
    return "periodic box";
}

bool resolves_eddies(const Case& c) {
    return traits_of(c.turbulence.closure).family == ClosureFamily::resolved;
}

bool has_level_surface(const Case& c, std::optional<double> inflow_depth,
                       std::optional<double> outflow_depth) {
    if (has_bodies(c) || c.channel.ends == Ends::walls) return false;
    return c.channel.ends != Ends::open ||
           (inflow_depth && outflow_depth && std::abs(*inflow_depth - *outflow_depth) < c.numerics.spacing);
}

bool has_mixing_length(const Case& c) {
    return traits_of(c.turbulence.closure).family == ClosureFamily::mixing_length;
}

bool uses_local_depth(const Case& c) {
    if (!has_mixing_length(c) || c.channel.top != Top::free_surface ||
        c.turbulence.depth == ClosureDepth::initial) {
        return false;
    }
    const bool open = c.channel.ends != Ends::periodic && c.channel.ends != Ends::walls;
    return c.turbulence.depth == ClosureDepth::local || open || !c.solids.empty() ||
           resistance_varies_along(c);
}

std::optional<std::string> why_no_column(const Case& c) {
    if (c.channel.top == Top::periodic) {
        return "the box repeats itself over its height too (channel.top = \"periodic\"): it has neither a "
               "bed nor a surface between which a flow could be uniform";
    }
    if (is_duct(c)) {
        return "water enters and leaves at the ends of a duct (channel.ends = \"open\", channel.top = \"wall\"), so "
               "its velocity follows from [inflow] and not from a slope: the uniform flow between the walls is "
               "that of the case with channel.ends = \"periodic\" and channel.slope > 0";
    }
    if (c.channel.ends == Ends::open && c.solids.size() == 1 && canal_of(c) != nullptr) {
        return fmt::format(
            "water enters and leaves at its ends (channel.ends = \"open\") over the cross-section \"{}\", and the "
            "twins know none but the rectangle: `riffle backwater` gives the steady flow along it",
            c.solids.front().name);
    }
    if (c.channel.ends == Ends::open && has_bodies(c)) {
        return "water enters and leaves at its ends (channel.ends = \"open\") and passes solids: `riffle backwater` "
               "gives the steady flow along the bed without them";
    }
    if (c.channel.ends == Ends::open) {
        return "water enters and leaves at its ends (channel.ends = \"open\"), so depth and velocity follow from "
               "[inflow] and [outflow] and not from the slope alone: `riffle backwater` is what to compare with, "
               "and the uniform flow of the bed is that of the case with channel.ends = \"periodic\"";
    }
    if (c.channel.ends == Ends::walls) {
        return "walls close the channel at its ends (channel.ends = \"walls\"), so no steady flow runs "
               "along it: a uniform flow needs channel.ends = \"periodic\" and channel.slope > 0";
    }
    if (has_bodies(c) && std::all_of(c.solids.begin(), c.solids.end(),
                                     [](const Solid& solid) { return is_section(solid.shape); })) {
        return fmt::format(
            "the bed is the cross-section \"{}\", and the twins know none but the rectangle: what a "
            "canal by the log law is compared with are the velocity and the discharge of Colebrook "
            "and White, which `riffle check` prints",
            c.solids.front().name);
    }
    if (has_bodies(c)) {
        const auto bodies = std::count_if(c.solids.begin(), c.solids.end(), is_body);
        return fmt::format(
            "the flow meets the solid \"{}\"{}, around which it is not uniform: the balance of a column "
            "has no drag of bodies. Without the [[solid]] the case has a uniform flow to compare with",
            std::find_if(c.solids.begin(), c.solids.end(), is_body)->name,
            bodies > 1 ? fmt::format(" and {} more", bodies - 1) : std::string());
    }
    if (has_solid_bed(c)) {
        return fmt::format(
            "the bed is made of solids (\"{}\"), whose resistance comes from the pressure on their faces: the column has "
            "it of spheres by their drag coefficient (bed.kind = \"spheres\") or of a given roughness "
            "(bed.kind = \"roughness\")",
            std::find_if_not(c.solids.begin(), c.solids.end(), is_body)->name);
    }
    if (c.channel.lid_velocity != 0.0) {
        return "a moving lid drives the flow (channel.lid_velocity), which the balance of the column does "
               "not have";
    }
    if (!(c.streamwise_gravity() > 0.0)) {
        return "nothing drives a steady flow (channel.slope = 0): a uniform flow needs channel.slope > 0";
    }
    if (!c.start.water_x.empty()) {
        return "the water starts within an outline (start.water_x), so the depth of its uniform flow is "
               "not that of the case: leave the outline out";
    }
    if (resolves_eddies(c)) {
        return "the eddies of the flow are resolved and carry its stress, which no model of the mean flow "
               "knows: the column of the same channel with a mixing length (turbulence.closure = "
               "\"nezu-rodi\") is one to compare with";
    }
    if (auto reason = patchy_bed(c)) return reason;
    if (auto reason = patchy_vegetation(c)) return reason;
    if (auto reason = patchy_porosity(c)) return reason;
    if (!channel_resists(c)) {
        return "nothing resists the flow down the slope, so it has no steady state: a slip bed, or spheres "
               "without drag. Give bed.kind = \"spheres\" with bed.roughness_height > 0 and "
               "bed.drag_coefficient > 0, bed.kind = \"no-slip\", [[vegetation]] or a layer under [[porous]]";
    }
    return std::nullopt;
}

}  // namespace riffle::inline case_file
