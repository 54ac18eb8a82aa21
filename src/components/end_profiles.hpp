#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <vector>

#include "case/end_floor.hpp"
#include "components/end_watch.hpp"
#include "ends/end_lattice.hpp"
#include "ends/end_sections.hpp"
#include "ends/leaving_profile.hpp"
#include "engine/flow.hpp"
#include "particles/lattice.hpp"

namespace riffle::inline components {

/// What the sections at both ends have at a place: heights over what the water stands on there, pressures,
/// and the profiles of the velocity of what enters and of what leaves.
template <int D, class Real>
class EndProfiles {
  public:
    using Flow = FlowOf<D, Real>;

    EndProfiles(const Flow& flow, const Lattice& lattice)
        : lattice_(lattice),
          length_(flow.c.channel.length),
          floors_(end_floors(flow.c)),
          upstream_(flow.c, lattice, place_of_end(flow.c, true)),
          downstream_(flow.c, lattice, place_of_end(flow.c, false)),
          sections_(read_end_input(flow.c), upstream_.waves(flow.scheme.normal_gravity),
                    downstream_.waves(flow.scheme.normal_gravity), flow.scheme.state.sound_speed, lattice.dz),
          leaving_(lattice.dz, floors_of_files()) {
        for (int file = 0; file < lattice_.files; ++file) files_.push_back(lattice_.y(file, 0));
    }

    [[nodiscard]] const EndSections& sections() const { return sections_; }
    /// Which places across the channel hold water beyond the inflow, and beyond the outflow.
    [[nodiscard]] const EndLattice& upstream() const { return upstream_; }
    [[nodiscard]] const EndLattice& downstream() const { return downstream_; }
    [[nodiscard]] const EndFloors& floors() const { return floors_; }
    [[nodiscard]] const EnteringFlow& entering() const { return *sections_.input().entering; }

    /// Height of a particle over what the water of an end stands on.
    [[nodiscard]] double over_floor(const Flow& flow, std::size_t i, bool entering) const {
        return flow.particles.position[Flow::vertical][i] -
               (entering ? floors_.upstream : floors_.downstream);
    }

    /// Velocity with which a particle rises with the depth of the water of its end, m/s.
    [[nodiscard]] double rise(const Flow& flow, std::size_t i, const EndState& end, bool entering) const {
        const double lowest = sections_.waves(entering).lowest();
        // At the outflow no water may be, or a drop of it.
        const double depth = entering ? end.depth - lowest : std::max(end.depth - lowest, lattice_.dz);
        return (over_floor(flow, i, entering) - lowest) / depth * end.depth_rate;
    }

    /// Width of the surface over the area of the water at an end, 1/m; in a rectangle 1/h.
    [[nodiscard]] double widening(const EndState& end, bool entering) const {
        const LongWaves& waves = sections_.waves(entering);
        const double depth = std::max(end.depth, waves.lowest() + lattice_.dz);
        if (waves.in_rectangle()) return 1.0 / depth;
        const double c = waves.speed(depth);
        return waves.gravity() / (c * c);
    }

    /// Pressure over the density at a height over the floor of an end.
    [[nodiscard]] double pressure_of(const EndState& end, double height) const {
        return sections_.in_duct() ? end.pressure
                                   : sections_.upstream().gravity() * std::max(0.0, end.depth - height);
    }

    /// Speed at which news of the flow come to the outflow: of its waves, in a duct of the water.
    [[nodiscard]] double leaving_speed(const OpenEndsState& state, double depth) const {
        return sections_.in_duct() ? std::abs(state.downstream.watched_velocity)
                                   : wave_speed(sections_.downstream(), depth);
    }

    /// The velocities with which the water of a start leaves.
    void begin_leaving(OpenEndsState& state) const {
        const int bins = std::max(4, lattice_.rows / 2);
        const double out = std::max(state.downstream.depth, lattice_.dz);
        // In a section each file has its own, over the bed there.
        const std::size_t profiles = downstream_.is_rectangle() ? 1 : files_.size();
        for (std::size_t file = 0; file < profiles; ++file) {
            const double bed = std::min(downstream_.floor_of(static_cast<int>(file)), out);
            for (int bin = 0; bin < bins; ++bin) {
                const double place = (bin + 0.5) / bins;
                const double relative =
                    downstream_.is_rectangle()
                        ? mean_across(place)
                        : entering().mean_at(files_[file], (bed + place * (out - bed)) / out);
                state.leaving.push_back(state.downstream.velocity * relative);
            }
        }
    }

