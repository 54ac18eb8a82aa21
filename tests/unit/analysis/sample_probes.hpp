#pragma once

#include <filesystem>

namespace riffle::testing {

/// What the instruments of add_sample_probes() measure.
struct SampleProbes {
    double interval = 0.01;             ///< s, from 0 to 30 s
    double u_deviation = 0.02;          ///< m/s
    double w_deviation = 0.01;          ///< m/s
    double correlation = -0.4;          ///< of u' and w'
    double wave_amplitude = 4e-4;       ///< m, of a sine that travels at `celerity`
    double wave_length = 0.1;           ///< m
    double celerity = 0.35;             ///< m/s
    double dispersive_stress = 0.05;    ///< Pa, the same at all heights
    double bed_drag = 0.4;              ///< N/m
    double last_window_samples = 100;   ///< of the grid; its other windows, of 1 s, have 100
    double last_window_velocity = 0.3;  ///< m/s, mean along the grid; of the others 0.3
};

/// Add an instrument of each kind to a results file, as a run would record them (docs/results-format.md).
void add_sample_probes(const std::filesystem::path& results, const SampleProbes& probes = {});

}  // namespace riffle::testing
