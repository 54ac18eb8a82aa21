#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <cerrno>
#include <cstdio>
#include <exception>
#include <string>
#include <system_error>
#include <vector>

#include "base/error.hpp"
#include "base/memory.hpp"
#include "base/version.hpp"
#include "cli/help_formatter.hpp"
#include "cli/terminal.hpp"
#include "cli/verbs.hpp"

namespace riffle::inline cli {

int& verb_exit_status() {
    static int status = 0;
    return status;
}

namespace {

constexpr const char* examples = R"(Examples:
  riffle new my-flume.toml                          a commented case to start from
  riffle check my-flume.toml                        is it valid, and what will it cost?
  riffle preview my-flume.toml                      what does it look like? a page with its geometry
  riffle column my-flume.toml                       the 1D twin: the mean flow in milliseconds
  riffle section my-channel.toml                    the 2D twin of a channel with side walls
  riffle backwater my-flume.toml --downstream 80mm  steady varied flow: M1 to S3, jumps
  riffle run my-flume.toml -o results/my-flume      simulate until the mean flow is steady
  riffle watch results/my-flume                     follow it in the browser meanwhile
  riffle resume results/my-flume                    go on after a stop
  riffle sweep my-flume.toml --vary numerics.spacing=2mm,1.5mm,1mm
                                                    runs of all combinations, with orders of convergence
  riffle report results/my-flume                    one HTML page with figures and numbers
  riffle analyse results/my-flume                   profiles, fitted laws, surface, spectra as numbers
  riffle help run                                   what a verb does, its options and examples

Exit status: 0 success, 1 the simulation failed, 2 wrong command line or case, 3 a file cannot be
read or written, 128 + n stopped by signal n with a checkpoint.)";

/// Tell what is wrong with the command line, and where its help is.
void print_usage_error(const CLI::App& app, const CLI::ParseError& error, int argc, char** argv) {
    const std::vector<CLI::App*> used = app.get_subcommands();
    const std::string first = argc > 1 ? argv[1] : "";
    std::string message = error.what();
    if (used.empty() && (first.empty() || first.front() != '-')) {
        message = (first.empty() ? "a verb is missing" : fmt::format("unknown verb `{}`", first)) +
                  verb_list(app, first);
    }
    print_error(fmt::format("{}\nriffle {}--help explains the command line.", message,
                            used.empty() ? "" : used.front()->get_name() + " "));
}

int parse_and_run(int argc, char** argv) {
    CLI::App app{
        "Riffle simulates turbulent flow in rivers and flumes over rough beds, with its free surface"};
    app.formatter(help_formatter());  // the verbs take it over
    app.require_subcommand(1);
    app.set_version_flag("--version", version());
    add_verb_new(app);
    add_verb_check(app);
    add_verb_preview(app);
    add_verb_column(app);
    add_verb_section(app);
    add_verb_backwater(app);
    add_verb_calibrate(app);
    add_verb_run(app);
    add_verb_resume(app);
    add_verb_sweep(app);
    add_verb_report(app);
    add_verb_analyse(app);
    add_verb_verify(app);
    add_verb_watch(app);
    add_verb_bench(app);
    add_verb_schema(app);
    add_verb_version(app);
    add_verb_help(app);
    app.footer(examples);  // behind the verbs, which would take it over for themselves
    try {
        app.parse(argc, argv);
    } catch (const CLI::ParseError& e) {
        if (e.get_exit_code() == static_cast<int>(CLI::ExitCodes::Success)) return app.exit(e);
        print_usage_error(app, e, argc, argv);
        return static_cast<int>(ExitCode::bad_input);
    }
    return verb_exit_status();
}

}  // namespace

}  // namespace riffle::inline cli

int main(int argc, char** argv) {
    using riffle::ExitCode;
    const auto fail = [](ExitCode code, const std::string& message) {
        riffle::print_error(message);
        return static_cast<int>(code);
    };
    const auto output_fault = [](int number) {
        return fmt::format("standard output cannot be written: {}. What it should hold is incomplete.",
                           std::generic_category().message(number));
    };
    try {
        const riffle::OutOfMemoryEnd guard;
        const int status = riffle::parse_and_run(argc, argv);
        // What has been printed counts only once it has arrived.
        if (std::fflush(stdout) != 0 || std::ferror(stdout) != 0) {
            return fail(ExitCode::file_error, output_fault(errno));
        }
        return status;
    } catch (const riffle::Error& e) {
        return fail(e.code(), e.what());
    } catch (const std::bad_alloc&) {
        return fail(
            ExitCode::run_failed,
            "out of memory: this takes more than the system gives. `riffle check CASE` says what a run "
            "needs; take a larger spacing or fewer records, or a computer with more memory.");
    } catch (const std::system_error& e) {
        if (std::ferror(stdout) != 0) return fail(ExitCode::file_error, output_fault(e.code().value()));
        return fail(ExitCode::file_error, fmt::format("the system refuses: {}", e.what()));
    } catch (const std::exception& e) {
        return fail(ExitCode::run_failed, std::string("unexpected fault: ") + e.what() +
                                              "\nThis is a defect of Riffle: please report it.");
    }
}
