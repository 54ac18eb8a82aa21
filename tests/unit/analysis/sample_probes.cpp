#include "sample_probes.hpp"

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <numbers>
#include <random>
#include <string>
#include <utility>
#include <vector>

#include "output/results_file.hpp"

namespace riffle::testing {

namespace {

constexpr double run_time = 30.0;

class Writer {
  public:
    void group(const std::string& name, const std::string& kind) {
        group_ = "/probes/" + name;
        content.attributes.push_back({group_, "kind", kind});
        content.attributes.push_back({group_, "sampling_frequency", 100.0});
        content.attributes.push_back({group_, "standard", std::int64_t{0}});
    }
    void put(const std::string& name, const std::string& unit, std::vector<double> values,
             std::vector<std::size_t> shape = {}) {
        if (shape.empty()) shape = {values.size()};
        content.datasets.push_back(
            {group_ + "/" + name, std::move(shape), std::move(values), unit, name, false});
    }
    Content content;

  private:
    std::string group_;
};

}  // namespace

void add_sample_probes(const std::filesystem::path& results, const SampleProbes& p) {
    std::mt19937_64 random(20260203);
    std::normal_distribution<double> normal;
    Writer writer;
    std::vector<double> time;
    for (double t = p.interval; t <= run_time + 1e-9; t += p.interval) time.push_back(t);
    const std::size_t rows = time.size();

    const std::vector<double> z = {0.012, 0.02, 0.028, 0.036, 0.044, 0.052};
    std::vector<double> u;
    std::vector<double> w;
    std::vector<double> slow(z.size(), 0.0);
    for (std::size_t row = 0; row < rows; ++row) {
        const double shared = normal(random);
        for (std::size_t i = 0; i < z.size(); ++i) {
            // Nearer heights share more, so that w' correlates over the depth.
            const double weight = static_cast<double>(i) / static_cast<double>(z.size() - 1);
            const double a = weight * shared + std::sqrt(1.0 - weight * weight) * normal(random);
            slow[i] = 0.8 * slow[i] + 0.6 * a;
            w.push_back(p.w_deviation * slow[i]);
            u.push_back(0.3 +
                        p.u_deviation * (p.correlation * slow[i] +
                                         std::sqrt(1.0 - p.correlation * p.correlation) * normal(random)));
        }
    }
    writer.group("adv", "velocity");
    writer.put("x", "m", std::vector<double>(z.size(), 0.1));
    writer.put("z", "m", z);
    writer.put("time", "s", time);
    writer.put("velocity", "m/s", u, {rows, z.size()});
    writer.put("vertical_velocity", "m/s", w, {rows, z.size()});

    const std::vector<double> x = {0.0, 0.028};
    std::vector<double> elevation;
    for (const double t : time) {
        for (const double at : x) {
            elevation.push_back(0.056 +
                                p.wave_amplitude *
                                    std::sin(2.0 * std::numbers::pi * (at - p.celerity * t) / p.wave_length) +
                                1e-6 * normal(random));
        }
    }
    writer.group("gauges", "wave");
    writer.put("x", "m", x);
    writer.put("time", "s", time);
    writer.put("elevation", "m", elevation, {rows, x.size()});

    // u~ = a sin(kx), w~ = -b sin(kx): -rho <u~ w~> = rho a b / 2.
    const std::size_t columns = 20;
    const std::size_t windows = 30;
    const double part = std::sqrt(2.0 * p.dispersive_stress / 1000.0);
    std::vector<double> grid_x;
    std::vector<double> grid_time;
    std::vector<double> mean_u;
    std::vector<double> mean_w;
    for (std::size_t i = 0; i < columns; ++i) grid_x.push_back(0.01 * static_cast<double>(i));
    for (std::size_t k = 0; k < windows; ++k) {
        grid_time.push_back(static_cast<double>(k + 1));
        for (std::size_t j = 0; j < z.size(); ++j) {
            for (std::size_t i = 0; i < columns; ++i) {
                const double wave = std::sin(2.0 * std::numbers::pi * static_cast<double>(i) / columns);
                mean_u.push_back((k + 1 == windows ? p.last_window_velocity : 0.3) + part * wave);
                mean_w.push_back(-part * wave);
            }
        }
    }
    const std::vector<std::size_t> shape = {windows, z.size(), columns};
    writer.group("piv", "grid");
    writer.put("x", "m", grid_x);
    writer.put("z", "m", z);
    writer.put("time", "s", grid_time);
    std::vector<double> samples(windows, 100.0);
    samples.back() = p.last_window_samples;
    writer.put("samples", "1", samples);
    writer.put("velocity", "m/s", mean_u, shape);
    writer.put("vertical_velocity", "m/s", mean_w, shape);
    writer.put("velocity_variance", "m2/s2", std::vector<double>(mean_u.size(), 4e-4), shape);
    writer.put("vertical_velocity_variance", "m2/s2", std::vector<double>(mean_u.size(), 1e-4), shape);
    writer.put("velocity_covariance", "m2/s2", std::vector<double>(mean_u.size(), -1e-4), shape);

    // w' of patterns that travel, of shorter waves deeper down; nothing but noise below 25 mm.
    writer.group("frames", "grid");
    std::vector<double> frame_time;
    std::vector<double> frame_u;
    std::vector<double> frame_w;
    for (double t = 0.02; t <= run_time + 1e-9; t += 0.02) {
        frame_time.push_back(t);
        for (const double height : z) {
            for (std::size_t i = 0; i < columns; ++i) {
                const double phase = 2.0 * std::numbers::pi * (grid_x[i] - p.celerity * t) / p.wave_length;
                frame_u.push_back(0.3);
                frame_w.push_back((height > 0.025 ? 5e-3 * std::sin(phase) : 0.0) + 1e-3 * normal(random));
            }
        }
    }
    const std::vector<std::size_t> frames = {frame_time.size(), z.size(), columns};
    writer.put("x", "m", grid_x);
    writer.put("z", "m", z);
    writer.put("time", "s", frame_time);
    writer.put("velocity", "m/s", frame_u, frames);
    writer.put("vertical_velocity", "m/s", frame_w, frames);

    writer.group("forces", "force");
    writer.put("time", "s", time);
    std::vector<double> drag;
    for (std::size_t row = 0; row < rows; ++row) drag.push_back(p.bed_drag + 0.01 * normal(random));
    writer.put("bed_drag", "N/m", drag);
    ResultsFile::update(results, writer.content);
}

}  // namespace riffle::testing
