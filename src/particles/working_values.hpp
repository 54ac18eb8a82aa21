#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

namespace riffle::inline particles {

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
    /// Keep those of these particles alone, in this order, which is that of the numbers.
    void keep(const std::vector<std::int32_t>& particles) {
        keep_values(single_, particles);
        keep_values(double_, particles);
    }
    [[nodiscard]] std::size_t size() const { return single_.size() + double_.size(); }
    [[nodiscard]] std::size_t bytes() const {
        return single_.capacity() * sizeof(float) + double_.capacity() * sizeof(double);
    }

    template <class T>
    static void keep_values(std::vector<T>& values, const std::vector<std::int32_t>& particles) {
        if (values.empty()) return;
        for (std::size_t i = 0; i < particles.size(); ++i) {
            values[i] = values[static_cast<std::size_t>(particles[i])];
        }
        values.resize(particles.size());
    }

  private:
    std::vector<float> single_;
    std::vector<double> double_;
    double factor_ = 1.0;
};

}  // namespace riffle::inline particles
