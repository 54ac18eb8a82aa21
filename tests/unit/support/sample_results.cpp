#include "sample_results.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <random>
#include <vector>

#include "case/case.hpp"
#include "column/column.hpp"
#include "output/results_file.hpp"

namespace riffle::testing {

namespace {

using std::numbers::pi;
constexpr double run_time = 30.0;
constexpr double window_start = 15.0;

class Sample {
  public:
    Sample(const SampleOptions& options, const Case& c) : options_(options), c_(c) {
        if (has_column(c)) {
            column_ = solve_column(c);
        } else {
            column_.profile.z = {0.0, c.total_depth()};  // still water
            column_.profile.velocity = {0.0, 0.0};
        }
        const double depth = c.total_depth();
        rows_ = static_cast<std::size_t>(std::lround(depth / c.numerics.spacing));
        for (std::size_t i = 0; i < rows_; ++i) {
            heights_.push_back((static_cast<double>(i) + 0.5) * depth / static_cast<double>(rows_));
        }
    }

    Content take() {
        attribute("/", "title", c_.title);
        attribute("/", "riffle_version", std::string("0.1.0"));
        attribute("/", "build", std::string("sample build"));
        attribute("/", "created", std::string("2026-01-02T03:04:05Z"));
        attribute("/", "dimension", std::int64_t{2});
        attribute("/", "complete", std::int64_t{options_.complete ? 1 : 0});
        content_.datasets.push_back({"/case/text",
                                     {},
                                     options_.stored_case_text.empty() ? c_.text : options_.stored_case_text,
                                     "1",
                                     "complete case",
                                     false});
        if (wants("/time_series")) series();
        if (wants("/profiles")) profiles();
        if (wants("/column") && has_column(c_)) column();
        if (wants("/surface")) surface();
        if (wants("/snapshots")) snapshot();
        if (wants("/summary")) summary();
        return std::move(content_);
    }

  private:
    [[nodiscard]] bool wants(const std::string& group) const { return options_.without.count(group) == 0; }
    double noise(double size) { return size * normal_(random_); }

    template <typename Value>
    void attribute(const std::string& path, const std::string& name, Value value) {
        const auto other = options_.summary_overrides.find(name);
        if (path == "/summary" && other != options_.summary_overrides.end()) {
            content_.attributes.push_back({path, name, other->second});
        } else {
            content_.attributes.push_back({path, name, std::move(value)});
        }
    }
    void dataset(const std::string& path, std::vector<double> values, std::vector<std::size_t> shape = {}) {
        if (shape.empty()) shape = {values.size()};
        content_.datasets.push_back({path, std::move(shape), std::move(values), "1", path, false});
    }

    [[nodiscard]] double velocity(double z) const {
        return column_.velocity_at(z) * (1 + options_.velocity_bias);
    }

    void series() {
        const std::size_t count = 1501;
        std::vector<double> time, mean, drag, wall, acceleration, level, fluctuation, order, low, high;
        double slow = 0;
        for (std::size_t i = 0; i < count; ++i) {
            const double t = run_time * static_cast<double>(i) / static_cast<double>(count - 1);
            slow = 0.97 * slow + noise(2e-5);
            const double approach = std::exp(-t / 4);
            time.push_back(t);
            mean.push_back(column_.depth_mean_velocity * (1 + options_.velocity_bias * (1 - approach)) +
                           slow);
            drag.push_back(0.999 - 0.01 * approach + noise(0.002));
            wall.push_back(0.0);
            acceleration.push_back(1 - drag.back());
            level.push_back(c_.total_depth() + 2e-5 * (1 - approach) + noise(3e-6));
            fluctuation.push_back(2e-3 * (1 - 0.5 * approach) + noise(5e-5));
            order.push_back(0.9 + 0.1 * approach + noise(0.004));
            low.push_back(-2e-4 + noise(2e-5));
            high.push_back(4e-3 + noise(5e-5));
        }
        dataset("/time_series/time", time);
        dataset("/time_series/depth_mean_velocity", mean);
        dataset("/time_series/drag_over_gravity", drag);
        dataset("/time_series/wall_over_gravity", wall);
        dataset("/time_series/acceleration_over_gravity", acceleration);
        dataset("/time_series/mean_level", level);
        dataset("/time_series/water_volume",
                std::vector<double>(count, c_.total_depth() * c_.channel.length * c_.channel.flow_width()));
        dataset("/time_series/velocity_fluctuation", fluctuation);
        dataset("/time_series/particle_order", order);
        dataset("/time_series/density_deviation_minimum", low);
        dataset("/time_series/density_deviation_maximum", high);
    }

