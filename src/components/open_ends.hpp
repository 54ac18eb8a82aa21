#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>
#include <vector>

#include "case/end_buffers.hpp"
#include "case/end_levels.hpp"
#include "components/end_exchange.hpp"
#include "components/end_profiles.hpp"
#include "components/end_sound.hpp"
#include "components/end_watch.hpp"
#include "ends/inflow_streams.hpp"
#include "engine/component.hpp"
#include "particles/lattice.hpp"

namespace riffle::inline components {

/// The open ends of a channel (docs/theory.md 20). Beyond each stands a buffer of ordinary particles, whose
/// motion and density are those of a section: its depth and velocity follow from what the case gives and from
/// the characteristics that come out of the channel. Particles are made and taken out when lists are built.
template <int D, class Real>
class OpenEnds final : public Component<D, Real> {
  public:
    using typename Component<D, Real>::Flow;
    using typename Component<D, Real>::Task;

    explicit OpenEnds(Flow& flow)
        : lattice_(lattice_of(flow.c)),
          length_(flow.c.channel.length),
          falls_(bed_ends(flow.c)),
          follows_tide_(tailwater_changes(flow.c)),
          profiles_(flow, lattice_),
          travel_(end_travel(flow.c)),
          support_(end_support(flow.c)),
          watch_(length_, watched_spacings(flow.c) * lattice_.dx),
          sound_(flow, lattice_, watch_.half(), support_ + travel_ + 2.0 * lattice_.dx),
          streams_(lattice_.files, lattice_.dx * lattice_.dz, lattice_.dz, -(support_ + travel_),
                   profiles_.upstream()) {
        flow.inputs.acceleration = true;
        begin(flow);
    }

    /// Particles that have left are taken out, those that enter are made.
    void before_lists(Flow& flow) override {
        OpenEndsState& state = flow.clock.open_ends;
        state.travel = 0.0;
        take_out(flow);
        streams_.rearrange(state, state.upstream.depth);
        if (inflow_is_strained(flow)) lay_inflow_anew(flow);
        make(flow);
        // What stands beyond the ends before the first step is of the start.
        if (flow.clock.steps == 0) state.ledger = {};
    }

    [[nodiscard]] bool lists_expired(const Flow& flow) const override {
        return flow.clock.open_ends.travel > travel_;
    }

    /// Which clusters and particles stand at the ends until the next build.
    void lists_built(const Flow& flow) override {
        const auto& slots = flow.clusters.slot_position[0];
        const double upstream = 2.0 * watch_.half() + 2.0 * travel_;
        near_end_.assign(flow.clusters.size(), 0);
        watch_.clear();
        for (std::size_t cluster = 0; cluster < flow.clusters.size(); ++cluster) {
            const auto first = static_cast<std::size_t>(flow.clusters.begin[cluster]);
            const auto count = static_cast<std::size_t>(flow.clusters.count(cluster));
            for (std::size_t n = 0; n < count; ++n) {
                const double x = flow.fixed_point.decode(slots[cluster * cluster_size + n], 0);
                const bool at_start = x < upstream;
                const bool at_end = x > length_ - upstream;
                near_end_[cluster] |= static_cast<std::uint8_t>(at_start || at_end);
                if (at_start) watch_.add(0, first + n);
                if (at_end) watch_.add(1, first + n);
            }
        }
    }

    void begin_step(Flow& flow, double dt) override {
        OpenEndsState& state = flow.clock.open_ends;
        step_ = dt;
        const double smoothing =
            std::min(1.0, dt / (2.0 * watch_.half() / sections().signal_speed(flow.scheme.depth)));
        const auto start = profiles_.watched(flow, watch_, 0);
        const auto end = profiles_.watched(flow, watch_, 1);
        start.smooth_into(state.upstream, smoothing);
        end.smooth_into(state.downstream, smoothing);
        sections().follow_upstream(state.upstream, flow.clock.time, dt);
        sections().follow_downstream(state.downstream, flow.clock.time, dt);
        follow_sound(flow, dt);
        profiles_.follow_leaving(flow, watch_, state, dt);
        profiles_.go_to_now(flow);
        fastest_ = std::max(start.fastest, end.fastest);
    }

    void begin_evaluation(Flow& /*flow*/, const Stage& stage) override { kick_ = stage.velocity_step(); }

