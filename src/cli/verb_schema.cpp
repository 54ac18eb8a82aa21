#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <memory>
#include <string>

#include "base/error.hpp"
#include "case/case_documents.hpp"
#include "cli/verbs.hpp"
#include "output/atomic_file.hpp"

namespace riffle {

namespace {

struct SchemaOptions {
    bool markdown = false;
    std::string file;
};

void write_schema(const SchemaOptions& options) {
    const std::string text = options.markdown ? case_reference_markdown() : case_schema_json();
    if (options.file.empty()) {
        fmt::print("{}", text);
        return;
    }
    write_text_atomically(options.file, text);
}

}  // namespace

void add_verb_schema(CLI::App& app) {
    auto* const verb = app.add_subcommand("schema", "Print the JSON schema of the case file, for editors");
    const auto options = std::make_shared<SchemaOptions>();
    verb->add_flag("--markdown", options->markdown,
                   "Print the reference page (docs/case-reference.md) instead");
    verb->add_option("-o,--output", options->file, "File to write to (default: the terminal)");
    verb->footer(
        "Examples:\n"
        "  riffle schema -o case.schema.json\n"
        "  riffle schema --markdown -o case-reference.md");
    verb->callback([options] { write_schema(*options); });
}

}  // namespace riffle
