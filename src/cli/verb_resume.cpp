#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <filesystem>
#include <memory>

#include "cli/case_argument.hpp"
#include "cli/run_arguments.hpp"
#include "cli/run_display.hpp"
#include "cli/terminal.hpp"
#include "cli/verbs.hpp"
#include "record/run_results.hpp"
#include "solver/run.hpp"

namespace riffle::inline cli {

namespace {

struct ResumeVerb {
    std::string folder;
    std::string checkpoint;
    std::vector<std::string> settings;
    RunArguments options;
};

void resume(const ResumeVerb& verb) {
    RunOptions options;
    options.folder = verb.folder;
    options.threads = verb.options.threads;
    RunDisplay display(verb.options.quiet);
    options.progress = [&](const RunProgress& progress) { display.show(progress); };
    options.warn = [&](const std::string& warning) { display.warn(warning); };
    options.stop_signal = &catch_stop_signals();
    std::filesystem::path checkpoint = verb.checkpoint;
    if (!checkpoint.empty() && checkpoint.is_relative() && !std::filesystem::exists(checkpoint)) {
        checkpoint = options.folder / checkpoint;
    }
    if (!checkpoint.empty() && !std::filesystem::exists(checkpoint)) {
        throw FileError(fmt::format(
            "--from {}: there is no such file, neither here nor in {}. Without --from, `riffle resume {}` "
            "goes on from the newest checkpoint",
            verb.checkpoint, verb.folder, verb.folder));
    }
    CaseArgument argument;
    argument.settings = verb.settings;
    const RunOutcome outcome = resume_run(options, checkpoint, argument.overrides());
    display.finish();
    const RunFiles files{options.folder};
    print_outcome(outcome, RunResults(files.results()).flow(), files, verb.options.quiet);
}

}  // namespace

void add_verb_resume(CLI::App& app) {
    const auto verb = std::make_shared<ResumeVerb>();
    CLI::App* const command =
        app.add_subcommand("resume", "Go on with a run from its last checkpoint, bit for bit");
    command->add_option("folder", verb->folder, "Folder of the run")->required()->type_name("DIR");
    command->add_option("--from", verb->checkpoint, "Another checkpoint, e.g. checkpoint-previous.h5")
        ->type_name("FILE");
    command
        ->add_option("--set", verb->settings,
                     "Change a key of [run] or [output], numerics.courant_number or numerics.time_step, e.g. "
                     "run.until='\"130 s\"'")
        ->type_name("KEY=VALUE")
        ->allow_extra_args(false);
    verb->options.add_to(*command);
    command->footer(
        "Examples:\n"
        "  riffle resume results/condition-2\n"
        "  riffle resume results/condition-2 --set run.until='\"130 s\"'\n"
        "  riffle resume results/condition-2 --set numerics.courant_number=0.4\n"
        "  riffle resume results/condition-2 --from checkpoint-previous.h5");
    command->callback([verb] { resume(*verb); });
}

}  // namespace riffle::inline cli
