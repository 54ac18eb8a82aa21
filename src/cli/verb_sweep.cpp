#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <filesystem>
#include <memory>
#include <set>

#include "base/error.hpp"
#include "base/parallel.hpp"
#include "cli/case_argument.hpp"
#include "cli/run_arguments.hpp"
#include "cli/run_display.hpp"
#include "cli/sweep_display.hpp"
#include "cli/terminal.hpp"
#include "cli/verbs.hpp"
#include "output/folder_lock.hpp"
#include "sweep/study_files.hpp"

namespace riffle::inline cli {

namespace {

struct SweepVerb {
    CaseArgument argument;
    std::vector<std::string> variations;
    std::vector<std::string> outcomes;
    std::string folder;
    RunArguments options;
    int jobs = 0;
    bool force = false;
    bool dry_run = false;
};

SweepInput input_of(const SweepVerb& verb) {
    SweepInput input;
    input.case_file = verb.argument.file;
    input.settings = verb.argument.overrides();
    for (const std::string& text : verb.variations) input.variations.push_back(read_variation(text));
    input.folder = verb.folder.empty()
                       ? std::filesystem::path("results") / (input.case_file.stem().string() + "-sweep")
                       : std::filesystem::path(verb.folder);
    return input;
}

/// Whether a run is left as it is.
bool left(FolderState state, bool force) {
    return state == FolderState::complete ||
           (!force && (state == FolderState::failed || state == FolderState::other));
}

void dry_run(const std::vector<SweepRun>& runs, const std::vector<FolderStanding>& standings,
             const ScheduleOptions& options) {
    const auto to_do = std::count_if(standings.begin(), standings.end(), [&](const FolderStanding& standing) {
        return !left(standing.state, options.force);
    });
    const Shares shares = shares_of(options, static_cast<std::size_t>(to_do));
    std::vector<std::optional<Forecast>> forecasts;
    for (std::size_t i = 0; i < runs.size(); ++i) {
        forecasts.push_back(left(standings[i].state, options.force)
                                ? std::nullopt
                                : std::optional(forecast_run(runs[i].flow, shares.threads)));
    }
    print_matrix(runs, standings, forecasts, shares);
}

/// Warnings of the cases, each once.
void print_warnings(const std::vector<SweepRun>& runs) {
    std::set<std::string> said;
    for (const SweepRun& run : runs) {
        for (const std::string& warning : case_warnings(run.flow)) {
            if (said.insert(warning).second) {
                print_warning(fmt::format("{}: {}", run.combination.name, warning));
            }
        }
    }
}

/// The exit status that says how the sweep ended; and what to do next.
void conclude(const SweepVerb& verb, const std::vector<SweepRun>& runs, const std::vector<RunReport>& reports,
              int stop, const SweepFiles& files) {
    std::size_t failed = 0;
    int status = 0;
    for (std::size_t i = 0; i < runs.size(); ++i) {
        const RunReport& report = reports[i];
        if (report.fate != RunFate::failed && report.fate != RunFate::failed_before) continue;
        ++failed;
        status =
            status == 0 || report.status == static_cast<int>(ExitCode::run_failed) ? report.status : status;
        if (report.fate == RunFate::failed_before) {
            print_error(fmt::format("{}: failed before: {}", runs[i].combination.name, report.message));
        }
    }
    verb_exit_status() = stop != 0 ? 128 + stop : status;
    if (verb.options.quiet) return;
    fmt::print("{}\n{}\n{}\n", files.page().string(), files.json().string(), files.csv().string());
    if (stop != 0) {
        fmt::print(
            "stopped; each run that was under way has left a checkpoint. Go on by the same command.\n");
    }
    if (failed > 0) {
        fmt::print(
            "{} of {} runs failed; their logs (run.log) say why. The same command with --force begins "
            "them anew; `riffle resume FOLDER` goes on with one, with a smaller step by --set "
            "numerics.courant_number=... or, where the case gives the step, numerics.time_step=...\n",
            failed, runs.size());
    }
}

void sweep(const SweepVerb& verb) {
    const std::vector<Outcome> outcomes = chosen_outcomes(verb.outcomes);
    // The runs are forks of this process, which may have no threads until the last of them is there; each has
    // its own. To read the water of another run takes loops.
    set_thread_count(1);
    const SweepInput input = input_of(verb);
    const std::vector<SweepRun> runs = read_matrix(input);
    for (const SweepRun& run : runs) verb.argument.check_size_of(run.flow);
    ScheduleOptions options;
    options.jobs = verb.jobs;
    options.threads = verb.options.threads;
    options.force = verb.force;
    const auto look = [&] {
        std::vector<FolderStanding> standings;
        std::transform(runs.begin(), runs.end(), std::back_inserter(standings), standing_of);
        return standings;
    };
    if (verb.dry_run) {
        dry_run(runs, look(), options);
        return;
    }
    if (!verb.options.quiet) print_warnings(runs);
    const FolderLock lock(input.folder, FolderLock::Work::sweep);
    SweepDisplay display(verb.options.quiet);
    options.stop_signal = &catch_stop_signals();
    options.progress = [&](const SweepProgress& progress) { display.show(progress); };
    options.ended = [&](const SweepRun& run, const RunReport& report, bool resumed) {
        display.show_end(run, report, resumed);
    };
    const std::vector<RunReport> reports = carry_out(runs, look(), options);
    display.clear();
    set_thread_count(verb.options.threads);
    const SweepStudy study = study_sweep(input, runs, reports, outcomes, verb.outcomes.empty());
    const SweepFiles files{input.folder};
    write_sweep(study, files);
    if (!verb.options.quiet) {
        fmt::print("\n{}\n", sweep_text(study));
    }
    conclude(verb, runs, reports, options.stop_signal->load(), files);
}

}  // namespace

void add_verb_sweep(CLI::App& app) {
    const auto verb = std::make_shared<SweepVerb>();
    CLI::App* const command = app.add_subcommand(
        "sweep", "Run a case for all combinations of some values; outcomes, orders of convergence, figures");
    verb->argument.add_to(*command);
    verb->argument.add_large_to(*command);
    command
        ->add_option("--vary", verb->variations,
                     "A key and the values it takes; may be given several times, for all combinations")
        ->required()
        ->type_name("KEY=V1,V2,...")
        ->allow_extra_args(false);
    command
        ->add_option("-o,--output", verb->folder,
                     "Folder of the sweep, with a folder for each run (default: results/<name of the "
                     "case>-sweep)")
        ->type_name("DIR");
    command
        ->add_option("--outcome", verb->outcomes,
                     "An outcome to tabulate and plot, by its name in docs/sweep.md; may be given several "
                     "times (default: the usual ones)")
        ->type_name("NAME")
        ->allow_extra_args(false);
    command
        ->add_option("--jobs", verb->jobs,
                     "Runs at a time, which share the threads (default: as many as have four each)")
        ->check(CLI::Range(1, maximum_threads));
    verb->options.add_to(*command);
    command->add_flag("--force", verb->force,
                      "Begin failed runs anew, and replace results of another case in the runs' folders");
    command->add_flag("--dry-run", verb->dry_run, "Only list the runs with what each will take");
    command->footer(
        "Examples:\n"
        "  riffle sweep my-flume.toml --vary numerics.spacing=2mm,1.5mm,1mm --dry-run\n"
        "  riffle sweep my-flume.toml --vary numerics.spacing=2mm,1.5mm,1mm -o results/grid\n"
        "  riffle sweep my-flume.toml --vary numerics.spacing=2mm,1mm \\\n"
        "      --vary numerics.kernel=wendland-c2,cubic-spline --set run.until='\"20 s\"' --jobs 2\n"
        "  riffle sweep my-flume.toml --vary turbulence.closure=ramp,nezu-rodi --outcome "
        "depth_mean_velocity\n"
        "Ctrl-C stops all runs with checkpoints; the same command goes on: complete runs are taken as they\n"
        "are, interrupted ones resumed. `riffle report DIR/*/` compares the runs on one page.");
    command->callback([verb] { sweep(*verb); });
}

}  // namespace riffle::inline cli
