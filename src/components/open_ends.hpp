#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>
#include <vector>

#include "ends/end_input.hpp"
#include "ends/inflow_streams.hpp"
#include "ends/section_state.hpp"
#include "engine/component.hpp"
#include "particles/end_buffers.hpp"
#include "particles/lattice.hpp"

namespace riffle {

/// The open ends of a channel (docs/theory.md 20). Beyond each stands a buffer of ordinary particles, whose
/// motion and density are those of a section: its depth and velocity follow from what the case gives and from
/// the characteristics that come out of the channel. Particles are made and taken out when lists are built.
template <int D, class Real>
class OpenEnds final : public Component<D, Real> {
  public:
    using typename Component<D, Real>::Flow;
    using typename Component<D, Real>::Task;

    explicit OpenEnds(Flow& flow)
        : input_(read_end_input(flow.c)),
          lattice_(lattice_of(flow.c)),
          length_(flow.c.channel.length),
          gravity_(flow.scheme.normal_gravity),
          travel_(end_travel(flow.c)),
          support_(end_support(flow.c)),
          watch_(std::ceil(2.0 * flow.c.numerics.smoothing_ratio - 1e-9) * lattice_.dx),
          streams_(D == 3 ? lattice_.files : 1, lattice_.dx * lattice_.dz, lattice_.dz,
                   -(support_ + travel_)) {
        flow.inputs.acceleration = true;
        begin(flow);
    }

    /// Particles that have left are taken out, those that enter are made.
    void before_lists(Flow& flow) override {
        OpenEndsState& state = flow.clock.open_ends;
        state.travel = 0.0;
        take_out(flow);
        streams_.rearrange(state, state.upstream.depth);
        make(flow);
    }

    [[nodiscard]] bool lists_expired(const Flow& flow) const override {
        return flow.clock.open_ends.travel > travel_;
    }

    /// Which clusters and particles stand at the ends until the next build.
    void lists_built(const Flow& flow) override {
        const auto& slots = flow.clusters.slot_position[0];
        const double upstream = 2.0 * watch_ + 2.0 * travel_;
        near_end_.assign(flow.clusters.size(), 0);
        watched_ = {};
        for (std::size_t cluster = 0; cluster < flow.clusters.size(); ++cluster) {
            const auto first = static_cast<std::size_t>(flow.clusters.begin[cluster]);
            const auto count = static_cast<std::size_t>(flow.clusters.count(cluster));
            for (std::size_t n = 0; n < count; ++n) {
                const double x = flow.fixed_point.decode(slots[cluster * cluster_size + n], 0);
                const bool at_start = x < upstream;
                const bool at_end = x > length_ - upstream;
                near_end_[cluster] |= static_cast<std::uint8_t>(at_start || at_end);
                if (at_start) {
                    watched_[0].push_back(first + n);
                }
                if (at_end) {
                    watched_[1].push_back(first + n);
                }
            }
        }
    }

    void begin_step(Flow& flow, double dt) override {
        OpenEndsState& state = flow.clock.open_ends;
        step_ = dt;
        const double smoothing = std::min(1.0, dt / (2.0 * watch_ / wave_speed(gravity_, flow.scheme.depth)));
        const Watched start = watch(flow, 0);
        const Watched end = watch(flow, 1);
        const auto smooth = [&](EndState& state_of, const Watched& now, double share) {
            state_of.watched_depth += share * (now.depth - state_of.watched_depth);
            state_of.watched_velocity += share * (now.velocity - state_of.watched_velocity);
        };
        smooth(state.upstream, start, smoothing);
        smooth(state.downstream, end, smoothing);
        follow_upstream(state.upstream, flow.clock.time, dt);
        follow_downstream(state.downstream, flow.clock.time, dt);
        watch_profile(flow, state, dt);
        shape_mean_ = input_.shape.mean_of_rows(state.rows);
        fastest_ = std::max(start.fastest, end.fastest);
    }

    void begin_evaluation(Flow& /*flow*/, const Stage& stage) override {
        kick_ = stage.kick < 0.0 ? stage.motion : stage.kick;
    }

