#include "ends/flow_at_ends.hpp"

#include <algorithm>
#include <cmath>
#include <functional>
#include <map>
#include <utility>
#include <vector>

#include "base/error.hpp"
#include "case/bed_patch.hpp"
#include "case/cross_section.hpp"
#include "case/end_floor.hpp"
#include "case/end_levels.hpp"
#include "case/flow_kind.hpp"
#include "column/twin_channel.hpp"
#include "column/twin_reaches.hpp"
#include "column/uniform_rating.hpp"
#include "ends/end_input.hpp"
#include "ends/end_lattice.hpp"
#include "hydraulics/varied_reaches.hpp"
#include "laboratory/profile_record.hpp"

namespace riffle::inline ends {

namespace {

void widen(std::optional<Extremes>& extremes, double value) {
    extremes = extremes ? Extremes{std::min(extremes->least, value), std::max(extremes->largest, value)}
                        : Extremes{value, value};
}

/// Velocity, Froude number and characteristic depths of one bed at any discharge, from its column twin where
/// it has one. Between side walls the channel of the section twin takes half a minute to find, so that there
/// only the normal depth is the twin's. Depths are those of all the water over what it stands on, m.
class BedFlow {
  public:
    BedFlow(Case c, bool at_inflow)
        : case_(std::move(c)),
          has_section_(has_section_reach(case_)),
          has_twin_(!is_duct(case_) && channel_or_walls_resist(case_) && !resolves_eddies(case_) &&
                    (has_section_ || has_column_reach(case_))),
          waves_(waves_of(case_, at_inflow)) {}

    [[nodiscard]] bool has_channel() const { return has_twin_ && !has_section_; }
    [[nodiscard]] const SteadyChannel& channel(double q) {
        const auto found = channels_.find(q);
        return found != channels_.end() ? found->second
                                        : channels_.emplace(q, twin_channel(case_, q)).first->second;
    }

    [[nodiscard]] double velocity(double q, double depth, bool on_bed) {
        return knows(q, depth, on_bed) ? channel(q).state(depth - case_.datum()).mean_velocity
                                       : q / waves_.area(depth);
    }

    [[nodiscard]] double froude(double q, double depth, bool on_bed) {
        return knows(q, depth, on_bed) ? channel(q).froude_number(depth - case_.datum())
                                       : q / waves_.area(depth) / waves_.speed(depth);
    }

    [[nodiscard]] double critical(double q, bool on_bed) {
        if (on_bed && has_channel() && q > 0.0) {
            const double depth = critical_depth(channel(q));
            if (depth > 0.0) return depth + case_.datum();
        }
        return waves_.critical_depth(q);
    }

    [[nodiscard]] std::optional<double> normal(double q) {
        const auto found = normal_.find(q);
        return found != normal_.end() ? found->second : normal_.emplace(q, find_normal(q)).first->second;
    }

  private:
    [[nodiscard]] std::optional<double> find_normal(double q) {
        if (!has_twin_ || !(case_.streamwise_gravity() > 0.0)) return std::nullopt;
        if (!(q > 0.0)) return 0.0;
        try {
            return has_section_ ? twin_normal_depth(case_, q) : normal_depth(channel(q));
        } catch (const InputError&) {
            // Shallower than what the friction of the bed is known for: as the outflow goes on downwards.
            return UniformRating(case_).depth(q);
        }
    }

    [[nodiscard]] bool knows(double q, double depth, bool on_bed) {
        return on_bed && has_channel() && q > 0.0 && depth - case_.datum() >= channel(q).least_depth;
    }

