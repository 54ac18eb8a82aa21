#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <memory>
#include <string>
#include <vector>

#include "base/error.hpp"
#include "case/nearest.hpp"
#include "cli/verbs.hpp"

namespace riffle::inline cli {

std::string verb_list(const CLI::App& app, const std::string& asked) {
    std::vector<std::string> verbs;
    for (const CLI::App* verb : app.get_subcommands([](const CLI::App*) { return true; })) {
        verbs.push_back(verb->get_name());
    }
    const auto meant = nearest_name(asked, verbs);
    return fmt::format("{}; the verbs are {}", meant ? fmt::format(": did you mean `{}`?", *meant) : "",
                       fmt::join(verbs, ", "));
}

void add_verb_help(CLI::App& app) {
    auto* const verb = app.add_subcommand("help", "Explain a verb, as `riffle VERB --help` does");
    const auto name = std::make_shared<std::string>();
    verb->add_option("verb", *name, "The verb; without it all verbs are listed")->type_name("VERB");
    verb->footer(
        "Examples:\n"
        "  riffle help\n"
        "  riffle help sweep");
    verb->callback([&app, name] {
        if (name->empty()) {
            // help() would delegate to the verb that was given, this one.
            fmt::print("{}",
                       app.get_formatter()->make_help(&app, app.get_name(), CLI::AppFormatMode::Normal));
            return;
        }
        const auto asked =
            app.get_subcommands([&](const CLI::App* other) { return other->get_name() == *name; });
        if (asked.empty()) {
            throw InputError(fmt::format("unknown verb `{}`{}", *name, verb_list(app, *name)));
        }
        fmt::print("{}", asked.front()->help(app.get_name()));
    });
}

}  // namespace riffle::inline cli
