#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <filesystem>
#include <memory>
#include <string>
#include <vector>

#include "base/error.hpp"
#include "cli/terminal.hpp"
#include "cli/verbs.hpp"
#include "output/checkpoint_file.hpp"
#include "output/results_file.hpp"
#include "solver/run.hpp"

namespace riffle::inline cli {

namespace {

namespace fs = std::filesystem;

struct VerifyOptions {
    std::vector<std::string> paths;
    bool accept = false;
};

/// The files of a run's folder that have checksums; a file stands for itself.
std::vector<fs::path> files_of(const fs::path& path) {
    std::error_code error;
    if (!fs::is_directory(path, error)) return {path};
    const RunFiles run{path};
    std::vector<fs::path> files = {run.results()};
    for (const fs::path& checkpoint : {run.checkpoint(), CheckpointFile::previous(run.checkpoint())}) {
        if (fs::exists(checkpoint, error)) files.push_back(checkpoint);
    }
    return files;
}

bool is_checkpoint(const fs::path& path) { return path.filename().string().starts_with("checkpoint"); }

/// What there is to say of a whole file. Throws FileError of one that is not.
std::string standing_of(const fs::path& path) {
    if (is_checkpoint(path)) {
        return fmt::format("whole, at t = {:.6g} s", CheckpointReader(path).number("/", "time"));
    }
    const ResultsReader results(path);
    if (!results.has_checksums()) {
        return "has no checksums (of another program, or of an early Riffle); --accept makes them";
    }
    const std::uint64_t behind = results.verify();
    if (behind == 0) return "whole";
    return fmt::format(
        "whole, but for {} byte{} behind the end that do{} not belong to it: a change that did not "
        "come to its end leaves such, and the next one takes them away",
        behind, behind == 1 ? "" : "s", behind == 1 ? "es" : "");
}

void verify(const VerifyOptions& options) {
    bool whole = true;
    for (const std::string& given : options.paths) {
        for (const fs::path& path : files_of(given)) {
            try {
                if (options.accept && !is_checkpoint(path)) ResultsFile::accept(path);
                fmt::print("{}: {}\n", path.string(), standing_of(path));
            } catch (const FileError& error) {
                whole = false;
                print_error(error.what());
            }
        }
    }
    if (!whole) verb_exit_status() = static_cast<int>(ExitCode::file_error);
}

}  // namespace

void add_verb_verify(CLI::App& app) {
    const auto options = std::make_shared<VerifyOptions>();
    CLI::App* const verb = app.add_subcommand(
        "verify", "Compare results and checkpoints with their checksums; say what of a damaged file is lost");
    verb->add_option("files", options->paths, "Folders of runs, results files or checkpoints")
        ->required()
        ->type_name("RESULTS|CHECKPOINT");
    verb->add_flag("--accept", options->accept,
                   "Make new checksums for results that another program (h5py) has changed on purpose");
    verb->footer(
        "Examples:\n"
        "  riffle verify results/my-flume\n"
        "  riffle verify copy-of-results.h5 --accept\n"
        "Exit status: 0 where all is whole, 3 where a file is damaged.");
    verb->callback([options] { verify(*options); });
}

}  // namespace riffle::inline cli
