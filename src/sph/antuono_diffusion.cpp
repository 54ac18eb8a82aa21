// Density diffusion of Antuono et al. (2010, 2012), the delta-SPH term:
//
//     D_i = delta h c0 sum_j V_j [2 (s_i - s_j) - (g_i + g_j).r_ij] F_ij,   g = M^-1 sum_j V_j (s_j - s_i)
//     grad W
//
// between fluid particles alone, g their density's gradient over the same neighbours, M its renormalisation:
// exact for a density that varies linearly, up to the last row at walls and surface.

#include "base/parallel.hpp"
#include "sph/correction.hpp"
#include "sph/listed_pairs.hpp"
#include "sph/pair_sum.hpp"

namespace riffle::inline sph {

namespace {

template <int D, class Real>
class AntuonoDiffusion final : public PairSum<D, Real> {
  public:
    AntuonoDiffusion(const PairSumConstants<D>& constants, double coefficient)
        : constants_(constants), coefficient_(coefficient) {}

    void begin(const PairData<D, Real>& data, const Clusters<D>& clusters) override {
        gradient_.resize(clusters.slots());
        parallel_blocks(clusters.size(), block_clusters, [&](std::size_t begin, std::size_t end) {
            find_gradients(data, clusters, begin, end);
        });
    }

    void complete(const PairData<D, Real>& data, const Clusters<D>& clusters, std::size_t begin,
                  std::size_t end, GradientResult<D, Real>& sums) const override {
        LaneArray<double> diffusion{};
        for_pairs(data, clusters, begin, end,
                  [&](std::size_t i, std::size_t j, const Vec<D>& r, double gradient_factor) {
                      double mean_gradient = 0.0;
                      for (std::size_t k = 0; k < D; ++k) {
                          mean_gradient += (gradient_[i][k] + gradient_[j][k]) * r[k];
                      }
                      const double difference = difference_of(data, i, j);
                      diffusion[i - begin * cluster_size] +=
                          volume(data, j) * (2.0 * difference - mean_gradient) * gradient_factor;
                  });
        for (std::size_t lane = 0; lane < (end - begin) * cluster_size; ++lane) {
            sums.diffusion[lane] = static_cast<Real>(coefficient_ * diffusion[lane]);
        }
    }

    [[nodiscard]] std::size_t bytes() const override { return gradient_.capacity() * sizeof(Vec<D>); }

  private:
    void find_gradients(const PairData<D, Real>& data, const Clusters<D>& clusters, std::size_t begin,
                        std::size_t end) {
        std::array<Symmetric<double, D>, block_lanes> moment{};
        std::array<Vec<D>, block_lanes> sum{};
        for_pairs(data, clusters, begin, end,
                  [&](std::size_t i, std::size_t j, const Vec<D>& r, double gradient_factor) {
                      const std::size_t lane = i - begin * cluster_size;
                      const double weight = volume(data, j) * gradient_factor;
                      const double difference = difference_of(data, i, j);
                      for (int l = 0; l < D; ++l) {
                          const auto axis = static_cast<std::size_t>(l);
                          sum[lane][axis] -= weight * difference * r[axis];
                          for (int k = 0; k <= l; ++k) {
                              moment[lane][symmetric_index<D>(k, l)] -=
                                  weight * r[static_cast<std::size_t>(k)] * r[axis];
                          }
                      }
                  });
        for (std::size_t lane = 0; lane < (end - begin) * cluster_size; ++lane) {
            // As the velocity gradient: of neighbours on one line alone there is no inverse.
            const auto blend = smoothstep<double>(0.1, 0.3, smallest_eigenvalue<double, D>(moment[lane]));
            const Components<double, D* D> inverse_moment =
                pressure_correction<double, D>(moment[lane], Symmetric<double, D>{}, blend);
            Vec<D>& gradient = gradient_[begin * cluster_size + lane];
            for (std::size_t k = 0; k < D; ++k) {
                gradient[k] = 0.0;
                for (std::size_t l = 0; l < D; ++l) gradient[k] += inverse_moment[k * D + l] * sum[lane][l];
            }
        }
    }

    /// f(i, j, r, F) for the pairs of a block.
    template <class F>
    void for_pairs(const PairData<D, Real>& data, const Clusters<D>& clusters, std::size_t begin,
                   std::size_t end, const F& f) const {
        for_listed_pairs<D>(*data.fluid_fluid, clusters, data.motion, data.motion, constants_.fixed_point(),
                            constants_.support(), begin, end,
                            [&](std::size_t i, std::size_t j, const Vec<D>& r, double squared) {
                                f(i, j, r, constants_.gradient_factor(squared));
                            });
    }
    static double volume(const PairData<D, Real>& data, std::size_t j) {
        return static_cast<double>(data.motion[j].volume);
    }
    /// s_i - s_j.
    static double difference_of(const PairData<D, Real>& data, std::size_t i, std::size_t j) {
        return static_cast<double>(data.motion[i].s) - static_cast<double>(data.motion[j].s);
    }

    PairSumConstants<D> constants_;
    double coefficient_;            ///< delta h c0
    std::vector<Vec<D>> gradient_;  ///< of s, by slot
};

}  // namespace

template <int D, class Real>
std::unique_ptr<PairSum<D, Real>> make_antuono_diffusion(const PairSumConstants<D>& constants,
                                                         double coefficient) {
    return std::make_unique<AntuonoDiffusion<D, Real>>(constants, coefficient);
}

template std::unique_ptr<PairSum<2, float>> make_antuono_diffusion(const PairSumConstants<2>&, double);
template std::unique_ptr<PairSum<2, double>> make_antuono_diffusion(const PairSumConstants<2>&, double);
template std::unique_ptr<PairSum<3, float>> make_antuono_diffusion(const PairSumConstants<3>&, double);
template std::unique_ptr<PairSum<3, double>> make_antuono_diffusion(const PairSumConstants<3>&, double);

}  // namespace riffle::inline sph
