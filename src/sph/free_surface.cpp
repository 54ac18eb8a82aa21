#include "sph/free_surface.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "base/parallel.hpp"
#include "sph/kernel_registry.hpp"

namespace riffle {

namespace {

/// Particles sorted into columns of width about 2h.
class Columns {
  public:
    Columns(const Domain<2>& domain, std::span<const double> x, double support)
        : lower_(domain.lower[0]), extent_(domain.extent(0)), periodic_(domain.periodic[0]) {
        count_ = std::max(1, static_cast<int>(extent_ / support));
        members_.resize(static_cast<std::size_t>(count_));
        for (std::size_t i = 0; i < x.size(); ++i) {
            members_[static_cast<std::size_t>(index(x[i]))].push_back(i);
        }
    }

    /// Indices of the particles in the columns around x.
    void around(double x, std::vector<std::size_t>& result) const {
        result.clear();
        const int centre = index(x);
        for (int c = centre - 1; c <= centre + 1; ++c) {
            int column = c;
            if (periodic_ && count_ >= 3) {
                column = (c + count_) % count_;
            } else if (c < 0 || c >= count_) {
                continue;
            }
            const auto& members = members_[static_cast<std::size_t>(column)];
            result.insert(result.end(), members.begin(), members.end());
        }
    }

    [[nodiscard]] double distance(double a, double b) const {
        const double d = a - b;
        return periodic_ ? d - extent_ * std::nearbyint(d / extent_) : d;
    }

  private:
    [[nodiscard]] int index(double x) const {
        return std::clamp(static_cast<int>((x - lower_) / extent_ * count_), 0, count_ - 1);
    }

    double lower_;
    double extent_;
    bool periodic_;
    int count_ = 1;
    std::vector<std::vector<std::size_t>> members_;
};

double gradient_factor(KernelKind kernel, double q) {
    return visit_kernel<2>(kernel, [q](auto chosen) { return decltype(chosen)::gradient_factor(q); });
}

}  // namespace

std::vector<double> surface_elevation(const Domain<2>& domain, std::span<const double> position_x,
                                      std::span<const double> position_z, std::span<const double> volume,
                                      KernelKind kernel, double smoothing_length, std::span<const double> x) {
    const double h = smoothing_length;
    const double scale = 1.0 / (h * h * h * h);
    const Columns columns(domain, position_x, 2.0 * h);
    std::vector<double> elevation(x.size());
    constexpr double threshold = 1.0;  // half of the dimension
    parallel_blocks(x.size(), 16, [&](std::size_t begin, std::size_t end) {
        std::vector<std::size_t> near;
        for (std::size_t n = begin; n < end; ++n) {
            columns.around(x[n], near);
            double top = -std::numeric_limits<double>::infinity();
            for (const std::size_t j : near) {
                top = std::max(top, position_z[j]);
            }
            const auto divergence = [&](double z) {
                double sum = 0.0;
                for (const std::size_t j : near) {
                    const double rz = z - position_z[j];
                    if (std::abs(rz) >= 2.0 * h) {
                        continue;
                    }
                    const double rx = columns.distance(x[n], position_x[j]);
                    const double squared = rx * rx + rz * rz;
                    sum -= volume[j] * squared * gradient_factor(kernel, std::sqrt(squared) / h) * scale;
                }
                return sum;
            };
            elevation[n] = std::numeric_limits<double>::quiet_NaN();
            const double step = 0.25 * h;
            double above = top + 2.0 * h;
            for (double z = above - step; z > domain.lower[1] && !near.empty(); z -= step) {
                if (divergence(z) < threshold) {
                    above = z;
                    continue;
                }
                double low = z;
                double high = above;
                for (int bisection = 0; bisection < 30; ++bisection) {
                    const double middle = 0.5 * (low + high);
                    (divergence(middle) < threshold ? high : low) = middle;
                }
                elevation[n] = 0.5 * (low + high);
                break;
            }
        }
    });
    return elevation;
}

}  // namespace riffle
