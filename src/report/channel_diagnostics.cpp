// Diagnostics of flows that are driven along a channel, with and without bodies.

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "case/end_levels.hpp"
#include "case/flow_kind.hpp"
#include "case/porous_zone.hpp"
#include "record/flow_fields.hpp"
#include "record/run_fields.hpp"
#include "record/twin_fields.hpp"
#include "report/diagnostic_rows.hpp"
#include "statistics/confidence.hpp"
#include "statistics/record.hpp"

namespace riffle::inline report {

namespace {

class ChannelRows : public DiagnosticRows {
  public:
    ChannelRows(const ReportData& data, const Analysis& analysis)
        : DiagnosticRows(data, analysis),
          stirred_(data.flow.stirring.acceleration > 0),
          space_(data.flow.channel.dimensions == 3),
          bodies_(has_bodies(data.flow)),
          vegetation_(!data.flow.vegetation.empty()),
          porous_(!data.flow.porous.empty()),
          open_(data.flow.channel.ends == Ends::open) {}

    void interval() {
        const auto mean = value(fields::summary.depth_mean_velocity);
        const auto half = value(fields::summary.depth_mean_velocity_half_width);
        if (!mean || !half || *mean == 0) return;
        const double share = *half / std::abs(*mean);
        const double bar = data_.flow.run.tolerance;
        add({"velocity_interval", "Certainty of the depth-mean velocity", "± " + percent(share),
             "at most ± " + percent(bar),
             "Half-width of the 95 % confidence interval of the time mean, with the correlation of "
             "successive values taken into account. If it is too wide, run longer. It knows of nothing slower "
             "than the window: between runs from other seeds the mean may differ by more.",
             mark_of(share, bar)});
    }

    /// Whether the window is long enough to tell: an interval from a handful of independent samples is a
    /// guess.
    void samples() {
        const Finding* const found = finding("effective_samples");
        const Finding* const change = finding("velocity_range_in_window");
        if (found == nullptr) return;
        constexpr double fewest = 10;
        // A record that stays within a tenth of the tolerance needs no statistics.
        const bool constant = change != nullptr && change->value <= 0.1 * data_.flow.run.tolerance;
        // One that stays within the tolerance knows its mean as well, though not by how much it is off.
        const bool narrow = change != nullptr && change->value <= data_.flow.run.tolerance;
        add({"independent_samples", "Independent samples in the averaging window",
             narrow ? fmt::format("{:.1f}, but the velocity stays within {} of its mean", found->value,
                                  percent(change->value, 3))
                    : fmt::format("{:.1f}", found->value),
             changes_in_time() ? "none where the case changes the flow in time"
                               : "10 make an interval; or a velocity that does not vary",
             "Length of the window over twice the integral time scale of the depth-mean velocity. Fewer "
             "make no interval of the mean that can be trusted, and slow changes are not seen.",
             changes_in_time()                        ? Health::none
             : constant || found->value >= fewest     ? Health::good
             : narrow || found->value >= 0.5 * fewest ? Health::caution
                                                      : Health::bad});
    }

    /// Whether the flow is still on its way to another state.
    void growth() {
        const Finding* const found = finding("velocity_fluctuation_growth");
        if (found == nullptr) return;
        constexpr double bar = 0.25;
        constexpr double many = 10.0;
        const Finding* const bound = finding("velocity_fluctuation_growth_least");
        const double least = bound != nullptr ? bound->value : found->value;
        add({"fluctuation_growth", "Growth of the particles' fluctuation in the window",
             // A number that its interval does not know from none would be read as one that is known.
             found->value > bar && least <= bar ? "not told apart from none"
             : found->value > many              ? fmt::format("{:.3g}-fold", 1.0 + found->value)
                                                : (found->value < 0.0 ? "" : "+") + percent(found->value, 0),
             "at most 25 %, as far as its interval tells",
             "By the trend of the logarithm of the velocity fluctuation. One that grows says that the "
             "particles are leaving the order they started in: the flow is on its way to another state, with "
             "another mean.",
             changes_in_time()    ? Health::none
             : least <= bar       ? Health::good
             : least <= 2.0 * bar ? Health::caution
                                  : Health::bad});
    }

    void start_up() {
        const auto relaxation = value(fields::summary.relaxation_time);
        if (!relaxation || data_.window_end <= data_.window_start) return;
        const double times = data_.window_start / *relaxation;
        add({"start_up", "Time before averaging", fmt::format("{:.1f} relaxation times", times), "at least 3",
             fmt::format(
                 "Departures from the steady flow {} {:.2f} s. Averages taken too early still carry the "
                 "start.",
                 converges_between_ends(data_.flow) ? "leave through the ends in some"
                                                    : "die out with an e-folding time of",
                 *relaxation),
             times >= 3   ? Health::good
             : times >= 1 ? Health::caution
                          : Health::bad});
    }

