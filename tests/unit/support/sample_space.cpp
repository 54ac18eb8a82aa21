#include "sample_space.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <map>
#include <numbers>
#include <random>
#include <utility>
#include <vector>

#include "case/case.hpp"
#include "output/results_file.hpp"
#include "sample_results.hpp"

namespace riffle::testing {

namespace {

using std::numbers::pi;
constexpr double nan = std::numeric_limits<double>::quiet_NaN();

class Space {
  public:
    Space(const SampleSpace& sample, const Case& c) : s_(sample), c_(c) {
        width_ = c.channel.simulated_width();
        depth_ = c.total_depth();
        x_ = centres(10, c.channel.length);
        y_ = centres(26, width_);
        z_ = centres(14, depth_);
    }

    Content take() {
        content_.attributes.push_back({"/", "dimension", std::int64_t{3}});
        series();
        mean_field();
        surface_map();
        if (c_.has_side_walls()) section();
        return std::move(content_);
    }

  private:
    static std::vector<double> centres(std::size_t count, double length) {
        std::vector<double> result;
        for (std::size_t i = 0; i < count; ++i) {
            result.push_back((static_cast<double>(i) + 0.5) * length / static_cast<double>(count));
        }
        return result;
    }
    void put(const std::string& path, std::vector<double> values, std::vector<std::size_t> shape = {}) {
        if (shape.empty()) shape = {values.size()};
        content_.datasets.push_back({path, std::move(shape), std::move(values), "1", path, false});
    }
    [[nodiscard]] double weight() const { return c_.fluid.density * c_.streamwise_gravity(); }

    void series() {
        std::vector<double> side;
        std::vector<double> drag;
        std::vector<double> acceleration;
        std::vector<double> centreline;
        std::vector<double> secondary;
        for (int i = 0; i <= 1500; ++i) {
            side.push_back(c_.has_side_walls() ? s_.side_wall_share + 0.002 * normal_(random_) : 0.0);
            drag.push_back(1.0 - (c_.has_side_walls() ? s_.side_wall_share : 0.0) + 0.002 * normal_(random_));
            acceleration.push_back(1.0 - side.back() - drag.back());
            centreline.push_back(0.36 + 1e-4 * normal_(random_));
            secondary.push_back(4e-3 + 1e-4 * normal_(random_));
        }
        put("/time_series/side_wall_over_gravity", side);
        put("/time_series/drag_over_gravity", drag);
        put("/time_series/acceleration_over_gravity", acceleration);
        put("/time_series/centreline_velocity", centreline);
        put("/time_series/secondary_velocity", secondary);
    }

    void mean_field() {
        constexpr std::size_t windows = 19;
        std::map<std::string, std::vector<double>> fields;
        std::vector<double> time;
        for (std::size_t k = 0; k < windows; ++k) {
            time.push_back(static_cast<double>(12 + k));
            const double factor = time.back() > 15.5 ? 1.0 : 2.0;
            for (const double z : z_) {
                for (const double y : y_) {
                    for (const double x : x_) cell(x, y, z, factor, fields);
                }
            }
        }
        put("/mean_field/time", time);
        put("/mean_field/samples", std::vector<double>(windows, 100.0));
        put("/mean_field/x", x_);
        put("/mean_field/y", y_);
        put("/mean_field/z", z_);
        for (auto& [name, values] : fields) {
            put("/mean_field/" + name, std::move(values), {windows, z_.size(), y_.size(), x_.size()});
        }
    }

    void cell(double x, double y, double z, double factor, std::map<std::string, std::vector<double>>& f) {
        const double form = std::cos(4.0 * pi * x / c_.channel.length);
        const double n = s_.cells * pi;
        const double a = s_.streamfunction;
        const double v = a * pi / depth_ * std::sin(n * y / width_) * std::cos(pi * z / depth_);
        const double w = -a * n / width_ * std::cos(n * y / width_) * std::sin(pi * z / depth_);
        const auto noise = [&] { return s_.noise * normal_(random_); };
        f["count"].push_back(4.0);
        f["velocity"].push_back(factor * sample_space_velocity(y, z, width_, depth_) + s_.form_u * form +
                                noise());
        f["spanwise_velocity"].push_back(v + noise());
        f["vertical_velocity"].push_back(w + s_.form_w * form + noise());
        for (const char* name :
             {"velocity_variance", "spanwise_velocity_variance", "vertical_velocity_variance"}) {
            f[name].push_back(1e-4);
        }
        f["velocity_covariance"].push_back(-s_.reynolds_stress / c_.fluid.density);
        f["velocity_spanwise_covariance"].push_back(0.0);
        f["spanwise_vertical_covariance"].push_back(0.0);
        const double side = 1.0 - s_.wall_slope * std::pow(std::cos(pi * y / width_), 2);
        f["shear_stress"].push_back(weight() * (depth_ - z) * side);
        f["lateral_shear_stress"].push_back(0.05 * std::cos(pi * y / width_));
        f["pressure"].push_back(c_.fluid.density * c_.normal_gravity() * (depth_ - z));
        f["eddy_viscosity"].push_back(1e-4);
        const double bed_rows = std::ceil(c_.crest() / (depth_ / static_cast<double>(z_.size())));
        const double bed = depth_ * bed_rows / static_cast<double>(z_.size());
        const bool in_bed = z < bed;
        const double walls = c_.has_side_walls() ? s_.side_wall_share : 0.0;
        f["drag"].push_back(in_bed ? -weight() * depth_ * (1.0 - walls) / bed : 0.0);
        f["spanwise_drag"].push_back(in_bed ? 2.0 * form : 0.0);
        const double cell = width_ / static_cast<double>(y_.size());
        const bool at_wall = y < cell || (c_.channel.sides == Sides::walls && y > width_ - cell);
        const double cells = c_.channel.sides == Sides::walls ? 2.0 : 1.0;
        f["side_wall_drag"].push_back(at_wall ? -weight() * walls * width_ / (cells * cell) : 0.0);
    }

