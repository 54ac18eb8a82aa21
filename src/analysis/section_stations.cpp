// Profiles at distances from the side wall, and across the channel at the heights that were measured.

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "analysis/chapters.hpp"
#include "analysis/figure_tools.hpp"
#include "analysis/section_parts.hpp"
#include "analysis/section_points.hpp"
#include "case/flow_conditions.hpp"
#include "hydraulics/profile_comparison.hpp"
#include "hydraulics/turbulence_laws.hpp"

namespace riffle::inline analysis {

namespace {

/// Distances from the wall, over the depth, at which the thesis shows profiles: those of its condition 8 for
/// that flow and for narrow channels, else those of condition 2.
std::vector<double> thesis_places(const Case& c) {
    const double half = c.channel.centreline() / c.total_depth();
    const bool narrow = flow_condition_of(c) == 8 || half < 2.2;
    std::vector<double> places;
    for (const double place : narrow ? std::vector{0.4, 1.2, 2.3} : std::vector{1.0, 2.2, 3.2, 3.9, 4.6}) {
        if (place <= half) places.push_back(place);
    }
    return places;
}

/// What the thesis says of its largest MSEP of u at these places, %.
std::optional<double> thesis_error(const Case& c) {
    const auto condition = flow_condition_of(c);
    if (condition == 2) return 2.0;
    if (condition == 8) return 3.0;
    return std::nullopt;
}

/// A place across the channel with what was measured there, which may be nothing.
struct Station {
    double y = 0;
    MeasuredStation measured;
};

std::vector<Station> stations_of(const Case& c, const SectionPoints& points) {
    std::vector<Station> stations;
    for (MeasuredStation& each : measured_stations(points)) stations.push_back({each.y, std::move(each)});
    if (!stations.empty()) return stations;
    for (const double place : thesis_places(c)) stations.push_back({place * c.total_depth(), {}});
    return stations;
}

std::vector<double> half_widths(const std::vector<double>& uncertainty) {
    std::vector<double> result;
    if (std::none_of(uncertainty.begin(), uncertainty.end(), [](double u) { return std::isfinite(u); })) {
        return result;
    }
    for (const double u : uncertainty) result.push_back(normal_95 * u);
    return result;
}

bool any_finite(const std::vector<double>& values) {
    return std::any_of(values.begin(), values.end(), [](double value) { return std::isfinite(value); });
}

/// The figures of the stations, filled station by station.
class StationFigures {
  public:
    StationFigures(const FlowRecord& record, Analysis& analysis)
        : record_(record),
          analysis_(analysis),
          c_(*record.flow()),
          simulated_(is_three_dimensional(record)),
          velocity_(figure("station_velocity_profile", "Streamwise velocity at distances from the side wall",
                           "thesis Figs 5.23 and 5.26", make_axis("streamwise velocity u", "m/s"))),
          stress_(figure("station_stress_profile", "Shear stress at distances from the side wall",
                         "thesis Figs 5.25 and 5.28", make_axis("shear stress tau_xz", "Pa"))),
          error_(figure("station_msep_profile", "MSEP of the velocity at distances from the side wall",
                        "thesis Figs 5.24(a) and 5.27", make_axis("MSEP of u", "%"))),
          gradient_(figure("station_msep_gradient_profile",
                           "MSEP of the velocity gradient at distances from the side wall",
                           "thesis Fig. 5.24(b)", make_axis("MSEP of du/dz", "%"))) {
        if (simulated_) {
            stress_.caption +=
                " Stress of viscosity and closure and resolved Reynolds stress; measured: Reynolds stress.";
        }
    }

    void add(const Station& station) {
        name_ = fmt::format("y/H = {:.2g}", station.y / c_.total_depth());
        add_velocity(station);
        add_stress(station);
        ++variant_;
    }

    void finish() {
        const double bed =
            crest_stress(c_.fluid.density, c_.streamwise_gravity(), c_.total_depth(), c_.crest());
        if (bed > 0.0 && !stress_.curves.empty()) {
            stress_.curves.push_back(make_curve("wide channel (4.6)", Origin::theory, Mark::line, {bed, 0.0},
                                                {c_.crest(), c_.total_depth()}));
        }
        take(velocity_, "none of the thesis' distances from the wall lies in this channel");
        take(stress_, "none of the thesis' distances from the wall lies in this channel");
        if (!simulated_) return;
        const char* const without =
            "no profiles at distances from the side wall were measured: --measured FILE.csv with columns "
            "y, z and u";
        take(error_, without);
        take(gradient_, without);
        if (std::isfinite(most_)) {
            analysis_.findings.push_back(
                against(make_finding(chapters::section, "station_msep_largest",
                                     "largest mean MSEP of u over the depth at the stations", "%", most_),
                        thesis_error(c_), "thesis, 3D simulations, largest at a point", "at " + where_));
        }
        if (std::isfinite(most_stress_)) {
            analysis_.findings.push_back(against(
                make_finding(chapters::section, "station_bed_stress_departure",
                             "largest departure of the stress near the bed from the measured one, over tau_b",
                             "1", most_stress_),
                c_.channel.dimensions == 3 ? std::optional<double>(0.26) : std::nullopt,
                "thesis, 3D: up to 26 % near the wall", "at " + stress_where_));
        }
    }

