#pragma once

#include <memory>
#include <vector>

#include "engine/component.hpp"

namespace riffle::inline components {

template <int D, class Real>
using ComponentList = std::vector<std::unique_ptr<Component<D, Real>>>;

/// The components that a case asks for, in the order in which their hooks are called: the one place where
/// they are registered. Each may add inputs to the motion of the flow. `celerity`: of the stirring, where the
/// case gives none, m/s.
template <int D, class Real>
[[nodiscard]] ComponentList<D, Real> make_components(FlowOf<D, Real>& flow, double celerity);

}  // namespace riffle::inline components
