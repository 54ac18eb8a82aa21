// What of the fluctuations of resolved eddies is a flow, and what the noise of the particles.

#include <fmt/format.h>

#include <array>
#include <string>
#include <utility>
#include <vector>

#include "analysis/figure_tools.hpp"
#include "analysis/profile_parts.hpp"
#include "case/flow_kind.hpp"

namespace riffle::inline analysis {

namespace {

constexpr std::array names = {"u'", "v'", "w'"};

std::string snapshots_text(const EddiesAndNoise& split) {
    return fmt::format("from {} snapshot{}", split.snapshots, split.snapshots == 1 ? "" : "s");
}

// Of the depth over the datum: where neither the bed nor the surface is near.
constexpr double middle_from = 0.2;
constexpr double middle_to = 0.8;

/// Mean of a quantity over the layers there.
template <class Value>
double mean_at_middle(const FlowRecord& record, const EddiesAndNoise& split, const Value& value) {
    const double datum = record.flow()->datum();
    const double depth = water_depth(record);
    double sum = 0.0;
    int count = 0;
    for (std::size_t i = 0; i < split.z.size(); ++i) {
        const double height = (split.z[i] - datum) / depth;
        if (height > middle_from && height < middle_to) {
            sum += value(i);
            ++count;
        }
    }
    return count > 0 ? sum / count : 0.0;
}

/// Eddies that have to live in water of the noise's viscosity need a Reynolds number like any others.
void add_noise_viscosity(const FlowRecord& record, const EddiesAndNoise& split, Analysis& analysis) {
    const Case& c = *record.flow();
    const double h = water_depth(record);
    const double viscosity = noise_viscosity(split, c.datum() + middle_from * h, c.datum() + middle_to * h);
    if (!(viscosity > 0.0)) return;
    Finding noise = make_finding(chapters::profiles, "noise_viscosity",
                                 "viscosity that the particles' noise acts as", "m2/s", viscosity);
    noise.remark =
        "what it carries of the Reynolds stress over the gradient of the mean velocity, 0.2 to 0.8 of the depth";
    analysis.findings.push_back(std::move(noise));
    Finding reynolds =
        make_finding(chapters::profiles, "reynolds_number_with_noise",
                     "Reynolds number u_* h/nu with the viscosity of water and noise", "1",
                     friction_velocity_of(record) * h / (c.fluid.kinematic_viscosity + viscosity));
    reynolds.remark =
        "of the flow in which the eddies live: where it is small they die out, and the water runs faster";
    analysis.findings.push_back(std::move(reynolds));
}

Figure intensities(const FlowRecord& record, const EddiesAndNoise& split) {
    const Case& c = *record.flow();
    Figure figure = make_figure(
        chapters::profiles, "eddies_and_noise", "Eddies and noise",
        fmt::format("Root mean squares over the friction velocity of the velocities that neighbours share "
                    "(the linear field that fits those within {:.2g} spacings) and of what each particle "
                    "departs from it, {}. Eddies smaller than some four spacings count as noise.",
                    noise_reach, snapshots_text(split)),
        "", make_axis("intensity over friction velocity", "1"),
        make_axis("height above the datum over depth z/h", "1"));
    const double friction_velocity = friction_velocity_of(record);
    std::vector<double> height;
    const double depth = water_depth(record);
    for (const double z : split.z) height.push_back((z - c.datum()) / depth);
    const auto add = [&](const std::string& name, std::vector<double> rms, Mark mark, int variant) {
        for (double& value : rms) value /= friction_velocity;
        figure.curves.push_back(make_curve(name, Origin::simulated, mark, std::move(rms), height, variant));
    };
    for (std::size_t k = 0; k < names.size(); ++k) {
        const int variant = k == 0 ? 0 : (k == 1 ? 2 : 1);  // as in the figure of the intensities
        add(fmt::format("{} of the eddies", names[k]), split.eddies[k], Mark::line_and_points, variant);
        add(fmt::format("{} of the noise", names[k]), split.noise[k], Mark::line, variant);
    }
    return figure;
}

Figure stresses(const FlowRecord& record, const EddiesAndNoise& split) {
    Figure figure = profile_figure(
        "stress_of_eddies", "Reynolds stress of eddies and of noise",
        fmt::format("-ρ⟨u'w'⟩ of the particles, of the velocities that neighbours share, and the rest, which "
                    "the noise of the particles carries, {}.",
                    snapshots_text(split)),
        "", make_axis("stress", "Pa"));
    const double density = record.flow()->fluid.density;
    std::vector<double> all;
    std::vector<double> eddies;
    std::vector<double> noise;
    for (std::size_t i = 0; i < split.z.size(); ++i) {
        all.push_back(density * split.stress[i]);
        eddies.push_back(density * split.stress_of_eddies[i]);
        noise.push_back(all.back() - eddies.back());
    }
    figure.curves.push_back(profile_curve("all", Origin::simulated, all, split.z, Mark::points));
    figure.curves.push_back(profile_curve("eddies", Origin::simulated, eddies, split.z));
    figure.curves.push_back(profile_curve("noise", Origin::simulated, noise, split.z));
    figure.curves[2].variant = 1;
    mark_levels(record, figure);
    return figure;
}

}  // namespace

void add_eddies_and_noise(const FlowRecord& record, Analysis& analysis) {
    const EddiesAndNoise& split = record.eddies_and_noise();
    if (split.empty() || friction_velocity_of(record) <= 0.0) return;
    if (between_side_walls(record)) {
        const std::string why =
            "between side walls the departures from a layer's mean over the width are those of the mean flow across "
            "the channel, no eddies";
        for (Figure figure : {intensities(record, split), stresses(record, split)}) {
            figure.curves.clear();
            add_missing(record, analysis, std::move(figure), why);
        }
        return;
    }
    analysis.figures.push_back(intensities(record, split));
    analysis.figures.push_back(stresses(record, split));
    const auto squared = [](double value) { return value * value; };
    const double noise =
        mean_at_middle(record, split, [&](std::size_t i) { return squared(split.noise[2][i]); });
    const double eddies =
        mean_at_middle(record, split, [&](std::size_t i) { return squared(split.eddies[2][i]); });
    if (noise + eddies > 0.0) {
        Finding share = make_finding(chapters::profiles, "noise_share_of_vertical_velocity",
                                     "share of the particles' noise in w'^2, 0.2 to 0.8 of the depth", "1",
                                     noise / (noise + eddies));
        share.remark = snapshots_text(split) +
                       "; noise: what a particle departs from the linear field of its neighbours, eddies "
                       "smaller than four spacings included";
        analysis.findings.push_back(std::move(share));
    }
    const double stress = mean_at_middle(record, split, [&](std::size_t i) { return split.stress[i]; });
    if (stress > 0.0) {
        analysis.findings.push_back(make_finding(
            chapters::profiles, "eddies_share_of_stress",
            "share of the Reynolds stress that eddies carry, 0.2 to 0.8 of the depth", "1",
            mean_at_middle(record, split, [&](std::size_t i) { return split.stress_of_eddies[i]; }) /
                stress));
    }
    add_noise_viscosity(record, split, analysis);
}

}  // namespace riffle::inline analysis