    void complete_gradients(Flow& flow, Task& task, std::size_t begin, std::size_t end) override {
        for_buffers(flow, begin, end, [&](std::size_t i, std::size_t lane, bool entering) {
            const double z = flow.particles.position[Flow::vertical][i];
            const double depth =
                entering ? flow.clock.open_ends.upstream.depth : flow.clock.open_ends.downstream.depth;
            flow.particles.density_deviation[i] =
                flow.scheme.state.deviation(gravity_ * std::max(0.0, depth - z));
            task.sums.gradient.density_rate[lane] = Real(0);
            task.sums.gradient.diffusion[lane] = Real(0);
            task.sums.gradient.regularity[lane] = Real(1);
        });
    }

    void add_forces(Flow& flow, Task& task, std::size_t begin, std::size_t end) override {
        const auto first = static_cast<std::size_t>(flow.clusters.begin[begin]);
        for_buffers(flow, begin, end, [&](std::size_t i, std::size_t lane, bool entering) {
            const Vec<D> wanted = entering ? entering_velocity(flow, i) : leaving_velocity(flow, i);
            for (std::size_t k = 0; k < Flow::axes; ++k) {
                task.sums.force.tensor[k][lane] = Real(0);
                task.sums.force.viscous[k][lane] = Real(0);
                task.particles.acceleration[k][lane] =
                    (wanted[k] - flow.particles.velocity[k][i]) / kick_ - flow.particle_data.gravity[k];
            }
            task.particles.drag[i - first] = 0.0;
        });
    }

    void end_step(Flow& flow) override {
        OpenEndsState& state = flow.clock.open_ends;
        const EndState& end = state.upstream;
        streams_.advance(state, step_, [&](int row) { return velocity_of_row(state, row, end); });
        state.travel += step_ * std::max(fastest_, std::abs(end.velocity) * input_.shape.largest());
    }

    [[nodiscard]] std::size_t bytes() const override {
        return near_end_.capacity() + (watched_[0].capacity() + watched_[1].capacity()) * sizeof(std::size_t);
    }

  private:
    /// Sums over the water at one end.
    struct Watched {
        double depth = 0.0;     ///< within a hat inside of the channel
        double velocity = 0.0;  ///< so
        double fastest = 0.0;
    };

    void begin(Flow& flow) {
        OpenEndsState& state = flow.clock.open_ends;
        if (state.begun) {
            return;
        }
        state.begun = true;
        const auto depth = start_depths(flow.c, input_);
        const double q = flow.c.start.kind == StartKind::rest ? 0.0 : start_unit_discharge(flow.c, input_);
        const auto at = [&](double x) {
            EndState end;
            end.depth = depth(x);
            end.velocity = q / end.depth;
            end.watched_depth = end.depth;
            end.watched_velocity = end.velocity;
            end.coming = end.velocity - 2.0 * wave_speed(gravity_, end.depth);
            return end;
        };
        state.upstream = at(0.0);
        state.downstream = at(length_);
        const int bins = std::max(4, lattice_.rows / 2);
        for (int bin = 0; bin < bins; ++bin) {
            state.leaving.push_back(state.downstream.velocity * input_.shape.at((bin + 0.5) / bins));
        }
        streams_.begin(state, streams_.rows_for(state.upstream.depth), 0.5 * lattice_.dx);
    }

    void follow_upstream(EndState& end, double time, double dt) {
        const double before = end.depth;
        end.coming = end.watched_velocity - 2.0 * wave_speed(gravity_, end.watched_depth);
        Section section;
        if (input_.inflow_depth && input_.unit_discharge) {
            section.depth = input_.inflow_depth->at(time);
            section.velocity = input_.unit_discharge->at(time) / section.depth;
        } else if (input_.inflow_depth) {
            section = inflow_by_depth(gravity_, input_.inflow_depth->at(time), end.coming);
        } else {
            section = inflow_by_discharge(gravity_, input_.unit_discharge->at(time), end.coming);
        }
        end.depth = section.depth;
        end.velocity = section.velocity;
        end.depth_rate = (end.depth - before) / dt;
    }

