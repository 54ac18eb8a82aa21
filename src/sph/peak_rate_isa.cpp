// Compiled once per instruction set, RIFFLE_ISA naming it (see cmake/instruction_sets.cmake).

#include <array>
#include <experimental/simd>

#include "sph/peak_rate.hpp"

namespace riffle::inline sph::RIFFLE_ISA {

namespace {

using Register = std::experimental::native_simd<float>;

/// Processors finish up to two multiply-adds per cycle and need up to five cycles for each: ten in flight
/// fill them. Twelve and the two factors fit into 16 registers.
constexpr std::size_t chains = 12;

float multiply_adds(std::int64_t turns) {
    // Each chain tends to offset / (1 - factor): no infinities, no denormal numbers.
    Register factor(0.5F);
    Register offset(0.25F);
    std::array<Register, chains> x{};
    for (std::size_t k = 0; k < chains; ++k) x[k] = Register(static_cast<float>(k));
    for (std::int64_t turn = 0; turn < turns; ++turn) {
        for (Register& value : x) value = value * factor + offset;
    }
    Register sum(0.0F);
    for (const Register& value : x) sum += value;
    return std::experimental::reduce(sum);
}

}  // namespace

PeakLoop peak_loop() {
    return {.run = &multiply_adds,
            .operations_per_turn = 2.0 * static_cast<double>(chains * Register::size())};
}

}  // namespace riffle::inline sph::RIFFLE_ISA
