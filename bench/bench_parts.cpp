// Micro-benchmarks of the parts of a step, on one thread. `items_per_second` counts particles, or directed
// pairs within the support where the name says pairs. Select with --benchmark_filter=REGEX, for example
// '3d.*avx2'.

#include <benchmark/benchmark.h>

#include <algorithm>
#include <functional>
#include <memory>
#include <string>

#include "base/parallel.hpp"
#include "channel.hpp"

namespace riffle::bench {

namespace {

/// Measure `part`, which treats `items` at a time.
void measure(const std::string& name, double items, const std::function<void()>& part) {
    benchmark::RegisterBenchmark(name.c_str(), [items, part](benchmark::State& state) {
        for (auto _ : state) {
            part();
            benchmark::ClobberMemory();
        }
        state.SetItemsProcessed(static_cast<std::int64_t>(items * static_cast<double>(state.iterations())));
    });
}

/// What does not depend on scheme and instruction set.
template <int D>
void register_lists(const std::string& dimensions, const std::shared_ptr<Channel<D>>& c) {
    const auto particles = static_cast<double>(c->particles.size());
    measure("sort/" + dimensions, particles, [c] {
        benchmark::DoNotOptimize(
            spatial_order<D>(c->domain, c->positions(), c->column_width, 0.5 * c->scheme.spacing));
    });
    measure("clusters/" + dimensions, particles, [c] {
        benchmark::DoNotOptimize(
            build_clusters<D>(c->domain, c->fixed_point, c->positions(), c->column_width));
    });
    measure("list/" + dimensions, particles, [c] {
        benchmark::DoNotOptimize(build_neighbour_list<D>(c->clusters, c->clusters, c->fixed_point, c->range));
    });
    measure("spell/" + dimensions, particles, [c] {
        for (std::size_t cluster = 0; cluster < c->clusters.size(); ++cluster) {
            benchmark::DoNotOptimize(c->fluid_fluid.spell(cluster, c->work.slots.data()));
        }
    });
}

/// The search alone, without the arrays of the list.
template <int D>
void register_search(const std::string& suffix, InstructionSet set, const std::shared_ptr<Channel<D>>& c) {
    measure("search/" + suffix, static_cast<double>(c->particles.size()),
            [c, find = neighbour_search<D>(set)] {
                const NeighbourSearch<D> search{
                    .i = &c->clusters, .j = &c->clusters, .fixed_point = &c->fixed_point, .range = c->range};
                for (std::size_t begin = 0; begin < c->clusters.size(); begin += NeighbourBlock::size) {
                    NeighbourBlock block;
                    find(search, begin, std::min(c->clusters.size(), begin + NeighbourBlock::size), block);
                    benchmark::DoNotOptimize(block.neighbours);
                }
            });
}

template <int D>
void register_sums(const std::string& suffix, InstructionSet set, const std::shared_ptr<Channel<D>>& c) {
    const PairLoops<D, float> loops = pair_loops<D, float>({.gradients = c->gradients}, set);
    const auto sweep = [&](const std::string& name, double items, const Clusters<D>& clusters,
                           typename PairLoops<D, float>::Loop loop) {
        measure(name + "/" + suffix, items, [c, &clusters, loop] {
            Channel<D>::for_blocks(
                clusters, [&](std::size_t begin, std::size_t end) { loop(c->data, begin, end, c->work); });
        });
    };
    const double pairs = c->directed_pairs();
    sweep("gradient_pairs", pairs, c->clusters, loops.gradient);
    sweep("force_pairs", pairs, c->clusters, loops.force);
    sweep("wall_extrapolation", static_cast<double>(c->walls.size()), c->wall_clusters, loops.wall);
}

template <int D>
void register_particle_loops(const std::string& suffix, InstructionSet set,
                             const std::shared_ptr<Channel<D>>& c) {
    const ParticleLoops<D, float> loops = particle_loops<D, float>(set);
    const auto sweep = [&](const std::string& name, auto loop) {
        measure(name + "/" + suffix, static_cast<double>(c->particles.size()),
                [c, loop] { Channel<D>::for_blocks(c->clusters, loop); });
    };
    // Steps of no length: the particles stay where they are.
    sweep("stress", [c, loops](std::size_t begin, std::size_t end) {
        loops.stress(c->particle_data, c->data, c->work, c->particle_work, 0.0, begin, end);
    });
    sweep("advance", [c, loops](std::size_t begin, std::size_t end) {
        loops.advance(c->particle_data, c->work, c->particle_work, {}, begin, end);
    });
    sweep("pack", [c, loops](std::size_t begin, std::size_t end) {
        loops.pack(c->particle_data, c->data, &c->moved, begin, end);
    });
    sweep("displaced", [c, loops](std::size_t begin, std::size_t end) {
        benchmark::DoNotOptimize(loops.displaced(c->data, c->fixed_point, c->moved, begin, end));
    });
}

template <int D>
void register_all(const std::string& dimensions) {
    const auto full = std::make_shared<Channel<D>>("default");
    const auto plain = std::make_shared<Channel<D>>("plain");
    register_lists<D>(dimensions, full);
    for (const InstructionSet set :
         {InstructionSet::baseline, InstructionSet::avx2, InstructionSet::avx512}) {
        if (!instruction_set_available(set)) {
            continue;
        }
        const std::string name = instruction_set_name(set);
        register_search<D>(dimensions + "/" + name, set, full);
        register_sums<D>(dimensions + "/default/" + name, set, full);
        register_sums<D>(dimensions + "/plain/" + name, set, plain);
        register_particle_loops<D>(dimensions + "/default/" + name, set, full);
        register_particle_loops<D>(dimensions + "/plain/" + name, set, plain);
    }
}

}  // namespace

}  // namespace riffle::bench

int main(int argc, char** argv) {
    riffle::set_thread_count(1);
    riffle::bench::register_all<2>("2d");
    riffle::bench::register_all<3>("3d");
    benchmark::Initialize(&argc, argv);
    if (benchmark::ReportUnrecognizedArguments(argc, argv)) {
        return 2;
    }
    benchmark::RunSpecifiedBenchmarks();
    benchmark::Shutdown();
    return 0;
}