  private:
    Figure figure(std::string key, std::string title, std::string source, Axis x) const {
        return make_figure(
            chapters::section, std::move(key), std::move(title),
            simulated_ ? "Means over the length and a period of the bed's elements across the channel; "
                         "with the means of the section twin over the same strips."
                       : "Measured profiles, with the section twin at the same places.",
            std::move(source), std::move(x), make_axis("height above the bed level z", "m"));
    }

    void push(Figure& figure, Curve curve) const {
        curve.variant = variant_;
        figure.curves.push_back(std::move(curve));
    }

    void add_twin(Figure& figure, const std::vector<double>& values, double y) const {
        const SectionTwin& twin = record_.section_twin();
        if (twin.empty() || values.empty()) return;
        push(figure, make_curve("section twin, " + name_, Origin::column, Mark::line,
                                twin_profile(twin, values, strip_around(c_, y)), twin.z));
    }

    [[nodiscard]] std::string measured_name_here() const { return simulated_ ? "measured, " + name_ : name_; }

    void add_velocity(const Station& station) {
        SectionProfile profile;
        if (simulated_) {
            profile = strip_profile(record_.mean_field(), strip_around(c_, station.y),
                                    [](const FieldSums& s) { return s.means(FieldQuantity::velocity); });
            Curve curve =
                make_curve(name_, Origin::simulated, Mark::line_and_points, profile.value, profile.z);
            if (any_finite(profile.half_width)) curve.x_half_width = profile.half_width;
            push(velocity_, std::move(curve));
        }
        add_twin(velocity_, record_.section_twin().velocity, station.y);
        const MeasuredStation& m = station.measured;
        if (!any_finite(m.velocity)) return;
        Curve curve = make_curve(measured_name_here(), Origin::measured, Mark::points, m.velocity, m.z);
        curve.x_half_width = half_widths(m.uncertainty);
        push(velocity_, std::move(curve));
        if (profile.z.size() > 1) add_errors(profile, m);
    }

    void add_errors(const SectionProfile& profile, const MeasuredStation& m) {
        const ProfileSpan computed{profile.z, profile.value};
        const ProfileSpan measured{m.z, m.velocity};
        const ProfileComparison velocity = compare_profiles(computed, measured);
        const ProfileComparison gradient = compare_gradients(computed, measured);
        for (const auto& [target, comparison] :
             {std::pair{&error_, &velocity}, std::pair{&gradient_, &gradient}}) {
            Curve curve = make_curve(name_, Origin::simulated, Mark::line_and_points, {}, {});
            for (const ComparedPoint& point : comparison->points) {
                curve.x.push_back(point.msep);
                curve.y.push_back(point.z);
            }
            if (!curve.x.empty()) push(*target, std::move(curve));
        }
        if (velocity.errors.mean_msep > most_ || !std::isfinite(most_)) {
            most_ = velocity.errors.mean_msep;
            where_ = name_;
        }
    }

    void add_stress(const Station& station) {
        const double rho = c_.fluid.density;
        SectionProfile profile;
        if (simulated_) {
            profile = strip_profile(record_.mean_field(), strip_around(c_, station.y),
                                    [rho](const FieldSums& s) { return total_stress(s, rho, false); });
            Curve curve = make_curve(name_, Origin::simulated, Mark::line, profile.value, profile.z);
            if (any_finite(profile.half_width)) curve.x_half_width = profile.half_width;
            push(stress_, std::move(curve));
        }
        add_twin(stress_, record_.section_twin().shear_stress, station.y);
        if (!any_finite(station.measured.reynolds_stress)) return;
        std::vector<double> stress = station.measured.reynolds_stress;
        for (double& value : stress) value *= rho;
        push(stress_,
             make_curve(measured_name_here(), Origin::measured, Mark::points, stress, station.measured.z));
        const double bed = crest_stress(rho, c_.streamwise_gravity(), c_.total_depth(), c_.crest());
        if (profile.z.size() < 2 || !(bed > 0.0)) return;
        for (std::size_t i = 0; i < stress.size(); ++i) {
            if (station.measured.z[i] < c_.crest() || !std::isfinite(stress[i])) continue;
            const double departure =
                (interpolated(profile.z, profile.value, station.measured.z[i]) - stress[i]) / bed;
            if (std::isfinite(departure) && !(std::abs(departure) <= std::abs(most_stress_))) {
                most_stress_ = departure;
                stress_where_ = name_;
            }
            return;  // the lowest one above the crests
        }
    }

