#include <algorithm>
#include <array>
#include <cstdlib>
#include <stdexcept>
#include <string>

#include "base/error.hpp"
#include "sph/loop_table.hpp"
#include "sph/particle_loop_table.hpp"
#include "sph/processor_instructions.hpp"

namespace riffle::inline sph {

namespace {

bool processor_offers(InstructionSet set) {
    switch (set) {
        case InstructionSet::baseline:
            return true;
        case InstructionSet::avx2:
            return processor_offers_avx2();
        case InstructionSet::avx512:
            return processor_offers_avx512();
    }
    return false;
}

/// An instruction set that this program holds the loops of.
struct BuiltSet {
    InstructionSet set;
    LoopTable (*loops)();
    ParticleLoopTable (*particle_loops)();
};

/// Those that cmake/instruction_sets.cmake was asked for, the best one first.
constexpr std::array built_sets = {
#include "riffle_instruction_sets.inc"
};

const BuiltSet* find_built(InstructionSet set) {
    const auto* const found = std::find_if(built_sets.begin(), built_sets.end(),
                                           [set](const BuiltSet& built) { return built.set == set; });
    return found == built_sets.end() ? nullptr : found;
}

const BuiltSet& built(InstructionSet set) {
    const BuiltSet* const found = find_built(set);
    if (found == nullptr) {
        throw std::logic_error("this program holds no loops for " + instruction_set_name(set));
    }
    return *found;
}

InstructionSet wished(const std::string& wish) {
    for (const InstructionSet set :
         {InstructionSet::avx512, InstructionSet::avx2, InstructionSet::baseline}) {
        if (instruction_set_name(set) != wish) continue;
        if (!processor_offers(set)) {
            throw InputError(
                "RIFFLE_INSTRUCTION_SET=" + wish +
                ": this processor does not offer it; choose a smaller one or unset the variable");
        }
        if (find_built(set) == nullptr) {
            throw InputError("RIFFLE_INSTRUCTION_SET=" + wish +
                             ": this program was built without it; unset the variable, or build with "
                             "-DRIFFLE_INSTRUCTION_SETS=all");
        }
        return set;
    }
    throw InputError("RIFFLE_INSTRUCTION_SET=" + wish + ": expected baseline, avx2 or avx512");
}

InstructionSet choose() {
    // Read once at start, before any thread exists.
    if (const char* wish = std::getenv("RIFFLE_INSTRUCTION_SET")) {  // NOLINT(concurrency-mt-unsafe)
        return wished(wish);
    }
    for (const BuiltSet& built : built_sets) {
        if (processor_offers(built.set)) return built.set;
    }
    throw InputError(
        "this program was built for a processor with other instructions than this one has; build it on this "
        "machine, or with -DRIFFLE_INSTRUCTION_SETS=all");
}

}  // namespace

bool instruction_set_available(InstructionSet set) {
    return find_built(set) != nullptr && processor_offers(set);
}

std::string instruction_set_name(InstructionSet set) {
    switch (set) {
        case InstructionSet::baseline:
            return "baseline";
        case InstructionSet::avx2:
            return "avx2";
        case InstructionSet::avx512:
            return "avx512";
    }
    return "unknown";
}

InstructionSet active_instruction_set() {
    static const InstructionSet set = choose();
    return set;
}

namespace {

template <bool single, class S, class D>
auto single_or_double(S in_single, D in_double) {
    if constexpr (single) {
        return in_single;
    } else {
        return in_double;
    }
}

}  // namespace

LoopTable loop_table(InstructionSet set) { return built(set).loops(); }

template <int D, class Real>
PairLoops<D, Real> pair_loops(const LoopOptions& options, InstructionSet set) {
    const LoopTable table = loop_table(set);
    constexpr bool single = std::is_same_v<Real, float>;
    if constexpr (D == 2) {
        return single_or_double<single>(table.plane_single, table.plane_double)(options);
    } else {
        return single_or_double<single>(table.space_single, table.space_double)(options);
    }
}

template <int D, class Real>
PairLoops<D, Real> pair_loops(const LoopOptions& options) {
    return pair_loops<D, Real>(options, active_instruction_set());
}

template PairLoops<2, float> pair_loops<2, float>(const LoopOptions&);
template PairLoops<2, double> pair_loops<2, double>(const LoopOptions&);
template PairLoops<3, float> pair_loops<3, float>(const LoopOptions&);
template PairLoops<3, double> pair_loops<3, double>(const LoopOptions&);
template PairLoops<2, float> pair_loops<2, float>(const LoopOptions&, InstructionSet);
template PairLoops<2, double> pair_loops<2, double>(const LoopOptions&, InstructionSet);
template PairLoops<3, float> pair_loops<3, float>(const LoopOptions&, InstructionSet);
template PairLoops<3, double> pair_loops<3, double>(const LoopOptions&, InstructionSet);

template <int D, class Real>
ParticleLoops<D, Real> particle_loops(InstructionSet set) {
    const ParticleLoopTable table = built(set).particle_loops();
    constexpr bool single = std::is_same_v<Real, float>;
    if constexpr (D == 2) {
        return single_or_double<single>(table.plane_single, table.plane_double);
    } else {
        return single_or_double<single>(table.space_single, table.space_double);
    }
}

template <int D, class Real>
ParticleLoops<D, Real> particle_loops() {
    return particle_loops<D, Real>(active_instruction_set());
}

template ParticleLoops<2, float> particle_loops<2, float>();
template ParticleLoops<2, double> particle_loops<2, double>();
template ParticleLoops<3, float> particle_loops<3, float>();
template ParticleLoops<3, double> particle_loops<3, double>();
template ParticleLoops<2, float> particle_loops<2, float>(InstructionSet);
template ParticleLoops<2, double> particle_loops<2, double>(InstructionSet);
template ParticleLoops<3, float> particle_loops<3, float>(InstructionSet);
template ParticleLoops<3, double> particle_loops<3, double>(InstructionSet);

template <int D>
NeighbourSearchFunction<D> neighbour_search(InstructionSet set) {
    if constexpr (D == 2) {
        return built(set).particle_loops().plane_search;
    } else {
        return built(set).particle_loops().space_search;
    }
}

template <int D>
NeighbourSearchFunction<D> neighbour_search() {
    return neighbour_search<D>(active_instruction_set());
}

template NeighbourSearchFunction<2> neighbour_search<2>();
template NeighbourSearchFunction<3> neighbour_search<3>();
template NeighbourSearchFunction<2> neighbour_search<2>(InstructionSet);
template NeighbourSearchFunction<3> neighbour_search<3>(InstructionSet);

}  // namespace riffle::inline sph
