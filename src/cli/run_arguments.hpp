#pragma once

#include <CLI/CLI.hpp>
#include <string>

namespace riffle::inline cli {

/// Add the option `-j,--threads` to a verb; 0 stands for available_processors().
CLI::Option* add_threads_option(CLI::App& verb, int& threads, const std::string& meaning);

/// The options that all verbs share that advance a simulation to its end.
struct RunArguments {
    int threads = 0;
    bool quiet = false;

    /// Add `-j,--threads` and `-q,--quiet`.
    void add_to(CLI::App& verb);
};

}  // namespace riffle::inline cli
