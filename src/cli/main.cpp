#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <exception>
#include <string>

#include "base/error.hpp"
#include "base/version.hpp"
#include "cli/terminal.hpp"
#include "cli/verbs.hpp"

namespace riffle {

int& verb_exit_status() {
    static int status = 0;
    return status;
}

namespace {

constexpr const char* examples = R"(Examples:
  riffle new my-flume.toml                          a commented case to start from
  riffle check my-flume.toml                        is it valid, and what will it cost?
  riffle column my-flume.toml                       the 1D twin: the mean flow in milliseconds
  riffle run my-flume.toml -o results/my-flume      simulate until the mean flow is steady
  riffle resume results/my-flume                    go on after a stop
  riffle report results/my-flume                    one HTML page with figures and numbers

Exit status: 0 success, 1 the simulation failed, 2 wrong command line or case, 3 a file cannot be
read or written, 128 + n stopped by signal n with a checkpoint.)";

int parse_and_run(int argc, char** argv) {
    CLI::App app{
        "Riffle simulates turbulent flow in rivers and flumes over rough beds, with its free surface"};
    app.footer(examples);
    app.require_subcommand(1);
    app.set_version_flag("--version", version());
    add_verb_new(app);
    add_verb_check(app);
    add_verb_column(app);
    add_verb_calibrate(app);
    add_verb_run(app);
    add_verb_resume(app);
    add_verb_report(app);
    add_verb_bench(app);
    add_verb_schema(app);
    add_verb_version(app);
    try {
        app.parse(argc, argv);
    } catch (const CLI::ParseError& e) {
        return app.exit(e) == 0 ? 0 : static_cast<int>(ExitCode::bad_input);
    }
    return verb_exit_status();
}

}  // namespace

}  // namespace riffle

int main(int argc, char** argv) {
    using riffle::ExitCode;
    try {
        return riffle::parse_and_run(argc, argv);
    } catch (const riffle::Error& e) {
        riffle::print_error(e.what());
        return static_cast<int>(e.code());
    } catch (const std::exception& e) {
        riffle::print_error(std::string("unexpected fault: ") + e.what() +
                            "\nThis is a defect of Riffle: please report it.");
        return static_cast<int>(ExitCode::run_failed);
    }
}
