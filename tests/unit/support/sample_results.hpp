#pragma once

#include <filesystem>
#include <map>
#include <set>
#include <string>

namespace riffle::testing {

/// What a sample results file is to hold.
struct SampleOptions {
    std::string case_text;          ///< empty: the sample channel over spheres
    std::string stored_case_text;   ///< case to store in the file instead of the one simulated
    std::set<std::string> without;  ///< groups left out, e.g. "/profiles"
    std::map<std::string, double> summary_overrides;  ///< attributes of /summary with another value
    bool complete = true;
    bool converged = true;
    double velocity_bias = 0.002;  ///< relative departure of the simulated velocity from the column twin
    double length = 0.2;           ///< of the channel, m
};

/// The sample case: flow condition 2 with its measured values.
[[nodiscard]] std::string sample_case(double length = 0.2);

/// Write a results file as a run would leave it: the column twin's flow, of a case without one still water,
/// with small, reproducible departures.
void write_sample_results(const std::filesystem::path& path, const SampleOptions& options = {});

}  // namespace riffle::testing
