// Time means in the x-z plane: of a grid, or of the cells around the centreline of a run in three dimensions.

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>
#include <utility>

#include "analysis/chapters.hpp"
#include "analysis/figure_tools.hpp"
#include "analysis/section_parts.hpp"
#include "case/flow_kind.hpp"
#include "case/porous_zone.hpp"
#include "hydraulics/turbulence_laws.hpp"

namespace riffle::inline analysis {

namespace {

/// Means of the mean field around the centreline, in its columns along the channel.
VelocityGrid centreline_plane(const MeanFlow& field, const Case& c) {
    const Strip strip = centreline_strip(c);
    FieldSums sums(field.x.size() * field.z.size());
    const std::vector<std::size_t> columns = columns_of_strip(field, strip.from, strip.to);
    for (std::size_t iz = 0; iz < field.z.size(); ++iz) {
        for (const std::size_t iy : columns) {
            for (std::size_t ix = 0; ix < field.x.size(); ++ix) {
                sums.add(iz * field.x.size() + ix, field.box, field.at(iz, iy, ix));
            }
        }
    }
    VelocityGrid grid;
    grid.name = fmt::format("mean over {:.3g} mm across the channel around the centreline",
                            1000.0 * (strip.to - strip.from));
    grid.x = field.x;
    grid.z = field.z;
    grid.u = sums.means(FieldQuantity::velocity);
    grid.w = sums.means(FieldQuantity::vertical_velocity);
    grid.uw = sums.means(FieldQuantity::velocity_covariance);
    grid.pressure = sums.means(FieldQuantity::pressure);
    grid.shear_stress = sums.means(FieldQuantity::shear_stress);
    return grid;
}

/// What a map shows.
struct MappedQuantity {
    const char* key;
    const char* title;
    const char* label;
    const char* unit;
    const char* source;
    bool diverging = false;
};

class PlaneMaps {
  public:
    PlaneMaps(const FlowRecord& record, const VelocityGrid& grid, Analysis& analysis)
        : record_(record), grid_(grid), analysis_(analysis) {}

    void add(const MappedQuantity& quantity, const std::vector<double>& values,
             const std::string& more = {}) {
        Figure figure = make_figure(chapters::profiles, quantity.key, quantity.title,
                                    "Time mean over the window, " + grid_.name + "." + more, quantity.source,
                                    make_axis("distance along the channel x", "m"),
                                    make_axis("height above the bed level z", "m"));
        ColourMap map;
        map.x = grid_.x;
        map.y = grid_.z;
        map.label = quantity.label;
        map.unit = quantity.unit;
        map.diverging = quantity.diverging;
        map.contours = true;
        for (const double value : values) map.values.push_back(static_cast<float>(value));
        figure.maps.push_back(std::move(map));
        const Case* const c = record_.flow();
        if (c != nullptr && has_rough_bed(*c) && grid_.x.size() > 1) {
            figure.curves.push_back(make_curve("crests of the bed", Origin::reference, Mark::line,
                                               {grid_.x.front(), grid_.x.back()}, {c->crest(), c->crest()}));
        }
        analysis_.figures.push_back(std::move(figure));
    }

    /// The stress of viscosity and closure with the Reynolds stress; of a laboratory the latter alone.
    void add_stress() {
        const Case& c = *record_.flow();
        const double density = c.fluid.density;
        const double bed = crest_stress(density, c.streamwise_gravity(), c.total_depth(), c.crest());
        const double scale = bed > 0.0 ? bed : 1.0;
        const bool closure = grid_.shear_stress.size() == grid_.uw.size();
        std::vector<double> values(grid_.uw.size());
        for (std::size_t i = 0; i < values.size(); ++i) {
            values[i] = ((closure ? grid_.shear_stress[i] : 0.0) - density * grid_.uw[i]) / scale;
        }
        const std::string over =
            bed > 0.0 ? fmt::format(" Over tau_b = rho g S0 (H - d_h) = {:.4g} Pa.", bed) : "";
        add({.key = "mean_stress_map",
             .title = closure ? "Mean shear stress" : "Mean Reynolds stress",
             .label = bed > 0.0 ? "stress tau_xz/tau_b" : "stress tau_xz",
             .unit = bed > 0.0 ? "1" : "Pa",
             .source = "thesis Figs 4.12 and 5.16",
             .diverging = true},
            values, (closure ? " Viscosity and closure, and the resolved Reynolds stress." : "") + over);
    }

