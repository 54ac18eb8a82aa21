#include "engine/flow.hpp"

#include <cmath>
#include <utility>

#include "engine/pair_setup.hpp"
#include "particles/lattice.hpp"

namespace riffle::inline engine {

template <int D, class Real>
FlowOf<D, Real>::FlowOf(const Case& c_, const ColumnResult* column, Particles<D> water)
    : FlowIn<D>(c_),
      domain(domain_of<D>(c_)),
      fixed_point(domain),
      column_width(cluster_column_spacings(D) * c_.numerics.spacing),
      loops(pair_loops<D, Real>(loop_options(c_))),
      particle_loops(riffle::particle_loops<D, Real>()),
      porous(c_) {
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
        for (const std::int32_t id : water.id) water.created = std::max(water.created, id + 1);
        for (const LostParticle& lost : water.lost) water.created = std::max(water.created, lost.id + 1);
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
        if (!(x >= particle_data.stay_from[k] && x < particle_data.stay_to[k])) return false;
    }
    return true;
}

template <int D, class Real>
void FlowOf<D, Real>::pack(Displacement<D>* displacement, std::size_t begin, std::size_t end) {
    particle_loops.pack(particle_data, data, displacement, begin, end);
    if (porous.empty()) return;
    const auto& position = this->particles.position;
    for_particles(begin, end, [&](std::size_t i, std::size_t lane) {
        const PorousMedia::At at =
            porous.at_with_normal(D, position[0][i], across_of<D>(position, i), position[vertical][i]);
        porous_at[i] = at;
        MotionRecord<D, Real>& record = data.motion[begin * cluster_size + lane];
        for (Real& u : record.u) u *= static_cast<Real>(at.porosity);
        record.volume /= static_cast<Real>(at.porosity);
    });
}

template <int D, class Real>
void FlowOf<D, Real>::put_media_in_stress(std::size_t begin, std::size_t end) {
    const auto change = [&](auto& records) {
        for_particles(begin, end, [&](std::size_t i, std::size_t lane) {
            auto& record = records[begin * cluster_size + lane];
            record.weight /= static_cast<Real>(porous_at[i].porosity);
            record.viscosity_root *= static_cast<Real>(std::sqrt(porous_at[i].viscosity_ratio));
        });
    };
    if (!data.stress.empty()) {
        change(data.stress);
    } else {
        change(data.pressure);
    }
}

template <int D, class Real>
void FlowOf<D, Real>::repack() {
    if (!porous.empty()) porous_at.resize(this->particles.size());
    parallel_blocks(clusters.size(), light_block,
                    [&](std::size_t begin, std::size_t end) { pack(&moved, begin, end); });
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

}  // namespace riffle::inline engine
