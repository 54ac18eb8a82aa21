#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <filesystem>
#include <memory>
#include <optional>

#include "cli/case_argument.hpp"
#include "cli/run_arguments.hpp"
#include "cli/run_display.hpp"
#include "cli/terminal.hpp"
#include "cli/verbs.hpp"
#include "solver/run.hpp"

namespace riffle::inline cli {

namespace {

struct RunVerb {
    CaseArgument argument;
    std::optional<std::string> folder;
    RunArguments options;
    bool force = false;
};

void run(const RunVerb& verb) {
    if (!verb.options.quiet) show_notices();
    if (verb.folder && verb.folder->empty()) {
        throw InputError("-o: the name of the folder is empty; give one, or leave -o out");
    }
    const Case c = verb.argument.read();
    verb.argument.check_size_of(c);
    RunOptions options;
    options.folder =
        verb.folder ? std::filesystem::path(*verb.folder)
                    : std::filesystem::path("results") / std::filesystem::path(verb.argument.file).stem();
    options.threads = verb.options.threads;
    options.overwrite = verb.force;
    options.notes = case_warnings(c);
    if (!verb.options.quiet) {  // the log has them in any case
        for (const std::string& warning : options.notes) print_warning(warning);
    }
    RunDisplay display(verb.options.quiet);
    options.progress = [&](const RunProgress& progress) { display.show(progress); };
    options.warn = [&](const std::string& warning) { display.warn(warning); };
    options.stop_signal = &catch_stop_signals();
    const RunOutcome outcome = run_case(c, options);
    display.finish();
    print_outcome(outcome, c, RunFiles{options.folder}, verb.options.quiet);
}

}  // namespace

void add_verb_run(CLI::App& app) {
    const auto verb = std::make_shared<RunVerb>();
    CLI::App* const command =
        app.add_subcommand("run", "Simulate a case; results, checkpoints and log go to one folder");
    verb->argument.add_to(*command);
    verb->argument.add_large_to(*command);
    command
        ->add_option("-o,--output", verb->folder,
                     "Folder of the results (default: results/<name of the case>)")
        ->type_name("DIR");
    verb->options.add_to(*command);
    command->add_flag("--force", verb->force, "Replace results that the folder already holds");
    command->footer(
        "Examples:\n"
        "  riffle run cases/rough-bed-2d/condition-2.toml\n"
        "  riffle run my-flume.toml -o results/fine --set numerics.spacing=1.5mm\n"
        "  riffle run my-flume.toml --set run.until='\"130 s\"'\n"
        "Ctrl-C or SIGTERM stops with a checkpoint; `riffle resume DIR` goes on from it.");
    command->callback([verb] { run(*verb); });
}

}  // namespace riffle::inline cli
