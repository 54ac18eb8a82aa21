#include "ends/end_input.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <memory>
#include <utility>
#include <vector>

#include "base/error.hpp"
#include "base/interpolation.hpp"
#include "case/bed_patch.hpp"
#include "case/cross_section.hpp"
#include "case/end_floor.hpp"
#include "case/end_levels.hpp"
#include "case/flow_kind.hpp"
#include "case/outline.hpp"
#include "case/units.hpp"
#include "column/twin_channel.hpp"
#include "column/twin_reaches.hpp"
#include "column/uniform_rating.hpp"
#include "ends/canal_entering.hpp"
#include "ends/end_checks.hpp"
#include "ends/end_lattice.hpp"
#include "ends/end_relaxation.hpp"
#include "ends/flow_of_results.hpp"
#include "ends/narrowest_opening.hpp"
#include "ends/section_state.hpp"
#include "hydraulics/varied_flow.hpp"
#include "laboratory/profile_record.hpp"

namespace riffle::inline ends {

namespace {

/// The columns that a discharge may have in a file; both give m2/s.
std::vector<TableColumn> discharge_columns(const Case& c) {
    return {{"discharge", "m3/s", 1.0 / c.channel.width}, {"unit_discharge", "m2/s"}};
}

/// A level over the datum as the depth over a floor.
TimeTable depth_table(const Case& c, const std::optional<double>& depth, const std::filesystem::path& file,
                      double floor) {
    if (depth) return TimeTable(*depth + c.datum() - floor);
    const double least = 1e-6 + std::max(0.0, floor - c.datum());
    return read_time_table(file, {{"depth", "m", 1.0, c.datum() - floor}}, least);
}

VelocityShape profile_from_file(const Case& c, double floor) {
    const ProfileRecord record = read_profile_record(c.inflow.profile_file);
    const ProfileColumn* const velocity = record.find(ProfileQuantity::velocity);
    if (velocity == nullptr) {
        throw FileError(fmt::format("{}: there is no column u", c.inflow.profile_file.string()));
    }
    std::vector<double> height;
    double mean = 0.0;
    for (std::size_t i = 0; i < record.z.size(); ++i) {
        if (!std::isfinite(velocity->values[i])) {
            throw FileError(
                fmt::format("{}: u has no value here; fill the hole or leave the row out", record.place(i)));
        }
        height.push_back(record.z[i] + c.datum() - floor);
        mean += velocity->values[i];
    }
    if (!(mean > 0.0)) {
        throw FileError(fmt::format("{}: the mean of u is {:g}; it must be above 0",
                                    c.inflow.profile_file.string(),
                                    mean / static_cast<double>(height.size())));
    }
    return {height, velocity->values, c.total_depth() - floor};
}

/// Discharge at which a twin gives its profile, m2/s.
double twin_discharge(const Case& c, const std::optional<TimeTable>& unit_discharge, double depth) {
    if (unit_discharge && unit_discharge->at(0.0) > 0.0) return unit_discharge->at(0.0);
    return c.streamwise_gravity() > 0.0 ? uniform_unit_discharge(c) : 0.1 * depth;
}

/// The profile of a law u(z) over a depth.
template <class Law>
VelocityShape shape_of_law(double depth, const Law& law) {
    constexpr int points = 400;
    std::vector<double> height;
    std::vector<double> velocity;
    for (int i = 0; i < points; ++i) {
        height.push_back(depth * (i + 0.5) / points);
        velocity.push_back(law(height.back()));
    }
    return {height, velocity, depth};
}

std::shared_ptr<const EnteringFlow> entering_flow(const Case& c,
                                                  const std::optional<TimeTable>& unit_discharge,
                                                  double floor) {
    const double depth = c.total_depth() - floor;
    if (uneven_bed_of(c) != nullptr) {
        const bool is_canal = canal_of(c) != nullptr;
        return canal_entering(c, is_canal ? twin_discharge(c, unit_discharge, depth) : 0.0, depth);
    }
    const auto profile = [](VelocityShape shape) {
        return std::make_shared<const ProfileFlow>(std::move(shape));
    };
    switch (c.inflow.profile) {
        case InflowProfile::twin:
            if (has_section_reach(c)) {
                const double q = twin_discharge(c, unit_discharge, depth);
                return std::make_shared<const SectionFlow>(
                    carrying_section(with_bed_at(c, 0.0), c.channel.depth - floor, q).section, depth);
            }
            [[fallthrough]];
        case InflowProfile::column: {
            const double q = twin_discharge(c, unit_discharge, depth);
            const CarryingColumn twin = carrying_column(with_bed_at(c, 0.0), c.channel.depth - floor, q);
            return profile({twin.column.profile.z, twin.column.profile.velocity, depth});
        }
        case InflowProfile::power_law:
            return profile(
                shape_of_law(depth, [&](double z) { return std::pow(z / depth, 1.0 / c.inflow.exponent); }));
        case InflowProfile::log_law:
            return profile(shape_of_law(depth, [&](double z) {
                const double over_datum = floor > 0.0 ? z : std::max(0.0, z - c.datum());
                return std::log(1.0 + 30.0 * over_datum / c.inflow.equivalent_roughness);
            }));
        case InflowProfile::file:
            return profile(profile_from_file(c, floor));
        case InflowProfile::results:
            return recorded_flow(c);
        case InflowProfile::uniform:
            break;
    }
    return profile({});
}

/// The depths that an outflow holds in time, over its floor.
TimeTable outflow_table(const Case& c, double floor) {
    TimeTable table = depth_table(c, c.outflow.depth, c.outflow.depth_file, floor);
    if (!c.outflow.depth_file.empty()) {
        require_room(c, c.outflow.depth_file.string(), "its largest depth is", table.largest() + floor);
    }
    return table;
}

/// Throws FileError unless a rating curve reaches as far as what enters in the time of the run: beyond its
/// ends it says nothing.
void require_covered(const Case& c, const std::optional<TimeTable>& entering,
                     const std::vector<double>& rated) {
    if (!entering) return;
    double least = entering->at(c.run.time);
    double largest = least;
    for (const double time : entering->times()) {
        if (time > c.run.time) break;
        least = std::min(least, entering->at(time));
        largest = std::max(largest, entering->at(time));
    }
    const bool in_space = c.channel.dimensions == 3;
    const double width = in_space ? c.channel.width : 1.0;
    const auto refuse = [&](const char* end, double at, const char* most, double value) {
        constexpr double litres = 1000.0;
        const char* const unit = in_space ? "l/s" : "l/s per metre of width";
        throw FileError(
            fmt::format("{}: the rating curve {} at {:.4g} {}, and the {} that enters is {:.4g} {}: add "
                        "rows, it says nothing beyond its ends",
                        c.outflow.rating_file.string(), end, litres * width * at, unit, most,
                        litres * width * value, unit));
    };
    constexpr double rounding = 1e-9;
    if (largest > rated.back() * (1.0 + rounding)) refuse("ends", rated.back(), "largest discharge", largest);
    if (least < rated.front() * (1.0 - rounding)) refuse("begins", rated.front(), "least discharge", least);
}

/// What another kind of outflow holds.
std::function<double(double, double)> outflow_rule(const Case& c, const std::optional<TimeTable>& entering,
                                                   double floor) {
    const Outflow& outflow = c.outflow;
    const double g = c.normal_gravity();
    const double datum = c.datum();
    switch (outflow.kind) {
        case OutflowKind::normal_depth: {
            const Case bed = with_bed_at(c, c.channel.length);
            if (const auto q = c.inflow_unit_discharge()) {
                const auto depth = twin_normal_depth(bed, *q);
                return [total = depth.value_or(c.channel.depth) + datum](double, double) { return total; };
            }
            // A discharge that changes, or follows from a depth: that of uniform flow with what leaves.
            return [rating = std::make_shared<UniformRating>(bed), datum](double q, double) {
                return rating->depth(q) + datum;
            };
        }
        case OutflowKind::critical_depth:
            return [waves = waves_of(c, false)](double q, double) { return waves.critical_depth(q); };
        case OutflowKind::weir:
            return [g, crest = outflow.weir_height + datum - floor, cd = outflow.weir_coefficient](
                       double q, double) { return crest + weir_head(g, cd, q); };
        case OutflowKind::rating_curve: {
            TwoColumns rating =
                read_two_columns(outflow.rating_file, {"depth", "m"}, discharge_columns(c), 0.0);
            if (!std::is_sorted(rating.second.begin(), rating.second.end())) {
                throw FileError(fmt::format("{}: the discharge does not rise with the depth",
                                            outflow.rating_file.string()));
            }
            require_covered(c, entering, rating.second);
            return [rating = std::move(rating), over = datum - floor](double q, double) {
                return place_in(rating.second, q).in(rating.first) + over;
            };
        }
        case OutflowKind::depth:
        case OutflowKind::free:
        case OutflowKind::free_fall:
        case OutflowKind::pressure:
            break;
    }
    return {};
}

/// What the ends of a duct need beside it.
void add_duct(const Case& c, double floor, EndInput& input) {
    input.duct = true;
    const double narrow = c.total_depth() - floor;
    const double velocity = input.entering->largest() * input.unit_discharge->largest() / narrow;
    // What leaves more than `widest` open makes no jet that is faster than the water beside a body.
    constexpr double widest = 0.74;
    constexpr double jet_alone = 0.70;
    constexpr double contraction = 0.61;                                     // of a jet from a sharp edge
    const double opening = narrowest_opening(c) * c.total_depth() / narrow;  // over that of the inflow
    const double part = std::clamp((widest - opening) / (widest - jet_alone), 0.0, 1.0);
    input.jet_velocity = velocity * (1.0 + part * (1.0 / (contraction * std::max(opening, 0.01)) - 1.0));
    // Only differences of the pressure act; so the water is nowhere under tension.
    input.outflow_pressure = input.jet_velocity * input.jet_velocity;
    // Sound passes the duct in L/c0, twice as long as which lets most of it out; the sound speed is at least
    // ten times the velocity.
    const double time = velocity > 0.0 ? 0.1 * c.channel.length / velocity : 0.0;
    input.inflow_relaxation_time = c.inflow.relaxation_time.value_or(time);
    input.relaxation_time = c.outflow.relaxation_time.value_or(time);
}

}  // namespace

EndInput read_end_levels(const Case& c) {
    EndInput input;
    if (!c.inflow.discharge_file.empty()) {
        input.unit_discharge = read_time_table(c.inflow.discharge_file, discharge_columns(c), 0.0);
    } else if (const auto q = c.inflow_unit_discharge()) {
        input.unit_discharge = TimeTable(*q);
    }
    const EndFloors floors = end_floors(c);
    if (c.inflow.gives_depth()) {
        input.inflow_depth = depth_table(c, c.inflow.depth, c.inflow.depth_file, floors.upstream);
        if (!c.inflow.depth_file.empty()) {
            require_room(c, c.inflow.depth_file.string(), "its largest depth is",
                         input.inflow_depth->largest() + floors.upstream);
        }
    } else if (!c.inflow.discharge_file.empty() && !is_duct(c)) {
        const double q = input.unit_discharge->largest();
        const double critical =
            std::max(waves_of(c, true).critical_depth(q), waves_of(c, false).critical_depth(q));
        require_room(c, c.inflow.discharge_file.string(), "critical flow with its largest discharge is",
                     critical + std::max(floors.upstream, floors.downstream));
    }
    if (!is_duct(c)) {
        if (c.outflow.kind == OutflowKind::depth) {
            input.outflow_table = outflow_table(c, floors.downstream);
            input.outflow_depth = [table = *input.outflow_table](double, double time) {
                return table.at(time);
            };
        } else {
            input.outflow_depth = outflow_rule(c, input.unit_discharge, floors.downstream);
            require_room_for_rule(c, input, floors.downstream);
        }
        const EndRelaxation times = end_relaxation(c, input.outflow_table);
        input.inflow_relaxation_time = times.inflow;
        input.relaxation_time = times.outflow;
        require_supercritical_inflow(c, input, floors.upstream);
        require_subcritical_outflow(c, input, floors.downstream);
        require_profile_in_water(c, floors.upstream);
    }
    return input;
}

EndInput read_end_input(const Case& c) {
    EndInput input = read_end_levels(c);
    const double floor = end_floors(c).upstream;
    input.entering = entering_flow(c, input.unit_discharge, floor);
    if (is_duct(c)) add_duct(c, floor, input);
    return input;
}

double start_unit_discharge(const Case& c, const EndInput& input) {
    if (input.unit_discharge) return input.unit_discharge->at(0.0);
    const bool has_twin = channel_or_walls_resist(c) && !resolves_eddies(c);
    return c.streamwise_gravity() > 0.0 && has_twin ? uniform_unit_discharge(c) : 0.0;
}

std::function<double(double)> start_depths(const Case& c, const EndInput& input) {
    if (!c.start.water_x.empty()) {
        // Where the outline leaves the bed, or the solid there, dry, the depth is that of its top.
        return [of = std::make_shared<const Case>(c),
                water = Outline{c.start.water_x, c.start.water_z}](double x) {
            const double place = within_ends(x, of->channel.length);
            return ceiling_above(water, place, floor_at(*of, place));
        };
    }
    if (c.start.kind != StartKind::backwater) {
        return [depth = c.total_depth()](double) { return depth; };
    }
    try {
        return varied_depths(c, input);
    } catch (const InputError& error) {
        throw InputError(
            fmt::format("{}: [start] kind = \"backwater\": {}, or another start", c.name(), error.what()));
    }
}

std::vector<double> times_of_tables(const Case& c, const EndInput& input) {
    std::vector<double> times{0.0, c.run.time};
    for (const std::optional<TimeTable>* table :
         {&input.unit_discharge, &input.inflow_depth, &input.outflow_table}) {
        if (!*table) continue;
        std::copy_if((*table)->times().begin(), (*table)->times().end(), std::back_inserter(times),
                     [&c](double time) { return time > 0.0 && time < c.run.time; });
    }
    return times;
}

ChannelControls controls_at_ends(const Case& c, const EndInput& input, const SteadyChannel& channel,
                                 double time) {
    ChannelControls controls{.length = c.channel.length, .upstream_depth = {}, .downstream_depth = {}};
    // Depths at ends are those over what the water stands on there.
    const EndFloors floors = end_floors(c);
    if (input.inflow_depth) {
        controls.upstream_depth = input.inflow_depth->at(time) + floors.upstream - c.datum();
    }
    if (input.outflow_depth) {
        const double critical = critical_depth(channel);
        const double held = input.outflow_depth(channel.unit_discharge, time) + floors.downstream;
        controls.downstream_depth = std::max(critical, held - c.datum());
    } else if (c.outflow.kind == OutflowKind::free_fall || c.outflow.kind == OutflowKind::free) {
        // Slower water leaves at the critical depth; faster water does not hear of it.
        controls.downstream_depth = critical_depth(channel);
    }
    return controls;
}

std::function<double(double)> varied_depths(const Case& c, const EndInput& input) {
    const double q = start_unit_discharge(c, input);
    if (!(q > 0.0)) {
        throw InputError(
            "the discharge begins with nothing, and varied flow needs some: give the first row more");
    }
    const auto reaches = twin_reaches(c, q, c.channel.length);
    const ChannelControls controls = controls_at_ends(c, input, reaches.back().channel);
    return [flow = std::make_shared<const VariedFlow>(solve_varied_reaches(reaches, controls)),
            length = c.channel.length,
            datum = c.datum()](double x) { return flow->depth_at(std::clamp(x, 0.0, length)) + datum; };
}

}  // namespace riffle::inline ends
