#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <vector>

#include "ends/open_ends_state.hpp"
#include "engine/flow.hpp"

namespace riffle::inline components {

/// What is seen of the water beside the open ends, inside of the channel: means under a hat of
/// watched_stretch(), so that a row of evenly spaced particles counts alike wherever it stands under it.
template <int D, class Real>
class EndWatch {
  public:
    using Flow = FlowOf<D, Real>;

    /// Depth, mean velocity and pressure over the density of the water beside an end; its largest velocity.
    struct Watched {
        double depth = 0.0;
        double velocity = 0.0;
        double pressure = 0.0;
        double fastest = 0.0;

        /// Let an end see them, smoothed in time.
        void smooth_into(EndState& end, double share) const {
            end.watched_depth += share * (depth - end.watched_depth);
            end.watched_velocity += share * (velocity - end.watched_velocity);
            end.watched_pressure += share * (pressure - end.watched_pressure);
        }
    };

    /// `half`: of the stretch that is watched, m: whole spacings.
    EndWatch(double length, double half) : length_(length), half_(half) {}

    [[nodiscard]] double half() const { return half_; }
    /// Weight of the water at a distance from an end inside of the channel.
    [[nodiscard]] double hat_at(double distance) const {
        return std::max(0.0, 1.0 - std::abs(distance - half_) / half_);
    }

    /// The particles near an end (0: the inflow) until the next list build.
    void clear() { particles_ = {}; }
    void add(std::size_t end, std::size_t particle) { particles_[end].push_back(particle); }
    [[nodiscard]] const std::vector<std::size_t>& near(std::size_t end) const { return particles_[end]; }

    [[nodiscard]] Watched watch(const Flow& flow, std::size_t end) const {
        const Particles<D>& p = flow.particles;
        const double width = flow.c.channel.flow_width();
        Watched sums;
        for (const std::size_t i : particles_[end]) {
            const double x = end == 0 ? p.position[0][i] : length_ - p.position[0][i];
            const double u = p.velocity[0][i];
            const double hat = p.mass[i] / (1.0 + p.density_deviation[i]) * hat_at(x);
            sums.fastest = std::max(sums.fastest, std::abs(u));
            sums.depth += hat;
            sums.velocity += hat * u;
            sums.pressure += hat * flow.scheme.state.pressure(p.density_deviation[i]);
        }
        sums.velocity /= sums.depth > 0.0 ? sums.depth : 1.0;
        sums.pressure /= sums.depth > 0.0 ? sums.depth : 1.0;
        sums.depth /= flow.scheme.density * half_ * width;
        return sums;
    }

    [[nodiscard]] std::size_t bytes() const {
        return (particles_[0].capacity() + particles_[1].capacity()) * sizeof(std::size_t);
    }

  private:
    double length_;
    double half_;
    std::array<std::vector<std::size_t>, 2> particles_;
};

}  // namespace riffle::inline components
