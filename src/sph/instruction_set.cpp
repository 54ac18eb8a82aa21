#include <array>
#include <cstdlib>
#include <string>

#include "base/error.hpp"
#include "sph/pair_loops.hpp"

namespace riffle {

namespace baseline {
PairLoops<2, float> loops_2d_single(KernelKind kernel, ViscosityForm viscosity);
PairLoops<2, double> loops_2d_double(KernelKind kernel, ViscosityForm viscosity);
}  // namespace baseline
namespace avx2 {
PairLoops<2, float> loops_2d_single(KernelKind kernel, ViscosityForm viscosity);
PairLoops<2, double> loops_2d_double(KernelKind kernel, ViscosityForm viscosity);
}  // namespace avx2
namespace avx512 {
PairLoops<2, float> loops_2d_single(KernelKind kernel, ViscosityForm viscosity);
PairLoops<2, double> loops_2d_double(KernelKind kernel, ViscosityForm viscosity);
}  // namespace avx512

namespace {

bool processor_offers(InstructionSet set) {
    __builtin_cpu_init();
    switch (set) {
        case InstructionSet::baseline:
            return true;
        case InstructionSet::avx2:
            return __builtin_cpu_supports("avx2") != 0 && __builtin_cpu_supports("fma") != 0;
        case InstructionSet::avx512:
            return __builtin_cpu_supports("avx512f") != 0 && __builtin_cpu_supports("avx512vl") != 0 &&
                   __builtin_cpu_supports("avx512dq") != 0 && __builtin_cpu_supports("avx512bw") != 0;
    }
    return false;
}

constexpr std::array<InstructionSet, 3> all_sets = {InstructionSet::avx512, InstructionSet::avx2,
                                                    InstructionSet::baseline};

InstructionSet choose() {
    // Read once at start, before any thread exists.
    const char* wish = std::getenv("RIFFLE_INSTRUCTION_SET");  // NOLINT(concurrency-mt-unsafe)
    for (const InstructionSet set : all_sets) {
        if (wish == nullptr ? processor_offers(set) : instruction_set_name(set) == wish) {
            if (!processor_offers(set)) {
                throw InputError(
                    "RIFFLE_INSTRUCTION_SET=" + std::string(wish) +
                    ": this processor does not offer it; choose a smaller one or unset the variable");
            }
            return set;
        }
    }
    throw InputError("RIFFLE_INSTRUCTION_SET=" + std::string(wish) + ": expected baseline, avx2 or avx512");
}

}  // namespace

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

template <>
PairLoops<2, float> pair_loops<2, float>(KernelKind kernel, ViscosityForm viscosity) {
    switch (active_instruction_set()) {
        case InstructionSet::avx512:
            return avx512::loops_2d_single(kernel, viscosity);
        case InstructionSet::avx2:
            return avx2::loops_2d_single(kernel, viscosity);
        case InstructionSet::baseline:
            break;
    }
    return baseline::loops_2d_single(kernel, viscosity);
}

template <>
PairLoops<2, double> pair_loops<2, double>(KernelKind kernel, ViscosityForm viscosity) {
    switch (active_instruction_set()) {
        case InstructionSet::avx512:
            return avx512::loops_2d_double(kernel, viscosity);
        case InstructionSet::avx2:
            return avx2::loops_2d_double(kernel, viscosity);
        case InstructionSet::baseline:
            break;
    }
    return baseline::loops_2d_double(kernel, viscosity);
}

}  // namespace riffle