    void budget() {
        if (open_) {
            momentum_between_ends();
            return;
        }
        const auto drag = value(fields::summary.drag_over_gravity);
        if (!drag || data_.flow.channel.slope <= 0) return;
        const double wall = value(fields::summary.wall_over_gravity).value_or(0.0);
        const double share = *drag + wall + value(fields::summary.side_wall_over_gravity).value_or(0.0) +
                             value(fields::summary.vegetation_over_gravity).value_or(0.0) +
                             value(fields::summary.porous_over_gravity).value_or(0.0);
        const bool pushed = porosity_varies_along(data_.flow);
        add({"force_budget",
             bodies_   ? "Force on bed, walls and bodies over the weight component"
             : porous_ ? "Resistance of porous zones, bed drag and wall friction over the weight component"
             : vegetation_ ? "Drag of vegetation and bed and wall friction over the weight component"
                           : "Drag and wall friction over the weight component",
             percent(share), pushed ? "none where porous zones end along the channel" : "100 ± 1 %",
             bodies_ ? "In steady flow bed, walls and bodies together must carry the whole component of the "
                       "water's weight down the slope, the bodies by the pressure on their faces (form drag) "
                       "and by friction. More: the flow still slows down; less: it still speeds up."
             : pushed
                 ? "Where porous zones end along the channel the pressure pushes their grains as well, which is "
                   "not recorded: the rest of the weight may be carried so."
                 : "In steady uniform flow the bed must carry the whole component of the water's weight down "
                   "the slope. More: the flow still slows down, or numerical friction acts; less: it still "
                   "speeds up.",
             pushed ? Health::none : mark_of(std::abs(share - 1), 0.01)});
    }

    /// At open ends the water on either side pushes too.
    void momentum_between_ends() {
        const Finding* const found = finding("momentum_residual_share");
        if (found == nullptr) return;
        constexpr double bar = 0.02;
        // Without an interval it is judged by its value alone, and not at all where what is known of it
        // reaches over the bar.
        const double known = found->half_width.value_or(0.0);
        const double least = std::max(0.0, std::abs(found->value) - known);
        const bool tells_nothing = least <= bar && known > bar;
        add({"momentum_budget", "Momentum between the ends that the budget leaves open",
             found->half_width ? fmt::format("{} ± {}", percent(found->value, 1), percent(known, 1))
                               : percent(found->value, 1),
             fmt::format("0 ± {}, as far as it is known", percent(bar, 0)),
             "What flow and pressure bring in at one end and take out at the other, with the weight down the slope, bed, walls "
             "and bodies must take, the bodies by the pressure on their faces (form drag) and by friction. Over the "
             "sum of these forces; more in a flow that is not steady. It is known to its interval in time and to 0.1 % of "
             "what presses on a section: where the forces are small beside that, the budget tells little.",
             changes_in_time() || tells_nothing ? Health::none : mark_of(least, bar)});
    }

    void bodies_share() {
        const Finding* const found = finding("solid_force_share");
        if (found == nullptr) return;
        std::string text = percent(found->value, 1);
        if (const Finding* const pressure = finding("solid_form_drag_share")) {
            text += fmt::format(", by pressure {}", percent(pressure->value, 1));
        }
        add({"form_drag",
             bodies_ ? "Force on the bodies over the weight component"
                     : "Force on the solids of the bed over the weight component",
             text, bodies_ ? "what the bodies take" : "what they take",
             fmt::format(
                 "Streamwise force of the water on the {}: form drag, by the pressure on their faces, and "
                 "friction. The rest of the weight component goes to {} and the walls.",
                 bodies_ ? "bodies" : "solids", bodies_ ? "the bed" : "the bed below them"),
             Health::none});
    }

    void spurious_stress() {
        const auto share = value(fields::summary.spurious_stress_rms);
        if (!share || open_) return;
        const double bar = space_ ? 0.01 : stirred_ ? 0.015 : 0.005;
        add({"spurious_stress",
             bodies_ ? "Spurious shear stress of the pressure, above the bodies"
                     : "Spurious shear stress of the pressure",
             percent(*share) + " of the bed stress",
             bodies_ ? "below their tops pressure carries form drag" : "at most " + percent(bar, 1),
             "Pressure alone must not drag layers along each other. In a particle method it can, when "
             "particles lie unevenly; a few percent of the bed stress would act as an additional "
             "roughness. Rms over the depth.",
             bodies_ ? Health::none : mark_of(*share, bar)});
    }