    void complete_gradients(Flow& flow, Task& task, std::size_t begin, std::size_t end) override {
        for_buffers(flow, begin, end, [&](std::size_t i, std::size_t lane, bool entering) {
            if (falls_ && !entering) return;
            const EndState& section =
                entering ? flow.clock.open_ends.upstream : flow.clock.open_ends.downstream;
            flow.particles.density_deviation[i] = flow.scheme.state.deviation(
                profiles_.pressure_of(section, profiles_.over_floor(flow, i, entering)) +
                sound_at(flow, i, entering));
            task.sums.gradient.density_rate[lane] = Real(0);
            task.sums.gradient.diffusion[lane] = Real(0);
            task.sums.gradient.regularity[lane] = Real(1);
        });
    }

    void add_forces(Flow& flow, Task& task, std::size_t begin, std::size_t end) override {
        const auto first = static_cast<std::size_t>(flow.clusters.begin[begin]);
        for_buffers(flow, begin, end, [&](std::size_t i, std::size_t lane, bool entering) {
            task.particles.drag[i - first] = 0.0;
            if (falls_ && !entering) {
                // No stems stand beyond the edge of the bed.
                for (std::size_t k = 0; flow.with_vegetation && k < Flow::axes; ++k) {
                    task.particles.acceleration[k][lane] -= task.vegetation_acceleration[k][lane];
                    task.vegetation_acceleration[k][lane] = 0.0;
                }
                return;
            }
            const Vec<D> wanted = entering ? entering_velocity(flow, i) : leaving_velocity(flow, i);
            for (std::size_t k = 0; k < Flow::axes; ++k) {
                if (flow.with_vegetation) task.vegetation_acceleration[k][lane] = 0.0;
                task.sums.force.tensor[k][lane] = Real(0);
                task.sums.force.viscous[k][lane] = Real(0);
                task.particles.acceleration[k][lane] =
                    (wanted[k] - flow.particles.velocity[k][i]) / kick_ - flow.particle_data.gravity[k];
            }
        });
    }

    void end_step(Flow& flow) override {
        OpenEndsState& state = flow.clock.open_ends;
        const EndState& end = state.upstream;
        streams_.advance(state, step_, spreading(end, true), [&](int row, int file) {
            return end.velocity * profiles_.entering_in_stream(row, file, state.rows) /
                   profiles_.entering_mean();
        });
        state.travel += step_ * std::max(fastest_, std::abs(end.velocity) * profiles_.entering().fastest());
    }

    [[nodiscard]] std::size_t bytes() const override {
        return near_end_.capacity() + watch_.bytes() + profiles_.entering().bytes();
    }

  private:
    [[nodiscard]] const EndSections& sections() const { return profiles_.sections(); }

    /// See the particles as they stand, before any list.
    void look(const Flow& flow) {
        watch_.clear();
        const auto& x = flow.particles.position[0];
        for (std::size_t i = 0; i < x.size(); ++i) {
            watch_.add(0, i);
            watch_.add(1, i);
        }
    }

    void begin(Flow& flow) {
        OpenEndsState& state = flow.clock.open_ends;
        if (state.begun) return;
        state.begun = true;
        if (flow.c.start.kind == StartKind::results) {
            // The particles say it.
            look(flow);
            const auto section = [&](std::size_t end) {
                const auto water = profiles_.watched(flow, watch_, end);
                // A duct is as high as it is.
                const double depth = sections().in_duct()
                                         ? flow.c.total_depth() - (end == 0 ? profiles_.floors().upstream
                                                                            : profiles_.floors().downstream)
                                         : std::max(water.depth, lattice_.dz);
                const LongWaves& waves = sections().waves(end == 0);
                return sections().start(depth, waves.area(depth) * water.velocity, end == 0);
            };
            state.upstream = section(0);
            state.downstream = section(1);
        } else {
            const auto depth = start_depths(flow.c, sections().input());
            const double q =
                flow.c.start.kind == StartKind::rest ? 0.0 : start_unit_discharge(flow.c, sections().input());
            state.upstream = sections().start(depth(0.0) - profiles_.floors().upstream, q);
            state.upstream.depth = std::max(state.upstream.depth, lattice_.dz);
            state.downstream =
                sections().start(std::max(0.0, depth(length_) - profiles_.floors().downstream), q, false);
        }
        profiles_.begin_leaving(state);
        streams_.begin(state, streams_.rows_for(state.upstream.depth), 0.5 * lattice_.dx);
    }

    void follow_sound(Flow& flow, double dt) {
        if (sections().in_duct()) return;
        OpenEndsState& state = flow.clock.open_ends;
        const auto follow = [&](std::size_t end, SoundBeyondEnd& sound, const EndState& section) {
            const auto height = [&](std::size_t i) { return profiles_.over_floor(flow, i, end == 0); };
            sound_.advance(
                flow, watch_, end, sound, section,
                [&](std::size_t i) { return profiles_.pressure_of(section, height(i)); }, height, dt);
        };
        follow(0, state.sound_upstream, state.upstream);
        if (!falls_) follow(1, state.sound_downstream, state.downstream);
    }

