// Particles that leave the domain, and states that are no longer finite.

#include <fmt/format.h>

#include <cmath>
#include <limits>

#include "base/error.hpp"
#include "solver/simulation_of.hpp"

namespace riffle::inline solver {

template <int D, class Real>
bool SimulationOf<D, Real>::can_be_packed(std::size_t begin, std::size_t end) const {
    bool possible = true;
    flow_.for_clusters(begin, end, [&](std::size_t first, std::size_t last, std::size_t) {
        for (std::size_t i = first; i < last; ++i) {
            for (std::size_t k = 0; k < axes; ++k) {
                possible = possible && flow_.fixed_point.in_range(flow_.particles.position[k][i], k);
            }
        }
    });
    return possible;
}

// What is not finite spreads over the kernel's support within a step. Where it began, the density departs
// most.
template <int D, class Real>
void SimulationOf<D, Real>::check_state() const {
    std::size_t faults = 0;
    std::size_t worst = 0;
    double departure = -1.0;
    for (std::size_t i = 0; i < flow_.particles.size(); ++i) {
        const double s = flow_.particles.density_deviation[i];
        bool fault = !std::isfinite(s);
        for (std::size_t k = 0; k < axes; ++k) {
            const double x = flow_.particles.position[k][i];
            fault = fault || !std::isfinite(x) || !std::isfinite(flow_.particles.velocity[k][i]) ||
                    !flow_.fixed_point.in_range(x, k);
        }
        if (fault) {
            ++faults;
            const double size = std::isfinite(s) ? std::abs(s) : std::numeric_limits<double>::infinity();
            if (size > departure) {
                departure = size;
                worst = i;
            }
        }
    }
    if (faults > 0) throw ParticleFault(worst, fault_text(worst, faults));
}

template <int D, class Real>
std::string SimulationOf<D, Real>::fault_text(std::size_t particle, std::size_t faults) const {
    const auto x = in_space<D>(flow_.particles.position, particle);
    const auto u = in_space<D>(flow_.particles.velocity, particle);
    const double s = flow_.particles.density_deviation[particle];
    bool finite = std::isfinite(s);
    for (std::size_t k = 0; k < 3; ++k) finite = finite && std::isfinite(x[k]) && std::isfinite(u[k]);
    // Water that rises over the room that the case gives it is not the fault of any particle.
    const double top = flow_.domain.upper[vertical];
    return fmt::format(
        "{}: particle {}{} at x = {:.6g} m, {}z = {:.6g} m, velocity ({:.4g}, {}{:.4g}) m/s, density "
        "deviation {:.4g}, at t = {:.6g} s (step {}){}",
        finite ? "a particle left the domain at one bound" : "the state is no longer finite",
        flow_.particles.id[particle],
        faults > 1 ? fmt::format(" (of {}, the one whose density departs most)", faults) : "", x[0],
        D == 3 ? fmt::format("y = {:.6g} m, ", x[1]) : "", x[2], u[0],
        D == 3 ? fmt::format("{:.4g}, ", u[1]) : "", u[2], s, flow_.clock.time, flow_.clock.steps,
        finite && x[2] > top ? fmt::format("; the domain reaches up to z = {:.4g} m, by [channel] depth", top)
                             : "");
}

// The lists still count the particles that go: they are built anew at the next step, and a saved state has
// none of them.
template <int D, class Real>
void SimulationOf<D, Real>::take_out_leaving() {
    leaving_ = false;
    std::vector<std::int32_t> kept;
    kept.reserve(flow_.particles.size());
    for (std::size_t i = 0; i < flow_.particles.size(); ++i) {
        if (flow_.stays(i)) {
            kept.push_back(static_cast<std::int32_t>(i));
            continue;
        }
        LostParticle lost{.id = flow_.particles.id[i],
                          .time = flow_.clock.time,
                          .mass = flow_.particles.mass[i],
                          .position = in_space<D>(flow_.particles.position, i),
                          .velocity = in_space<D>(flow_.particles.velocity, i)};
        lost.exit = exit_of(flow_.c, lost.position, lost.velocity);
        flow_.particles.lost.push_back(lost);
    }
    if (kept.size() == flow_.particles.size()) {
        return;  // back within the second half of the step
    }
    if (kept.empty()) {
        throw RunError(fmt::format("all water has left the domain ({}) at t = {:.6g} s",
                                   exits_text(flow_.particles.lost), flow_.clock.time));
    }
    flow_.fields.keep(kept, flow_.particles.size());
    flow_.particles.permute(kept);
    unlisted_ = true;
}

template class SimulationOf<2, float>;
template class SimulationOf<2, double>;
template class SimulationOf<3, float>;
template class SimulationOf<3, double>;

}  // namespace riffle::inline solver
