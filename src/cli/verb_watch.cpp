#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <atomic>
#include <cstdio>
#include <filesystem>
#include <memory>
#include <optional>
#include <string>

#include "cli/run_display.hpp"
#include "cli/terminal.hpp"
#include "cli/verbs.hpp"
#include "watch/page_server.hpp"

namespace riffle::inline cli {

namespace {

struct WatchOptions {
    std::string results;
    std::optional<int> port;
    std::string listen = "127.0.0.1";
};

void watch(const WatchOptions& options) {
    const std::filesystem::path results = results_file_to_watch(options.results);
    const std::atomic<int>& signal = catch_stop_signals();
    WatchSite site(results, options.listen);
    PageServer server(site, options.listen, options.port);
    if (!is_loopback(options.listen)) {
        print_warning(fmt::format(
            "--listen {}: whoever reaches this machine on port {} can read this run; there is no "
            "password and no encryption. From elsewhere, `ssh -L {}:localhost:{} MACHINE` is safer",
            options.listen, server.port(), server.port(), server.port()));
    }
    if (!std::filesystem::exists(results)) {
        print_warning(fmt::format("{}: not there yet; the page waits for it", results.string()));
    }
    fmt::print("{}\n", server.url());
    std::fflush(stdout);
    if (error_stream_is_terminal()) {
        fmt::print(stderr, "Open this address in a browser. Ctrl-C ends the watching, not the run.\n");
    }
    server.serve([&] { return signal.load() != 0; });
}

}  // namespace

void add_verb_watch(CLI::App& app) {
    const auto options = std::make_shared<WatchOptions>();
    CLI::App* const verb =
        app.add_subcommand("watch", "Follow a run in the browser, on a page of this machine");
    verb->add_option("results", options->results,
                     "Folder of the run, or its results.h5; it may not be there yet")
        ->required()
        ->type_name("RESULTS");
    verb->add_option("--port", options->port,
                     fmt::format("Port to listen on; 0: any free one (default: {}, or the next that is free)",
                                 default_watch_port))
        ->check(CLI::Range(0, 65535))
        ->type_name("PORT");
    verb->add_option("--listen", options->listen,
                     "Address to listen on (default: 127.0.0.1, which only this machine reaches; 0.0.0.0: "
                     "all networks)")
        ->type_name("ADDRESS");
    verb->footer(
        "Examples:\n"
        "  riffle watch results/my-flume\n"
        "  riffle watch results/my-flume --port 9000\n"
        "Prints the address of the page. It may be started before, during and after the run, and never "
        "disturbs it.\n"
        "Ctrl-C ends it.");
    verb->callback([options] { watch(*options); });
}

}  // namespace riffle::inline cli