    void profiles() {
        const double weight = c_.fluid.density * c_.streamwise_gravity();
        const double bin = c_.total_depth() / static_cast<double>(rows_);
        std::vector<double> lower, upper, u, half, deviation, gradient, pressure, viscous, pair, reynolds,
            total, analytic, viscosity, drag;
        // What the bed elements above z carry, Pa.
        const auto carried = [&](double z) {
            const double share = z < c_.crest() ? z / c_.crest() : 1.0;
            return weight * (c_.total_depth() - z) * (1.0 - share * share);
        };
        for (const double z : heights_) {
            const double here =
                velocity(z) + noise(2e-4) + (z < c_.crest() ? 0.01 * column_.velocity_at(z) : 0.0);
            lower.push_back(z - 0.5 * bin);
            upper.push_back(z + 0.5 * bin);
            u.push_back(here);
            half.push_back(6e-4);
            deviation.push_back(here - column_.velocity_at(z));
            gradient.push_back((velocity(z + 1e-4) - velocity(z - 1e-4)) / 2e-4);
            pressure.push_back(c_.fluid.density * c_.normal_gravity() * (c_.total_depth() - z) + noise(0.5));
            analytic.push_back(weight * (c_.total_depth() - upper.back()) - carried(upper.back()));
            drag.push_back((carried(upper.back()) - carried(lower.back())) / bin);
            const double stress = 0.97 * (weight * (c_.total_depth() - z) - carried(z));
            viscosity.push_back(stress > 0.0 ? stress / (c_.fluid.density * gradient.back()) : 0.0);
            viscous.push_back(0.97 * analytic.back() + noise(0.005));
            reynolds.push_back(0.02 * analytic.back() + noise(0.004));
            pair.push_back(noise(0.008));
            total.push_back(viscous.back() + reynolds.back() + pair.back());
        }
        dataset("/profiles/z", heights_);
        dataset("/profiles/bin_lower", lower);
        dataset("/profiles/bin_upper", upper);
        dataset("/profiles/velocity", u);
        dataset("/profiles/velocity_half_width", half);
        dataset("/profiles/velocity_deviation", deviation);
        dataset("/profiles/velocity_gradient", gradient);
        dataset("/profiles/pressure", pressure);
        dataset("/profiles/viscous_stress", viscous);
        dataset("/profiles/pair_stress", pair);
        dataset("/profiles/reynolds_stress", reynolds);
        dataset("/profiles/total_stress", total);
        dataset("/profiles/analytic_stress", analytic);
        dataset("/profiles/eddy_viscosity", viscosity);
        dataset("/profiles/drag", drag);
        attribute("/profiles", "window_start", window_start);
        attribute("/profiles", "window_end", run_time);
        attribute("/profiles", "samples", std::int64_t{1500});
    }

    void column() {
        dataset("/column/z", column_.profile.z);
        dataset("/column/velocity", column_.profile.velocity);
        dataset("/column/velocity_gradient", column_.profile.velocity_gradient);
        dataset("/column/shear_stress", column_.profile.shear_stress);
        attribute("/column", "depth_mean_velocity", column_.depth_mean_velocity);
        attribute("/column", "surface_velocity", column_.surface_velocity);
        attribute("/column", "friction_velocity", column_.friction_velocity);
        attribute("/column", "equivalent_roughness", column_.log_law.equivalent_roughness);
    }

    void surface() {
        const std::size_t columns = 50;
        const std::size_t rows = 1500;
        std::vector<double> x, time, elevation;
        for (std::size_t i = 0; i < columns; ++i) {
            x.push_back((static_cast<double>(i) + 0.5) * c_.channel.length / static_cast<double>(columns));
        }
        for (std::size_t row = 0; row < rows; ++row) {
            time.push_back(run_time * static_cast<double>(row + 1) / static_cast<double>(rows));
            for (const double at : x) {
                const double k = 2 * pi / c_.channel.length;
                elevation.push_back(c_.total_depth() + 8e-6 * std::cos(k * (at - 0.35 * time.back())) +
                                    5e-6 * std::cos(2 * k * (at - 0.95 * time.back())) + noise(1e-6));
            }
        }
        dataset("/surface/x", x);
        dataset("/surface/time", time);
        dataset("/surface/elevation", elevation, {rows, columns});
    }