    /// Take over the velocities of the water before the outflow in a step of dt.
    void follow_leaving(const Flow& flow, const EndWatch<D, Real>& watch, OpenEndsState& state, double dt) {
        leaving_.clear(state);
        for (const std::size_t i : watch.near(1)) {
            const Particles<D>& p = flow.particles;
            if (const double hat = watch.hat_at(length_ - p.position[0][i]); hat > 0.0) {
                leaving_.add(state, over_floor(flow, i, false), hat * p.mass[i], p.velocity[0][i],
                             file_of(flow, i));
            }
        }
        leaving_.finish(state, leaving_speed(state, std::max(state.downstream.watched_depth, lattice_.dz)),
                        dt);
    }
    /// Go on with those of a state that has been restored.
    void go_on(const OpenEndsState& state) { leaving_.go_on(state); }

    /// Velocity along the channel of the section at the outflow where a particle stands.
    [[nodiscard]] double leaving_velocity(const Flow& flow, std::size_t i) const {
        const OpenEndsState& state = flow.clock.open_ends;
        return leaving_.at(state, over_floor(flow, i, false), std::max(state.downstream.depth, lattice_.dz),
                           file_of(flow, i));
    }

    /// What enters is that of the time now.
    void go_to_now(const Flow& flow) {
        moment_ = flow.clock.time;
        const OpenEndsState& state = flow.clock.open_ends;
        if (upstream_.is_rectangle()) {
            entering_mean_ = entering().mean_of_streams(moment_, state.rows, files_);
            return;
        }
        // The streams of a section together are the area of its water but for parts of their rows.
        double sum = 0.0;
        for (int row = 0; row < state.rows; ++row) {
            for (int file = 0; file < lattice_.files; ++file) {
                if (upstream_.holds(row, file)) sum += entering_in_stream(row, file, state.rows);
            }
        }
        const double depth = state.upstream.depth;
        entering_mean_ = sum / (state.rows * lattice_.files) * depth / sections_.upstream().area(depth);
    }

    /// (u, v, w) of what enters now at y and z/h, over the mean of its section.
    [[nodiscard]] Vec<3> entering_at(double y, double place) const {
        return entering().at(moment_, y, place);
    }
    /// The same along the channel in the stream of a row and a file.
    [[nodiscard]] double entering_in_stream(int row, int file, int rows) const {
        return entering().at(moment_, files_[static_cast<std::size_t>(file)], (row + 0.5) / rows)[0];
    }
    /// By which these are to be divided, for the streams to bring in the discharge.
    [[nodiscard]] double entering_mean() const { return entering_mean_; }

    /// What is seen beside an end: the depth is that which the area of the water has in its section.
    [[nodiscard]] typename EndWatch<D, Real>::Watched watched(const Flow& flow,
                                                              const EndWatch<D, Real>& watch,
                                                              std::size_t end) const {
        auto seen = watch.watch(flow, end);
        seen.depth = sections_.waves(end == 0).depth_of_area(seen.depth);
        return seen;
    }

  private:
    /// Heights of the bed in the files of a section; none of a rectangle.
    [[nodiscard]] std::vector<double> floors_of_files() const {
        std::vector<double> floors;
        for (int file = 0; file < lattice_.files && !downstream_.is_rectangle(); ++file) {
            floors.push_back(downstream_.floor_of(file));
        }
        return floors;
    }

    /// The file of a section in which a particle stands; 0 in a rectangle, where all have one profile.
    [[nodiscard]] std::size_t file_of(const Flow& flow, std::size_t i) const {
        if (downstream_.is_rectangle()) return 0;
        const double file = across_of<D>(flow.particles.position, i) / lattice_.dy;
        return static_cast<std::size_t>(std::clamp(file, 0.0, lattice_.files - 0.5));
    }

    /// The mean of what enters at z/H across the channel, over that of the section.
    [[nodiscard]] double mean_across(double place) const {
        double sum = 0.0;
        for (const double y : files_) sum += entering().mean_at(y, place);
        return sum / static_cast<double>(files_.size());
    }

    Lattice lattice_;
    double length_;
    EndFloors floors_;
    EndLattice upstream_;  ///< across the channel
    EndLattice downstream_;
    EndSections sections_;
    LeavingProfile leaving_;
    std::vector<double> files_;   ///< places of the streams across the channel, m
    double moment_ = 0.0;         ///< time of what enters, s
    double entering_mean_ = 1.0;  ///< of it over its streams, over that of the section
};

}  // namespace riffle::inline components