    Case case_;
    bool has_section_;
    bool has_twin_;
    LongWaves waves_;
    std::map<double, SteadyChannel> channels_;
    std::map<double, std::optional<double>> normal_;
};

/// Whether bodies, patches or solids at the ends make the flow other than that over the bed.
bool is_disturbed(const Case& c) {
    const EndFloors floors = end_floors(c);
    return has_solids_beside_section(c) || has_solid_bed(c) || varies_beyond_beds(c) ||
           floors.upstream > 0.0 || floors.downstream > 0.0;
}

/// The steady varied flow between the ends, where it is what the case has: one discharge over the bed alone.
std::optional<VariedFlow> steady_flow(const Case& c, const EndInput& input, BedFlow& bed, double q) {
    const bool steady = c.inflow.discharge_file.empty() && c.inflow.depth_file.empty() &&
                        c.outflow.depth_file.empty() && q > 0.0;
    if (!bed.has_channel() || is_disturbed(c) || !steady) return std::nullopt;
    try {
        const auto reaches = c.bed_patches.empty()
                                 ? std::vector<Reach>{{"", 0.0, c.channel.length, bed.channel(q)}}
                                 : twin_reaches(c, q, c.channel.length);
        return solve_varied_reaches(reaches, controls_at_ends(c, input, reaches.back().channel));
    } catch (const InputError&) {
        return std::nullopt;  // riffle backwater says why
    }
}

/// Depth of the start at x = 0 over z = 0, m.
double depth_of_start(const Case& c, const EndInput& input) {
    try {
        return start_depths(c, input)(0.0);
    } catch (const InputError&) {
        return c.total_depth();  // no varied flow, as the start of the run says itself
    }
}

/// What the tables of a case give at one time; depths over what the water stands on, 0 where none is given.
struct Instant {
    double time = 0.0;
    double unit_discharge = 0.0;
    double inflow_depth = 0.0;
    double outflow_depth = 0.0;
};

/// The instants of a run at which quantities of the ends are least and largest: among the rows of the tables,
/// for between two of them each quantity only rises or only falls.
std::vector<Instant> extreme_instants(const Case& c, const EndInput& input, double other_depth) {
    const double of_start = start_unit_discharge(c, input);
    std::vector<Instant> all;
    for (const double time : times_of_tables(c, input)) {
        const double q = input.unit_discharge ? input.unit_discharge->at(time) : of_start;
        all.push_back({time, q, input.inflow_depth ? input.inflow_depth->at(time) : 0.0,
                       input.outflow_depth ? input.outflow_depth(q, time) : 0.0});
        if (!input.unit_discharge && !input.inflow_depth && !input.outflow_table) break;
    }
    const auto depth_in = [&](const Instant& at) {
        return input.inflow_depth ? at.inflow_depth : other_depth;
    };
    const std::function<double(const Instant&)> measures[] = {
        [](const Instant& at) { return at.unit_discharge; },
        depth_in,
        [](const Instant& at) { return at.outflow_depth; },
        [&](const Instant& at) { return at.unit_discharge / std::max(depth_in(at), 1e-9); },
        [&](const Instant& at) { return at.unit_discharge / std::pow(std::max(depth_in(at), 1e-9), 1.5); },
        [](const Instant& at) { return at.unit_discharge / std::max(at.outflow_depth, 1e-9); },
        [](const Instant& at) { return at.unit_discharge / std::pow(std::max(at.outflow_depth, 1e-9), 1.5); },
    };
    std::vector<Instant> chosen;
    for (const auto& measure : measures) {
        const auto [least, largest] =
            std::minmax_element(all.begin(), all.end(),
                                [&](const Instant& a, const Instant& b) { return measure(a) < measure(b); });
        for (const Instant& at : {*least, *largest}) {
            if (std::none_of(chosen.begin(), chosen.end(),
                             [&](const Instant& other) { return other.time == at.time; })) {
                chosen.push_back(at);
            }
        }
    }
    return chosen;
}

/// Depth at the inflow, over the datum, of the steady flow with what the tables give at one time; none where
/// there is no such flow.
std::optional<double> depth_of_steady_flow(const Case& c, const EndInput& input, BedFlow& bed,
                                           const Instant& at) {
    if (!(at.unit_discharge > 0.0)) {
        // Still water is as high as the outflow holds it.
        return std::max(0.0, at.outflow_depth - c.channel.slope * c.channel.length) - c.datum();
    }
    try {
        const SteadyChannel& channel = bed.channel(at.unit_discharge);
        return solve_varied_reaches({{"", 0.0, c.channel.length, channel}},
                                    controls_at_ends(c, input, channel, at.time))
            .depth_at(0.0);
    } catch (const InputError&) {
        return std::nullopt;
    }
}

/// Adds what a depth (m, over what the water stands on there) means at an end.
void add_depth(const Case& c, BedFlow& bed, double q, double depth, FlowAtEnd& end) {
    if (!(depth > 0.0)) return;
    const bool on_bed = end.floor == 0.0;
    widen(end.depth, is_duct(c) ? depth : depth + (on_bed ? -c.datum() : end.floor));
    widen(end.velocity, bed.velocity(q, depth, on_bed));
    if (!is_duct(c)) widen(end.froude, bed.froude(q, depth, on_bed));
}

/// Adds the critical and the normal depth of a discharge at an end.
void add_characteristic_depths(const Case& c, BedFlow& bed, double q, FlowAtEnd& end) {
    const bool on_bed = end.floor == 0.0;
    end.critical_of_profile = on_bed && bed.has_channel();
    // Water that does not flow is critical at no depth, and not below the datum.
    widen(end.critical_depth, std::max(0.0, bed.critical(q, on_bed) - (on_bed ? c.datum() : 0.0)));
    if (!on_bed) return;
    if (const auto normal = bed.normal(q)) widen(end.normal_depth, *normal);
}

DepthSource source_of_inflow(const Case& c, const EndInput& input, bool has_flow, bool has_uniform_flow) {
    return is_duct(c)           ? DepthSource::full
           : input.inflow_depth ? DepthSource::given
           : has_flow           ? DepthSource::backwater
           : has_uniform_flow   ? DepthSource::uniform
                                : DepthSource::start;
}

DepthSource source_of_outflow(const Case& c, const EndInput& input, bool has_flow) {
    return is_duct(c)            ? DepthSource::full
           : has_flow            ? DepthSource::backwater
           : input.outflow_depth ? DepthSource::given
                                 : DepthSource::unknown;
}

}  // namespace

FlowAtEnds flow_at_ends(const Case& c) {
    const EndInput input = read_end_levels(c);
    const EndFloors floors = end_floors(c);
    BedFlow bed(with_bed_at(c, 0.0), true);
    std::optional<BedFlow> other;
    BedFlow& bed_at_outflow = c.bed_patches.empty() && measured_bed_of(c) == nullptr
                                  ? bed
                                  : other.emplace(with_bed_at(c, c.channel.length), false);
    FlowAtEnds states;
    states.gives_discharge = input.unit_discharge.has_value();
    states.inflow.floor = floors.upstream > 0.0 ? floors.upstream - c.datum() : 0.0;
    states.outflow.floor = floors.downstream > 0.0 ? floors.downstream - c.datum() : 0.0;
    states.one_bed = !other && states.inflow.floor == states.outflow.floor;
    states.varied = steady_flow(c, input, bed, start_unit_discharge(c, input));
    const std::optional<VariedFlow>& flow = states.varied;
    // A hydrograph, whatever the start: about that of the steady flow with each discharge, where the bed
    // alone rules it that of uniform flow.
    const bool has_uniform = !c.inflow.discharge_file.empty() && !is_disturbed(c) && !is_duct(c) &&
                             bed.normal(input.unit_discharge->largest()).has_value();
    states.inflow.source = source_of_inflow(c, input, flow.has_value(), has_uniform);
    if (states.inflow.source == DepthSource::uniform && c.outflow.kind != OutflowKind::normal_depth &&
        c.bed_patches.empty() && bed.has_channel()) {
        states.inflow.source = DepthSource::steady;
    }
    states.outflow.source = source_of_outflow(c, input, flow.has_value());
    const double of_start = depth_of_start(c, input) - floors.upstream;

    std::optional<Extremes> discharge;
    for (const Instant& at : extreme_instants(c, input, of_start)) {
        const double q = at.unit_discharge;
        widen(discharge, q);
        if (is_duct(c)) {
            add_depth(c, bed, q, c.total_depth() - floors.upstream, states.inflow);
            add_depth(c, bed, q, c.total_depth() - floors.downstream, states.outflow);
            continue;
        }
        add_characteristic_depths(c, bed, q, states.inflow);
        add_characteristic_depths(c, bed_at_outflow, q, states.outflow);
        const std::optional<double> uniform =
            has_uniform && !input.inflow_depth ? bed.normal(q) : std::nullopt;
        const std::optional<double> varied = states.inflow.source == DepthSource::steady
                                                 ? depth_of_steady_flow(c, input, bed, at)
                                                 : std::nullopt;
        const double before = input.inflow_depth ? at.inflow_depth
                              : flow             ? flow->depth_at(0.0) + c.datum()
                              : varied           ? *varied + c.datum()
                              : uniform          ? std::max(*uniform + c.datum(), bed.critical(q, true))
                                        : std::max(of_start, bed.critical(q, states.inflow.floor == 0.0));
        add_depth(c, bed, q, before, states.inflow);
        if (input.outflow_depth) {
            widen(states.held_depth, at.outflow_depth + floors.downstream - c.datum());
            states.holding_time = input.relaxation_time;
        }
        add_depth(c, bed_at_outflow, q,
                  flow ? flow->depth_at(c.channel.length) + c.datum() : at.outflow_depth, states.outflow);
    }
    if (c.inflow.profile == InflowProfile::file) {
        std::vector<double> heights = read_profile_record(c.inflow.profile_file).z;
        std::sort(heights.begin(), heights.end());
        for (const double z : heights) widen(states.profile_heights, z);
        for (std::size_t i = 1; i < heights.size(); ++i) {
            const Extremes gap{heights[i - 1], heights[i]};
            const auto width = [](const Extremes& e) { return e.largest - e.least; };
            if (!states.profile_gap || width(gap) > width(*states.profile_gap)) states.profile_gap = gap;
        }
    }
    states.unit_discharge = discharge.value_or(Extremes{});
    if (is_duct(c) && c.fluid.kinematic_viscosity > 0.0) {
        // Between two walls the hydraulic diameter is twice their distance.
        states.reynolds = 2.0 * states.unit_discharge.largest / c.fluid.kinematic_viscosity;
    }
    return states;
}

}  // namespace riffle::inline ends
