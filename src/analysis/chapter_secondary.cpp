// The secondary flow of a run in three dimensions: how strong it is, whether it survives averaging, cells and
// vortices.

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include "analysis/chapters.hpp"
#include "analysis/figure_tools.hpp"
#include "analysis/secondary_flow.hpp"
#include "analysis/section_parts.hpp"
#include "analysis/vortices.hpp"
#include "case/bed_traits.hpp"

namespace riffle::inline analysis {

namespace {

constexpr double thesis_averaging_time = 0.2;  // s

/// What the chapter starts from.
struct Setting {
    const MeanFlow& field;
    const Case& c;
    double velocity = 0;  ///< U, m/s
    bool periodic = false;

    [[nodiscard]] SecondaryFlow flow(const FieldSums& section) const {
        return secondary_flow(field, section, c.datum(), periodic);
    }
};

Finding over_velocity(const Setting& s, std::string key, std::string label, double value, double half_width) {
    return make_finding(chapters::secondary, std::move(key), std::move(label), "1", value / s.velocity,
                        half_width / s.velocity);
}

void add_strength(const Setting& s, Analysis& analysis) {
    const auto strength = [&](double SecondaryStrength::*member) {
        return section_estimate(
            s.field, [&](const FieldSums& section) { return strength_of(s.flow(section)).*member; });
    };
    const Estimate mean = strength(&SecondaryStrength::mean);
    const Estimate largest = strength(&SecondaryStrength::largest);
    analysis.findings.push_back(against(
        over_velocity(s, "secondary_strength_mean",
                      "secondary flow: mean of sqrt(V^2 + W^2) above the datum over U", mean.value,
                      mean.half_width),
        0.016, "thesis, 1.2 to 2.0 %",
        fmt::format("averaged over {:.4g} s and the length; the thesis averages over {} s",
                    s.field.interval * static_cast<double>(s.field.time.size()), thesis_averaging_time)));
    analysis.findings.push_back(over_velocity(s, "secondary_strength_largest", "its largest value over U",
                                              largest.value, largest.half_width));
}

std::string verdict_of(const Estimate& persistent, double left) {
    if (!std::isfinite(persistent.half_width)) {
        return "too few windows of the mean field to tell a cell from fluctuation";
    }
    if (persistent.value > persistent.half_width) {
        return fmt::format(
            "a motion across the flow survives the averaging: its mean square is {:.2g} times "
            "its 95 % half-width",
            persistent.value / persistent.half_width);
    }
    return fmt::format(
        "no motion across the flow stands out: at 95 % what lasts is below {:.2g} of U, and "
        "the map shows fluctuation that averaging has not removed",
        left);
}

void add_survival(const FlowRecord& record, const Setting& s, Analysis& analysis) {
    Figure figure = make_figure(
        chapters::secondary, "secondary_strength_averaging",
        "Strength of the secondary flow against averaging time",
        "Root mean square and largest sqrt(V^2 + W^2) of means over stretches of time, over U. What is "
        "fluctuation falls as 1/sqrt(T); the horizontal line is what the products of different stretches "
        "have in common, the part that lasts; the curve is both together.",
        "thesis chapter 5, strength of the secondary flow", make_axis("averaging time T", "s", true),
        make_axis("strength over U", "1", true));
    const SecondarySurvival survival = secondary_survival(s.field, s.c.datum(), s.periodic);
    if (s.field.time.size() < 2) {
        add_missing(record, analysis, std::move(figure),
                    "the averaging window holds one window of the mean field only; set "
                    "output.mean_field_interval shorter");
        return;
    }
    Curve rms = make_curve("rms", Origin::simulated, Mark::line_and_points, {}, {});
    Curve largest = make_curve("largest", Origin::simulated, Mark::line_and_points, {}, {});
    largest.variant = 1;
    for (const AveragedStrength& averaged : survival.averaged) {
        rms.x.push_back(averaged.time);
        rms.y.push_back(averaged.strength.root_mean_square / s.velocity);
        largest.x.push_back(averaged.time);
        largest.y.push_back(averaged.strength.largest / s.velocity);
    }
    const double interval = s.field.interval;
    const double all = survival.averaged.back().time;
    const Estimate& persistent = survival.persistent;
    const double lasting = std::sqrt(std::max(0.0, persistent.value));
    const double bound = std::isfinite(persistent.half_width)
                             ? std::sqrt(std::max(0.0, persistent.value + persistent.half_width))
                             : std::numeric_limits<double>::quiet_NaN();
    Curve law = make_curve("what lasts and fluctuation as 1/sqrt(T)", Origin::theory, Mark::line, {}, {});
    for (int i = 0; i <= 40; ++i) {
        const double from = std::min(thesis_averaging_time, interval);
        const double time = from * std::pow(all / from, i / 40.0);
        const double square = survival.mean_square_after(time, interval);
        law.x.push_back(time);
        law.y.push_back(std::sqrt(std::max(0.0, square)) / s.velocity);
    }
    figure.curves.push_back(std::move(rms));
    figure.curves.push_back(std::move(largest));
    figure.curves.push_back(std::move(law));
    if (lasting > 0.0) {
        figure.curves.push_back(make_curve("what lasts", Origin::fit, Mark::line,
                                           {figure.curves.back().x.front(), all},
                                           {lasting / s.velocity, lasting / s.velocity}));
    }
    analysis.figures.push_back(std::move(figure));

    Finding lasts = over_velocity(s, "secondary_lasting_rms",
                                  "rms of the secondary flow that lasts over the windows, over U", lasting,
                                  // Not told from zero: the interval reaches down to it.
                                  persistent.value > persistent.half_width ? bound - lasting
                                  : std::isfinite(bound) ? std::max(lasting, bound - lasting)
                                                         : std::numeric_limits<double>::infinity());
    lasts.remark = verdict_of(persistent, bound / s.velocity);
    analysis.findings.push_back(std::move(lasts));
    Finding left = over_velocity(
        s, "secondary_fluctuation_left", "rms of the fluctuation left in the mean field, over U",
        std::sqrt(std::max(0.0, survival.mean_square_after(all, interval) - persistent.value)),
        std::numeric_limits<double>::infinity());
    left.remark = fmt::format("after {:.4g} s; it falls as 1/sqrt(T)", all);
    analysis.findings.push_back(std::move(left));
    Finding brief = over_velocity(
        s, "secondary_strength_brief", "rms of the secondary flow averaged over 0.2 s only, over U",
        std::sqrt(std::max(0.0, survival.mean_square_after(thesis_averaging_time, interval))),
        std::numeric_limits<double>::infinity());
    brief.remark = std::abs(interval - thesis_averaging_time) < 1e-6
                       ? "from the windows of this length"
                       : fmt::format(
                             "from windows of {:.3g} s and the law of the figure: an upper bound where the "
                             "fluctuation's own time scale is longer",
                             interval);
    analysis.findings.push_back(std::move(brief));
}

void add_cells(const Setting& s, Analysis& analysis) {
    const double scale = s.velocity * s.c.total_depth();
    FieldEstimates psi = section_estimates(s.field, [&](const FieldSums& section) {
        return depth_mean_streamfunction(s.field, s.flow(section));
    });
    const std::vector<SecondaryCell> cells = secondary_cells(s.field.y, psi, s.c.channel.simulated_width());
    const bool known = std::isfinite(psi.half_width.front());
    for (double& value : psi.value) value /= scale;
    for (double& value : psi.half_width) value /= scale;
    Figure figure = make_figure(
        chapters::secondary, "secondary_streamfunction", "Streamfunction across the channel",
        "Mean over the depth of the streamfunction of (V, W), over U H, with 95 % intervals. A cell is a "
        "stretch of one sign beyond its interval.",
        "", across_axis(s.c, "/H"), make_axis("streamfunction over U H", "1"));
    std::vector<double> y = s.field.y;
    for (double& value : y) value /= s.c.total_depth();
    Curve curve = make_curve("simulated", Origin::simulated, Mark::line, y, psi.value);
    if (known) curve.y_half_width = psi.half_width;
    figure.curves.push_back(std::move(curve));
    analysis.figures.push_back(std::move(figure));
    if (!known) return;
    Finding count =
        make_finding(chapters::secondary, "secondary_cells", "cells of the secondary flow across the channel",
                     "1", static_cast<double>(cells.size()));
    count.remark = cells.empty()
                       ? "no place where the streamfunction stands out of its 95 % interval"
                       : "each place by itself: where nothing lasts, one in twenty stands out by chance";
    analysis.findings.push_back(std::move(count));
    if (cells.empty()) return;
    double width = 0.0;
    for (const SecondaryCell& cell : cells) {
        width += (cell.to - cell.from) / static_cast<double>(cells.size());
    }
    analysis.findings.push_back(
        against(make_finding(chapters::secondary, "secondary_cell_width", "mean width of the cells over H",
                             "1", width / s.c.total_depth()),
                1.05, "thesis, 0.9 to 1.2"));
}

void add_vortices(const FieldSums& section, const Setting& s, Analysis& analysis) {
    const SecondaryFlow flow = s.flow(section);
    CellBox plane;
    plane.cells = {s.field.y.size(), s.field.z.size(), 1};
    plane.spacing = {s.field.cell_width(), s.field.cell_height(), 0.0};
    plane.periodic = {s.periodic, false, false};
    const std::vector<double> swirl = swirling_strength(plane, flow.v, flow.w);
    const double scale = s.velocity / s.c.total_depth();
    std::vector<double> scaled = swirl;
    for (double& value : scaled) value /= scale;
    Figure figure = section_figure(
        chapters::secondary, "swirling_strength_map", "Swirling strength of the mean motion across the flow",
        "Imaginary part of the eigenvalues of the gradient of (V, W), with the sign of the rotation, over "
        "U/H; arrows: (V, W).",
        "thesis chapter 5, vortices; Zhou et al. 1999");
    figure.maps.push_back(section_map(s.field, s.c, scaled, "swirling strength lambda_ci H/U", "1", true));
    figure.maps.back().contours = false;
    figure.curves.push_back(section_vectors(s.field, section, s.c, s.velocity, "U"));
    analysis.figures.push_back(std::move(figure));

    constexpr double threshold = 1.5;  // times the rms, Wu & Christensen (2006)
    const double least = threshold * root_mean_square(swirl);
    double area = 0.0;
    double number = 0.0;
    double standing = 0.0;
    for (const bool positive : {true, false}) {
        std::vector<bool> marked(swirl.size());
        for (std::size_t i = 0; i < swirl.size(); ++i) {
            marked[i] = least > 0.0 && (positive ? swirl[i] : -swirl[i]) > least;
        }
        for (const std::vector<std::size_t>& region : connected_regions(plane, marked, 4)) {
            const double size = static_cast<double>(region.size()) * plane.spacing[0] * plane.spacing[1];
            const Estimate circulation = section_estimate(s.field, [&](const FieldSums& sums) {
                const SecondaryFlow part = s.flow(sums);
                const std::vector<double> rotation = plane_vorticity(plane, part.v, part.w);
                double sum = 0.0;
                for (const std::size_t cell : region) {
                    if (std::isfinite(rotation[cell])) sum += rotation[cell];
                }
                return sum;
            });
            area += size;
            number += 1.0;
            if (std::abs(circulation.value) > circulation.half_width) standing += 1.0;
        }
    }
    Finding count = make_finding(chapters::secondary, "vortices",
                                 "vortices in the mean motion across the flow", "1", number);
    count.remark = fmt::format(
        "regions of at least 4 cells with a swirling strength above {} times its rms; "
        "{:.0f} of them have a circulation beyond its 95 % interval",
        threshold, standing);
    analysis.findings.push_back(std::move(count));
    if (number > 0.0) {
        analysis.findings.push_back(
            make_finding(chapters::secondary, "vortex_diameter",
                         "mean diameter of the vortices, of a circle of their area, over H", "1",
                         std::sqrt(4.0 * area / number / std::numbers::pi) / s.c.total_depth()));
    }
}

void add_space_vortices(const Setting& s, Analysis& analysis) {
    const MeanFlow& field = s.field;
    CellBox box;
    box.cells = {field.x.size(), field.y.size(), field.z.size()};
    box.spacing = {field.cell_length(), field.cell_width(), field.cell_height()};
    box.periodic = {s.c.channel.ends == Ends::periodic, s.periodic, false};
    if (field.x.size() < 3 || field.y.size() < 3) return;
    const std::array velocity = {field.box.means(FieldQuantity::velocity),
                                 field.box.means(FieldQuantity::spanwise_velocity),
                                 field.box.means(FieldQuantity::vertical_velocity)};
    const std::vector<double> q = q_criterion(box, velocity);
    const double least = root_mean_square(q);
    std::vector<bool> marked(q.size());
    double share = 0.0;
    double wet = 0.0;
    for (std::size_t i = 0; i < q.size(); ++i) {
        marked[i] = least > 0.0 && q[i] > least;
        wet += std::isfinite(q[i]) ? 1.0 : 0.0;
        share += marked[i] ? 1.0 : 0.0;
    }
    const std::vector<std::vector<std::size_t>> regions = connected_regions(box, marked, 8);
    Finding count = make_finding(chapters::secondary, "vortex_regions",
                                 "regions of the mean flow in space with Q above its rms", "1",
                                 static_cast<double>(regions.size()));
    count.remark = fmt::format(
        "of at least 8 cells; Q > rms in {:.2g} % of the water{}", wet > 0.0 ? 100.0 * share / wet : 0.0,
        has_spheres(s.c.bed) ? "; behind the spheres the mean flow turns at each of them" : "");
    analysis.findings.push_back(std::move(count));
    const auto middle = static_cast<std::size_t>(
        std::lower_bound(field.z.begin(), field.z.end(), s.c.crest()) - field.z.begin());
    const std::size_t iz = std::min(middle, field.z.size() - 1);
    Figure figure = make_figure(
        chapters::secondary, "q_criterion_map", "Q of the mean flow at the crests",
        fmt::format("Q = (|Omega|^2 - |S|^2)/2 of the mean velocity in space, over (U/H)^2, at {:.3g} mm "
                    "above the bed level: positive where the mean flow turns more than it strains.",
                    1000.0 * field.z[iz]),
        "Hunt et al. 1988", make_axis("distance along the channel x", "m"), across_axis(s.c));
    ColourMap map;
    map.x = field.x;
    map.y = field.y;
    map.label = "Q H^2/U^2";
    map.unit = "1";
    map.diverging = true;
    const double scale = std::pow(s.velocity / s.c.total_depth(), 2);
    for (std::size_t cell = 0; cell < field.x.size() * field.y.size(); ++cell) {
        map.values.push_back(static_cast<float>(q[iz * field.x.size() * field.y.size() + cell] / scale));
    }
    figure.maps.push_back(std::move(map));
    analysis.figures.push_back(std::move(figure));
}

}  // namespace

void analyse_secondary(const FlowRecord& record, Analysis& analysis) {
    if (!is_three_dimensional(record)) return;
    const MeanFlow& field = record.mean_field();
    const Case& c = *record.flow();
    const double velocity = bulk_velocity(record);
    if (field.empty() || !(velocity > 0.0)) {
        add_missing(
            record, analysis,
            make_figure(chapters::secondary, "secondary_strength_averaging",
                        "Strength of the secondary flow against averaging time", "", "",
                        make_axis("averaging time T", "s", true), make_axis("strength over U", "1", true)),
            field.empty() ? "the results file holds no window of the mean field within the averaging window"
                          : "no depth-mean velocity is known to compare with");
        return;
    }
    const Setting setting{field, c, velocity, c.channel.sides == Sides::periodic};
    add_strength(setting, analysis);
    add_survival(record, setting, analysis);
    add_cells(setting, analysis);
    add_vortices(field.section(), setting, analysis);
    add_space_vortices(setting, analysis);
}

}  // namespace riffle::inline analysis