    void snapshot() {
        const auto along = static_cast<std::size_t>(std::lround(c_.channel.length / c_.numerics.spacing));
        // Beside the centreline, where a file of the lattice would be.
        const double across =
            c_.channel.dimensions == 3 ? c_.channel.centreline() + 0.25 * c_.numerics.spacing : 0.0;
        std::vector<double> position, speed, pressure, viscosity, density;
        for (std::size_t i = 0; i < along; ++i) {
            for (const double z : heights_) {
                const double x =
                    std::clamp((static_cast<double>(i) + 0.5) * c_.numerics.spacing + noise(2e-4), 0.0,
                               c_.channel.length);
                position.insert(position.end(), {x, across, z + noise(5e-5)});
                speed.insert(speed.end(), {velocity(z) + noise(2e-3), 0.0, noise(2e-3)});
                pressure.push_back(c_.fluid.density * c_.normal_gravity() * (c_.total_depth() - z) +
                                   noise(2));
                viscosity.push_back(3e-4 * z * (c_.total_depth() - z) / std::pow(c_.total_depth(), 2));
                density.push_back(c_.fluid.density);
            }
        }
        const std::size_t count = pressure.size();
        dataset("/snapshots/00000/position", position, {count, 3});
        dataset("/snapshots/00000/velocity", speed, {count, 3});
        dataset("/snapshots/00000/pressure", pressure);
        dataset("/snapshots/00000/density", density);
        dataset("/snapshots/00000/eddy_viscosity", viscosity);
        attribute("/snapshots/00000", "time", run_time);
    }

    void summary() {
        attribute("/summary", "depth_mean_velocity",
                  column_.depth_mean_velocity * (1 + options_.velocity_bias));
        attribute("/summary", "depth_mean_velocity_half_width", 6e-4);
        attribute("/summary", "surface_velocity", velocity(c_.total_depth()));
        attribute("/summary", "friction_velocity", column_.friction_velocity * 1.002);
        attribute("/summary", "drag_over_gravity", 0.999);
        attribute("/summary", "wall_over_gravity", 0.0);
        attribute("/summary", "mean_level", c_.total_depth() + 2e-5);
        attribute("/summary", "particles", std::int64_t{2800});
        attribute("/summary", "steps", std::int64_t{123456});
        attribute("/summary", "wall_clock_seconds", 87.5);
        attribute("/summary", "particle_updates_per_second", 7.1e6);
        attribute("/summary", "converged", std::int64_t{options_.converged ? 1 : 0});
        attribute("/summary", "window_start", window_start);
        attribute("/summary", "window_end", run_time);
        attribute("/summary", "spurious_stress_rms", 0.0031);
        attribute("/summary", "stress_error_rms", 0.0042);
        attribute("/summary", "velocity_error_above_rms", 0.0031);
        attribute("/summary", "velocity_error_above_maximum", 0.0062);
        attribute("/summary", "velocity_error_below_rms", 0.018);
        attribute("/summary", "velocity_error_below_maximum", 0.031);
    }

    const SampleOptions& options_;
    const Case& c_;
    ColumnResult column_;
    std::size_t rows_ = 0;
    std::vector<double> heights_;
    std::mt19937_64 random_{20260102};
    std::normal_distribution<double> normal_{0.0, 1.0};
    Content content_;
};

}  // namespace

std::string sample_case(double length) {
    return fmt::format(R"(title = "Flow condition 2: depth 50 mm, slope 0.004"
description = "Rough-bed channel over hexagonally packed 25 mm spheres."

[channel]
slope = 0.004
depth = "50 mm"
length = {}

[bed]
kind = "spheres"
sphere_diameter = "25 mm"
roughness_height = "0.4 D"
datum_below_crest = "4 mm"
drag_coefficient = 0.8

[numerics]
spacing = "2 mm"

[measured]
depth_mean_velocity = 0.35
friction_velocity = 0.044
equivalent_roughness = "35 mm"
surface_standard_deviation = "0.4 mm"
source = "thesis, Table 3.1, condition 2"
)",
                       length);
}

void write_sample_results(const std::filesystem::path& path, const SampleOptions& options) {
    const std::string text = options.case_text.empty() ? sample_case(options.length) : options.case_text;
    Case c = parse_case(text, "sample");
    c.text = text;
    ResultsFile::create(path, Sample(options, c).take(), true);
}

}  // namespace riffle::testing
