#include "check_run.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <optional>
#include <utility>

#include <fmt/format.h>
#include <gtest/gtest.h>

#include "base/parallel.hpp"
#include "column/column.hpp"
#include "solver/start.hpp"

namespace riffle::verification {

CheckRun::CheckRun(const std::string& name, const std::vector<Override>& overrides)
    : case_(read_case(std::string(RIFFLE_SOURCE_DIR) + "/cases/checks/" + name + ".toml", overrides)) {
    set_thread_count(1);
    std::optional<ColumnResult> column;
    if (has_column(case_)) column = solve_column(case_);
    const ColumnResult* twin = column ? &*column : nullptr;
    simulation_ = make_simulation(case_, twin, initial_particles(case_, make_scheme(case_, twin), twin));
}

void CheckRun::advance_to(double time, const std::function<void()>& each) {
    while (simulation_->clock().time < time) {
        simulation_->step();
        if (each) each();
    }
}

template <int D>
double mass_mean(const Particles<D>& particles, const std::function<double(std::size_t)>& f) {
    double sum = 0.0;
    double mass = 0.0;
    for (std::size_t i = 0; i < particles.size(); ++i) {
        sum += particles.mass[i] * f(i);
        mass += particles.mass[i];
    }
    return sum / mass;
}

template <int D>
double largest_speed(const Particles<D>& particles) {
    double largest = 0.0;
    for (std::size_t i = 0; i < particles.size(); ++i) {
        double squared = 0.0;
        for (const auto& component : particles.velocity) squared += component[i] * component[i];
        largest = std::max(largest, std::sqrt(squared));
    }
    return largest;
}

template double mass_mean<2>(const Particles<2>&, const std::function<double(std::size_t)>&);
template double mass_mean<3>(const Particles<3>&, const std::function<double(std::size_t)>&);
template double largest_speed<2>(const Particles<2>&);
template double largest_speed<3>(const Particles<3>&);

double hydrostatic_error(const CheckRun& run) {
    const Scheme& scheme = run.simulation().scheme();
    double sum = 0.0;
    int count = 0;
    for (std::size_t i = 0; i < run.particles().size(); ++i) {
        const double z = run.particles().position[1][i];
        if (z < scheme.depth - 2.0 * scheme.smoothing_length) {
            const double exact = scheme.density * scheme.normal_gravity * (scheme.depth - z);
            const double difference = run.simulation().fields().pressure[i] - exact;
            sum += difference * difference;
            ++count;
        }
    }
    return std::sqrt(sum / count) / (scheme.density * scheme.normal_gravity * scheme.depth);
}

ProfileError profile_error(const CheckRun& run, const std::function<double(double)>& profile) {
    const Particles<2>& particles = run.particles();
    const double bin = run.parameters().numerics.spacing;
    std::map<int, std::pair<double, int>> bins;
    ProfileError error;
    for (std::size_t i = 0; i < particles.size(); ++i) {
        const double z = particles.position[1][i];
        const double difference = particles.velocity[0][i] - profile(z);
        error.largest = std::max(error.largest, std::abs(difference));
        error.rms += difference * difference;
        auto& [sum, count] = bins[static_cast<int>(std::floor(z / bin))];
        sum += difference;
        ++count;
    }
    error.rms = std::sqrt(error.rms / static_cast<double>(particles.size()));
    for (const auto& [height, content] : bins) {
        const double mean = content.first / content.second;
        error.profile += mean * mean;
    }
    error.profile = std::sqrt(error.profile / static_cast<double>(bins.size()));
    return error;
}

void expect_below(const std::string& check, const std::string& norm, double bar, double measured) {
    fmt::print("| {} | {} | {:.3g} | {:.3g} |\n", check, norm, bar, measured);
    EXPECT_LT(measured, bar) << check << ": " << norm;
}

}  // namespace riffle::verification
