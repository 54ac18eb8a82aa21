// Signs of health of the particles over time: how they fluctuate, how they lie, how dense they are.

#include "analysis/chapters.hpp"
#include "analysis/figure_tools.hpp"
#include "record/flow_fields.hpp"

namespace riffle::inline analysis {

namespace {

/// A curve of such a figure: its series, its name.
struct Sign {
    Field series;
    const char* name;
};

void add_signs(const FlowRecord& record, Figure figure, const std::vector<Sign>& signs, Analysis& analysis) {
    const SeriesTable& series = record.series();
    const std::vector<double>& time = series[fields::time_series.time];
    int variant = 0;
    for (const Sign& sign : signs) {
        if (!series.has(sign.series) || time.size() < 2) continue;
        figure.curves.push_back(make_curve(sign.name, Origin::simulated, Mark::line, thinned(time),
                                           thinned(series[sign.series]), variant++));
    }
    if (figure.curves.empty()) {
        add_missing(record, analysis, std::move(figure), "the results file holds no such time series yet");
        return;
    }
    mark_window(record, figure);
    analysis.figures.push_back(std::move(figure));
}

}  // namespace

void analyse_particles(const FlowRecord& record, Analysis& analysis) {
    if (record.flow() == nullptr || record.origin() != Origin::simulated) return;
    const auto figure = [](const char* key, const char* title, const char* caption, const char* label,
                           const char* unit) {
        return make_figure(chapters::particles, key, title, caption, "", make_axis("time t", "s"),
                           make_axis(label, unit));
    };
    const auto& of = fields::time_series;
    add_signs(record,
              figure("fluctuation_history", "Fluctuation of the particles",
                     "Rms departure of the particle velocities from the mean of their layer.",
                     "velocity fluctuation", "m/s"),
              {{of.velocity_fluctuation, "velocity fluctuation"}}, analysis);
    Figure order =
        figure("order_history", "Order of the particles",
               "Layering of the particles: 1: perfect rows, 0: none.", "order of the particles", "1");
    order.y.from = 0.0;
    order.y.to = 1.05;
    add_signs(record, std::move(order), {{of.particle_order, "order"}}, analysis);
    add_signs(
        record,
        figure("density_history", "Extremes of the density",
               "Largest and smallest density of a particle, relative to that of water at rest under no load.",
               "relative density deviation", "1"),
        {{of.density_deviation_maximum, "largest"}, {of.density_deviation_minimum, "smallest"}}, analysis);
    add_signs(record,
              figure("speed_history", "Largest speed of a particle", "Speed of the fastest particle.",
                     "largest speed", "m/s"),
              {{of.maximum_velocity, "fastest particle"}}, analysis);
}

}  // namespace riffle::inline analysis
