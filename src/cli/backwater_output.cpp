#include "cli/backwater_output.hpp"

#include <fmt/format.h>

#include <cmath>
#include <numbers>

#include "base/wrapped_text.hpp"
#include "cli/printed_number.hpp"

namespace riffle::inline cli {

namespace {

BackwaterStation station(const Backwater& b, const SurfaceProfile& part, double x) {
    BackwaterStation s;
    s.x = x;
    s.bed = (b.length - x) * b.channel.sine();
    s.depth = part.depth_at(x);
    s.surface = s.bed + s.depth * b.channel.cosine();
    const SteadyChannel& channel = part.curve.channel();
    s.energy_grade = s.bed + channel.energy_head(s.depth);
    const SectionState state = channel.state(s.depth);
    s.velocity = state.mean_velocity;
    s.friction_slope = state.friction_slope;
    s.froude = channel.froude_number(s.depth);
    s.manning = channel.manning(s.depth);
    s.area = channel.area(s.depth) * b.width;
    s.top_width = b.width * (channel.section ? channel.section->top_width(s.depth) : 1.0);
    s.profile = part.name;
    return s;
}

const char* slope_word(SlopeClass slope) {
    switch (slope) {
        case SlopeClass::mild:
            return "mild";
        case SlopeClass::critical:
            return "critical";
        case SlopeClass::steep:
            return "steep";
        case SlopeClass::horizontal:
            return "horizontal";
        case SlopeClass::adverse:
            return "adverse";
    }
    return "";
}

void print_fact(const char* name, const std::string& value) { fmt::print("  {:<28} {}\n", name, value); }

struct Quantity1D {
    const char* key;
    const char* heading;
    double BackwaterStation::*value;
};
constexpr Quantity1D quantities[] = {
    {"x", "x [m]", &BackwaterStation::x},
    {"bed", "bed [m]", &BackwaterStation::bed},
    {"depth", "depth [m]", &BackwaterStation::depth},
    {"surface", "surface [m]", &BackwaterStation::surface},
    {"energy_grade", "energy grade [m]", &BackwaterStation::energy_grade},
    {"velocity", "U [m/s]", &BackwaterStation::velocity},
    {"froude", "Fr", &BackwaterStation::froude},
    {"manning", "n [s/m^(1/3)]", &BackwaterStation::manning},
    {"friction_slope", "S_f", &BackwaterStation::friction_slope},
    {"area", "area [m2]", &BackwaterStation::area},
    {"top_width", "top width [m]", &BackwaterStation::top_width},
};

}  // namespace

std::vector<BackwaterStation> backwater_stations(const Backwater& b, int count, Places places) {
    std::vector<BackwaterStation> result;
    for (const SurfaceProfile& part : b.flow.profiles) {
        const bool first = part.from == 0.0;
        const bool last = part.to == b.length;
        if (places == Places::dense_at_ends) {
            for (int i = 0; i < count; ++i) {
                const double share = 0.5 - 0.5 * std::cos(std::numbers::pi * i / (count - 1));
                result.push_back(station(b, part, part.from + share * (part.to - part.from)));
            }
            continue;
        }
        if (!first) result.push_back(station(b, part, part.from));
        for (int i = 0; i < count; ++i) {
            const double x = i == count - 1 ? b.length : b.length * i / (count - 1);
            if (x > part.from - (first ? 1.0 : 0.0) && (x < part.to || (last && i == count - 1))) {
                result.push_back(station(b, part, x));
            }
        }
        if (!last) result.push_back(station(b, part, part.to));
    }
    return result;
}

void print_backwater(const Case& c, const Backwater& b, const std::vector<BackwaterStation>& stations) {
    const auto metres = [](double value) { return printed_number(value) + " m"; };
    fmt::print("{}\n", c.title.empty() ? "Steady varied flow over the bed of the case" : c.title);
    fmt::print("friction: {}; {} slope {}, {} m long\n\n", b.friction, slope_word(b.flow.slope),
               printed_number(b.channel.slope), printed_number(b.length));
    print_fact("discharge",
               fmt::format("{} m3/s over {} m: {} m2/s", printed_number(b.discharge),
                           printed_number(c.channel.width), printed_number(b.channel.unit_discharge)));
    const auto depth_or_none = [&](const std::optional<double>& depth) {
        return depth ? metres(*depth) : std::string("none");
    };
    if (b.flow.reaches.empty()) {
        print_fact("normal depth", depth_or_none(b.flow.normal_depth));
        print_fact("critical depth", metres(b.flow.critical_depth));
    }
    for (const VariedReach& reach : b.flow.reaches) {
        print_fact(reach.name.empty() ? "bed of the channel" : "bed of a patch",
                   fmt::format("{}from {} to {}:", reach.name.empty() ? "" : reach.name + ", ",
                               metres(reach.from), metres(reach.to)));
        print_fact("", fmt::format("normal depth {}, critical {}", depth_or_none(reach.normal_depth),
                                   metres(reach.critical_depth)));
    }
    for (const SurfaceProfile& part : b.flow.profiles) {
        print_fact(&part == b.flow.profiles.data() ? "surface" : "",
                   fmt::format("{} from {} at {} to {} at {}", part.name, metres(part.depth_from),
                               metres(part.from), metres(part.depth_to), metres(part.to)));
    }
    if (b.flow.jump) {
        const HydraulicJump& jump = *b.flow.jump;
        print_fact("hydraulic jump", fmt::format("at {}: {} to {}", metres(jump.place),
                                                 metres(jump.depth_before), metres(jump.depth_after)));
        print_fact("", fmt::format("Fr {} before it, head loss {}", printed_number(jump.froude_before),
                                   metres(jump.head_loss)));
    }
    fmt::print("\n{:>8} {:>9} {:>9} {:>9} {:>9} {:>8} {:>8}  {}\n", "x", "depth", "surface", "energy", "U",
               "Fr", "n", "profile");
    fmt::print("{:>8} {:>9} {:>9} {:>9} {:>9} {:>8} {:>8}\n", "m", "m", "m", "m", "m/s", "", "s/m^1/3");
    for (const BackwaterStation& s : stations) {
        fmt::print("{:>8} {:>9} {:>9} {:>9} {:>9} {:>8} {:>8}  {}\n", printed_number(s.x),
                   printed_number(s.depth), printed_number(s.surface), printed_number(s.energy_grade),
                   printed_number(s.velocity), printed_number(s.froude), printed_number(s.manning),
                   s.profile);
    }
    fmt::print("\nElevations over the bed at the downstream end. {}\n",
               b.channel.section ? "n with the hydraulic radius of\nthe section."
                                 : "Wide channel: the hydraulic\nradius is the depth.");
    for (const auto* sentences : {&b.flow.events, &b.notes}) {
        for (const std::string& sentence : *sentences) fmt::print("{}\n", wrapped_text(sentence, 0));
    }
}

std::string backwater_csv(const std::vector<BackwaterStation>& stations) {
    std::string text;
    for (const Quantity1D& quantity : quantities) text += std::string(quantity.heading) + ",";
    text += "profile\n";
    for (const BackwaterStation& s : stations) {
        for (const Quantity1D& quantity : quantities) text += fmt::format("{:.9g},", s.*quantity.value);
        text += s.profile + "\n";
    }
    return text;
}

nlohmann::ordered_json backwater_json(const Case& c, const Backwater& b,
                                      const std::vector<BackwaterStation>& stations) {
    using nlohmann::ordered_json;
    ordered_json result;
    result["title"] = c.title;
    result["friction"] = b.friction;
    result["discharge"] = b.discharge;
    result["unit_discharge"] = b.channel.unit_discharge;
    result["slope"] = b.channel.slope;
    result["slope_class"] = slope_word(b.flow.slope);
    result["length"] = b.length;
    result["normal_depth"] = optional_number(b.flow.normal_depth);
    result["critical_depth"] = b.flow.critical_depth;
    result["reaches"] = ordered_json::array();
    for (const VariedReach& reach : b.flow.reaches) {
        result["reaches"].push_back({{"name", reach.name},
                                     {"from", reach.from},
                                     {"to", reach.to},
                                     {"slope_class", slope_word(reach.slope)},
                                     {"normal_depth", optional_number(reach.normal_depth)},
                                     {"critical_depth", reach.critical_depth}});
    }
    result["profiles"] = ordered_json::array();
    for (const SurfaceProfile& part : b.flow.profiles) {
        result["profiles"].push_back({{"name", part.name},
                                      {"from", part.from},
                                      {"to", part.to},
                                      {"depth_from", part.depth_from},
                                      {"depth_to", part.depth_to}});
    }
    result["jump"] = nullptr;
    if (b.flow.jump) {
        const HydraulicJump& jump = *b.flow.jump;
        result["jump"] = {{"place", jump.place},
                          {"depth_before", jump.depth_before},
                          {"depth_after", jump.depth_after},
                          {"froude_before", jump.froude_before},
                          {"head_loss", jump.head_loss}};
    }
    result["events"] = b.flow.events;
    result["notes"] = b.notes;
    for (const Quantity1D& quantity : quantities) {
        for (const BackwaterStation& s : stations) {
            result["stations"][quantity.key].push_back(s.*quantity.value);
        }
    }
    for (const BackwaterStation& s : stations) result["stations"]["profile"].push_back(s.profile);
    return result;
}

}  // namespace riffle::inline cli
