#pragma once

#include <cstddef>
#include <vector>

namespace riffle {

/// Values by particle in the precision that they were computed in, so that those of single precision take
/// half of the memory; read as doubles, times a factor.
class WorkingValues {
  public:
    /// Take so many values, all zero.
    template <class Real>
    void reset(std::size_t n, double factor = 1.0) {
        factor_ = factor;
        if constexpr (sizeof(Real) == sizeof(float)) {
            single_.assign(n, 0.0F);
        } else {
            double_.assign(n, 0.0);
        }
    }
    void release() {
        std::vector<float>().swap(single_);
        std::vector<double>().swap(double_);
    }

    void set(std::size_t i, float value) { single_[i] = value; }
    void set(std::size_t i, double value) { double_[i] = value; }
    [[nodiscard]] double operator[](std::size_t i) const {
        return factor_ * (single_.empty() ? double_[i] : static_cast<double>(single_[i]));
    }
    [[nodiscard]] std::size_t size() const { return single_.size() + double_.size(); }
    [[nodiscard]] std::size_t bytes() const {
        return single_.capacity() * sizeof(float) + double_.capacity() * sizeof(double);
    }

  private:
    std::vector<float> single_;
    std::vector<double> double_;
    double factor_ = 1.0;
};

}  // namespace riffle
