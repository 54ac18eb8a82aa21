#pragma once

namespace riffle::inline sph {

// What the processor that runs this offers of what the objects of the instruction sets are compiled for.
// Without other headers: cmake/machine_instruction_set.cpp asks the same when a build for one machine is
// configured.

[[nodiscard]] inline bool processor_offers_avx2() {
    __builtin_cpu_init();
    return __builtin_cpu_supports("avx2") != 0 && __builtin_cpu_supports("fma") != 0;
}

[[nodiscard]] inline bool processor_offers_avx512() {
    __builtin_cpu_init();
    return __builtin_cpu_supports("avx512f") != 0 && __builtin_cpu_supports("avx512vl") != 0 &&
           __builtin_cpu_supports("avx512dq") != 0 && __builtin_cpu_supports("avx512bw") != 0;
}

}  // namespace riffle::inline sph
