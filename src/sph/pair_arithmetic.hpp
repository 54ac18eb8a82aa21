#pragma once

namespace riffle::inline sph {

/// Floating-point operations of one directed pair within the support, by the formulas of pair_loops_impl.hpp
/// for the Wendland kernel and Morris' viscosity; an addition, multiplication, square root or maximum counts
/// one, a multiply-add two. Not counted: integers, conversions, broadcasts, and the lanes outside of the
/// support. For particles and walls alike, which differ by a few operations.
struct PairOperations {
    int gradient_pass = 0;
    int force_pass = 0;
    [[nodiscard]] constexpr int sum() const { return gradient_pass + force_pass; }
};

/// `gradients`: with velocity gradient, correction matrix and stress tensor (default scheme); without: the
/// divergence and the pressure alone (plain scheme).
/// `directional`: with the viscosity weighed by the direction of the pair.
[[nodiscard]] constexpr PairOperations pair_operations(int dimensions, bool gradients,
                                                       bool directional = false) {
    const int d = dimensions;
    const int distance = d              // r = unit * (x_i - x_j)
                         + (2 * d - 1)  // r.r
                         + 1;           // q = sqrt(r.r)
    const int weight = 3                // t = max(1 - q/2, 0)
                       + 2              // t t t
                       + 1;             // times volume or weight
    const int velocity = d;             // u_i - u_j
    const int common = distance + weight + velocity;
    const int diffusion = 1               // s_i - s_j
                          + 2             // + k r_z
                          + 2;            // times weight, summed
    const int divergence = (2 * d - 1)    // u.r
                           + 2;           // times weight, summed
    const int gradient = d                // weight r_l
                         + 2 * d * d      // u_k weight r_l, summed
                         + d * (d + 1);   // r_k weight r_l, summed; upper triangle
    const int pressure = 1                // p_i + p_j
                         + 1              // times weight
                         + 2 * d;         // times r, summed
    const int stress = d * d              // Q_i + Q_j
                       + d * (2 * d - 1)  // (Q_i + Q_j) r
                       + 2 * d;           // times weight, summed
    const int viscosity = 2               // (root_i + root_j)^2
                          + 1             // times weight
                          + 2 * d;        // times u, summed
    const int direction = 4               // slope r_y r_y / (r.r + tiny)
                          + 3             // eddy and molecular part, times weight
                          + 2 * 3;        // two factors
    return {
        .gradient_pass = common + diffusion + (gradients ? gradient : divergence),
        .force_pass = common + (gradients ? stress : pressure) + viscosity + (directional ? direction : 0)};
}

// Written out once: 2D plain 24 + 27, default 35 + 35; 3D plain 30 + 35, default 56 + 57.
static_assert(pair_operations(2, false).sum() == 51 && pair_operations(2, true).sum() == 70);
static_assert(pair_operations(3, false).sum() == 65 && pair_operations(3, true).sum() == 113);

}  // namespace riffle::inline sph
