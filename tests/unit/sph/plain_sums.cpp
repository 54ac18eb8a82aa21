#include "plain_sums.hpp"

#include <algorithm>
#include <cmath>
#include <memory>
#include <numbers>
#include <random>

#include "sph/pair_terms.hpp"

namespace riffle {

namespace {

constexpr double spacing = 1.0 / 16.0;
constexpr double pi = std::numbers::pi;

/// W and dW/dr of the 2D kernels, written down again.
struct KernelValue {
    double w = 0.0;
    double slope = 0.0;
};
KernelValue kernel_value(KernelKind kind, double r, double h) {
    const double q = r / h;
    if (q >= 2.0) {
        return {};
    }
    if (kind == KernelKind::wendland_c2) {
        const double a = 7.0 / (4.0 * pi * h * h);
        const double t = 1.0 - 0.5 * q;
        return {a * std::pow(t, 4) * (2.0 * q + 1.0), -5.0 * a * q * std::pow(t, 3) / h};
    }
    const double a = 10.0 / (7.0 * pi * h * h);
    if (q < 1.0) {
        return {a * (1.0 - 1.5 * q * q + 0.75 * q * q * q), a * (-3.0 * q + 2.25 * q * q) / h};
    }
    return {0.25 * a * std::pow(2.0 - q, 3), -0.75 * a * (2.0 - q) * (2.0 - q) / h};
}

}  // namespace

void PlainSum::add(double term) {
    value += term;
    magnitude += std::abs(term);
}

PairSample disordered_sample(double jitter, int layers, unsigned seed) {
    PairSample sample;
    const bool periodic = layers == 0;
    sample.h = 1.5 * spacing;
    const double depth = 10.0 * spacing;
    sample.domain = {.lower = {0.0, periodic ? 0.0 : -8.0 * spacing},
                     .upper = {1.0, periodic ? depth : 2.0 * depth},
                     .periodic = {true, periodic}};
    sample.fixed_point = FixedPoint<2>(sample.domain);
    std::mt19937 generator(seed);
    std::uniform_real_distribution<double> uniform(-1.0, 1.0);
    const auto wrap = [](double x, double period) { return x - period * std::floor(x / period); };
    // Positions on the grid of the fixed point, so that its rounding is no difference between the two sums.
    const auto on_grid = [&](double x, std::size_t k) {
        return sample.fixed_point.decode(sample.fixed_point.encode(x, k), k);
    };
    for (int column = 0; column < 16; ++column) {
        for (int row = -layers; row < 10; ++row) {
            PairSample::Particle p;
            const bool wall = row < 0;
            p.x = {(column + 0.5) * spacing, (row + 0.5) * spacing};
            if (!wall) {
                p.x[0] += jitter * spacing * uniform(generator);
                p.x[1] += jitter * spacing * uniform(generator);
            }
            p.x[0] = on_grid(wrap(p.x[0], 1.0), 0);
            p.x[1] = on_grid(periodic ? wrap(p.x[1], depth) : p.x[1], 1);
            p.u = {uniform(generator), uniform(generator)};
            p.s = 0.01 * uniform(generator);
            p.volume = spacing * spacing * (1.0 + 0.05 * uniform(generator));
            p.pressure = 0.5 + 0.3 * uniform(generator);
            p.viscosity_root = 0.1 * std::abs(uniform(generator));
            for (double& q : p.stress) {
                q = uniform(generator);
            }
            if (wall) {
                p.stress = {p.pressure, 0.0, 0.0, p.pressure};
                p.projector = {0.3, 0.1, 0.1, 0.9};
                p.continuation = column < 8 ? 1.0 : 0.0;
                sample.wall.push_back(p);
            } else {
                sample.fluid.push_back(p);
            }
        }
    }
    return sample;
}

PlainSums plain_sums(const PairSample& sample, KernelKind kernel, ViscosityForm viscosity, double diffusion,
                     double hydrostatic_gradient, const std::vector<std::array<double, 4>>& correction) {
    const std::size_t n = sample.fluid.size();
    const std::size_t m = sample.wall.size();
    PlainSums sums;
    const auto resize = [](auto& arrays, std::size_t size) {
        for (auto& array : arrays) {
            array.resize(size);
        }
    };
    sums.density_rate.resize(n);
    sums.diffusion.resize(n);
    resize(sums.gradient, n);
    resize(sums.m_fluid, n);
    resize(sums.m_wall, n);
    resize(sums.m_continued, n);
    resize(sums.tensor, n);
    resize(sums.viscous, n);
    resize(sums.wall, n);
    sums.zeroth.resize(n);
    sums.mass.resize(n);
    resize(sums.first, n);
    resize(sums.second, n);
    resize(sums.velocity, n);
    sums.wall_weight.resize(m);
    sums.wall_pressure.resize(m);
    sums.wall_density_rate.resize(m);
    resize(sums.wall_offset, m);
    resize(sums.wall_velocity, m);

    struct Pair {
        Vec<2> r{};
        double distance = 0.0;
        KernelValue k;
        Vec<2> gradient{};
    };
    const auto pair_of = [&](const PairSample::Particle& a, const PairSample::Particle& b) {
        Pair pair;
        for (std::size_t k = 0; k < 2; ++k) {
            double d = a.x[k] - b.x[k];
            if (sample.domain.periodic[k]) {
                const double period = sample.domain.upper[k] - sample.domain.lower[k];
                d -= period * std::nearbyint(d / period);
            }
            pair.r[k] = d;
        }
        pair.distance = std::hypot(pair.r[0], pair.r[1]);
        pair.k = kernel_value(kernel, pair.distance, sample.h);
        for (std::size_t k = 0; k < 2; ++k) {
            pair.gradient[k] = pair.distance > 0.0 ? pair.k.slope * pair.r[k] / pair.distance : 0.0;
        }
        return pair;
    };
    const auto viscous_force = [&](const PairSample::Particle& i, const PairSample::Particle& j,
                                   const Pair& p, std::size_t k) {
        if (p.distance == 0.0) {
            return 0.0;
        }
        // Roots of mu; the records hold sqrt(mu/2).
        const double root = 0.5 * (i.viscosity_root + j.viscosity_root);
        const double twice = 2.0 * root * root;
        const double ux = i.u[0] - j.u[0];
        const double uz = i.u[1] - j.u[1];
        if (viscosity == ViscosityForm::morris) {
            return j.volume * twice * p.k.slope / p.distance * (k == 0 ? ux : uz);
        }
        const double approach = (ux * p.r[0] + uz * p.r[1]) / (p.distance * p.distance);
        return 4.0 * j.volume * twice * approach * p.gradient[k];
    };

    for (std::size_t i = 0; i < n; ++i) {
        const PairSample::Particle& a = sample.fluid[i];
        for (const PairSample::Particle& b : sample.fluid) {
            const Pair p = pair_of(a, b);
            const double V = b.volume;
            for (std::size_t k = 0; k < 2; ++k) {
                sums.density_rate[i].add(V * (a.u[k] - b.u[k]) * p.gradient[k]);
                for (std::size_t l = 0; l < 2; ++l) {
                    sums.gradient[2 * k + l][i].add(-V * (a.u[k] - b.u[k]) * p.gradient[l]);
                    sums.tensor[k][i].add(-V * (a.stress[2 * k + l] + b.stress[2 * k + l]) * p.gradient[l]);
                }
                sums.viscous[k][i].add(viscous_force(a, b, p, k));
                sums.first[k][i].add(V * p.k.w * p.r[k]);
                sums.velocity[k][i].add(V * p.k.w * (b.u[k] - a.u[k]));
            }
            if (p.distance > 0.0) {
                sums.diffusion[i].add(diffusion * 2.0 * V * (a.s - b.s + hydrostatic_gradient * p.r[1]) *
                                      p.k.slope / p.distance);
            }
            sums.m_fluid[0][i].add(-V * p.r[0] * p.gradient[0]);
            sums.m_fluid[1][i].add(-V * p.r[0] * p.gradient[1]);
            sums.m_fluid[2][i].add(-V * p.r[1] * p.gradient[1]);
            sums.zeroth[i].add(V * p.k.w);
            sums.mass[i].add(V * (1.0 + b.s) * p.k.w);
            sums.second[0][i].add(V * p.k.w * p.r[0] * p.r[0]);
            sums.second[1][i].add(V * p.k.w * p.r[0] * p.r[1]);
            sums.second[2][i].add(V * p.k.w * p.r[1] * p.r[1]);
        }
        for (const PairSample::Particle& b : sample.wall) {
            const Pair p = pair_of(a, b);
            const double V = b.volume;
            auto& moment = b.continuation > 0.0 ? sums.m_continued : sums.m_wall;
            moment[0][i].add(-V * p.r[0] * p.gradient[0]);
            moment[1][i].add(-V * p.r[0] * p.gradient[1]);
            moment[2][i].add(-V * p.r[1] * p.gradient[1]);
            for (std::size_t k = 0; k < 2; ++k) {
                for (std::size_t l = 0; l < 2; ++l) {
                    sums.density_rate[i].add(V * b.projector[2 * k + l] * a.u[l] * p.gradient[k]);
                    const double identity = k == l ? 1.0 : 0.0;
                    const double matrix = b.continuation > 0.0 ? correction[i][2 * k + l] : identity;
                    const double force = -V * (a.pressure + b.pressure) * matrix * p.gradient[l];
                    sums.tensor[k][i].add(force);
                    sums.wall[k][i].add(force);
                }
                const double force = viscous_force(a, b, p, k);
                sums.viscous[k][i].add(force);
                sums.wall[k][i].add(force);
            }
        }
    }
    for (std::size_t i = 0; i < m; ++i) {
        const PairSample::Particle& a = sample.wall[i];
        for (const PairSample::Particle& b : sample.fluid) {
            const Pair p = pair_of(a, b);
            const double w = p.k.w * sample.h * sample.h;  // the loops leave h^-2 out
            sums.wall_weight[i].add(w);
            sums.wall_pressure[i].add(w * b.pressure);
            for (std::size_t k = 0; k < 2; ++k) {
                sums.wall_offset[k][i].add(w * p.r[k]);
                sums.wall_velocity[k][i].add(w * b.u[k]);
                sums.wall_density_rate[i].add(-b.volume * b.u[k] * p.gradient[k]);
            }
        }
    }
    return sums;
}

namespace {

PositionView<2> view(const std::array<std::vector<double>, 2>& position) {
    return {position[0], position[1]};
}

std::array<std::vector<double>, 2> sorted_positions(const std::vector<PairSample::Particle>& particles,
                                                    const Domain<2>& domain,
                                                    std::vector<std::int32_t>& order) {
    std::array<std::vector<double>, 2> position;
    for (const auto& p : particles) {
        position[0].push_back(p.x[0]);
        position[1].push_back(p.x[1]);
    }
    order = spatial_order<2>(domain, view(position), 2.67 * spacing, 0.5 * spacing);
    std::array<std::vector<double>, 2> sorted;
    for (const std::int32_t i : order) {
        sorted[0].push_back(position[0][static_cast<std::size_t>(i)]);
        sorted[1].push_back(position[1][static_cast<std::size_t>(i)]);
    }
    return sorted;
}

std::size_t slot_of(const std::vector<std::int32_t>& order, const Clusters<2>& clusters,
                    std::size_t particle) {
    for (std::size_t slot = 0; slot < clusters.slots(); ++slot) {
        const std::int32_t i = clusters.particle_of(slot);
        if (i >= 0 && order[static_cast<std::size_t>(i)] == static_cast<std::int32_t>(particle)) {
            return slot;
        }
    }
    return 0;
}

}  // namespace

template <class Real>
LoopRun<Real>::LoopRun(const PairSample& sample, double diffusion, double hydrostatic_gradient,
                       bool correct) {
    const double h = sample.h;
    const auto fluid = sorted_positions(sample.fluid, sample.domain, order);
    clusters = build_clusters<2>(sample.domain, sample.fixed_point, view(fluid), 2.67 * spacing);
    fluid_fluid = build_neighbour_list<2>(clusters, clusters, sample.fixed_point, 2.2 * h);
    data.fluid_fluid = &fluid_fluid;
    for (std::size_t k = 0; k < 2; ++k) {
        data.constants.unit[k] = static_cast<Real>(sample.fixed_point.unit(k) / h);
    }
    data.constants.h = static_cast<Real>(h);
    data.constants.gradient_scale = static_cast<Real>(1.0 / (h * h * h * h));
    data.constants.diffusion = static_cast<Real>(diffusion);
    data.constants.hydrostatic_gradient = static_cast<Real>(hydrostatic_gradient);
    data.constants.correct_pressure = correct;
    data.constants.correct_gradient = correct;

    const std::size_t slots = clusters.slots();
    data.motion.resize(slots + 1);
    data.stress.resize(slots + 1);
    data.pressure.resize(slots + 1);
    for (auto& component : data.correction) {
        component.resize(slots + 1);
    }
    for (std::size_t slot = 0; slot < slots; ++slot) {
        auto& motion = data.motion[slot];
        auto& stress = data.stress[slot];
        motion.x = {clusters.slot_position[0][slot], clusters.slot_position[1][slot]};
        if (clusters.particle_of(slot) < 0) {
            continue;
        }
        const auto& p =
            sample
                .fluid[static_cast<std::size_t>(order[static_cast<std::size_t>(clusters.particle_of(slot))])];
        for (std::size_t k = 0; k < 2; ++k) {
            motion.u[k] = static_cast<Real>(p.u[k]);
        }
        motion.s = static_cast<Real>(p.s);
        motion.volume = static_cast<Real>(p.volume);
        for (std::size_t k = 0; k < 4; ++k) {
            stress.stress[k] = static_cast<Real>(p.stress[k]);
        }
        stress.viscosity_root = static_cast<Real>(viscosity_root(p.viscosity_root * p.viscosity_root));
        stress.weight = motion.volume;
        stress.pressure = static_cast<Real>(p.pressure);
        data.pressure[slot] = {.stress = {stress.pressure},
                               .viscosity_root = stress.viscosity_root,
                               .weight = stress.weight,
                               .pressure = stress.pressure};
    }
    if (sample.wall.empty()) {
        return;
    }
    const auto wall_positions = sorted_positions(sample.wall, sample.domain, wall_order);
    wall_clusters =
        build_clusters<2>(sample.domain, sample.fixed_point, view(wall_positions), 2.67 * spacing);
    fluid_wall = build_neighbour_list<2>(clusters, wall_clusters, sample.fixed_point, 2.2 * h);
    wall_fluid = build_neighbour_list<2>(wall_clusters, clusters, sample.fixed_point, 2.2 * h);
    data.fluid_wall = &fluid_wall;
    data.wall_fluid = &wall_fluid;
    const std::size_t wall_slots = wall_clusters.slots();
    data.wall_gradient.resize(wall_slots + 1);
    data.wall_force.resize(wall_slots + 1);
    for (std::size_t slot = 0; slot < wall_slots; ++slot) {
        auto& of_gradient = data.wall_gradient[slot];
        auto& of_force = data.wall_force[slot];
        of_gradient.x = {wall_clusters.slot_position[0][slot], wall_clusters.slot_position[1][slot]};
        of_force.x = of_gradient.x;
        if (wall_clusters.particle_of(slot) < 0) {
            continue;
        }
        const auto& p = sample.wall[static_cast<std::size_t>(
            wall_order[static_cast<std::size_t>(wall_clusters.particle_of(slot))])];
        for (std::size_t k = 0; k < 4; ++k) {
            of_gradient.projector[k] = static_cast<Real>(p.projector[k]);
        }
        for (std::size_t k = 0; k < 2; ++k) {
            of_force.u[k] = static_cast<Real>(p.u[k]);
        }
        of_gradient.volume = static_cast<Real>(p.volume);
        of_gradient.continuation = static_cast<Real>(p.continuation);
        of_force.pressure = static_cast<Real>(p.pressure);
        of_force.continuation = of_gradient.continuation;
        of_force.viscous_weight = of_gradient.volume;
        of_force.weight = of_gradient.volume;
        of_force.viscosity_root = static_cast<Real>(viscosity_root(p.viscosity_root * p.viscosity_root));
    }
}

namespace {

/// Copy the lanes of a block to the slots of the whole.
template <class Real>
void collect(const LaneArray<Real>& lanes, std::size_t begin, std::size_t end, std::vector<Real>& all) {
    all.resize(std::max(all.size(), end * cluster_size));
    std::copy_n(lanes.begin(), (end - begin) * cluster_size,
                all.begin() + static_cast<std::ptrdiff_t>(begin * cluster_size));
}
template <std::size_t N, class Real>
void collect(const std::array<LaneArray<Real>, N>& lanes, std::size_t begin, std::size_t end,
             std::array<std::vector<Real>, N>& all) {
    for (std::size_t k = 0; k < N; ++k) {
        collect(lanes[k], begin, end, all[k]);
    }
}

}  // namespace

template <class Real>
void LoopRun<Real>::run(const PairLoops<2, Real>& loops) {
    const auto work = std::make_unique<BlockWork<2, Real>>();
    work->slots.resize(
        std::max({fluid_fluid.buffer_size(), fluid_wall.buffer_size(), wall_fluid.buffer_size()}));
    const auto blocks = [&](std::size_t n, const auto& f) {
        for (std::size_t begin = 0; begin < n; begin += block_clusters) {
            f(begin, std::min(n, begin + block_clusters));
        }
    };
    blocks(clusters.size(), [&](std::size_t begin, std::size_t end) {
        loops.gradient(data, begin, end, *work);
        const auto& result = work->gradient;
        collect(result.density_rate, begin, end, gradient.density_rate);
        collect(result.diffusion, begin, end, gradient.diffusion);
        collect(result.viscosity_factor, begin, end, gradient.viscosity_factor);
        collect(result.regularity, begin, end, gradient.regularity);
        collect(result.velocity_gradient, begin, end, gradient.velocity_gradient);
        collect(result.correction, begin, end, gradient.correction);
        collect(result.correction, begin, end, data.correction);
    });
    for (auto& component : data.correction) {
        component.resize(clusters.slots() + 1);
    }
    if (data.wall_fluid != nullptr) {
        blocks(wall_clusters.size(), [&](std::size_t begin, std::size_t end) {
            loops.wall(data, begin, end, *work);
            const auto& result = work->wall;
            collect(result.weight, begin, end, wall.weight);
            collect(result.pressure, begin, end, wall.pressure);
            collect(result.density_rate, begin, end, wall.density_rate);
            collect(result.offset, begin, end, wall.offset);
            collect(result.velocity, begin, end, wall.velocity);
        });
    }
    blocks(clusters.size(), [&](std::size_t begin, std::size_t end) {
        loops.force(data, begin, end, *work);
        collect(work->force.tensor, begin, end, force.tensor);
        collect(work->force.viscous, begin, end, force.viscous);
        collect(work->force.wall, begin, end, force.wall);
        loops.filter(data, begin, end, *work);
        const auto& result = work->filter;
        collect(result.zeroth, begin, end, filter.zeroth);
        collect(result.mass, begin, end, filter.mass);
        collect(result.first, begin, end, filter.first);
        collect(result.mass_first, begin, end, filter.mass_first);
        collect(result.velocity, begin, end, filter.velocity);
        collect(result.second, begin, end, filter.second);
    });
}

template <class Real>
std::size_t LoopRun<Real>::fluid_slot(std::size_t particle) const {
    return slot_of(order, clusters, particle);
}

template <class Real>
std::size_t LoopRun<Real>::wall_slot(std::size_t particle) const {
    return slot_of(wall_order, wall_clusters, particle);
}

template struct LoopRun<float>;
template struct LoopRun<double>;

}  // namespace riffle
