#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <filesystem>
#include <memory>
#include <string>

#include "base/error.hpp"
#include "case/case.hpp"
#include "case/case_documents.hpp"
#include "case/flow_conditions.hpp"
#include "cli/verbs.hpp"
#include "output/atomic_file.hpp"
#include "output/replaced_file.hpp"

namespace riffle::inline cli {

namespace {

struct NewOptions {
    std::string file;
    std::string from = "rough-bed";
    bool violent = false;
    bool resolved = false;
    bool force = false;
};

void write_new_case(const NewOptions& options) {
    const std::filesystem::path file(options.file);
    if (!options.force) refuse_to_replace(file);
    const std::string from = options.violent    ? "dam-break"
                             : options.resolved ? "resolved-eddies"
                                                : options.from;
    const bool from_file = std::filesystem::is_regular_file(from);
    const Case c = from_file ? read_case(from) : builtin_case(from);
    write_text_atomically(file, case_template(c));
    fmt::print("{} written; `riffle check {}` says what it will cost, `riffle run {}` runs it\n",
               options.file, options.file, options.file);
}

}  // namespace

void add_verb_new(CLI::App& app) {
    auto* const verb = app.add_subcommand("new", "Write a commented case file");
    const auto options = std::make_shared<NewOptions>();
    verb->add_option("file", options->file, "Case file to write")->required();
    verb->add_option(
            "--from", options->from,
            "Case file to take the values from, or a built-in case: rough-bed, condition-1 to condition-8, "
            "paper-2016, dam-break, resolved-eddies; in three dimensions condition-N-3d (the thesis' size), "
            "condition-N-3d-coarse (half the width, two spheres long) and condition-N-3d-wide (periodic across), N = "
            "1, 2, 5 or 8")
        ->capture_default_str();
    verb->add_flag(
            "--violent", options->violent,
            "A case of water that falls and breaks, with the numerics for it: the same as --from dam-break")
        ->excludes("--from");
    verb->add_flag("--resolved", options->resolved,
                   "A cell of a channel whose eddies the particles carry: the same as --from resolved-eddies")
        ->excludes("--from")
        ->excludes("--violent");
    verb->add_flag("--force", options->force, "Overwrite an existing file");
    verb->footer(
        "Examples:\n"
        "  riffle new my-flume.toml\n"
        "  riffle new my-flume.toml --from condition-2\n"
        "  riffle new my-flume.toml --from condition-2-3d-coarse   in three dimensions\n"
        "  riffle new my-tank.toml --violent             water that falls, breaks and hits\n"
        "  riffle new my-eddies.toml --resolved          eddies and a surface that moves with them\n"
        "  riffle new other.toml --from my-flume.toml   its values, with the comments of all keys");
    verb->callback([options] { write_new_case(*options); });
}

}  // namespace riffle::inline cli