    /// Pressure over the density of the sound at a particle beyond an end.
    [[nodiscard]] double sound_at(const Flow& flow, std::size_t i, bool entering) const {
        const OpenEndsState& state = flow.clock.open_ends;
        return entering ? sound_.at(flow, 0, state.sound_upstream.now, i, profiles_.over_floor(flow, i, true),
                                    state.upstream)
                        : sound_.at(flow, 1, state.sound_downstream.now, i,
                                    profiles_.over_floor(flow, i, false), state.downstream);
    }

    /// -dU/dx of the water beyond an end, 1/s. It rises and falls with a tailwater that changes: where what
    /// goes on along it did not change by as much, its rows would be drawn apart and pressed together, and a
    /// tide would bring too little water in.
    [[nodiscard]] double spreading(const EndState& end, bool entering) const {
        return follows_tide_ ? end.depth_rate * profiles_.widening(end, entering) : 0.0;
    }

    /// In its stream, that is straight; the motions across it begin within one support of the channel, over
    /// which they grow to their size.
    [[nodiscard]] Vec<D> entering_velocity(const Flow& flow, std::size_t i) const {
        const EndState& end = flow.clock.open_ends.upstream;
        const double place = profiles_.over_floor(flow, i, true) / end.depth;
        const double y = across_of<D>(flow.particles.position, i);
        const Vec<3> relative = profiles_.entering_at(y, place);
        const double grown = std::clamp(1.0 + flow.particles.position[0][i] / support_, 0.0, 1.0);
        Vec<D> u{};
        u[0] = end.velocity * relative[0] / profiles_.entering_mean() +
               sound_.velocity_of(0, sound_at(flow, i, true));
        u[0] -= flow.particles.position[0][i] * spreading(end, true);
        if constexpr (D == 3) u[1] = grown * end.velocity * relative[1] / profiles_.entering_mean();
        u[Flow::vertical] = profiles_.rise(flow, i, end, true) +
                            grown * end.velocity * relative[2] / profiles_.entering_mean();
        return u;
    }

    /// What leaves goes over to the profile of its section, and to rest across.
    [[nodiscard]] Vec<D> leaving_velocity(const Flow& flow, std::size_t i) const {
        const Vec<D> wanted = leaving_section(flow, i);
        const double kept = std::exp(
            -step_ * profiles_.leaving_speed(flow.clock.open_ends, flow.clock.open_ends.downstream.depth) /
            watch_.half());
        Vec<D> u = vector_of(flow.particles.velocity, i);
        for (std::size_t k = 0; k < Flow::axes; ++k) u[k] = wanted[k] + kept * (u[k] - wanted[k]);
        const OpenEndsState& state = flow.clock.open_ends;
        const double change = sound_.at(flow, 1, state.sound_downstream.change, i,
                                        profiles_.over_floor(flow, i, false), state.downstream);
        u[0] += sound_.velocity_of(1, change);
        return u;
    }

    /// The velocity of the section at the outflow at the height of a particle.
    [[nodiscard]] Vec<D> leaving_section(const Flow& flow, std::size_t i) const {
        const EndState& end = flow.clock.open_ends.downstream;
        Vec<D> u{};
        u[0] = profiles_.leaving_velocity(flow, i);
        u[0] -= (flow.particles.position[0][i] - length_) * spreading(end, false);
        u[Flow::vertical] = profiles_.rise(flow, i, end, false);
        return u;
    }

    /// f(particle, lane, whether it enters) for the particles of a block that stand in a buffer, or fall
    /// over the edge of the bed.
    template <class F>
    void for_buffers(const Flow& flow, std::size_t begin, std::size_t end, const F& f) const {
        for (std::size_t cluster = begin; cluster < end; ++cluster) {
            if (near_end_[cluster] == 0) continue;
            flow.for_clusters(cluster, cluster + 1, [&](std::size_t first, std::size_t last, std::size_t) {
                for (std::size_t i = first; i < last; ++i) {
                    const double x = flow.particles.position[0][i];
                    if (x < 0.0 || x >= length_) {
                        f(i, (cluster - begin) * cluster_size + (i - first), x < 0.0);
                    }
                }
            });
        }
    }