    void stress_error() {
        const auto share = value(fields::summary.stress_error_rms);
        if (!share || bodies_ || open_) return;
        const double bar = space_ ? 0.035 : 0.015;
        add({"stress_error", "Total shear stress against the analytic line",
             percent(*share) + " of the stress at the crests", "at most " + percent(bar, 1),
             "In steady uniform flow the shear stress grows linearly from the surface down. Rms departure "
             "above the crests.",
             mark_of(*share, bar)});
    }

    void velocity_errors() {
        // The bars of three dimensions are wider: the spheres stand at their places, which no twin knows.
        const auto& of = fields::summary;
        const auto above = [&](double rms_bar, double maximum_bar) {
            velocity_error("above", of.velocity_error_above_rms, of.velocity_error_above_maximum, rms_bar,
                           maximum_bar);
        };
        const auto below = [&](double rms_bar, double maximum_bar) {
            velocity_error("below", of.velocity_error_below_rms, of.velocity_error_below_maximum, rms_bar,
                           maximum_bar);
        };
        if (space_) {
            above(0.02, 0.04);
            below(0.10, 0.15);
            return;
        }
        above(0.01, 0.02);
        // The thin layers between the bed elements are harder to resolve; less so with a wide kernel.
        const bool wide = data_.flow.numerics.smoothing_ratio >= 2;
        below(wide ? 0.025 : 0.03, wide ? 0.04 : 0.06);
    }

    void depth_drift() {
        if (!data_.series.has(fields::time_series.mean_level) ||
            !data_.series.has(fields::time_series.time)) {
            return;
        }
        auto levels = in_window(fields::time_series.mean_level);
        auto times = in_window(fields::time_series.time);
        // A run's first rows may precede the first sample of the surface.
        while (!levels.empty() && !std::isfinite(levels.front())) {
            levels = levels.subspan(1);
            times = times.subspan(1);
        }
        constexpr std::size_t fewest = 20;
        if (levels.size() < fewest) return;
        const double interval = (times.back() - times.front()) / static_cast<double>(times.size() - 1);
        if (!(interval > 0)) return;
        const TrendEstimate trend = trend_with_confidence(levels);
        const double minute = 60.0 / interval;
        const double depth = data_.flow.total_depth();
        constexpr double bar = 0.005;
        add({"depth_drift", "Drift of the water level",
             fmt::format("{:+.3g} ± {:.2g} mm per minute", 1000 * trend.slope * minute,
                         1000 * trend.half_width * minute),
             fmt::format("at most {:.2f} mm per minute, 0.5 % of the depth", 1000 * bar * depth),
             open_
                 ? "Where as much water enters as leaves, the level stays. A drift means that the flow is still on "
                   "its way, or that the case changes it: what enters, what rules the outflow, a solid that moves."
                 : "Water is neither lost nor added, so the level must stay. A drift means that the particles' "
                   "volume changes: numerics.density_relaxation = 0.4 keeps it.",
             changes_in_time()
                 ? Health::none
                 : mark_of(std::abs(trend.slope) * minute / depth, bar, trend.half_width * minute / depth)});
    }

    /// Particles that are stored, have entered, left or been lost: the account must close to each of them.
    void account() {
        const auto& of = fields::time_series;
        if (!open_ || !data_.series.has(of.particles_stored)) return;
        const auto& stored = data_.series[of.particles_stored];
        const auto& entered = data_.series[of.particles_entered];
        const auto& left = data_.series[of.particles_left];
        const auto& lost = data_.series[of.particles_lost];
        if (stored.empty()) return;
        double worst = 0.0;
        const auto of_row = [&](std::size_t i) { return stored[i] - entered[i] + left[i] + lost[i]; };
        for (std::size_t i = 0; i < stored.size(); ++i) {
            worst = std::max(worst, std::abs(of_row(i) - of_row(0)));
        }
        add({"account", "Account of the particles",
             fmt::format("{:.0f} entered, {:.0f} left, {:.0f} lost, {:.0f} stored; error {:.0f}",
                         entered.back(), left.back(), lost.back(), stored.back(), worst),
             "error 0",
             "Each particle that is stored has been there from the start or has entered and not left: the account "
             "of the open ends closes to the particle.",
             worst == 0.0 ? Health::good : Health::bad});
    }

    /// What goes out against what comes in, by the particles: the state of the section at the outflow misses
    /// the gaps that water carries along behind a jump.
    void throughput() {
        const auto& of = fields::time_series;
        if (!open_ || !data_.series.has(of.mass_stored)) return;
        const auto times = in_window(of.time);
        const auto stored = in_window(of.mass_stored);
        const double entering = mean_of(in_window(of.inflow_discharge));
        constexpr std::size_t fewest = 20;
        if (stored.size() < fewest || entering == 0.0) return;
        const double interval = (times.back() - times.front()) / static_cast<double>(times.size() - 1);
        const TrendEstimate trend = trend_with_confidence(stored);
        const double share = 1.0 / (data_.flow.fluid.density * std::abs(entering) * interval);
        const double change = -trend.slope * share * (entering > 0.0 ? 1.0 : -1.0);
        const double half = trend.half_width * share;
        constexpr double bar = 0.01;
        add({"throughput", "Discharge that leaves against that which enters",
             fmt::format("{} ± {}", signed_percent(change), percent(half)), "within ± 1 %",
             "What enters, less the trend of the mass that the channel holds. In steady flow they are the same; "
             "the rest fills or empties the channel.",
             changes_in_time() ? Health::none : mark_of(std::abs(change), bar, half)});
    }

