#pragma once

#include <cstddef>
#include <span>
#include <vector>

namespace riffle::inline particles {

/// Two arrays seen as one: values of the particles, then those of their images behind walls. Both must
/// outlive it.
class JoinedValues {
  public:
    JoinedValues() = default;
    JoinedValues(std::span<const double> own, std::span<const double> images = {})
        : own_(own), images_(images) {}
    JoinedValues(const std::vector<double>& own) : own_(own) {}

    [[nodiscard]] std::size_t size() const { return own_.size() + images_.size(); }
    [[nodiscard]] double operator[](std::size_t i) const {
        return i < own_.size() ? own_[i] : images_[i - own_.size()];
    }

  private:
    std::span<const double> own_;
    std::span<const double> images_;
};

}  // namespace riffle::inline particles
