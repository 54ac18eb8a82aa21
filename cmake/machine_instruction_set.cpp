// Print the best instruction set of this machine that Riffle has loops for.

#include <cstdio>

#include "sph/processor_instructions.hpp"

int main() {
    std::fputs(riffle::processor_offers_avx512() ? "avx512"
               : riffle::processor_offers_avx2() ? "avx2"
                                                 : "baseline",
               stdout);
}
