#include "cli/run_arguments.hpp"

#include "cli/verbs.hpp"

namespace riffle::inline cli {

CLI::Option* add_threads_option(CLI::App& verb, int& threads, const std::string& meaning) {
    return verb.add_option("-j,--threads", threads, meaning)->check(CLI::Range(0, maximum_threads));
}

void RunArguments::add_to(CLI::App& verb) {
    add_threads_option(verb, threads,
                       "Threads (default: all processors that may be used); the results do not depend on it");
    verb.add_flag("-q,--quiet", quiet, "No warnings, progress and summary on the terminal; errors only");
}

}  // namespace riffle::inline cli
