#include "sample_analysis.hpp"

#include <cmath>
#include <functional>
#include <limits>
#include <utility>
#include <vector>

#include "analysis/figure_tools.hpp"

namespace riffle::testing {

namespace {

using std::numbers::pi;
constexpr double nan = std::numeric_limits<double>::quiet_NaN();

using Values = std::vector<double>;

Values spread(double from, double to, int count) {
    Values values;
    for (int i = 0; i < count; ++i) values.push_back(from + (to - from) * i / (count - 1));
    return values;
}

Values of(const Values& x, const std::function<double(double)>& law) {
    Values values;
    for (const double at : x) values.push_back(law(at));
    return values;
}

Figure figure(const char* key, const char* chapter, const char* title, Axis x, Axis y) {
    return make_figure(chapter, key, title,
                       "What this figure of the sample shows, in a sentence with x = U t in it.",
                       "thesis Fig. 4.4", std::move(x), std::move(y));
}

Figure velocity(double scale, Origin origin) {
    Figure made =
        figure("velocity_profile", "profiles", "Streamwise velocity",
               make_axis("streamwise velocity u", "m/s"), make_axis("height above the bed level z", "m"));
    const Values z = spread(0.001, 0.055, 28);
    const auto law = [&](double at) { return scale * 0.45 * std::pow(at / 0.055, 0.3); };
    Curve points = make_curve(origin == Origin::measured ? "measured" : "simulated", origin, Mark::points,
                              of(z, law), z);
    points.x_half_width = of(z, [](double) { return 0.004; });
    made.curves.push_back(points);
    if (origin == Origin::measured) return made;
    made.curves.push_back(make_curve("column twin", Origin::column, Mark::line,
                                     of(z, [&](double at) { return 0.99 * law(at); }), z));
    made.curves.push_back(make_curve("log law of u_*", Origin::fit, Mark::line,
                                     of(z, [&](double at) { return 0.1 * scale * std::log(at / 2e-4); }), z));
    return made;
}

Figure settling(double scale) {
    Figure made = figure("settling", "statistics", "Settling of the depth-mean velocity",
                         make_axis("time t", "s"), make_axis("depth-mean velocity U", "m/s"));
    const Values t = spread(0, 30, 601);
    Values u = of(t, [&](double at) { return scale * (0.335 + 0.02 * std::exp(-at / 4)); });
    u[100] = nan;  // a gap
    Curve running = make_curve("running mean", Origin::simulated, Mark::line, t, u);
    running.y_half_width = of(t, [](double at) { return 0.002 + 0.01 * std::exp(-at / 6); });
    made.curves = {running, make_curve("limit", Origin::theory, Mark::line, {0, 30}, {0.335, 0.335})};
    return made;
}

Figure density() {
    Figure made = figure("elevation_density", "surface", "Probability density of the elevation",
                         make_axis("elevation over its standard deviation", "1"),
                         make_axis("probability density", "1"));
    const Values x = spread(-3.5, 3.5, 29);
    const auto normal = [](double at) { return std::exp(-0.5 * at * at) / std::sqrt(2 * pi); };
    Curve bars = make_curve("simulated", Origin::simulated, Mark::bars, x,
                            of(x, [&](double at) { return normal(at) * (1 + 0.1 * std::sin(7 * at)); }));
    bars.y_half_width = of(x, [](double) { return 0.01; });
    made.curves = {bars, make_curve("normal distribution", Origin::fit, Mark::line, x, of(x, normal))};
    return made;
}

Figure spectrum(double scale, Origin origin) {
    Figure made =
        figure("elevation_spectrum", "surface", "Frequency spectrum of the elevation",
               make_axis("frequency f", "Hz", true), make_axis("power spectral density", "m2/Hz", true));
    const Values f = of(spread(-1, 1.7, 120), [](double power) { return std::pow(10.0, power); });
    const auto law = [&](double at) { return scale * 1e-7 / (1 + std::pow(at / 2, 5.0 / 3)); };
    Curve line =
        make_curve(origin == Origin::measured ? "measured" : "simulated", origin, Mark::line, f, of(f, law));
    line.y_half_width = of(f, [&](double at) { return 0.4 * law(at); });
    made.curves = {line, make_curve("slope −5/3", Origin::reference, Mark::line, {3, 40},
                                    {8e-8, 8e-8 * std::pow(40.0 / 3, -5.0 / 3)})};
    return made;
}

ColourMap map(std::string label, std::string unit, Values x, Values y,
              const std::function<double(double, double)>& law) {
    ColourMap made;
    made.label = std::move(label);
    made.unit = std::move(unit);
    for (const double at_y : y) {
        for (const double at_x : x) made.values.push_back(static_cast<float>(law(at_x, at_y)));
    }
    made.x = std::move(x);
    made.y = std::move(y);
    return made;
}

Figure space_time(double scale) {
    Figure made = figure("elevation_map", "surface", "Elevation in space and time",
                         make_axis("distance x", "m"), make_axis("time t", "s"));
    ColourMap elevation =
        map("elevation η'", "m", spread(0.001, 0.199, 100), spread(20, 22, 120),
            [&](double x, double t) { return 2e-5 * scale * std::cos(2 * pi * (x - 0.3 * t) / 0.1); });
    elevation.diverging = true;
    made.maps.push_back(elevation);
    made.curves.push_back(
        make_curve("x = U t", Origin::theory, Mark::line, {0, 0.2, nan, 0, 0.2}, {20, 20.6, nan, 21, 21.6}));
    return made;
}

Figure wavenumber_frequency() {
    Figure made = figure("wavenumber_frequency", "surface", "Spectrum in wavenumber and frequency",
                         make_axis("wavenumber k", "rad/m"), make_axis("angular frequency ω", "rad/s"));
    made.y.from = 0;
    made.y.to = 100;
    ColourMap power =
        map("power spectral density", "m3 s", spread(0, 600, 60), spread(0, 150, 80),
            [](double k, double w) { return 1e-9 * std::exp(-std::pow((w - 0.3 * k) / 8, 2)) + 1e-14; });
    power.logarithmic = true;
    made.maps.push_back(power);
    const Values k = spread(0, 300, 50);
    made.curves = {
        make_curve("gravity-capillary waves", Origin::theory, Mark::line, k,
                   of(k, [](double at) { return std::sqrt(9.81 * at + 7.3e-5 * at * at * at); })),
        make_curve("advection", Origin::theory, Mark::line, k, of(k, [](double at) { return 0.3 * at; }), 1)};
    return made;
}

Figure field() {
    Figure made = figure("velocity_field", "subsurface", "Vertical velocity", make_axis("distance x", "m"),
                         make_axis("height above the bed level z", "m"));
    made.y.equal_scale = true;
    made.maps.push_back(
        map("vertical velocity w", "m/s", spread(0, 0.2, 50), spread(0, 0.05, 14),
            [](double x, double z) { return z < 0.004 ? nan : 0.004 * std::sin(31 * x) * z; }));
    return made;
}

Figure absent() {
    Figure made = figure("correlation", "surface", "Temporal cross-correlation", make_axis("lag t_l", "s"),
                         make_axis("R", "1"));
    made.missing = "the record of 2.0 s is shorter than ten integral time scales; run longer.";
    return made;
}

}  // namespace

Analysis sample_analysis(const std::string& name, double scale) {
    Analysis analysis;
    analysis.name = name;
    analysis.source = name + "/results.h5";
    analysis.warnings = {"a warning of the sample <with> marks & more"};
    analysis.figures = {settling(scale),   velocity(scale, Origin::simulated),
                        density(),         spectrum(scale, Origin::simulated),
                        space_time(scale), wavenumber_frequency(),
                        absent(),          field()};
    Finding mean =
        make_finding("profiles", "depth_mean_velocity", "depth-mean velocity U", "m/s", 0.335 * scale);
    mean.half_width = 0.0012;
    mean.reference = 0.35;
    mean.reference_name = "measured (thesis Table 3.1)";
    Finding deviation = make_finding("surface", "surface_standard_deviation",
                                     "standard deviation of the elevation", "m", 1.4e-5 * scale);
    deviation.half_width = 2e-6;
    deviation.reference = 4e-4;
    deviation.reference_name = "measured (thesis Table 3.1)";
    deviation.remark = "the closure averages the turbulence out";
    analysis.findings = {mean, deviation,
                         make_finding("statistics", "integral_time", "integral time scale of U", "s", 0.05),
                         make_finding("statistics", "undefined", "a value that is not known", "1", nan)};
    return analysis;
}

Analysis sample_record(const std::string& name) {
    Analysis analysis;
    analysis.name = name;
    analysis.source = name + ".csv";
    analysis.figures = {velocity(1.04, Origin::measured), spectrum(3, Origin::measured)};
    analysis.findings = {
        make_finding("profiles", "depth_mean_velocity", "depth-mean velocity U", "m/s", 0.35)};
    return analysis;
}

}  // namespace riffle::testing
