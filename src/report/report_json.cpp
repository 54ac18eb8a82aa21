#include "report/report_json.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>

#include "case/bed_traits.hpp"
#include "case/flow_kind.hpp"
#include "report/base64.hpp"
#include "report/field_data.hpp"
#include "report/json_parts.hpp"
#include "report/run_facts.hpp"
#include "report/summary_json.hpp"

namespace riffle::inline report {

namespace {

Json geometry_json(const ReportData& data) {
    const Case& c = data.flow;
    const bool closed = c.channel.ends == Ends::walls;
    return {{"length", c.channel.length},
            {"datum", c.datum()},
            {"crest", c.crest()},
            {"spacing", c.numerics.spacing},
            {"rough", has_spheres(c.bed)},
            {"bed", c.channel.top != Top::periodic},
            {"lid", c.channel.top == Top::wall ? Json(c.total_depth()) : Json(nullptr)},
            {"ends", closed ? Json(c.channel.wall_height.value_or(1.5 * c.total_depth())) : Json(nullptr)},
            {"falls", falling_height(c)},
            {"periodic", c.channel.ends == Ends::periodic}};
}

/// Values as 16-bit steps between the ends of their range, base64; not-a-number is the highest step.
std::string packed(const std::vector<double>& values, double low, double high) {
    constexpr double steps = 65534.0;
    constexpr std::uint16_t none = 65535;
    std::vector<std::uint8_t> bytes;
    bytes.reserve(2 * values.size());
    for (const double value : values) {
        const double share = high > low ? std::clamp((value - low) / (high - low), 0.0, 1.0) : 0.0;
        const auto step =
            std::isfinite(value) ? static_cast<std::uint16_t>(std::lround(steps * share)) : none;
        bytes.push_back(static_cast<std::uint8_t>(step & 255U));
        bytes.push_back(static_cast<std::uint8_t>(step >> 8U));
    }
    return base64(bytes);
}

/// A quantity of the field's picture: its name, its values, and their range over all frames.
struct FieldQuantity {
    const char* name;
    std::vector<double> FieldFrame::*values;
    double low = std::numeric_limits<double>::infinity();
    double high = -std::numeric_limits<double>::infinity();
    bool whole = true;  ///< each frame has a value for each particle
};

std::vector<FieldQuantity> field_quantities(const FieldPicture& picture) {
    std::vector<FieldQuantity> quantities = {{"x", &FieldFrame::x},
                                             {"z", &FieldFrame::z},
                                             {"velocity", &FieldFrame::velocity},
                                             {"vertical_velocity", &FieldFrame::vertical_velocity},
                                             {"pressure", &FieldFrame::pressure},
                                             {"eddy_viscosity", &FieldFrame::eddy_viscosity}};
    for (FieldQuantity& quantity : quantities) {
        for (const FieldFrame& frame : picture.frames) {
            const std::vector<double>& values = frame.*quantity.values;
            quantity.whole = quantity.whole && values.size() == frame.x.size();
            for (const double value : values) {
                if (!std::isfinite(value)) continue;
                quantity.low = std::min(quantity.low, value);
                quantity.high = std::max(quantity.high, value);
            }
        }
    }
    std::erase_if(quantities, [](const FieldQuantity& q) { return !q.whole || !(q.low <= q.high); });
    return quantities;
}

Json outlines_json(const std::vector<Outline>& outlines) {
    Json array = Json::array();
    for (const Outline& outline : outlines) {
        array.push_back({{"x", array_of(outline.x)}, {"z", array_of(outline.z)}});
    }
    return array;
}

Json field_json(const ReportData& data) {
    if (!data.field) return nullptr;
    const FieldPicture& picture = *data.field;
    const std::vector<FieldQuantity> quantities = field_quantities(picture);
    Json ranges = Json::object();
    for (const FieldQuantity& quantity : quantities) ranges[quantity.name] = {quantity.low, quantity.high};
    Json frames = Json::array();
    for (const FieldFrame& frame : picture.frames) {
        Json object = {{"time", frame.time}, {"count", frame.x.size()}};
        for (const FieldQuantity& quantity : quantities) {
            object[quantity.name] = packed(frame.*quantity.values, quantity.low, quantity.high);
        }
        object["surface"] = {{"x", array_of(frame.surface_x)}, {"z", array_of(frame.surface_z)}};
        object["bodies"] = outlines_json(frame.bodies);
        frames.push_back(std::move(object));
    }
    Json spheres = Json::array();
    for (const Circle& circle : picture.spheres) {
        spheres.push_back({rounded(circle.x), rounded(circle.z), rounded(circle.radius)});
    }
    Json zones = Json::array();
    for (const FieldZone& zone : picture.zones) {
        zones.push_back({{"kind", zone.kind},
                         {"name", zone.name},
                         {"x", array_of(zone.outline.x)},
                         {"z", array_of(zone.outline.z)}});
    }
    Json object = {
        {"spacing", data.flow.numerics.spacing}, {"x_end", picture.x_end},      {"top", picture.top},
        {"left_out", picture.left_out},          {"ranges", std::move(ranges)}, {"frames", std::move(frames)},
        {"spheres", std::move(spheres)},         {"zones", std::move(zones)}};
    if (picture.y) object["y"] = *picture.y;
    return object;
}

Json surface_frames_json(const ReportData& data, const std::vector<SummaryRow>& quantities) {
    if (!data.surface_frames) return nullptr;
    const SurfaceFrames& surface = *data.surface_frames;
    double largest = 0.0;
    for (const double value : surface.elevation) {
        if (std::isfinite(value)) largest = std::max(largest, std::abs(value));
    }
    const auto points = static_cast<std::ptrdiff_t>(surface.x.size() * surface.y.size());
    Json frames = Json::array();
    for (auto at = surface.elevation.begin(); at != surface.elevation.end(); at += points) {
        frames.push_back(packed({at, at + points}, -largest, largest));
    }
    const Case& c = data.flow;
    const SummaryRow* const mean = find_quantity(quantities, "depth_mean_velocity");
    return {{"x", array_of(surface.x)},
            {"y", array_of(surface.y)},
            {"time", array_of(surface.time)},
            {"largest", largest},
            {"frames", std::move(frames)},
            {"length", c.channel.length},
            {"width", c.channel.simulated_width()},
            {"periodic_along", c.channel.ends == Ends::periodic},
            {"periodic_across", c.channel.sides == Sides::periodic},
            {"velocity", mean != nullptr && mean->simulated ? Json(mean->simulated->value) : Json(nullptr)},
            {"earlier_left_out", surface.earlier_left_out}};
}

/// The chapters in the order of the page, before and after the picture of the flow field; those of neither
/// list follow at the end, and `particles` stands with the diagnostics.
Json chapters_json(FlowKind kind) {
    const auto lists = [](const std::vector<std::string>& first, const std::vector<std::string>& then) {
        return Json{{"first", first}, {"then", then}};
    };
    switch (kind) {
        case FlowKind::uniform_channel:
            return lists({"profiles", "statistics"}, {"section", "secondary", "bed", "fits", "surface",
                                                      "subsurface", "forces", "energy"});
        case FlowKind::channel_with_bodies:
        case FlowKind::open_channel:
            return lists({"along", "forces", "energy"},
                         {"statistics", "profiles", "section", "secondary", "surface", "subsurface"});
        case FlowKind::tank:
        case FlowKind::standing_wave:
        case FlowKind::periodic_box:
            break;
    }
    return lists({"course", "energy"}, {"profiles", "forces", "section"});
}

std::string summary_note(const ReportData& data) {
    const FlowKind kind = flow_kind(data.flow);
    if (is_undriven(kind)) {
        return "Theory stands beside what it knows: the references are named in the chapter on the course of "
               "the flow.";
    }
    std::string note;
    if (varies_along(kind)) {
        note =
            "Levels are time means above the bed level along the channel; forces are shares of the "
            "component of the water's weight down the slope. ";
    } else if (!why_no_column(data.flow)) {
        note =
            "The column twin is the steady one-dimensional solution of the same equations, closure and "
            "drag: what the particles would give with perfect numerics. ";
    }
    if (data.flow.has_side_walls() && kind == FlowKind::uniform_channel) {
        note +=
            "Between side walls the twin is that of the section, the steady flow over the cross-section, "
            "and what was measured at the centreline stands beside the simulated centreline: means over "
            "the length and a period of the bed's elements across the channel. ";
    }
    if (has_rough_bed(data.flow) && kind == FlowKind::uniform_channel) {
        note +=
            "The datum lies below the crests of the bed elements; depth-mean values are taken above it. "
            "Friction velocity and equivalent roughness from the fit: rough log law "
            "<i>u</i>/<i>u</i><sub>∗</sub> = "
            "ln((<i>z</i> − <i>z</i><sub>0</sub>)/<i>k</i><sub>s</sub>)/0.41 + 8.5 with <i>z</i><sub>0</sub> "
            "at the datum. ";
    }
    if (data.flow.channel.slope > 0 && kind == FlowKind::uniform_channel) {
        note +=
            "Channel numbers are for a wide channel: hydraulic radius = depth above the datum; those of "
            "the measured flow follow from its depth-mean velocity in the same way.";
    }
    return note;
}

}  // namespace

std::string page_json(const ReportData& data, const Analysis& analysis) {
    const std::vector<SummaryRow> quantities = summarize(data, analysis);
    const std::vector<Diagnostic> diagnostics = diagnose(data, analysis);
    Json facts = Json::array();
    for (const Fact& fact : run_facts(data)) facts.push_back({{"label", fact.label}, {"value", fact.value}});
    const Json object = {
        {"kicker", flow_line(data)},
        {"description", data.flow.description},
        {"flow_kind", flow_kind_word(flow_kind(data.flow))},
        {"verdict", verdict_json(judge(data, quantities, diagnostics))},
        {"quantities", quantity_rows(quantities)},
        {"summary_note", summary_note(data)},
        {"twin", data.flow.has_side_walls() ? "Section twin" : "Column twin"},
        {"chapters", chapters_json(flow_kind(data.flow))},
        {"geometry", geometry_json(data)},
        {"field", field_json(data)},
        {"moving_surface", surface_frames_json(data, quantities)},
        {"diagnostics", diagnostics_json(diagnostics)},
        {"run", std::move(facts)},
        {"references", references_json(cited_references({analysis}, {data.flow.measured.source}))},
        {"case_text", data.flow.text}};
    return json_text(object, -1);
}

}  // namespace riffle::inline report
