// The instruction sets give the same results up to rounding. A process keeps the set that it started with, so
// this program is run again with the others.

#include <gtest/gtest.h>
#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <string>

#include "small_case.hpp"
#include "sph/pair_loops.hpp"

namespace riffle::instruction_sets_test {
namespace {

namespace fs = std::filesystem;

constexpr const char* set_variable = "RIFFLE_INSTRUCTION_SET";
constexpr const char* output_variable = "RIFFLE_TEST_STATE";
constexpr int steps = 40;

/// Positions, velocities and densities by particle id after some steps from a disordered start, walls,
/// closure and drag included.
template <int D>
std::vector<double> state_after_steps(Precision precision) {
    Case c = test::small_channel(D);
    c.start.jitter = 0.2;
    c.numerics.precision = precision;
    const test::ChannelIn<D> channel(c);
    channel.advance(steps);
    const Particles<D>& p = channel.simulation->particles();
    std::vector<double> values;
    for (const std::size_t i : test::places_by_id<D>(p)) {
        for (std::size_t k = 0; k < D; ++k) {
            values.push_back(p.position[k][i]);
            values.push_back(p.velocity[k][i]);
        }
        values.push_back(p.density_deviation[i]);
    }
    return values;
}

struct States {
    std::vector<double> in_double;
    std::vector<double> in_single;
};

States run_here() {
    States states;
    states.in_double = state_after_steps<2>(Precision::double_precision);
    states.in_single = state_after_steps<2>(Precision::single_precision);
    const auto append = [](std::vector<double>& values, const std::vector<double>& more) {
        values.insert(values.end(), more.begin(), more.end());
    };
    append(states.in_double, state_after_steps<3>(Precision::double_precision));
    append(states.in_single, state_after_steps<3>(Precision::single_precision));
    return states;
}

void write(std::ofstream& file, const std::vector<double>& values) {
    const std::size_t size = values.size();
    file.write(reinterpret_cast<const char*>(&size), sizeof size);
    file.write(reinterpret_cast<const char*>(values.data()),
               static_cast<std::streamsize>(size * sizeof(double)));
}

std::vector<double> read(std::ifstream& file) {
    std::size_t size = 0;
    file.read(reinterpret_cast<char*>(&size), sizeof size);
    std::vector<double> values(file ? size : 0);
    file.read(reinterpret_cast<char*>(values.data()),
              static_cast<std::streamsize>(values.size() * sizeof(double)));
    return values;
}

/// The states of a process of its own under `set`.
States run_under(InstructionSet set) {
    const fs::path file = fs::temp_directory_path() /
                          ("riffle-states-" + std::to_string(getpid()) + "-" + instruction_set_name(set));
    std::vector<std::string> environment = {std::string(set_variable) + "=" + instruction_set_name(set),
                                            std::string(output_variable) + "=" + file.string()};
    std::vector<char*> environment_pointers;
    for (std::string& entry : environment) environment_pointers.push_back(entry.data());
    environment_pointers.push_back(nullptr);
    std::string program = fs::read_symlink("/proc/self/exe").string();
    std::string filter = "--gtest_filter=InstructionSets.StateOfThisProcess";
    char* arguments[] = {program.data(), filter.data(), nullptr};
    pid_t child = 0;
    EXPECT_EQ(posix_spawn(&child, program.c_str(), nullptr, nullptr, arguments, environment_pointers.data()),
              0);
    int status = 1;
    EXPECT_EQ(waitpid(child, &status, 0), child);
    EXPECT_EQ(status, 0) << "the run under " << instruction_set_name(set) << " failed";
    States states;
    {
        std::ifstream in(file, std::ios::binary);
        states.in_double = read(in);
        states.in_single = read(in);
    }
    fs::remove(file);
    return states;
}

// Writes its state where the test below asks it to.
TEST(InstructionSets, StateOfThisProcess) {
    const char* output = std::getenv(output_variable);  // NOLINT(concurrency-mt-unsafe)
    if (output == nullptr) GTEST_SKIP() << "part of InstructionSets.AgreeToRounding";
    EXPECT_EQ(instruction_set_name(active_instruction_set()),
              std::getenv(set_variable));  // NOLINT(concurrency-mt-unsafe)
    const States states = run_here();
    std::ofstream file(output, std::ios::binary);
    write(file, states.in_double);
    write(file, states.in_single);
}

double largest_difference(const std::vector<double>& a, const std::vector<double>& b) {
    EXPECT_EQ(a.size(), b.size());
    EXPECT_FALSE(a.empty());
    double largest = 0.0;
    for (std::size_t i = 0; i < std::min(a.size(), b.size()); ++i) {
        largest = std::max(largest, std::abs(a[i] - b[i]));
    }
    return largest;
}

TEST(InstructionSets, AgreeToRounding) {
    const States reference = run_under(InstructionSet::baseline);
    for (const InstructionSet set : {InstructionSet::avx2, InstructionSet::avx512}) {
        if (!instruction_set_available(set)) continue;
        const States states = run_under(set);
        // Values up to 1 (m, m/s), of some thousand operations each: 1e-12 is far above the rounding of the
        // sums in double precision, and 1e-5 above that in single. The flow is too short to amplify it.
        EXPECT_LT(largest_difference(reference.in_double, states.in_double), 1e-12)
            << instruction_set_name(set);
        EXPECT_LT(largest_difference(reference.in_single, states.in_single), 1e-5)
            << instruction_set_name(set);
        // Not by being the same code: fused multiplications round differently.
        EXPECT_NE(reference.in_double, states.in_double) << instruction_set_name(set);
    }
}

}  // namespace
}  // namespace riffle::instruction_sets_test
