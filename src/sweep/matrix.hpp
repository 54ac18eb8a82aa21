#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "case/case.hpp"

namespace riffle::inline sweep {

/// A key of the case and the values that it takes in a sweep, as on the command line.
struct Variation {
    std::string key;                  ///< "numerics.spacing"
    std::vector<std::string> values;  ///< "2mm", "1.5mm"

    /// Its name in the names of the runs: the key without its section.
    [[nodiscard]] std::string short_name() const;
};

/// Read "KEY=V1,V2,...". Commas inside quotes or brackets belong to a value. Throws InputError where it is
/// not of this form, a value is missing or is given twice.
[[nodiscard]] Variation read_variation(const std::string& text);

/// One value of each variation.
struct Combination {
    std::string name;                 ///< "spacing=2mm_kernel=cubic-spline", fit for a folder
    std::vector<std::string> values;  ///< in the order of the variations
};

/// All combinations, the last variation changing fastest. Throws InputError where a key is varied twice or
/// two combinations would get one name.
[[nodiscard]] std::vector<Combination> combinations_of(const std::vector<Variation>& variations);

/// A run of a sweep: its combination, its case, and its folder.
struct SweepRun {
    Combination combination;
    Case flow;
    std::filesystem::path folder;
};

/// What a sweep is made from.
struct SweepInput {
    std::filesystem::path case_file;
    std::vector<Override> settings;  ///< for all runs
    std::vector<Variation> variations;
    std::filesystem::path folder;  ///< of the sweep: its runs lie in it
};

/// Read and validate the case of each combination, and check that it can be run. Throws InputError that names
/// all combinations that cannot, with the key and the reason; FileError where a file cannot be read.
[[nodiscard]] std::vector<SweepRun> read_matrix(const SweepInput& input);

}  // namespace riffle::inline sweep