    void follow_downstream(EndState& end, double time, double dt) {
        const double before = end.depth;
        const double c = wave_speed(gravity_, end.watched_depth);
        const double going = end.watched_velocity + 2.0 * c;
        // Where the flow is supercritical, nothing comes up from outside.
        if (!input_.outflow_depth || end.watched_velocity >= c) {
            end.coming = end.watched_velocity - 2.0 * c;
        }
        Section section = outflow_between(gravity_, going, end.coming);
        if (input_.outflow_depth && end.watched_velocity < c) {
            const double q = end.watched_velocity * end.watched_depth;
            end.coming +=
                relaxation(gravity_, section, input_.outflow_depth(q, time), input_.relaxation_time, dt);
            section = outflow_between(gravity_, going, end.coming);
        }
        end.depth = section.depth;
        end.velocity = section.velocity;
        end.depth_rate = (end.depth - before) / dt;
    }

    [[nodiscard]] double velocity_of_row(const OpenEndsState& state, int row, const EndState& end) const {
        return end.velocity * input_.shape.at((row + 0.5) / state.rows) / shape_mean_;
    }

    [[nodiscard]] Vec<D> entering_velocity(const Flow& flow, std::size_t i) const {
        const EndState& end = flow.clock.open_ends.upstream;
        const double place = flow.particles.position[Flow::vertical][i] / end.depth;
        Vec<D> u{};
        u[0] = end.velocity * input_.shape.at(place) / shape_mean_;
        u[Flow::vertical] = place * end.depth_rate;
        return u;
    }

    /// What leaves goes over to the profile of its section, and to rest across.
    [[nodiscard]] Vec<D> leaving_velocity(const Flow& flow, std::size_t i) const {
        const Vec<D> wanted = leaving_section(flow, i);
        const double kept =
            std::exp(-step_ * wave_speed(gravity_, flow.clock.open_ends.downstream.depth) / watch_);
        Vec<D> u = vector_of(flow.particles.velocity, i);
        for (std::size_t k = 0; k < Flow::axes; ++k) {
            u[k] = wanted[k] + kept * (u[k] - wanted[k]);
        }
        return u;
    }

    /// The velocity of the section at the outflow at the height of a particle. While the flow as a whole
    /// leaves, none of it comes back: nothing would be there to come.
    [[nodiscard]] Vec<D> leaving_section(const Flow& flow, std::size_t i) const {
        const EndState& end = flow.clock.open_ends.downstream;
        const double place = flow.particles.position[Flow::vertical][i] / end.depth;
        Vec<D> u{};
        u[0] = leaving_factor_ * leaving_at(flow.clock.open_ends, place) + leaving_shift_;
        u[0] = end.velocity >= 0.0 ? std::max(0.0, u[0]) : u[0];
        u[Flow::vertical] = place * end.depth_rate;
        return u;
    }

    /// The profile of what leaves at z/h, straight lines between the middles of its bins.
    [[nodiscard]] static double leaving_at(const OpenEndsState& state, double place) {
        const double last = static_cast<double>(state.leaving.size()) - 1.0;
        const double at = std::clamp(place * (last + 1.0) - 0.5, 0.0, last);
        const auto low = static_cast<std::size_t>(at);
        const std::size_t high = std::min(low + 1, state.leaving.size() - 1);
        return state.leaving[low] +
               (at - static_cast<double>(low)) * (state.leaving[high] - state.leaving[low]);
    }

