// The kernel correction (Shepard 1968; Bonet & Lok 1999): the kernel and its gradient over the sum of the
// kernel,
//
//     B_i = I + b_i (1/S_i - 1) I,   S_i = sum_j V_j W_ij,
//
// in place of the inverse of the first moments. S of all neighbours for the pressure, with the blend b of the
// corrected form near a free surface; of the fluid for the velocity gradient, whose sum is over the fluid.

#include "sph/correction.hpp"
#include "sph/listed_pairs.hpp"
#include "sph/pair_sum.hpp"

namespace riffle::inline sph {

namespace {

template <int D, class Real>
class ShepardCorrection final : public PairSum<D, Real> {
  public:
    ShepardCorrection(const PairSumConstants<D>& constants, bool pressure, bool gradient)
        : constants_(constants), pressure_(pressure), gradient_(gradient) {}

    void begin(const PairData<D, Real>&, const Clusters<D>&) override {}

    void complete(const PairData<D, Real>& data, const Clusters<D>& clusters, std::size_t begin,
                  std::size_t end, GradientResult<D, Real>& sums) const override {
        LaneArray<double> sum{};
        add(*data.fluid_fluid, data, data.motion, clusters, begin, end, sum);
        // Lanes without a particle keep what the loops left.
        const auto for_lanes = [&](const auto& f) {
            for (std::size_t lane = 0; lane < (end - begin) * cluster_size; ++lane) {
                if (clusters.particle_of(begin * cluster_size + lane) >= 0) f(lane);
            }
        };
        if (gradient_) {
            for (auto& component : sums.velocity_gradient) {
                for_lanes([&](std::size_t lane) {
                    component[lane] = static_cast<Real>(static_cast<double>(component[lane]) / sum[lane]);
                });
            }
        }
        if (!pressure_) return;
        if (data.fluid_wall != nullptr) {
            add(*data.fluid_wall, data, data.wall_gradient, clusters, begin, end, sum);
        }
        for_lanes([&](std::size_t lane) {
            const auto blend = smoothstep<double>(0.6, 0.9, static_cast<double>(sums.regularity[lane]));
            const auto factor = static_cast<Real>(1.0 + blend * (1.0 / sum[lane] - 1.0));
            for (std::size_t k = 0; k < D; ++k) {
                for (std::size_t l = 0; l < D; ++l) {
                    sums.correction[k * D + l][lane] = k == l ? factor : Real(0);
                }
            }
            sums.viscosity_factor[lane] = factor;
        });
    }

  private:
    template <class Record>
    void add(const NeighbourList& list, const PairData<D, Real>& data, const std::vector<Record>& records,
             const Clusters<D>& clusters, std::size_t begin, std::size_t end, LaneArray<double>& sum) const {
        for_listed_pairs<D>(list, clusters, data.motion, records, constants_.fixed_point(),
                            constants_.support(), begin, end,
                            [&](std::size_t i, std::size_t j, const Vec<D>&, double squared) {
                                sum[i - begin * cluster_size] +=
                                    static_cast<double>(records[j].volume) * constants_.value(squared);
                            });
    }

    PairSumConstants<D> constants_;
    bool pressure_;
    bool gradient_;
};

}  // namespace

template <int D, class Real>
std::unique_ptr<PairSum<D, Real>> make_shepard_correction(const PairSumConstants<D>& constants, bool pressure,
                                                          bool gradient) {
    return std::make_unique<ShepardCorrection<D, Real>>(constants, pressure, gradient);
}

template std::unique_ptr<PairSum<2, float>> make_shepard_correction(const PairSumConstants<2>&, bool, bool);
template std::unique_ptr<PairSum<2, double>> make_shepard_correction(const PairSumConstants<2>&, bool, bool);
template std::unique_ptr<PairSum<3, float>> make_shepard_correction(const PairSumConstants<3>&, bool, bool);
template std::unique_ptr<PairSum<3, double>> make_shepard_correction(const PairSumConstants<3>&, bool, bool);

}  // namespace riffle::inline sph
