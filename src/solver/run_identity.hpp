#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

#include "case/case.hpp"
#include "output/checkpoint_file.hpp"
#include "output/dataset.hpp"
#include "output/results_file.hpp"

namespace riffle::inline solver {

// What ties the files of a run together: results and checkpoints carry the same run id, and tell of which
// build, which instructions and which input files they are.

/// A file that a case reads beside its own text.
struct InputFile {
    std::string key;  ///< of the case, that names it
    std::filesystem::path path;
    bool needed = false;  ///< read again when the run is resumed
};
[[nodiscard]] std::vector<InputFile> input_files(const Case& c);

/// A new run id: 16 hexadecimal digits, drawn at random.
[[nodiscard]] std::string new_run_id();

/// Lines "checksum bytes key path" of the input files as they are now; "-" for a file that is not there.
[[nodiscard]] std::string input_checksums(const Case& c);

/// Add the run id, the build, the instruction set and the checksums of the inputs. `inputs`: of
/// input_checksums().
void add_identity(Content& content, const std::string& run_id, const std::string& inputs);

/// The run id of a file; empty where it has none.
[[nodiscard]] std::string run_id_of(const ContentReader& file);

/// Refuse a checkpoint of another run than the results. Throws FileError.
void require_same_run(const CheckpointReader& checkpoint, const ResultsReader& results);

/// Compare the inputs, the build and the instructions with those of a checkpoint. Throws InputError where a
/// file has changed that the run needs. Gives warnings of what else differs.
[[nodiscard]] std::vector<std::string> compare_identity(const CheckpointReader& checkpoint, const Case& c);

}  // namespace riffle::inline solver
