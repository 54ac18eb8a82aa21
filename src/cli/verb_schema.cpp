#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <memory>
#include <string>
#include <string_view>

#include "base/error.hpp"
#include "case/case_documents.hpp"
#include "cli/verbs.hpp"
#include "output/atomic_file.hpp"
#include "output/replaced_file.hpp"
#include "record/field_tables.hpp"

namespace riffle::inline cli {

namespace {

struct SchemaOptions {
    bool results = false;
    bool markdown = false;
    std::string file;
};

void write_schema(const SchemaOptions& options) {
    std::string text;
    if (options.results) {
        text = options.markdown ? results_fields_markdown() : results_fields_json();
    } else {
        text = options.markdown ? case_reference_markdown() : case_schema_json();
    }
    if (options.file.empty()) {
        fmt::print("{}", text);
        return;
    }
    const std::string_view begin =
        options.markdown ? std::string_view(text).substr(0, text.find('\n')) : begin_of_json;
    refuse_to_replace_another(options.file, begin, options.markdown ? "page of this reference" : "JSON file");
    write_text_atomically(options.file, text);
}

}  // namespace

void add_verb_schema(CLI::App& app) {
    auto* const verb = app.add_subcommand(
        "schema", "Print the JSON schema of the case file, for editors, or the fields of the results");
    const auto options = std::make_shared<SchemaOptions>();
    verb->add_flag("--results", options->results,
                   "Print the fields of results files instead of the case's keys");
    verb->add_flag("--markdown", options->markdown,
                   "Print the reference page (docs/case-reference.md, docs/results-fields.md) instead");
    verb->add_option("-o,--output", options->file, "File to write to (default: the terminal)");
    verb->footer(
        "Examples:\n"
        "  riffle schema -o case.schema.json\n"
        "  riffle schema --markdown -o case-reference.md\n"
        "  riffle schema --results --markdown -o results-fields.md");
    verb->callback([options] { write_schema(*options); });
}

}  // namespace riffle::inline cli
