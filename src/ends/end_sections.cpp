#include "ends/end_sections.hpp"

#include <algorithm>
#include <cmath>

#include "ends/duct_section.hpp"

namespace riffle::inline ends {

namespace {

void go_over_to(EndState& end, const Section& section, double dt) {
    end.depth_rate = (section.depth - end.depth) / dt;
    end.depth = section.depth;
    end.velocity = section.velocity;
}

}  // namespace

EndState EndSections::start(double depth, double unit_discharge, bool at_inflow) const {
    const LongWaves& waves = this->waves(at_inflow);
    EndState end;
    end.depth = depth;
    end.velocity = depth > waves.lowest() ? unit_discharge / waves.area(depth) : 0.0;
    end.watched_depth = end.depth;
    end.watched_velocity = end.velocity;
    if (in_duct()) {
        end.pressure = input_.outflow_pressure;
        end.watched_pressure = end.pressure;
        end.coming = end.velocity - end.pressure / sound_speed_;
        return end;
    }
    end.coming = end.velocity - waves.invariant(end.depth);
    return end;
}

void EndSections::follow_duct_upstream(EndState& end, double time, double dt) const {
    end.coming = end.watched_velocity - end.watched_pressure / sound_speed_;
    const double wanted = input_.unit_discharge->at(time) / end.depth;
    const double before = input_.unit_discharge->at(time - dt) / end.depth;
    const DuctSection section = duct_inflow(sound_speed_, {end.velocity, end.pressure}, end.coming, wanted,
                                            wanted - before, input_.inflow_relaxation_time, dt);
    end.velocity = section.velocity;
    end.pressure = section.pressure;
}

void EndSections::follow_duct_downstream(EndState& end, double dt) const {
    const double going = end.watched_velocity + end.watched_pressure / sound_speed_;
    const DuctSection now = duct_section(sound_speed_, going, end.coming);
    end.coming += duct_relaxation(sound_speed_, now, input_.outflow_pressure, input_.relaxation_time, dt);
    const DuctSection section = duct_section(sound_speed_, going, end.coming);
    end.velocity = section.velocity;
    end.pressure = section.pressure;
}

void EndSections::follow_upstream(EndState& end, double time, double dt) const {
    if (in_duct()) {
        follow_duct_upstream(end, time, dt);
        return;
    }
    end.coming = end.watched_velocity - upstream_.invariant(end.watched_depth);
    Section section;
    if (input_.inflow_depth && input_.unit_discharge) {
        section.depth = reached(end, input_.inflow_depth->at(time), dt);
        section.velocity = input_.unit_discharge->at(time) / upstream_.area(section.depth);
    } else if (input_.inflow_depth) {
        section = inflow_by_depth(upstream_, reached(end, input_.inflow_depth->at(time), dt), end.coming);
    } else {
        section = section_of_discharge(end, time, dt);
        const double depth = reached(end, section.depth, dt);
        section = {depth, section.velocity * (upstream_.area(section.depth) / upstream_.area(depth))};
    }
    go_over_to(end, section, dt);
}

/// The depth at an end after a step of dt on the way to another one, which the start may not have: no surface
/// falls or rises faster than its waves run, and where nothing enters a film stands.
double EndSections::reached(const EndState& end, double depth, double dt) const {
    const double most = dt * wave_speed(upstream_, std::max(depth, end.depth));
    return std::max(upstream_.lowest() + least_depth_, std::clamp(depth, end.depth - most, end.depth + most));
}

/// The section that carries the discharge: to the moment, or but for the waves that leave through it. (A
/// section that answers each of them with another depth feeds them: behind a weir they grew to a tenth of the
/// head.)
Section EndSections::section_of_discharge(const EndState& end, double time, double dt) const {
    const double wanted = input_.unit_discharge->at(time);
    const double going = end.velocity + upstream_.invariant(end.depth);
    const Section now = outflow_between(upstream_, going, end.coming);
    const bool subcritical = now.depth - upstream_.lowest() >= least_depth_ &&
                             std::abs(now.velocity) < wave_speed(upstream_, now.depth);
    if (input_.inflow_relaxation_time <= 0.0 || !subcritical) {
        return inflow_by_discharge(upstream_, wanted, end.coming);
    }
    const double share = std::min(1.0, dt / input_.inflow_relaxation_time);
    const double of_the_hydrograph = wanted - input_.unit_discharge->at(time - dt);
    const double change = share * (wanted - upstream_.area(now.depth) * now.velocity) + of_the_hydrograph;
    return outflow_between(upstream_, going + invariant_of_discharge(upstream_, now, change), end.coming);
}

void EndSections::follow_downstream(EndState& end, double time, double dt) const {
    if (in_duct()) {
        follow_duct_downstream(end, dt);
        return;
    }
    const double c = wave_speed(downstream_, end.watched_depth);
    const double going = end.watched_velocity + downstream_.invariant(end.watched_depth);
    const Section watched{end.watched_depth, end.watched_velocity};
    const double q = watched.velocity * downstream_.area(watched.depth);
    // Where the flow is dry, or supercritical, nothing comes up from outside, unless it is so deep there that
    // it drives a jump up the channel.
    const bool ruled =
        input_.outflow_depth &&
        (watched.velocity < c || (watched.depth - downstream_.lowest() > least_depth_ &&
                                  input_.outflow_depth(q, time) > sequent_depth(downstream_, watched)));
    if (!ruled) {
        // Nothing holds water that flows slower than its waves back: it goes over to critical flow, and none
        // comes in.
        const bool held = !input_.outflow_depth && watched.depth - downstream_.lowest() > least_depth_ &&
                          watched.velocity < c;
        end.coming = held ? invariant_of_critical_flow(downstream_, going)
                          : end.watched_velocity - downstream_.invariant(end.watched_depth);
    }
    Section section = outflow_between(downstream_, going, end.coming);
    if (ruled) {
        section.depth = std::max(section.depth, downstream_.lowest() + least_depth_);
        end.coming +=
            relaxation(downstream_, section, input_.outflow_depth(q, time), input_.relaxation_time, dt);
        if (input_.outflow_table) {
            const double of_the_tide = input_.outflow_table->at(time) - input_.outflow_table->at(time - dt);
            end.coming += invariant_of_depth(downstream_, section, of_the_tide);
        }
        section = outflow_between(downstream_, going, end.coming);
    }
    go_over_to(end, section, dt);
}

}  // namespace riffle::inline ends