    /// f(particle, lane, whether it enters) for the particles of a block that stand in a buffer.
    template <class F>
    void for_buffers(const Flow& flow, std::size_t begin, std::size_t end, const F& f) const {
        for (std::size_t cluster = begin; cluster < end; ++cluster) {
            if (near_end_[cluster] == 0) {
                continue;
            }
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

    /// Depth and velocity within a hat of 2 watch_ beside an end: a row of evenly spaced particles counts
    /// alike wherever it stands under it.
    [[nodiscard]] Watched watch(const Flow& flow, std::size_t end) const {
        const Particles<D>& p = flow.particles;
        const double breadth =
            flow.scheme.density * watch_ * (D == 3 ? flow.c.channel.simulated_width() : 1.0);
        Watched sums;
        for (const std::size_t i : watched_[end]) {
            const double x = end == 0 ? p.position[0][i] : length_ - p.position[0][i];
            const double u = p.velocity[0][i];
            const double volume = p.mass[i] / (1.0 + p.density_deviation[i]);
            sums.fastest = std::max(sums.fastest, std::abs(u));
            const double hat = volume * hat_at(x);
            sums.depth += hat;
            sums.velocity += hat * u;
        }
        sums.velocity /= sums.depth > 0.0 ? sums.depth : 1.0;
        sums.depth /= breadth;
        return sums;
    }

    /// Weight of the water at a distance from an end inside of the channel.
    [[nodiscard]] double hat_at(double x) const { return std::max(0.0, 1.0 - std::abs(x - watch_) / watch_); }

    /// What leaves has the profile of the water before the end, smoothed over the time that a wave takes
    /// along one depth. (Were it to keep its own velocity, slow water at the bed could come to rest beyond
    /// the end and dam the channel.)
    void watch_profile(const Flow& flow, OpenEndsState& state, double dt) {
        const Particles<D>& p = flow.particles;
        const double depth = state.downstream.watched_depth;
        volume_.assign(state.leaving.size(), 0.0);
        flux_.assign(state.leaving.size(), 0.0);
        for (const std::size_t i : watched_[1]) {
            const double hat = hat_at(length_ - p.position[0][i]);
            if (hat > 0.0) {
                const std::size_t bin = bin_of(state, p.position[Flow::vertical][i] / depth);
                volume_[bin] += hat * p.mass[i];
                flux_[bin] += hat * p.mass[i] * p.velocity[0][i];
            }
        }
        const double share = std::min(1.0, dt * wave_speed(gravity_, depth) / depth);
        double mean = 0.0;
        for (std::size_t bin = 0; bin < state.leaving.size(); ++bin) {
            if (volume_[bin] > 0.0) {
                state.leaving[bin] += share * (flux_[bin] / volume_[bin] - state.leaving[bin]);
            }
            mean += state.leaving[bin] / static_cast<double>(state.leaving.size());
        }
        // The mean is that of the section: by a factor, so that slow water stays slow, unless the flow turns.
        const double wanted = state.downstream.velocity;
        const bool turns = mean * wanted <= 0.0 || std::abs(wanted) > 2.0 * std::abs(mean);
        leaving_factor_ = turns ? 1.0 : wanted / mean;
        leaving_shift_ = turns ? wanted - mean : 0.0;
    }

    [[nodiscard]] static std::size_t bin_of(const OpenEndsState& state, double place) {
        const double bins = static_cast<double>(state.leaving.size());
        return static_cast<std::size_t>(std::clamp(place * bins, 0.0, bins - 0.5));
    }

    void take_out(Flow& flow) {
        Particles<D>& p = flow.particles;
        EndsLedger& ledger = flow.clock.open_ends.ledger;
        const double from = -(support_ + travel_) - 2.0 * lattice_.dx;
        const double to = length_ + support_;
        std::vector<std::int32_t> kept;
        kept.reserve(p.size());
        for (std::size_t i = 0; i < p.size(); ++i) {
            if (p.position[0][i] >= from && p.position[0][i] <= to) {
                kept.push_back(static_cast<std::int32_t>(i));
                continue;
            }
            ++ledger.left;
            ledger.mass_left += p.mass[i];
            ledger.momentum_left += p.mass[i] * p.velocity[0][i];
        }
        if (kept.size() < p.size()) {
            p.permute(kept);
        }
    }

    void make(Flow& flow) {
        OpenEndsState& state = flow.clock.open_ends;
        const EndState& end = state.upstream;
        shape_mean_ = input_.shape.mean_of_rows(state.rows);
        std::vector<Vec<D>> places;
        streams_.fill(state, end.depth, [&](int row, int file, double x) {
            places.push_back(place_of(row, file, x, state.rows, end.depth));
        });
        add(flow, places, end.depth, [&](std::size_t i) { return entering_velocity(flow, i); });
        if (state.downstream.velocity < 0.0) {
            const auto behind = gaps_behind_outflow(flow);
            add(flow, behind, state.downstream.depth,
                [&](std::size_t i) { return leaving_section(flow, i); });
        }
    }

    [[nodiscard]] Vec<D> place_of(int row, int file, double x, int rows, double depth) const {
        Vec<D> place{};
        place[0] = x;
        if constexpr (D == 3) {
            place[1] = lattice_.y(file, row);
        }
        place[Flow::vertical] = streams_.height_of(row, rows, depth);
        return place;
    }

    /// Where the flow comes back from the outflow, what has gone into the channel is to be replaced: places
    /// behind the last particle of each row.
    [[nodiscard]] std::vector<Vec<D>> gaps_behind_outflow(const Flow& flow) const {
        const Particles<D>& p = flow.particles;
        const double depth = flow.clock.open_ends.downstream.depth;
        const int rows = streams_.rows_for(depth);
        const int files = D == 3 ? lattice_.files : 1;
        const double step = streams_.length(rows, depth);
        std::vector<double> last(static_cast<std::size_t>(rows) * static_cast<std::size_t>(files),
                                 length_ - step);
        const auto index = [](double place, int count) {
            return static_cast<std::size_t>(std::clamp(place, 0.0, count - 0.5));
        };
        for (std::size_t i = 0; i < p.size(); ++i) {
            if (p.position[0][i] > length_ - step) {
                const std::size_t row = index(p.position[Flow::vertical][i] / depth * rows, rows);
                const std::size_t file = D == 3 ? index(p.position[1][i] / lattice_.dy, files) : 0;
                double& place = last[row * static_cast<std::size_t>(files) + file];
                place = std::max(place, p.position[0][i]);
            }
        }
        std::vector<Vec<D>> places;
        for (int row = 0; row < rows; ++row) {
            for (int file = 0; file < files; ++file) {
                const auto at = static_cast<std::size_t>(row * files + file);
                for (double x = last[at] + step; x < length_ + support_; x += step) {
                    places.push_back(place_of(row, file, x, rows, depth));
                }
            }
        }
        return places;
    }

    /// Add particles at places in water of a depth, with the velocity of each by its index.
    template <class Velocity>
    void add(Flow& flow, const std::vector<Vec<D>>& places, double depth, const Velocity& velocity) const {
        if (places.empty()) {
            return;
        }
        Particles<D>& p = flow.particles;
        EndsLedger& ledger = flow.clock.open_ends.ledger;
        const std::size_t first = p.append(places.size());
        for (std::size_t n = 0; n < places.size(); ++n) {
            const std::size_t i = first + n;
            for (std::size_t k = 0; k < Flow::axes; ++k) {
                p.position[k][i] = places[n][k];
            }
            const double s =
                flow.scheme.state.deviation(gravity_ * std::max(0.0, depth - places[n][Flow::vertical]));
            p.density_deviation[i] = s;
            p.mass[i] = flow.scheme.density * (1.0 + s) * lattice_.volume<D>();
            const Vec<D> u = velocity(i);
            for (std::size_t k = 0; k < Flow::axes; ++k) {
                p.velocity[k][i] = u[k];
            }
            ++ledger.entered;
            ledger.mass_entered += p.mass[i];
            ledger.momentum_entered += p.mass[i] * u[0];
        }
    }

    EndInput input_;
    Lattice lattice_;
    double length_, gravity_;
    double travel_;   ///< of water at an end from list build to list build, m
    double support_;  ///< water that must stand beyond an end, m
    double watch_;    ///< half of the stretch beside an end that is watched: whole spacings, m
    InflowStreams streams_;
    std::vector<std::uint8_t> near_end_;               ///< by cluster
    std::array<std::vector<std::size_t>, 2> watched_;  ///< particles at either end
    // Of the step in progress.
    double step_ = 0.0;
    double kick_ = 0.0;                  ///< dt of the velocities
    double leaving_factor_ = 1.0;        ///< from the profile of what leaves to that of its section
    double leaving_shift_ = 0.0;         ///< so, m/s
    std::vector<double> volume_, flux_;  ///< by bin of the profile
    double shape_mean_ = 1.0;            ///< of the profile over the rows
    double fastest_ = 0.0;               ///< at the ends, m/s
};

template <int D, class Real>
std::unique_ptr<Component<D, Real>> make_open_ends(FlowOf<D, Real>& flow) {
    return flow.c.channel.ends == Ends::open ? std::make_unique<OpenEnds<D, Real>>(flow) : nullptr;
}

}  // namespace riffle
