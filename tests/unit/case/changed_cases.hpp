#pragma once

#include <filesystem>
#include <regex>
#include <string>
#include <variant>
#include <vector>

#include "case/case.hpp"
#include "case/conversion.hpp"
#include "case/key_table.hpp"
#include "case/solid_shapes.hpp"
#include "case_test.hpp"
#include "plane_bed.hpp"
#include "stl_box.hpp"
#include "temporary_folder.hpp"

namespace riffle::test {

// Cases that are right.

inline Case flume() { return parse_case(smallest, "case.toml"); }

inline Case tank() {
    Case c = flume();
    c.channel.slope = 0.0;
    c.channel.ends = Ends::walls;
    c.bed.kind = BedKind::slip;
    c.bed.roughness_height = 0.0;
    c.bed.datum_below_crest = 0.0;
    c.start.kind = StartKind::rest;
    c.run.until = RunUntil::time;
    c.run.time = 5.0;
    return c;
}

inline Case open_channel() {
    Case c = flume();
    c.channel.ends = Ends::open;
    c.channel.length = 0.3;
    c.inflow.unit_discharge = 0.0174;
    c.run.until = RunUntil::time;
    c.run.time = 5.0;
    return c;
}

/// A solid 10 mm high that reaches through the inflow.
inline Solid step_through_inflow() {
    Solid step;
    step.name = "step";
    step.x = {-0.2, 0.1, 0.1, -0.2};
    step.z = {0.0, 0.0, 0.01, 0.01};
    return step;
}

inline Case open_channel_over_step() {
    Case c = open_channel();
    c.inflow.profile = InflowProfile::uniform;
    c.outflow.kind = OutflowKind::critical_depth;
    c.start.kind = StartKind::rest;
    c.solids.push_back(step_through_inflow());
    return c;
}

inline Case open_channel_with_solid() {
    Case c = open_channel();
    c.outflow.kind = OutflowKind::critical_depth;
    Solid weir;
    weir.name = "weir";
    weir.x = {0.13, 0.17, 0.17, 0.13};
    weir.z = {0.0, 0.0, 0.03, 0.03};
    c.solids.push_back(weir);
    return c;
}

/// A bed by its equivalent roughness.
inline Case gravel() {
    Case c = flume();
    lay_plane_bed(c, 0.001);
    return c;
}

/// A trapezoidal canal with open ends, whose bed and banks have the friction of the log law.
inline Case open_canal() {
    Case c = gravel();
    c.channel.dimensions = 3;
    c.channel.sides = Sides::walls;
    c.channel.width = 0.2;
    c.channel.ends = Ends::open;
    c.channel.length = 0.3;
    c.bed = {};
    c.bed.kind = BedKind::slip;
    c.bed.roughness_height = 0.0;
    c.bed.datum_below_crest = 0.0;
    c.side_walls.drag_form = SideDragForm::none;
    c.inflow.unit_discharge = 0.0174;
    c.run.until = RunUntil::time;
    c.run.time = 5.0;
    Solid canal;
    canal.name = "canal";
    canal.shape = SolidShape::trapezoid;
    canal.bottom_width = 0.1;
    canal.bank_slope = 1.0;
    canal.surface = SolidSurface::log_law;
    canal.equivalent_roughness = 0.001;
    c.solids.push_back(canal);
    return c;
}

/// By Manning's n.
inline Case earth() {
    Case c = gravel();
    c.bed.equivalent_roughness.reset();
    c.bed.manning = 0.015;
    return c;
}

/// A smooth bed.
inline Case glass() {
    Case c = gravel();
    c.bed.kind = BedKind::smooth;
    c.bed.equivalent_roughness.reset();
    return c;
}

inline Case periodic_box() {
    Case c = tank();
    c.channel.ends = Ends::periodic;
    c.channel.top = Top::periodic;
    c.fluid.gravity = 0.0;
    return c;
}

inline Case plates() {
    Case c = tank();
    c.channel.ends = Ends::periodic;
    c.channel.top = Top::wall;
    c.bed.kind = BedKind::no_slip;
    return c;
}

/// Laminar flow through a duct of 20 mm.
inline Case duct() {
    Case c = plates();
    c.channel.length = 0.3;
    c.channel.depth = 0.02;
    c.channel.ends = Ends::open;
    c.inflow.unit_discharge = 1e-3;
    c.outflow.kind = OutflowKind::pressure;
    c.start.kind = StartKind::uniform;
    c.numerics.spacing = 0.001;
    return c;
}

inline Case duct_with_step() {
    Case c = duct();
    c.solids.push_back(step_through_inflow());
    return c;
}

inline Case cell() {
    Case c = flume();
    c.channel.dimensions = 3;
    c.channel.length = 0.05;
    c.channel.width = 0.0433;
    c.numerics.spacing = 0.003;
    return c;
}

inline Case between_side_walls() {
    Case c = cell();
    c.channel.width = 0.2;
    c.channel.sides = Sides::walls;
    return c;
}

/// Two patches of emergent stems one behind the other.
inline Case with_vegetation() {
    Case c = gravel();
    c.run.until = RunUntil::time;
    c.run.time = 5.0;
    c.start.kind = StartKind::rest;
    Vegetation reeds;
    reeds.name = "reeds";
    reeds.stems_per_area = 400.0;
    reeds.stem_diameter = 0.006;
    reeds.height = 0.1;
    reeds.x_from = 0.0;
    reeds.x_to = 0.1;
    Vegetation sedges = reeds;
    sedges.name = "sedges";
    sedges.x_from = 0.1;
    sedges.x_to = 0.2;
    c.vegetation = {reeds, sedges};
    return c;
}

/// A channel in space over gravel with two patches beside each other.
inline Case with_bed_patches() {
    Case c = cell();
    lay_plane_bed(c, 0.001);
    c.run.until = RunUntil::time;
    c.run.time = 5.0;
    c.start.kind = StartKind::rest;
    BedPatch cobbles;
    cobbles.name = "cobbles";
    cobbles.equivalent_roughness = 0.01;
    cobbles.y_from = 0.0;
    cobbles.y_to = 0.01;
    BedPatch sand = cobbles;
    sand.name = "sand";
    sand.equivalent_roughness = 0.0005;
    sand.y_from = 0.01;
    sand.y_to = 0.02;
    c.bed_patches = {cobbles, sand};
    return c;
}

/// A medium of small stones, everywhere.
inline Porous small_stones() {
    Porous stones;
    stones.name = "gravel";
    stones.porosity = 0.4;
    stones.grain_size = 0.003;
    return stones;
}

/// Two porous zones one behind the other.
inline Case with_porous() {
    Case c = tank();
    c.numerics.wall = WallKind::dummy;
    Porous gravel = small_stones();
    gravel.x_from = 0.05;
    gravel.x_to = 0.1;
    Porous sand;
    sand.name = "sand";
    sand.porosity = 0.3;
    sand.permeability = 1e-9;
    sand.x_from = 0.1;
    sand.x_to = 0.15;
    c.porous = {gravel, sand};
    return c;
}

/// A porous zone with an outline.
inline Case with_porous_outline() {
    Case c = with_porous();
    c.porous.pop_back();
    Porous& zone = c.porous.front();
    zone.x_from.reset();
    zone.x_to.reset();
    zone.x = {0.05, 0.1, 0.1, 0.05};
    zone.z = {0.0, 0.0, 0.03, 0.03};
    return c;
}

/// A channel in space with a porous zone that has an outline in plan.
inline Case with_porous_in_plan() {
    Case c = cell();
    c.numerics.wall = WallKind::dummy;
    Porous gravel = small_stones();
    gravel.x = {0.005, 0.045, 0.045, 0.005};
    gravel.y = {0.01, 0.01, 0.035, 0.035};
    c.start.kind = StartKind::uniform;
    c.start.velocity = 0.1;
    c.porous = {gravel};
    return c;
}

inline Case with_solid() {
    Case c = tank();
    Solid weir;
    weir.name = "weir";
    weir.x = {0.08, 0.12, 0.12, 0.08};
    weir.z = {0.0, 0.0, 0.03, 0.03};
    c.solids.push_back(weir);
    return c;
}

inline Case with_two_solids() {
    Case c = with_solid();
    c.solids.push_back(c.solids.front());
    c.solids[1].name = "gate";
    for (double& x : c.solids[1].x) x += 0.05;
    c.solids[1].motion = SolidMotion::constant;
    c.solids[1].velocity_z = 0.01;
    return c;
}

inline Case with_water() {
    Case c = tank();
    c.start.water_x = {0.0, 0.05, 0.05, 0.0};
    c.start.water_z = {0.0, 0.0, 0.05, 0.05};
    return c;
}

/// A box of 30 mm in a file, and the case that it stands in.
inline Case with_mesh() {
    const auto& folder = folder_of_this_process();
    test::write_stl_box(folder / "riffle_refusals.stl", {0.0, 0.0, 0.0}, {30.0, 30.0, 30.0});
    Case c = tank();
    c.path = folder / "case.toml";
    c.channel.dimensions = 3;
    c.channel.ends = Ends::periodic;
    c.channel.width = 0.1;
    Solid stone;
    stone.name = "stone";
    stone.file = folder / "riffle_refusals.stl";
    stone.scale = 0.001;
    stone.place = {0.05, 0.02, 0.0};
    c.solids.push_back(stone);
    return c;
}

inline Case with_shape(SolidShape shape) {
    const bool plane = shape == SolidShape::rectangle || shape == SolidShape::circle;
    Case c = with_mesh();
    c.channel.length = 0.2;
    c.channel.dimensions = plane ? 2 : 3;
    Solid solid;
    solid.name = "s";
    solid.shape = shape;
    switch (shape) {
        case SolidShape::box:
            solid.size = {0.03, 0.03, 0.03};
            break;
        case SolidShape::rectangle:
            solid.size = {0.03, 0.03};
            break;
        case SolidShape::bed:
            solid.heights = folder_of_this_process() / "riffle_refusals.xyz";
            put_bytes(solid.heights, "0 0 0.01\n0.2 0 0.01\n0 0.1 0.01\n0.2 0.1 0.01\n");
            break;
        case SolidShape::section:
            solid.y = {0.0, 0.1};
            solid.levels = {0.01, 0.01};
            break;
        case SolidShape::compound:
            solid.bank_height = 0.01;
            break;
        case SolidShape::pipe:
            solid.diameter = 0.1;
            break;
        case SolidShape::spheres:
            solid.packing = SolidPacking::square;
            solid.diameter = 0.02;
            break;
        default:
            solid.diameter = 0.03;
            solid.length = shape == SolidShape::cylinder ? 0.04 : 0.0;
    }
    if (!is_bed_shape(shape)) {
        solid.centre = plane ? std::vector{0.1, 0.02} : std::vector{0.1, 0.05, 0.02};
    }
    c.solids = {solid};
    return c;
}

inline Case with_probe(ProbeKind kind) {
    Case c = flume();
    Probe p;
    p.name = "p";
    p.kind = kind;
    p.sampling_frequency = 100.0;
    if (kind == ProbeKind::velocity || kind == ProbeKind::wave || kind == ProbeKind::flow_rate) {
        p.x = {0.1};
    }
    if (kind == ProbeKind::velocity) {
        p.z = {0.02};
    }
    c.probes.push_back(p);
    return c;
}

/// One whose files are looked for.
inline Case open_channel_in_file() {
    Case c = open_channel();
    c.path = with_mesh().path;
    return c;
}

/// A case with other values of keys: "channel.depth = 5 mm; solid[1].start = 5".
inline Case with_keys(Case c, const std::string& keys) {
    // One setting at a time: a regular expression takes a frame of the stack for each character that it
    // matches.
    static const std::regex setting(R"(\s*([a-z_]+)(\[(\d)\])?\.([a-z_]+) = )");
    for (std::size_t begin = 0; begin < keys.size();) {
        const std::size_t end = std::min(keys.find(';', begin), keys.size());
        const std::string each = keys.substr(begin, end - begin);
        begin = end + 1;
        std::smatch m;
        if (!std::regex_search(each, m, setting, std::regex_constants::match_continuous)) continue;
        const Key& key = *find_key(m[1].str(), m[4].str());
        const std::string text = m.suffix();
        const auto value = text == "[]" ? Value(std::vector<double>{})
                                        : std::get<Value>(convert(key, read_option_value(text)));
        key.set(c, value, m[3].matched ? std::stoul(m[3]) : 0);
    }
    return c;
}

}  // namespace riffle::test
