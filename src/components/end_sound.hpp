#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>

#include "components/end_watch.hpp"
#include "ends/outgoing_sound.hpp"
#include "engine/flow.hpp"
#include "particles/lattice.hpp"

namespace riffle::inline components {

/// Sound that leaves an open channel through its ends: what the water before an end has of it goes on through
/// the buffer beyond. Not of a duct, whose sections are those of sound already, nor where the water is a
/// film.
template <int D, class Real>
class EndSound {
  public:
    using Flow = FlowOf<D, Real>;

    /// `half` as of EndWatch, `buffer`: length of the water beyond an end, m.
    EndSound(const Flow& flow, const Lattice& lattice, double half, double buffer)
        : half_(half),
          length_(flow.c.channel.length),
          width_(flow.c.channel.flow_width()),
          least_depth_(4.0 * lattice.dz),
          sound_speed_(flow.scheme.state.sound_speed),
          upstream_(grid(lattice, half + buffer)),
          downstream_(grid(lattice, half + buffer)) {}

    /// Follow the sound for dt (s). `pressure_of(particle)`: that of the section at its height, over the
    /// density; `height_of(particle)`: over the floor, m.
    template <class Pressure, class Height>
    void advance(const Flow& flow, const EndWatch<D, Real>& watch, std::size_t end, SoundBeyondEnd& sound,
                 const EndState& section, const Pressure& pressure_of, const Height& height_of, double dt) {
        OutgoingSound& outgoing = end == 0 ? upstream_ : downstream_;
        const double gravity = flow.scheme.normal_gravity;
        outgoing.clear();
        const double depth = std::max(section.depth, least_depth_);
        for (const std::size_t i : watch.near(end)) {
            if (section.depth <= least_depth_) break;  // a film has none
            const Particles<D>& p = flow.particles;
            const double hat = watch.hat_at(end == 0 ? p.position[0][i] : length_ - p.position[0][i]);
            if (hat <= 0.0) continue;
            outgoing.add(place(flow, i, height_of(i), section), hat * p.mass[i],
                         flow.scheme.state.pressure(p.density_deviation[i]) - pressure_of(i));
        }
        const double full =
            flow.scheme.density * half_ * width_ * depth / static_cast<double>(outgoing.bins());
        const double along = end == 0 ? -section.velocity : section.velocity;
        outgoing.advance(sound, sound_speed_ / cosine + along, std::sqrt(depth / gravity), full,
                         gravity * depth, dt);
    }

    /// Pressure over the density of the sound at a particle beyond an end, or its change in the last step.
    [[nodiscard]] double at(const Flow& flow, std::size_t end, const std::vector<double>& nodes,
                            std::size_t i, double height, const EndState& section) const {
        const OutgoingSound& outgoing = end == 0 ? upstream_ : downstream_;
        const double x = flow.particles.position[0][i];
        const double beyond = end == 0 ? -x : x - length_;
        return outgoing.at(nodes, half_ + beyond, place(flow, i, height, section));
    }

    /// Velocity along the channel that goes with a pressure over the density: outwards.
    [[nodiscard]] double velocity_of(std::size_t end, double pressure) const {
        return cosine * (end == 0 ? -pressure : pressure) / sound_speed_;
    }

  private:
    /// Under a free surface sound runs along the channel at an angle, for it goes up and down as well: that
    /// of waves two depths long is 27 degrees, of four depths 45. What runs at 37 comes back least.
    static constexpr double cosine = 0.8;

    [[nodiscard]] static OutgoingSound::Grid grid(const Lattice& lattice, double length) {
        return {.spacing = lattice.dx,
                .length = length,
                .bins_upright = std::max(2, lattice.rows / 2),
                .bins_across = D == 3 ? std::max(1, lattice.files / 2) : 1};
    }

    [[nodiscard]] OutgoingSound::Place place(const Flow& flow, std::size_t i, double height,
                                             const EndState& section) const {
        return {.upright = height / std::max(section.depth, least_depth_),
                .across = D == 3 ? across_of<D>(flow.particles.position, i) / width_ : 0.0};
    }

    double half_;
    double length_;
    double width_;
    double least_depth_;
    double sound_speed_;
    OutgoingSound upstream_;
    OutgoingSound downstream_;
};

}  // namespace riffle::inline components
