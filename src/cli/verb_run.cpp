#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <filesystem>
#include <memory>

#include "cli/case_argument.hpp"
#include "cli/run_display.hpp"
#include "cli/terminal.hpp"
#include "cli/verbs.hpp"
#include "solver/run.hpp"

namespace riffle {

namespace {

struct RunVerb {
    CaseArgument argument;
    std::string folder;
    int threads = 0;
    bool quiet = false;
    bool force = false;
};

void run(const RunVerb& verb) {
    const Case c = verb.argument.read();
    RunOptions options;
    options.folder = verb.folder.empty()
                         ? std::filesystem::path("results") / std::filesystem::path(verb.argument.file).stem()
                         : std::filesystem::path(verb.folder);
    options.threads = verb.threads;
    options.overwrite = verb.force;
    options.notes = case_warnings(c);
    if (!verb.quiet) {  // the log has them in any case
        for (const std::string& warning : options.notes) {
            print_warning(warning);
        }
    }
    RunDisplay display(verb.quiet);
    options.progress = [&](const RunProgress& progress) { display.show(progress); };
    options.stop_signal = &catch_stop_signals();
    const RunOutcome outcome = run_case(c, options);
    display.finish();
    print_outcome(outcome, c, RunFiles{options.folder}, verb.quiet);
}

}  // namespace

void add_verb_run(CLI::App& app) {
    const auto verb = std::make_shared<RunVerb>();
    CLI::App* const command =
        app.add_subcommand("run", "Simulate a case; results, checkpoints and log go to one folder");
    verb->argument.add_to(*command);
    command
        ->add_option("-o,--output", verb->folder,
                     "Folder of the results (default: results/<name of the case>)")
        ->type_name("DIR");
    command
        ->add_option("-j,--threads", verb->threads,
                     "Threads (default: all cores); the results do not depend on it")
        ->check(CLI::Range(0, maximum_threads));
    command->add_flag("-q,--quiet", verb->quiet,
                      "No warnings, progress and summary on the terminal; errors only");
    command->add_flag("--force", verb->force, "Replace results that the folder already holds");
    command->footer(
        "Examples:\n"
        "  riffle run cases/rough-bed-2d/condition-2.toml\n"
        "  riffle run my-flume.toml -o results/fine --set numerics.spacing=1.5mm\n"
        "  riffle run my-flume.toml --set run.until='\"130 s\"'\n"
        "Ctrl-C or SIGTERM stops with a checkpoint; `riffle resume DIR` goes on from it.");
    command->callback([verb] { run(*verb); });
}

}  // namespace riffle