    /// What the pair sums add to the motion or take from it beside the physics: it tells eddies from noise.
    void energy() {
        // Between open ends what the sections there miss counts with the time stepping, and says nothing of
        // it.
        const bool open = data_.flow.channel.ends == Ends::open;
        const Finding* const found = finding(open ? "energy_share_pressure" : "energy_share_scheme");
        if (found == nullptr) return;
        constexpr double bar = 0.1;
        add({"energy", "Energy that the scheme itself adds or takes",
             signed_percent(found->value) + " of the energy input", "at most 10 %",
             open
                 ? "Weight and what flows in with more energy than flows out drive the flow; drag, closure and "
                   "viscosity take it. What the pressure adds or takes beside them is not physics; what dissipation "
                   "of impacts and damping of sound take is not in it."
                 : "Weight drives the flow; drag, closure and viscosity take its energy. What pressure forces and "
                   "time stepping add or take beside them is not physics: it feeds noise or damps eddies.",
             mark_of(std::abs(found->value), bar, found->half_width.value_or(0.0))});
    }

    /// What the start-up has done to the volume stays in every mean after it, steady as they may be. The
    /// level knows of it; the density that the particles carry does not.
    void volume() {
        if (!data_.series.has(fields::time_series.mean_level) || data_.flow.channel.ends != Ends::periodic) {
            return;
        }
        const double level = mean_of(in_window(fields::time_series.mean_level));
        if (!std::isfinite(level)) return;
        const auto& all = data_.series[fields::time_series.mean_level];
        const auto first = std::find_if(all.begin(), all.end(), [](double z) { return std::isfinite(z); });
        constexpr double bar = 0.005;
        const double change = (level - *first) / data_.flow.total_depth();
        add({"volume", "Volume of the water since the start", signed_percent(change) + " of the depth",
             "at most " + percent(bar, 1),
             "The mean level in the window over that at the start: water that takes more room as its "
             "particles leave their lattice is a flow of another depth, however steady.",
             bodies_ ? Health::none : mark_of(std::abs(change), bar)});
    }

  private:
    /// Whether the flow changes because the case says so: by what it gives at open ends, or by solids that it
    /// moves.
    [[nodiscard]] bool changes_in_time() const {
        const Case& c = data_.flow;
        const bool moves = std::any_of(c.solids.begin(), c.solids.end(),
                                       [](const Solid& solid) { return !solid.rests() && !solid.is_free(); });
        return moves || changes_at_ends(c);
    }

    /// A drift counts as bad only where it stands out of its own uncertainty.
    void velocity_error(const std::string& part, const Field& rms_field, const Field& maximum_field,
                        double rms_bar, double maximum_bar) {
        const auto rms = value(rms_field);
        const auto maximum = value(maximum_field);
        if (!rms || !maximum) return;
        const char* const twin = data_.flow.has_side_walls() ? "section twin" : "column twin";
        add({"velocity_error_" + part, fmt::format("Velocity {} the crests against the {}", part, twin),
             fmt::format("rms {}, largest {}", percent(*rms), percent(*maximum)),
             fmt::format("rms at most {}, largest at most {}", percent(rms_bar, 1), percent(maximum_bar, 0)),
             fmt::format("The {} is the exact steady solution of the same equations, so this is the error of "
                         "the particles, not of the model.",
                         twin),
             std::max(mark_of(*rms, rms_bar), mark_of(*maximum, maximum_bar))});
    }

    bool stirred_;
    bool space_;
    bool bodies_;
    bool vegetation_;
    bool porous_;
    bool open_;  ///< ends
};

}  // namespace

std::vector<Diagnostic> diagnose_channel(const ReportData& data, const Analysis& analysis) {
    ChannelRows rows(data, analysis);
    rows.interval();
    rows.samples();
    rows.growth();
    rows.start_up();
    rows.budget();
    rows.bodies_share();
    rows.spurious_stress();
    rows.stress_error();
    rows.velocity_errors();
    rows.depth_drift();
    rows.volume();
    rows.account();
    rows.throughput();
    rows.energy();
    rows.density();
    rows.particles_lost();
    rows.order();
    rows.fluctuation();
    return rows.take();
}

}  // namespace riffle::inline report
