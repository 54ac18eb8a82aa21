#pragma once

#include <array>
#include <memory>
#include <random>
#include <vector>

#include "../particles/cloud.hpp"
#include "sph/particle_loops.hpp"

namespace riffle {

/// Particles at random places, with random states and random results of the pair sums, for the loops over
/// particles. With few particles per column most clusters are not full.
template <int D, class Real>
struct ParticleSet {
    static constexpr std::size_t axes = D;
    Cloud<D> cloud;
    std::array<std::vector<double>, static_cast<std::size_t>(D)> position;
    std::array<std::vector<double>, static_cast<std::size_t>(D)> start;  ///< positions before the step
    std::array<std::vector<double>, static_cast<std::size_t>(D)> velocity;
    std::vector<double> density_deviation;
    std::vector<double> mass;
    ParticleData<D> particles;
    PairData<D, Real> records;
    std::unique_ptr<BlockWork<D, Real>> sums = std::make_unique<BlockWork<D, Real>>();
    std::unique_ptr<ParticleWork<D, Real>> work = std::make_unique<ParticleWork<D, Real>>();
    Displacement<D> moved;
    std::size_t end = 0;  ///< clusters of the block that the tests treat

    /// `count` particles in a box of about 1 m, periodic across the bed; at most block_clusters clusters of
    /// them are used.
    ParticleSet(std::size_t count, std::uint64_t seed)
        : cloud(random_cloud<D>(domain(), count, 0.3, seed)), generator_(seed) {
        position = cloud.position;
        for (auto& component : velocity) fill(component, count, -1.0, 1.0);
        fill(density_deviation, count, -0.02, 0.02);
        fill(mass, count, 900.0, 1100.0);
        for (std::size_t k = 0; k < axes; ++k) {
            particles.position[k] = position[k].data();
            particles.velocity[k] = velocity[k].data();
            particles.gravity[k] = uniform(-10.0, 10.0);
        }
        particles.density_deviation = density_deviation.data();
        particles.mass = mass.data();
        particles.domain = cloud.domain;
        particles.fixed_point = cloud.fixed_point;
        for (std::size_t k = 0; k < axes; ++k) {
            particles.stay_from[k] = cloud.fixed_point.lowest(k);
            particles.stay_to[k] = cloud.fixed_point.highest(k);
        }
        particles.state.sound_speed = 20.0;
        particles.density = 1000.0;
        particles.viscosity = 1e-3;
        particles.clusters = &cloud.clusters;
        records.motion.resize(cloud.clusters.slots() + 1);
        moved.resize(cloud.clusters.size());
        end = std::min(cloud.clusters.size(), block_clusters);
        fill_sums();
    }
    ParticleSet(const ParticleSet&) = delete;
    ParticleSet& operator=(const ParticleSet&) = delete;
    ParticleSet(ParticleSet&&) = delete;
    ParticleSet& operator=(ParticleSet&&) = delete;
    ~ParticleSet() = default;

    static Domain<D> domain() {
        Domain<D> d;
        for (std::size_t k = 0; k < axes; ++k) {
            d.lower[k] = k + 1 < axes ? 0.0 : -0.3;
            d.upper[k] = 1.0 - 0.1 * static_cast<double>(k);
            d.periodic[k] = k + 1 < axes;
        }
        return d;
    }

    [[nodiscard]] double uniform(double low, double high) {
        return std::uniform_real_distribution<double>(low, high)(generator_);
    }

    /// Call f(particle, slot, lane) for the particles of the block.
    template <class F>
    void for_particles(const F& f) const {
        for (std::size_t slot = 0; slot < end * cluster_size; ++slot) {
            if (cloud.clusters.particle_of(slot) >= 0) {
                f(static_cast<std::size_t>(cloud.clusters.particle_of(slot)), slot, slot);
            }
        }
    }

  private:
    void fill(std::vector<double>& values, std::size_t count, double low, double high) {
        values.resize(count);
        for (double& value : values) value = uniform(low, high);
    }
    /// Random lanes; empty ones repeat the last particle's, as the pair sums leave them.
    template <class Value>
    void fill(LaneArray<Value>& lanes, double low, double high) {
        for (std::size_t lane = 0; lane < block_lanes; ++lane) {
            const bool empty = lane < end * cluster_size && cloud.clusters.particle_of(lane) < 0;
            lanes[lane] = empty ? lanes[lane - 1] : static_cast<Value>(uniform(low, high));
        }
    }
    template <class Value, std::size_t N>
    void fill(std::array<LaneArray<Value>, N>& lanes, double low, double high) {
        for (auto& component : lanes) fill(component, low, high);
    }
    void fill_sums() {
        fill(sums->gradient.density_rate, -1.0, 1.0);
        fill(sums->gradient.diffusion, -1.0, 1.0);
        fill(sums->gradient.velocity_gradient, -5.0, 5.0);
        fill(sums->gradient.correction, -1.0, 1.0);
        fill(sums->gradient.viscosity_factor, 0.9, 1.2);
        fill(sums->gradient.regularity, 0.0, 1.0);
        fill(sums->force.tensor, -10.0, 10.0);
        fill(sums->force.viscous, -10.0, 10.0);
        fill(work->mixing_length, 0.0, 0.1);
        fill(work->drag, 0.0, 5.0);
        work->drag_clusters = 0xfffffffbU;  // the drag acts in all clusters but one
        fill(work->acceleration, -3.0, 3.0);
        fill(work->transport, -0.5, 0.5);
    }

    std::mt19937_64 generator_;
};

}  // namespace riffle
