#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <memory>
#include <nlohmann/json.hpp>
#include <set>
#include <string>
#include <vector>

#include "base/error.hpp"
#include "base/version.hpp"
#include "cli/run_arguments.hpp"
#include "cli/verbs.hpp"
#include "solver/benchmark.hpp"
#include "sph/pair_loops.hpp"

namespace riffle {

namespace {

struct BenchVerb {
    std::vector<std::string> names;
    int threads = 1;
    int repetitions = 5;
    double seconds = 1.0;
    bool json = false;
};

/// The workloads of these names ("name" or "name/scheme"); all when none is given.
std::vector<Workload> chosen_workloads(const std::vector<std::string>& names) {
    const std::vector<Workload> all = standard_workloads();
    std::vector<std::string> known;
    std::set<std::string> unknown(names.begin(), names.end());
    std::vector<Workload> chosen;
    for (const Workload& w : all) {
        known.push_back(w.name + "/" + w.scheme);
        const bool wanted = std::any_of(names.begin(), names.end(), [&](const std::string& name) {
            return name == w.name || name == known.back();
        });
        if (wanted || names.empty()) {
            chosen.push_back(w);
        }
        unknown.erase(w.name);
        unknown.erase(known.back());
    }
    if (!unknown.empty()) {
        throw InputError(fmt::format("unknown workload `{}`; the workloads are {}", *unknown.begin(),
                                     fmt::join(known, ", ")));
    }
    return chosen;
}

void bench(const BenchVerb& verb) {
    const std::vector<Workload> chosen = chosen_workloads(verb.names);
    nlohmann::ordered_json array = nlohmann::ordered_json::array();
    if (!verb.json) {
        fmt::print("riffle {}, {} instructions, {}\n", version(),
                   instruction_set_name(active_instruction_set()), build_description());
        fmt::print("{:<26} {:>9} {:>7} {:>11} {:>14} {:>14} {:>12}\n", "workload/scheme", "particles",
                   "threads", "neighbours", "ns/update*core", "M updates/s", "steps/build");
    }
    for (const Workload& w : chosen) {
        const BenchmarkResult r = run_benchmark(w, verb.threads, verb.repetitions, verb.seconds);
        const double pairs = r.neighbours * r.updates_per_second / r.threads;
        if (verb.json) {
            array.push_back({{"name", w.name},
                             {"scheme", w.scheme},
                             {"particles", r.particles},
                             {"neighbours", r.neighbours},
                             {"threads", r.threads},
                             {"nanoseconds_per_update", r.nanoseconds_per_update},
                             {"updates_per_second", r.updates_per_second},
                             {"directed_pairs_per_second_per_core", pairs},
                             {"steps_per_list_build", r.steps_per_list_build},
                             {"bytes_per_particle", r.bytes_per_particle}});
        } else {
            fmt::print("{:<26} {:>9} {:>7} {:>11.1f} {:>14.1f} {:>14.2f} {:>12.1f} {:6.0f} M pairs/s {:5.0f} B | lists {:.1f} grad {:.1f} force {:.1f} walls {:.1f} rest {:.1f} | listed {:.1f}\n",
                       w.name + "/" + w.scheme, r.particles, r.threads, r.neighbours,
                       r.nanoseconds_per_update, r.updates_per_second * 1e-6, r.steps_per_list_build, pairs * 1e-6, r.bytes_per_particle, 100*r.profile.lists, 100*r.profile.gradients, 100*r.profile.forces, 100*r.profile.walls, 100*r.profile.particles, r.listed_neighbours);
        }
    }
    if (verb.json) {
        const nlohmann::ordered_json json = {
            {"version", version()},
            {"build", build_description()},
            {"instruction_set", instruction_set_name(active_instruction_set())},
            {"workloads", array}};
        fmt::print("{}\n", json.dump(2));
    }
}

}  // namespace

void add_verb_bench(CLI::App& app) {
    const auto verb = std::make_shared<BenchVerb>();
    CLI::App* const command =
        app.add_subcommand("bench", "Measure the speed of standard workloads on this machine");
    command->add_option("workloads", verb->names,
                        "Names, e.g. channel-2d-5k or channel-2d-5k/default (default: all)");
    add_threads_option(*command, verb->threads, "Threads (0: all cores)")->capture_default_str();
    command->add_option("--repetitions", verb->repetitions, "Timed parts; the median counts")
        ->check(CLI::PositiveNumber)
        ->capture_default_str();
    command->add_option("--seconds", verb->seconds, "Length of a part, s")
        ->check(CLI::PositiveNumber)
        ->capture_default_str();
    command->add_flag("--json", verb->json, "Print JSON");
    command->callback([verb] { bench(*verb); });
}

}  // namespace riffle
