#pragma once

#include <CLI/CLI.hpp>
#include <string>

namespace riffle::inline cli {

// Each verb of the command line adds its subcommand; its callback does the work and throws riffle::Error.
// One file per verb; a new verb is a new file, a line here and a line in main.cpp.

void add_verb_new(CLI::App& app);
void add_verb_check(CLI::App& app);
void add_verb_preview(CLI::App& app);
void add_verb_column(CLI::App& app);
void add_verb_section(CLI::App& app);
void add_verb_backwater(CLI::App& app);
void add_verb_calibrate(CLI::App& app);
void add_verb_run(CLI::App& app);
void add_verb_resume(CLI::App& app);
void add_verb_sweep(CLI::App& app);
void add_verb_report(CLI::App& app);
void add_verb_analyse(CLI::App& app);
void add_verb_verify(CLI::App& app);
void add_verb_watch(CLI::App& app);
void add_verb_bench(CLI::App& app);
void add_verb_schema(CLI::App& app);
void add_verb_version(CLI::App& app);
void add_verb_help(CLI::App& app);

/// The verbs for a message about one that is none: ": did you mean `run`?; the verbs are new, check ...".
[[nodiscard]] std::string verb_list(const CLI::App& app, const std::string& asked);

/// Most threads that may be asked for; 0 stands for available_processors().
inline constexpr int maximum_threads = 4096;

/// Exit status that a verb asks for after its callback (a run stopped by a signal); 0 unless set.
[[nodiscard]] int& verb_exit_status();

}  // namespace riffle::inline cli
