#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <cstdio>
#include <memory>
#include <nlohmann/json.hpp>
#include <set>
#include <string>
#include <vector>

#include "base/error.hpp"
#include "base/machine.hpp"
#include "base/version.hpp"
#include "cli/positive_number.hpp"
#include "cli/run_arguments.hpp"
#include "cli/terminal.hpp"
#include "cli/verbs.hpp"
#include "solver/benchmark.hpp"
#include "sph/pair_loops.hpp"
#include "sph/peak_rate.hpp"

namespace riffle::inline cli {

namespace {

struct BenchVerb {
    std::vector<std::string> names;
    bool all = false;
    int threads = 1;
    int repetitions = 5;
    double seconds = 1.0;
    bool json = false;
};

/// What is run without names: a minute in all.
const std::set<std::string> quick_workloads = {"channel-2d-5k", "channel-2d-50k", "channel-3d-200k"};

std::string full_name(const Workload& w) { return w.name + "/" + w.scheme; }

/// The workloads of these names ("name" or "name/scheme"); the quick ones when none is given.
std::vector<Workload> chosen_workloads(const BenchVerb& verb) {
    std::vector<std::string> known;
    std::set<std::string> unknown(verb.names.begin(), verb.names.end());
    std::vector<Workload> chosen;
    for (const Workload& w : standard_workloads()) {
        known.push_back(full_name(w));
        const bool named = std::any_of(verb.names.begin(), verb.names.end(), [&](const std::string& name) {
            return name == w.name || name == known.back();
        });
        const bool quick = verb.names.empty() && quick_workloads.count(w.name) > 0 && !w.is_spatial();
        if (verb.all || named || quick) chosen.push_back(w);
        unknown.erase(w.name);
        unknown.erase(known.back());
    }
    if (!unknown.empty()) {
        throw InputError(fmt::format("unknown workload `{}`; the workloads are {}", *unknown.begin(),
                                     fmt::join(known, ", ")));
    }
    return chosen;
}

/// Whether the machine has the memory for a workload; says so when not.
bool fits(const Workload& w) {
    const auto available = available_memory();
    const double needed = workload_memory(w);
    if (!available || needed <= static_cast<double>(*available)) return true;
    print_warning(fmt::format("{} is left out: it needs about {} of memory, {} are available", full_name(w),
                              size_text(needed), size_text(static_cast<double>(*available))));
    return false;
}

nlohmann::ordered_json json_of(const BenchmarkResult& r, double peak) {
    const StepProfile& share = r.profile;
    return {{"name", r.workload.name},
            {"scheme", r.workload.scheme},
            {"dimensions", r.workload.dimensions},
            {"particles", r.particles},
            {"neighbours", r.neighbours},
            {"listed_neighbours_per_cluster", r.listed_neighbours},
            {"threads", r.threads},
            {"particle_evaluations_per_second", r.evaluations_per_second},
            {"nanoseconds_per_particle_evaluation", r.nanoseconds_per_evaluation()},
            {"nanoseconds_per_directed_pair", r.nanoseconds_per_pair()},
            {"directed_pairs_per_second_per_core", r.pairs_per_second()},
            {"useful_gigaflops_per_core", r.useful_rate()},
            {"share_of_fma_peak", r.useful_rate() / peak},
            {"bytes_per_particle", r.bytes_per_particle},
            {"steps_per_list_build", r.steps_per_list_build},
            {"skin_in_smoothing_lengths", r.skin},
            {"phase_shares",
             {{"lists", share.lists},
              {"gradients", share.gradients},
              {"forces", share.forces},
              {"walls", share.walls},
              {"particles", share.particles}}}};
}

void print_header() {
    fmt::print("\n{:<24} {:>9} {:>7} {:>7} {:>10} {:>7} {:>11} {:>8} {:>6} {:>9}\n", "workload/scheme",
               "particles", "neigh-", "threads", "ns per", "ns per", "M pairs/s", "GFLOP/s", "% of",
               "bytes per");
    fmt::print("{:<24} {:>9} {:>7} {:>7} {:>10} {:>7} {:>11} {:>8} {:>6} {:>9}\n", "", "", "bours", "",
               "evaluation", "pair", "and core", "and core", "peak", "particle");
}

void print_row(const BenchmarkResult& r, double peak) {
    fmt::print("{:<24} {:>9} {:>7.1f} {:>7} {:>10.1f} {:>7.2f} {:>11.0f} {:>8.1f} {:>6.1f} {:>9.0f}\n",
               full_name(r.workload), r.particles, r.neighbours, r.threads, r.nanoseconds_per_evaluation(),
               r.nanoseconds_per_pair(), 1e-6 * r.pairs_per_second(), r.useful_rate(),
               100.0 * r.useful_rate() / peak, r.bytes_per_particle);
    std::fflush(stdout);
}

void print_phases(const std::vector<BenchmarkResult>& results) {
    fmt::print("\n{:<24} {:>5} {:>11} {:>9}   {}\n", "workload/scheme", "skin", "steps per", "listed/",
               "% of a step");
    fmt::print("{:<24} {:>5} {:>11} {:>9} {:>9} {:>9} {:>9} {:>9} {:>9}\n", "", "/h", "list build", "cluster",
               "lists", "gradients", "forces", "walls", "particles");
    for (const BenchmarkResult& r : results) {
        const StepProfile& share = r.profile;
        fmt::print("{:<24} {:>5.2f} {:>11.1f} {:>9.1f} {:>9.1f} {:>9.1f} {:>9.1f} {:>9.1f} {:>9.1f}\n",
                   full_name(r.workload), r.skin, r.steps_per_list_build, r.listed_neighbours,
                   100.0 * share.lists, 100.0 * share.gradients, 100.0 * share.forces, 100.0 * share.walls,
                   100.0 * share.particles);
    }
}

void bench(const BenchVerb& verb) {
    const std::vector<Workload> chosen = chosen_workloads(verb);
    const std::string set = instruction_set_name(active_instruction_set());
    const double peak = measure_peak_rate(active_instruction_set());
    const std::string processor = processor_name();
    if (!verb.json) {
        fmt::print(
            "riffle {}, {}\n{}, {} instructions, FMA peak {:.1f} GFLOP/s of a core (single precision)\n",
            version(), build_description(), processor, set, peak);
        print_header();
    }
    std::vector<BenchmarkResult> results;
    for (const Workload& w : chosen) {
        if (!fits(w)) continue;
        results.push_back(run_benchmark(w, verb.threads, verb.repetitions, verb.seconds));
        if (!verb.json) print_row(results.back(), peak);
    }
    if (results.empty()) {
        throw RunError("this machine has not enough memory for any of the workloads; choose smaller ones");
    }
    if (!verb.json) {
        print_phases(results);
        return;
    }
    nlohmann::ordered_json array = nlohmann::ordered_json::array();
    for (const BenchmarkResult& r : results) array.push_back(json_of(r, peak));
    const nlohmann::ordered_json json = {
        {"version", version()},   {"build", build_description()},        {"processor", processor},
        {"instruction_set", set}, {"fma_peak_gigaflops_per_core", peak}, {"workloads", array}};
    fmt::print("{}\n", json.dump(2));
}

}  // namespace

void add_verb_bench(CLI::App& app) {
    const auto verb = std::make_shared<BenchVerb>();
    CLI::App* const command =
        app.add_subcommand("bench", "Measure the speed of standard workloads on this machine");
    CLI::Option* const names = command->add_option(
        "workloads", verb->names,
        "Names: channel-2d-5k, -50k, -1m, channel-3d-200k, -1m, -8m, each alone or with "
        "/plain, /default or, in 3D, /spheres or /resolved (default: channel-2d-5k, -50k and channel-3d-200k, plain and default)");
    command
        ->add_flag("--all", verb->all, "All workloads: half an hour, the largest holds 8 million particles")
        ->excludes(names);
    add_threads_option(*command, verb->threads, "Threads (0: all processors that may be used)")
        ->capture_default_str();
    command->add_option("--repetitions", verb->repetitions, "Timed parts; the median counts")
        ->check(positive_number())
        ->capture_default_str();
    command
        ->add_option("--seconds", verb->seconds,
                     "Least length of a part, s; it lasts until the lists are built again")
        ->check(positive_number())
        ->capture_default_str();
    command->add_flag("--json", verb->json, "Print JSON");
    command->footer(
        "Scheme `default` is Riffle's; `plain` leaves out velocity gradient, correction and closure;\n"
        "  `spheres` has the anisotropic closure of Czernuszenko & Rylov over spheres at their places;\n"
        "  `resolved` has eddies that the particles carry, over the same\n"
        "  neighbours   particles within the kernel's support, fluid and wall: the directed pairs of one\n"
        "  evaluation   of the force on one particle, everything of a step included: time of one core, ns\n"
        "  pair         directed pair within the support: the same time over the neighbours\n"
        "  GFLOP/s      arithmetic of these pairs by the formulas, of one core, and its share of the "
        "largest\n"
        "               rate of multiply-adds that this program reaches on a core of the machine\n"
        "  skin/h       reach of the lists beyond the kernel (numerics.skin)\n"
        "  % of a step  lists: sorting, clusters, lists and the test whether they hold; gradients, forces:\n"
        "               the two sums over neighbours; walls: extrapolation; particles: all else\n"
        "A workload for which the memory does not suffice is left out with a warning.\n"
        "Examples:\n"
        "  riffle bench\n"
        "  riffle bench channel-3d-1m/default --threads 0\n"
        "  riffle bench --all --repetitions 3 --json > speed.json\n"
        "  RIFFLE_INSTRUCTION_SET=avx2 riffle bench channel-2d-50k");
    command->callback([verb] { bench(*verb); });
}

}  // namespace riffle::inline cli