  private:
    const FlowRecord& record_;
    const VelocityGrid& grid_;
    Analysis& analysis_;
};

/// Value of a grid between its points; not-a-number beyond them.
double value_in(const VelocityGrid& grid, const std::vector<double>& values, double x, double z) {
    const std::size_t width = grid.x.size();
    std::vector<double> at_height(grid.z.size());
    for (std::size_t j = 0; j < grid.z.size(); ++j) {
        const auto first = values.begin() + static_cast<std::ptrdiff_t>(j * width);
        at_height[j] =
            interpolated(grid.x, std::vector<double>(first, first + static_cast<std::ptrdiff_t>(width)), x);
    }
    return interpolated(grid.z, at_height, z);
}

/// Whether the mean flow of a run varies along the channel, so that places must be compared.
bool varies_along(const Case& c) {
    return has_bodies(c) || resistance_varies_along(c) || c.channel.ends != Ends::periodic;
}

/// The measured field of velocities and the run's departure from it.
void add_measured_field(const FlowRecord& record, const VelocityGrid* grid, Analysis& analysis) {
    const VelocityGrid& measured = record.measured().field;
    if (measured.x.empty()) return;
    const Case& c = *record.flow();
    const auto figure = [&](const char* key, const char* title, const std::string& caption) {
        return make_figure(chapters::profiles, key, title, caption, "",
                           make_axis("distance along the channel x", "m"),
                           make_axis("height above the bed level z", "m"));
    };
    const auto map_of = [&](const std::vector<double>& values, const char* label, bool diverging) {
        ColourMap map;
        map.x = measured.x;
        map.y = measured.z;
        map.label = label;
        map.unit = "m/s";
        map.diverging = diverging;
        map.contours = !diverging;
        for (const double value : values) map.values.push_back(static_cast<float>(value));
        return map;
    };
    Figure beside =
        figure("measured_velocity_map", "Measured streamwise velocity", "Time mean, " + measured.name + ".");
    beside.maps.push_back(map_of(measured.u, "streamwise velocity u", false));
    analysis.figures.push_back(std::move(beside));

    const bool places = varies_along(c);
    Figure departure =
        figure("velocity_departure_map", "Departure from the measured velocities",
               places ? "Simulated less measured mean velocity at the measured points."
                      : "Simulated mean over the length of the channel, where the mean flow is "
                        "the same at all places, less the measured velocity at each point.");
    if (places && grid == nullptr) {
        add_missing(record, analysis, std::move(departure),
                    "no means in the x-z plane were recorded; [[probe]] kind = \"grid\" in the case file "
                    "records them");
        return;
    }
    const SectionProfile centreline =
        c.has_side_walls() ? centreline_velocity_profile(record) : SectionProfile{};
    const std::vector<double>& z = centreline.z.empty() ? record.profiles().z : centreline.z;
    const std::vector<double>& u = centreline.z.empty() ? record.profiles().velocity : centreline.value;
    std::vector<double> values;
    double squares = 0.0;
    double mean = 0.0;
    double count = 0.0;
    for (std::size_t i = 0; i < measured.u.size(); ++i) {
        const double height = measured.z[i / measured.x.size()];
        const double simulated = places ? value_in(*grid, grid->u, measured.x[i % measured.x.size()], height)
                                        : interpolated(z, u, height);
        values.push_back(simulated - measured.u[i]);
        if (!std::isfinite(values.back())) continue;
        squares += values.back() * values.back();
        mean += measured.u[i];
        count += 1.0;
    }
    departure.maps.push_back(map_of(values, "departure of u", true));
    analysis.figures.push_back(std::move(departure));
    if (!(count > 0.0)) {
        analysis.warnings.emplace_back("none of the measured velocities lies where the run has water");
        return;
    }
    Finding finding = make_finding(chapters::profiles, "field_velocity_error_rms",
                                   "rms departure of u from the measured field over its mean", "1",
                                   std::sqrt(squares / count) / (mean / count));
    finding.remark = fmt::format("{:.0f} of {} points", count, measured.u.size());
    analysis.findings.push_back(std::move(finding));
}

}  // namespace

void add_plane_maps(const FlowRecord& record, Analysis& analysis) {
    VelocityGrid grid;
    if (!record.velocity_grids().empty()) {
        grid = record.velocity_grids().front();
        grid.name = "grid " + grid.name;
        if (grid.y) grid.name += fmt::format(" at y = {}", shown_place(*grid.y));
    } else if (is_three_dimensional(record) && !record.mean_field().empty()) {
        grid = centreline_plane(record.mean_field(), *record.flow());
    } else {
        if (record.flow() != nullptr) add_measured_field(record, nullptr, analysis);
        add_missing(record, analysis,
                    make_figure(chapters::profiles, "mean_velocity_map", "Mean streamwise velocity", "",
                                "thesis Figs 4.9 and 5.11", make_axis("distance along the channel x", "m"),
                                make_axis("height above the bed level z", "m")),
                    "no means in the x-z plane were recorded; [[probe]] kind = \"grid\" in the case file "
                    "records them");
        return;
    }
    if (record.flow() != nullptr) add_measured_field(record, &grid, analysis);
    PlaneMaps maps(record, grid, analysis);
    maps.add({"mean_velocity_map", "Mean streamwise velocity", "streamwise velocity u", "m/s",
              "thesis Figs 4.9 and 5.11"},
             grid.u);
    maps.add({"mean_vertical_velocity_map", "Mean vertical velocity", "vertical velocity w", "m/s",
              "thesis chapters 4 and 5", true},
             grid.w);
    if (!grid.pressure.empty()) {
        maps.add({"mean_pressure_map", "Mean pressure", "pressure p", "Pa", "thesis Figs 4.6 and 5.12"},
                 grid.pressure);
    }
    if (record.flow() == nullptr || grid.uw.empty()) return;
    maps.add_stress();
    if (grid.shear_stress.empty()) return;  // the map above is that of the Reynolds stress
    std::vector<double> reynolds = grid.uw;
    for (double& value : reynolds) value *= -record.flow()->fluid.density;
    maps.add({"reynolds_stress_map", "Resolved Reynolds stress", "-rho u'w'", "Pa", "thesis chapters 4 and 5",
              true},
             reynolds);
}

}  // namespace riffle::inline analysis
