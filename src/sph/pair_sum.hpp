#pragma once

#include <cmath>
#include <memory>

#include "sph/pair_loops.hpp"
#include "sph/scalar_kernel.hpp"

namespace riffle::inline sph {

/// What the sums beside the pair loops need.
template <int D>
class PairSumConstants {
  public:
    PairSumConstants(const FixedPoint<D>& fixed_point, KernelKind kernel, double smoothing_length)
        : fixed_point_(fixed_point),
          kernel_(scalar_kernel<D>(kernel)),
          h_(smoothing_length),
          value_scale_(std::pow(h_, -D)),
          gradient_scale_(std::pow(h_, -(D + 2))) {}

    [[nodiscard]] const FixedPoint<D>& fixed_point() const { return fixed_point_; }
    [[nodiscard]] double smoothing_length() const { return h_; }
    [[nodiscard]] double support() const { return 2.0 * h_; }
    /// W (1/m^D) and the factor F of its gradient F r (1/m^(D+2)) at a squared distance (m2).
    [[nodiscard]] double value(double squared) const {
        return value_scale_ * kernel_.value(std::sqrt(squared) / h_);
    }
    [[nodiscard]] double gradient_factor(double squared) const {
        return gradient_scale_ * kernel_.gradient_factor(std::sqrt(squared) / h_);
    }

  private:
    FixedPoint<D> fixed_point_;
    ScalarKernel kernel_;
    double h_;
    double value_scale_;
    double gradient_scale_;
};

/// An option of the scheme as a further sum over the lists, beside the pair loops: in double precision, plain
/// and slower than they are. Only cases that choose such an option pay for it.
template <int D, class Real>
class PairSum {
  public:
    PairSum() = default;
    PairSum(const PairSum&) = delete;
    PairSum& operator=(const PairSum&) = delete;
    virtual ~PairSum() = default;

    /// Before the sums of an evaluation: the motion records and the walls hold the state that it starts from.
    virtual void begin(const PairData<D, Real>& data, const Clusters<D>& clusters) = 0;
    /// Complete the sums of the gradient pass of a block, before density and stress follow from them.
    virtual void complete(const PairData<D, Real>& data, const Clusters<D>& clusters, std::size_t begin,
                          std::size_t end, GradientResult<D, Real>& sums) const = 0;
    [[nodiscard]] virtual std::size_t bytes() const { return 0; }
};

// The sums, one file each; equations and sources in docs/theory.md, sections 4 and 5. Which of them a case
// asks for says make_pair_sums() (engine/pair_setup.hpp).
template <int D, class Real>
[[nodiscard]] std::unique_ptr<PairSum<D, Real>> make_antuono_diffusion(const PairSumConstants<D>& constants,
                                                                       double coefficient);
template <int D, class Real>
[[nodiscard]] std::unique_ptr<PairSum<D, Real>> make_shepard_correction(const PairSumConstants<D>& constants,
                                                                        bool pressure, bool gradient);

}  // namespace riffle::inline sph
