// Diagnostics of flows that nothing drives steadily: what a closed flow must keep, and what theory says of a
// wave and of vortices.

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "case/flow_kind.hpp"
#include "record/flow_fields.hpp"
#include "report/diagnostic_rows.hpp"

namespace riffle::inline report {

namespace {

class CourseRows : public DiagnosticRows {
  public:
    using DiagnosticRows::DiagnosticRows;

    void volume() {
        const Finding* const found = finding("volume_change_largest");
        if (found == nullptr) return;
        constexpr double bar = 0.01;
        add({"volume", "Largest change of the water's volume", signed_percent(found->value), "within ± 1 %",
             "The water is closed in, so its volume must stay, but for the slight compression by impacts "
             "and by its own weight.",
             mark_of(std::abs(found->value), bar)});
    }

    void energy() {
        const Finding* const gain = finding("energy_gain");
        const Finding* const change = finding("energy_change");
        if (gain == nullptr || change == nullptr) return;
        // What a moving body or lid adds cannot be told from what the scheme does; still water has no motion
        // to compare with.
        const Case& c = data_.flow;
        const bool moved =
            c.channel.lid_velocity != 0.0 ||
            std::any_of(c.solids.begin(), c.solids.end(), [](const Solid& solid) { return !solid.rests(); });
        const bool judged = !moved && !still();
        constexpr double bar = 0.02;
        add({"energy", "Change of the water's energy", energy_text(change->value, gain->value),
             judged  ? "no gain above 2 %"
             : moved ? "moving walls and bodies add energy"
                     : "the water is nearly still",
             "Kinetic, potential and elastic energy together, since the start; a wave that dies out or a dam that "
             "has emptied loses more than it ever had in motion. Friction takes energy away, and so does the "
             "density diffusion; nothing at rest may add any.",
             judged ? mark_of(gain->value, bar) : Health::none});
    }

    /// Of water that is at rest: how fast its particles still are in the end.
    void rest() {
        if (!still() || !data_.series.has(fields::time_series.maximum_velocity)) return;
        const double speed = data_.series[fields::time_series.maximum_velocity].back();
        const double scale = std::sqrt(data_.flow.normal_gravity() * data_.flow.total_depth());
        add({"largest_speed", "Fastest particle in the end",
             fmt::format("{:.2g} mm/s, {:.1e} of √(gH)", 1000 * speed, speed / scale), "at rest: none",
             "Still water must stay still. Particles that lie unevenly find no rest beside inclined faces; "
             "the order of magnitude is that of the spurious currents.",
             Health::none});
    }

    void momentum() {
        if (flow_kind(data_.flow) != FlowKind::periodic_box ||
            !data_.series.has(fields::time_series.total_mean_velocity)) {
            return;
        }
        const auto& mean = data_.series[fields::time_series.total_mean_velocity];
        double most = 0.0;
        for (const double value : mean) most = std::max(most, std::abs(value - mean.front()));
        const double scale = data_.flow.start.velocity.value_or(0.0);
        if (!(scale > 0.0)) return;
        constexpr double bar = 1e-3;
        add({"momentum", "Change of the mean velocity", percent(most / scale, 4) + " of the initial velocity",
             "at most 0.1 %", "No force acts on the water of a periodic box, so its momentum must stay.",
             mark_of(most / scale, bar)});
    }

    void decay() { against_theory("velocity_decay_rate", "decay", "Rate at which the vortices decay", 0.03); }
    void period() {
        against_theory("mode_period", "period", "Period of the first mode of the surface", 0.01);
    }
    void front() { against_theory("front_speed", "front", "Speed of the front against Ritter's", 0.05); }

  private:
    /// Change and gain, both over the largest kinetic energy; of still water, which has next to none, the
    /// change over the potential energy.
    [[nodiscard]] std::string energy_text(double change, double gain) const {
        const Finding* const kinetic = finding("kinetic_energy_largest");
        const auto& of = fields::time_series;
        if (still() && kinetic != nullptr && data_.series.has(of.potential_energy) &&
            data_.series[of.potential_energy].front() > 0.0) {
            const double share = change * kinetic->value / data_.series[of.potential_energy].front();
            return fmt::format("{:+.1e} of the potential energy", share);
        }
        return fmt::format("{} of the largest kinetic energy; largest gain {}", signed_percent(change),
                           percent(gain));
    }

    /// Whether the fastest water ever moves at less than two hundredths of sqrt(g H).
    [[nodiscard]] bool still() const {
        const double scale = std::sqrt(data_.flow.normal_gravity() * data_.flow.total_depth());
        const Finding* const energy = finding("kinetic_energy_largest");
        if (!(scale > 0.0) || energy == nullptr || !data_.series.has(fields::time_series.maximum_velocity)) {
            return false;
        }
        const auto& fastest = data_.series[fields::time_series.maximum_velocity];
        return *std::max_element(fastest.begin(), fastest.end()) < 0.02 * scale;
    }

    void against_theory(const char* key, const char* row, const char* label, double bar) {
        const Finding* const found = finding(key);
        if (found == nullptr || !found->reference || *found->reference == 0.0) return;
        const double share = found->value / *found->reference - 1.0;
        const double known = found->half_width ? std::abs(*found->half_width / *found->reference) : 0.0;
        // An interval wider than the bar says nothing for or against.
        const std::string interval = found->half_width ? fmt::format(" ± {:.2g}", *found->half_width) : "";
        add({row, label,
             fmt::format("{:.4g}{} {}, {} off theory", found->value, interval, found->unit,
                         signed_percent(share)),
             fmt::format("within {} of {:.4g} {}", percent(bar, 0), *found->reference, found->unit),
             fmt::format("Theory: {}.", found->reference_name),
             known > bar ? Health::none : mark_of(std::abs(share), bar, known)});
    }
};

}  // namespace

std::vector<Diagnostic> diagnose_course(const ReportData& data, const Analysis& analysis) {
    CourseRows rows(data, analysis);
    rows.volume();
    rows.particles_lost();
    rows.density();
    rows.energy();
    rows.rest();
    rows.momentum();
    rows.decay();
    rows.period();
    rows.front();
    return rows.take();
}

}  // namespace riffle::inline report