    void take(Figure& figure, const char* why) {
        if (figure.curves.empty()) {
            add_missing(record_, analysis_, std::move(figure), why);
        } else {
            analysis_.figures.push_back(std::move(figure));
        }
    }

    const FlowRecord& record_;
    Analysis& analysis_;
    const Case& c_;
    bool simulated_;
    Figure velocity_, stress_, error_, gradient_;
    std::string name_, where_, stress_where_;
    int variant_ = 0;
    double most_ = std::numeric_limits<double>::quiet_NaN();
    double most_stress_ = std::numeric_limits<double>::quiet_NaN();
};

/// u over y at the measured heights.
void add_rows(const FlowRecord& record, Analysis& analysis) {
    const Case& c = *record.flow();
    std::vector<MeasuredRow> rows = measured_rows(points_beside(record));
    std::erase_if(rows, [](const MeasuredRow& row) { return !any_finite(row.velocity); });
    if (rows.empty()) return;
    const bool simulated = is_three_dimensional(record);
    Figure figure = make_figure(
        chapters::section, "lateral_profile", "Streamwise velocity across the channel at measured heights",
        simulated ? "Means over the length and a period of the bed's elements across the channel; measured "
                    "points with 95 % intervals; the section twin."
                  : "Measured points with 95 % intervals; the section twin.",
        "thesis chapter 5", across_axis(c), make_axis("streamwise velocity u", "m/s"));
    constexpr std::size_t most = 4;
    const std::size_t stride = (rows.size() + most - 1) / most;
    const SectionTwin& twin = record.section_twin();
    double squares = 0.0;
    double count = 0.0;
    int variant = 0;
    for (std::size_t r = 0; r < rows.size(); r += stride, ++variant) {
        const MeasuredRow& row = rows[r];
        const std::string name = fmt::format("z = {:.4g} mm", 1000.0 * row.z);
        const auto push = [&](Curve curve) {
            curve.variant = variant;
            figure.curves.push_back(std::move(curve));
        };
        if (simulated) {
            const MeanFlow& field = record.mean_field();
            const FieldEstimates found = section_estimates(field, [&](const FieldSums& section) {
                std::vector<double> values(field.y.size());
                std::vector<double> profile(field.z.size());
                for (std::size_t iy = 0; iy < field.y.size(); ++iy) {
                    for (std::size_t iz = 0; iz < field.z.size(); ++iz) {
                        profile[iz] = section.mean(FieldQuantity::velocity, field.at(iz, iy));
                    }
                    values[iy] = interpolated(field.z, profile, row.z);
                }
                return period_means(field.y, values, lattice_period_across(c).value_or(0.0));
            });
            push(make_curve(name, Origin::simulated, Mark::line, field.y, found.value));
            for (std::size_t i = 0; i < row.y.size(); ++i) {
                const double u = interpolated(field.y, found.value, row.y[i]);
                if (!std::isfinite(u) || !(std::abs(row.velocity[i]) > 0.0)) continue;
                squares += std::pow(u / row.velocity[i] - 1.0, 2);
                count += 1.0;
            }
        }
        if (!twin.empty()) {
            std::vector<double> values;
            for (const double y : twin.y) values.push_back(twin_value(twin, twin.velocity, y, row.z));
            push(make_curve("section twin, " + name, Origin::column, Mark::line, twin.y, values));
        }
        Curve measured = make_curve(simulated ? "measured, " + name : name, Origin::measured, Mark::points,
                                    row.y, row.velocity);
        measured.y_half_width = half_widths(row.uncertainty);
        push(std::move(measured));
    }
    analysis.figures.push_back(std::move(figure));
    if (count > 0.0) {
        Finding finding =
            make_finding(chapters::section, "lateral_profile_error_rms",
                         "rms relative departure of u from the points measured across the channel", "1",
                         std::sqrt(squares / count));
        finding.remark = fmt::format("{:.0f} points at {} heights", count, variant);
        analysis.findings.push_back(std::move(finding));
    }
}

}  // namespace

void add_section_stations(const FlowRecord& record, Analysis& analysis) {
    const Case& c = *record.flow();
    if (!c.has_side_walls() && record.origin() == Origin::simulated) {
        if (!record.measured().section.empty()) {
            analysis.warnings.emplace_back(
                "the points measured across the channel are not compared with: the run has no side walls "
                "to count their distances from");
        }
        return;
    }
    const SectionPoints& points = points_beside(record);
    StationFigures figures(record, analysis);
    const std::vector<Station> stations =
        record.origin() == Origin::measured && measured_stations(points).empty() ? std::vector<Station>{}
                                                                                 : stations_of(c, points);
    for (const Station& station : stations) figures.add(station);
    figures.finish();
    add_rows(record, analysis);
}

}  // namespace riffle::inline analysis
