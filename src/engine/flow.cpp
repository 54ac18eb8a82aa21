#include "engine/flow.hpp"

#include <utility>

#include "engine/pair_setup.hpp"
#include "particles/lattice.hpp"

namespace riffle {

template <int D, class Real>
FlowOf<D, Real>::FlowOf(const Case& c_, const ColumnResult* column, Particles<D> water)
    : FlowIn<D>(c_),
      domain(domain_of<D>(c_)),
      fixed_point(domain),
      column_width(cluster_column_spacings(D) * c_.numerics.spacing),
      loops(pair_loops<D, Real>(loop_options(c_))),
      particle_loops(riffle::particle_loops<D, Real>()) {
    this->particles = std::move(water);
    this->scheme = make_scheme(c_, column);
    data.constants = pair_constants<D, Real>(c_, this->scheme, fixed_point);
    particle_data = particle_constants<D>(c_, this->scheme, domain);
    refer_to_particles();
}

template <int D, class Real>
void FlowOf<D, Real>::refer_to_particles() {
    auto& water = this->particles;
    if (water.created == 0) {
        for (const std::int32_t id : water.id) {
            water.created = std::max(water.created, id + 1);
        }
        for (const LostParticle& lost : water.lost) {
            water.created = std::max(water.created, lost.id + 1);
        }
    }
    for (std::size_t k = 0; k < axes; ++k) {
        particle_data.position[k] = water.position[k].data();
        particle_data.velocity[k] = water.velocity[k].data();
    }
    particle_data.density_deviation = water.density_deviation.data();
    particle_data.mass = water.mass.data();
    const auto& mass = water.mass;
    const bool uniform = std::all_of(mass.begin(), mass.end(), [&](double m) { return m == mass.front(); });
    particle_data.uniform_mass = uniform && !mass.empty() ? mass.front() : 0.0;
    particle_data.clusters = &clusters;
}

template <int D, class Real>
bool FlowOf<D, Real>::stays(std::size_t particle) const {
    for (std::size_t k = 0; k < axes; ++k) {
        const double x = this->particles.position[k][particle];
        if (!(x >= particle_data.stay_from[k] && x < particle_data.stay_to[k])) {
            return false;
        }
    }
    return true;
}

template <int D, class Real>
void FlowOf<D, Real>::repack() {
    parallel_blocks(clusters.size(), light_block, [&](std::size_t begin, std::size_t end) {
        particle_loops.pack(particle_data, data, &moved, begin, end);
    });
    moved_known = true;
    fill_last_records();
}

template <int D, class Real>
void FlowOf<D, Real>::fill_last_records() {
    data.motion.back() = MotionRecord<D, Real>{};
    data.motion.back().x = data.motion.front().x;
    if (!data.stress.empty()) {
        data.stress.back() = StressRecord<D, Real>{};
    } else {
        data.pressure.back() = PressureRecord<Real>{};
    }
}

template struct FlowOf<2, float>;
template struct FlowOf<2, double>;
template struct FlowOf<3, float>;
template struct FlowOf<3, double>;

}  // namespace riffle
