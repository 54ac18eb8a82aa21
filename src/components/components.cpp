#include "components/components.hpp"

#include <utility>

#include "components/bed_drag_force.hpp"
#include "components/contact.hpp"
#include "components/crowds.hpp"
#include "components/density_filter.hpp"
#include "components/density_relaxation.hpp"
#include "components/energy_budget.hpp"
#include "components/free_bodies.hpp"
#include "components/further_pair_sums.hpp"
#include "components/mixing_lengths.hpp"
#include "components/open_ends.hpp"
#include "components/porous_forces.hpp"
#include "components/reference_pressure_force.hpp"
#include "components/repulsion.hpp"
#include "components/settling.hpp"
#include "components/slow_correction.hpp"
#include "components/solid_forces.hpp"
#include "components/solid_friction.hpp"
#include "components/stirring_force.hpp"
#include "components/vegetation_drag.hpp"
#include "components/xsph.hpp"

namespace riffle::inline components {

namespace {

/// Adds a component of a kind where the case asks for it: one that is not asked for is null.
template <int D, class Real>
void add(ComponentList<D, Real>& components, std::unique_ptr<Component<D, Real>> component) {
    if (component) components.push_back(std::move(component));
}

}  // namespace

template <int D, class Real>
ComponentList<D, Real> make_components(FlowOf<D, Real>& flow, double celerity) {
    ComponentList<D, Real> components;
    add(components, make_density_filter(flow));
    add(components, make_xsph(flow));
    add(components, make_crowds_of_impacts(flow));
    add(components, make_crowds_at_edges(flow));
    add(components, make_further_pair_sums(flow));
    add(components, make_density_relaxation(flow));
    add(components, make_slow_correction(flow));  // after all that makes the correction
    add(components, make_mixing_lengths(flow));
    add(components, make_solid_forces(flow));
    add(components, make_bed_drag_force(flow));
    add(components, make_vegetation_drag(flow));
    add(components, make_stirring(flow, celerity));
    add(components, make_settling(flow));
    add(components, make_reference_pressure_force(flow));
    add(components, make_repulsion(flow));
    add(components, make_solid_friction(flow));  // after solid_forces, to which it adds
    add(components, make_porous_forces(flow));   // after all that adds forces, which it must know
    add(components, make_open_ends(flow));       // after all that adds forces, which buffers do not feel
    add(components, make_energy_budget(flow));   // after all that adds forces, before what changes velocities
    add(components, make_contact(flow));
    add(components, make_free_bodies(flow));  // after all that acts on them
    return components;
}

template ComponentList<2, float> make_components(FlowOf<2, float>&, double);
template ComponentList<2, double> make_components(FlowOf<2, double>&, double);
template ComponentList<3, float> make_components(FlowOf<3, float>&, double);
template ComponentList<3, double> make_components(FlowOf<3, double>&, double);

}  // namespace riffle::inline components
