#include "ends/end_sections.hpp"

#include <algorithm>
#include <cmath>

namespace riffle {

namespace {

void go_over_to(EndState& end, const Section& section, double dt) {
    end.depth_rate = (section.depth - end.depth) / dt;
    end.depth = section.depth;
    end.velocity = section.velocity;
}

}  // namespace

EndState EndSections::start(double depth, double unit_discharge) const {
    EndState end;
    end.depth = depth;
    end.velocity = depth > 0.0 ? unit_discharge / depth : 0.0;
    end.watched_depth = end.depth;
    end.watched_velocity = end.velocity;
    end.coming = end.velocity - 2.0 * wave_speed(gravity_, end.depth);
    return end;
}

void EndSections::follow_upstream(EndState& end, double time, double dt) const {
    end.coming = end.watched_velocity - 2.0 * wave_speed(gravity_, end.watched_depth);
    Section section;
    if (input_.inflow_depth && input_.unit_discharge) {
        section.depth = input_.inflow_depth->at(time);
        section.velocity = input_.unit_discharge->at(time) / section.depth;
    } else if (input_.inflow_depth) {
        section = inflow_by_depth(gravity_, input_.inflow_depth->at(time), end.coming);
    } else {
        section = section_of_discharge(end, time, dt);
    }
    go_over_to(end, section, dt);
}

/// The section that carries the discharge: to the moment, or but for the waves that leave through it. (A
/// section that answers each of them with another depth feeds them: behind a weir they grew to a tenth of the
/// head.)
Section EndSections::section_of_discharge(const EndState& end, double time, double dt) const {
    const double wanted = input_.unit_discharge->at(time);
    const double going = end.velocity + 2.0 * wave_speed(gravity_, end.depth);
    const Section now = outflow_between(gravity_, going, end.coming);
    const bool subcritical =
        now.depth >= least_depth_ && std::abs(now.velocity) < wave_speed(gravity_, now.depth);
    if (input_.inflow_relaxation_time <= 0.0 || !subcritical) {
        return inflow_by_discharge(gravity_, wanted, end.coming);
    }
    const double share = std::min(1.0, dt / input_.inflow_relaxation_time);
    const double of_the_hydrograph = wanted - input_.unit_discharge->at(time - dt);
    const double change = share * (wanted - now.depth * now.velocity) + of_the_hydrograph;
    return outflow_between(gravity_, going + invariant_of_discharge(gravity_, now, change), end.coming);
}

void EndSections::follow_downstream(EndState& end, double time, double dt) const {
    const double c = wave_speed(gravity_, end.watched_depth);
    const double going = end.watched_velocity + 2.0 * c;
    // Where the flow is supercritical, or dry, nothing comes up from outside.
    const bool ruled = input_.outflow_depth && end.watched_velocity < c;
    if (!ruled) {
        end.coming = end.watched_velocity - 2.0 * c;
    }
    Section section = outflow_between(gravity_, going, end.coming);
    if (ruled) {
        const double q = end.watched_velocity * end.watched_depth;
        section.depth = std::max(section.depth, least_depth_);
        end.coming +=
            relaxation(gravity_, section, input_.outflow_depth(q, time), input_.relaxation_time, dt);
        section = outflow_between(gravity_, going, end.coming);
    }
    go_over_to(end, section, dt);
}

}  // namespace riffle