    void surface_map() {
        const std::vector<double> x = centres(6, c_.channel.length);
        const std::vector<double> y = centres(8, width_);
        std::vector<double> time;
        std::vector<double> elevation;
        for (int i = 1; i <= 150; ++i) {
            time.push_back(0.2 * i);
            for (const double at : y) {
                for (std::size_t j = 0; j < x.size(); ++j) {
                    // A mean level with a slope across, and a pattern of zero mean over the plan.
                    const double sign = j % 2 == 0 ? 1.0 : -1.0;
                    elevation.push_back(depth_ + 1e-3 * (at / width_ - 0.5) +
                                        std::sqrt(2.0) * s_.surface_deviation * sign *
                                            std::sin(1.7 * time.back()));
                }
            }
        }
        put("/surface_map/x", x);
        put("/surface_map/y", y);
        put("/surface_map/time", time);
        put("/surface_map/elevation", elevation, {time.size(), y.size(), x.size()});
    }

    void section() {
        std::vector<double> velocity;
        std::vector<double> stress;
        std::vector<double> lateral;
        for (const double z : z_) {
            for (const double y : y_) {
                velocity.push_back(1.01 * sample_space_velocity(y, z, width_, depth_));
                stress.push_back(weight() * (depth_ - z));
                lateral.push_back(0.0);
            }
        }
        put("/section/y", y_);
        put("/section/z", z_);
        const std::vector<std::size_t> shape = {z_.size(), y_.size()};
        put("/section/velocity", velocity, shape);
        put("/section/mixing_length", lateral, shape);
        put("/section/shear_stress", stress, shape);
        put("/section/lateral_shear_stress", lateral, shape);
        for (const auto& [name, value] :
             {std::pair{"depth_mean_velocity", 0.35}, std::pair{"centreline_velocity", 0.36},
              std::pair{"drag_share", 0.79}, std::pair{"side_wall_share", 0.21}, std::pair{"bed_stress", 1.7},
              std::pair{"wall_stress", 1.2}}) {
            content_.attributes.push_back({"/section", name, value});
        }
    }

    const SampleSpace& s_;
    const Case& c_;
    double width_ = nan;
    double depth_ = nan;
    std::vector<double> x_, y_, z_;
    std::mt19937_64 random_{20260404};
    std::normal_distribution<double> normal_{0.0, 1.0};
    Content content_;
};

}  // namespace

double sample_space_velocity(double y, double z, double width, double depth) {
    return 0.5 * std::cbrt(z / depth) * std::pow(std::sin(pi * y / width), 0.25);
}

std::string sample_space_case(const std::string& sides) {
    return fmt::format(R"(title = "Flow condition 2 in three dimensions"

[channel]
slope = 0.004
depth = "50 mm"
dimensions = 3
length = "50 mm"
width = 0.12990381056766578
sides = "{}"

[bed]
kind = "spheres"
sphere_diameter = "25 mm"
roughness_height = "0.4 D"
datum_below_crest = "4 mm"
drag_coefficient = 0.8

[turbulence]
closure = "czernuszenko-rylov"

[numerics]
spacing = "4 mm"

[output]
mean_field_interval = 1.0

[measured]
depth_mean_velocity = 0.35
friction_velocity = 0.044
equivalent_roughness = "35 mm"
surface_standard_deviation = "0.4 mm"
source = "thesis, Table 3.1, condition 2"
)",
                       sides);
}

void write_sample_space(const std::filesystem::path& path, const SampleSpace& sample) {
    SampleOptions options;
    options.case_text = sample_space_case(sample.sides);
    options.length = 0.05;
    write_sample_results(path, options);
    const Case c = parse_case(options.case_text, "sample");
    ResultsFile::update(path, Space(sample, c).take());
}

}  // namespace riffle::testing
