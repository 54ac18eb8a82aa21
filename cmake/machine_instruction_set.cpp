// Print the best instruction set of this machine that Riffle has loops for, as src/sph/instruction_set.cpp asks for it.

#include <cstdio>

int main() {
    __builtin_cpu_init();
    const bool avx2 = __builtin_cpu_supports("avx2") && __builtin_cpu_supports("fma");
    const bool avx512 = __builtin_cpu_supports("avx512f") && __builtin_cpu_supports("avx512vl") &&
                        __builtin_cpu_supports("avx512dq") && __builtin_cpu_supports("avx512bw");
    std::fputs(avx512 ? "avx512" : avx2 ? "avx2" : "baseline", stdout);
}