    /// Whether a particle is so far below the edge of the bed that its pressure is none.
    [[nodiscard]] bool has_fallen(const Particles<D>& p, std::size_t i) const {
        return p.position[0][i] > length_ && p.position[Flow::vertical][i] < -support_;
    }

    void take_out(Flow& flow) {
        const auto& x = flow.particles.position[0];
        const double from = -(support_ + travel_) - 2.0 * lattice_.dx;
        const double to = length_ + support_ + (falls_ ? 0.5 * flow.scheme.depth : 0.0);
        take_out_with_account(flow, TakenOut::left, [&](std::size_t i) {
            return x[i] < from || x[i] > to || (falls_ && has_fallen(flow.particles, i));
        });
    }

    /// Whether the particles that wait before the inflow take up another room than the water of its section:
    /// where the depth changes faster than they go in, they are pressed together or drawn apart with it.
    [[nodiscard]] bool inflow_is_strained(const Flow& flow) const {
        constexpr double most = 0.2;
        const Particles<D>& p = flow.particles;
        const double half = 0.5 * support_;
        double volume = 0.0;
        for (std::size_t i = 0; i < p.size(); ++i) {
            const double hat = 1.0 - std::abs(p.position[0][i] + half) / half;
            if (hat > 0.0) volume += hat * p.mass[i] / (1.0 + p.density_deviation[i]);
        }
        const double width = flow.c.channel.flow_width();
        const double due = flow.scheme.density * half * width *
                           sections().upstream().area(flow.clock.open_ends.upstream.depth);
        return volume > 0.0 && std::abs(volume - due) > most * due;
    }

    /// Take out the water before the inflow; its streams are filled again from the channel on.
    void lay_inflow_anew(Flow& flow) {
        OpenEndsState& state = flow.clock.open_ends;
        take_out_with_account(flow, TakenOut::not_entered,
                              [&](std::size_t i) { return flow.particles.position[0][i] < 0.0; });
        streams_.begin(state, state.rows, 0.5 * streams_.length(state.rows, state.upstream.depth));
    }

    void make(Flow& flow) {
        OpenEndsState& state = flow.clock.open_ends;
        const EndState& end = state.upstream;
        profiles_.go_to_now(flow);
        // After a restore they know nothing of the last step.
        if (flow.clock.steps > 0) profiles_.go_on(state);
        const auto add = [&](const std::vector<Vec<D>>& places, bool entering, const auto& velocity) {
            const EndState& section = entering ? state.upstream : state.downstream;
            const auto pressure = [&](std::size_t i) {
                return profiles_.pressure_of(section, profiles_.over_floor(flow, i, entering));
            };
            add_with_account(flow, lattice_.volume(), places, pressure, velocity);
        };
        const EndRows before{.rows = state.rows, .depth = end.depth, .floor = profiles_.floors().upstream};
        std::vector<Vec<D>> places;
        streams_.fill(state, end.depth, [&](int row, int file, double x) {
            places.push_back(place_in_rows<D>(lattice_, streams_, before, row, file, x));
        });
        add(places, true, [&](std::size_t i) { return entering_velocity(flow, i); });
        if (falls_ || state.downstream.velocity >= 0.0) return;
        const double depth = std::max(state.downstream.depth, lattice_.dz);
        const EndRows behind{
            .rows = streams_.rows_for(depth), .depth = depth, .floor = profiles_.floors().downstream};
        add(gaps_behind_outflow(flow.particles, lattice_, streams_, profiles_.downstream(), behind, length_,
                                support_, flow.scheme.density,
                                sections().downstream().area(depth) * flow.c.channel.flow_width()),
            false, [&](std::size_t i) { return leaving_section(flow, i); });
    }

    Lattice lattice_;
    double length_;
    bool falls_;         ///< over the edge of the bed at x = L
    bool follows_tide_;  ///< the tailwater changes
    EndProfiles<D, Real> profiles_;
    double travel_;   ///< of water at an end from list build to list build, m
    double support_;  ///< water that must stand beyond an end, m
    EndWatch<D, Real> watch_;
    EndSound<D, Real> sound_;
    InflowStreams streams_;
    std::vector<std::uint8_t> near_end_;  ///< by cluster
    double step_ = 0.0;                   ///< dt of the step in progress
    double kick_ = 0.0;                   ///< dt of the velocities
    double fastest_ = 0.0;                ///< at the ends, m/s
};

template <int D, class Real>
std::unique_ptr<Component<D, Real>> make_open_ends(FlowOf<D, Real>& flow) {
    return flow.c.channel.ends == Ends::open ? std::make_unique<OpenEnds<D, Real>>(flow) : nullptr;
}

}  // namespace riffle::inline components
