#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "base/error.hpp"
#include "cli/case_argument.hpp"
#include "cli/run_arguments.hpp"
#include "cli/terminal.hpp"
#include "cli/verbs.hpp"
#include "output/atomic_file.hpp"
#include "output/replaced_file.hpp"
#include "preview/preview_page.hpp"

namespace riffle::inline cli {

namespace {

namespace fs = std::filesystem;

struct PreviewVerb {
    CaseArgument argument;
    std::string output;
    int threads = 0;
    bool geometry = false;
};

void preview(const PreviewVerb& verb) {
    show_notices();
    const Case c = verb.argument.read();
    verb.argument.check_size_of(c);
    const fs::path page =
        verb.output.empty() ? fs::path(c.path.stem().string() + "-preview.html") : fs::path(verb.output);
    if (page.extension() != ".html") {
        throw InputError(
            fmt::format("--output {}: expected the name of a page, NAME.html; the drawing lies beside "
                        "it as NAME.svg",
                        verb.output));
    }
    fs::path drawing = page;
    drawing.replace_extension(".svg");
    refuse_to_replace_another(page, begin_of_page, "page of Riffle");
    refuse_to_replace_another(drawing, "<svg", "drawing (SVG)");
    const std::vector<std::string> warnings = case_warnings(c);
    for (const std::string& warning : warnings) print_warning(warning);
    for (const std::string& note : c.solid_notes) {
        fmt::print("{}\n", note);
    }
    const std::string svg = preview_drawing(c);
    std::optional<Forecast> forecast;
    if (!verb.geometry) forecast = forecast_run(c, verb.threads);
    write_text_atomically(drawing, svg);
    write_text_atomically(page, preview_page(c, svg, forecast ? &*forecast : nullptr, warnings));
    fmt::print("{}\n{}\n", page.string(), drawing.string());
}

}  // namespace

void add_verb_preview(CLI::App& app) {
    const auto verb = std::make_shared<PreviewVerb>();
    CLI::App* const command = app.add_subcommand(
        "preview",
        "Draw the geometry of a case before any run: a page and a picture with bed, water, solids, "
        "walls, instruments and the numbers of `check`");
    verb->argument.add_to(*command);
    verb->argument.add_large_to(*command);
    command->add_option(
        "-o,--output", verb->output,
        "Page to write (default: CASE-preview.html here); the drawing lies beside it as .svg");
    command->add_flag("--geometry-only", verb->geometry,
                      "Leave out the forecast of particles, steps, time and memory, which takes a few steps");
    add_threads_option(*command, verb->threads,
                       "Threads of the forecast (default: all processors that may be used)");
    command->footer(
        "Examples:\n"
        "  riffle preview my-flume.toml\n"
        "  riffle preview my-flume.toml -o pictures/flume.html\n"
        "  riffle preview my-flume.toml --set numerics.spacing=1mm   what would a finer one look like?\n\n"
        "Exit status: 0 written, 2 the case or the command line is wrong, 3 a file cannot be read or written.");
    command->callback([verb] { preview(*verb); });
}

}  // namespace riffle::inline cli
