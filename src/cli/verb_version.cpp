#include <fmt/format.h>

#include <CLI/CLI.hpp>

#include "base/parallel.hpp"
#include "base/version.hpp"
#include "cli/verbs.hpp"
#include "sph/pair_loops.hpp"

namespace riffle::inline cli {

void add_verb_version(CLI::App& app) {
    auto* const verb = app.add_subcommand("version", "Version, build, instruction set and threads");
    verb->footer(
        "Examples:\n"
        "  riffle version\n"
        "  RIFFLE_INSTRUCTION_SET=avx2 riffle version");
    verb->callback([] {
        set_thread_count(0);
        fmt::print(
            "riffle {}\nbuild: {}\ninstruction set: {} (RIFFLE_INSTRUCTION_SET=baseline|avx2|avx512 forces "
            "one)\n"
            "threads: {}\n",
            version(), build_description(), instruction_set_name(active_instruction_set()), thread_count());
    });
}

}  // namespace riffle::inline cli
