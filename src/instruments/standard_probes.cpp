#include "instruments/standard_probes.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <string>
#include <utility>

#include "case/end_buffers.hpp"
#include "case/units.hpp"

namespace riffle::inline instruments {

namespace {

/// Positions of the laboratory's wave probes along the centreline (thesis, chapter 3), m.
constexpr std::array<double, 4> laboratory_probes = {0.0, 0.028, 0.1203, 0.3003};

constexpr double usual_frequency = 100.0;  ///< Hz, as the laboratory sampled
constexpr int profile_points = 16;
constexpr std::size_t prefix_length = std::char_traits<char>::length(standard_probe_prefix);

class StandardSet {
  public:
    StandardSet(const Case& c, double largest_step) : c_(c) {
        // Halved where the steps are long.
        const double limit = 0.25 / largest_step;
        for (frequency_ = usual_frequency; frequency_ > limit && frequency_ > 1e-6;) frequency_ *= 0.5;
    }

    [[nodiscard]] StandardProbes make() && {
        const bool surface = c_.channel.top == Top::free_surface;
        const bool flow = c_.channel.ends == Ends::periodic && c_.channel.slope > 0.0;
        velocity_profile();
        if (surface) wave_probes(flow);
        if (c_.channel.top != Top::periodic) {
            if (flow) {
                add(ProbeKind::flow_rate, "flow_rate").x = {0.5 * c_.channel.length};
            }
            if (c_.channel.ends == Ends::open) {
                add(ProbeKind::flow_rate, "flow_rate").x = along({0.25, 0.5, 0.75});
                add(ProbeKind::flow_rate, "end_sections").x = along({0.0, 1.0});
                const auto [first, last] = momentum_sections(c_);
                add(ProbeKind::flow_rate, momentum_sections_name + prefix_length).x = {first, last};
            }
            add(ProbeKind::force, "force");
        }
        return std::move(set_);
    }

  private:
    Probe& add(ProbeKind kind, const char* name) {
        Probe probe;
        probe.name = std::string(standard_probe_prefix) + name;
        probe.kind = kind;
        probe.sampling_frequency = frequency_;
        set_.probes.push_back(std::move(probe));
        return set_.probes.back();
    }

    /// Places at shares of the length.
    [[nodiscard]] std::vector<double> along(std::vector<double> shares) const {
        for (double& share : shares) share *= c_.channel.length;
        return shares;
    }

    /// At mid-channel from the crests, on a smooth bed from a twentieth of the depth, to 0.95 of the depth;
    /// of a standing wave at the quarter of its length, where the water moves along.
    void velocity_profile() {
        const double depth = c_.total_depth();
        const double lowest = std::max(c_.crest(), 0.05 * depth);
        const double highest = 0.95 * depth;
        Probe& profile = add(ProbeKind::velocity, "velocity");
        profile.x = {(c_.start.kind == StartKind::standing_wave ? 0.25 : 0.5) * c_.channel.length};
        for (int i = 0; i < profile_points; ++i) {
            profile.z.push_back(lowest + (highest - lowest) * i / (profile_points - 1));
        }
    }

    /// Where the laboratory had them, in a flow; else at the ends, the quarter and the middle.
    void wave_probes(bool flow) {
        const double length = c_.channel.length;
        std::vector<double> x;
        if (c_.channel.ends == Ends::open) {
            x = along({0.0, 0.25, 0.5, 0.75, 1.0});
        } else if (!flow) {
            x = along({0.0, 0.25, 0.5});
            if (c_.channel.ends == Ends::walls) x.push_back(length);
        } else {
            for (const double position : laboratory_probes) {
                if (position < length) {
                    x.push_back(position);
                } else {
                    set_.notes.push_back(fmt::format(
                        "standard_wave: the laboratory's wave probe at x = {:.4g} mm is left out, as the "
                        "channel is {} long",
                        1e3 * position, quantity_text(length, Dimension::length)));
                }
            }
        }
        add(ProbeKind::wave, "wave").x = std::move(x);
    }

    const Case& c_;
    double frequency_ = usual_frequency;
    StandardProbes set_;
};

}  // namespace

StandardProbes standard_probes(const Case& c, double largest_step) {
    return c.output.standard_probes ? StandardSet(c, largest_step).make() : StandardProbes{};
}

}  // namespace riffle::inline instruments
