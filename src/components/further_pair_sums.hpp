#pragma once

#include <utility>
#include <vector>

#include "engine/component.hpp"
#include "engine/pair_setup.hpp"
#include "sph/pair_sum.hpp"

namespace riffle::inline components {

/// The options of the scheme that are sums of their own over the lists.
template <int D, class Real>
class FurtherPairSums final : public Component<D, Real> {
  public:
    using typename Component<D, Real>::Flow;
    using typename Component<D, Real>::Task;

    explicit FurtherPairSums(std::vector<std::unique_ptr<PairSum<D, Real>>> sums) : sums_(std::move(sums)) {}

    void begin_evaluation(Flow& flow, const Stage& /*stage*/) override {
        for (const auto& sum : sums_) sum->begin(flow.data, flow.clusters);
    }
    void complete_gradients(Flow& flow, Task& task, std::size_t begin, std::size_t end) override {
        for (const auto& sum : sums_) sum->complete(flow.data, flow.clusters, begin, end, task.sums.gradient);
    }
    [[nodiscard]] std::size_t bytes() const override {
        std::size_t total = 0;
        for (const auto& sum : sums_) total += sum->bytes();
        return total;
    }

  private:
    std::vector<std::unique_ptr<PairSum<D, Real>>> sums_;
};

template <int D, class Real>
std::unique_ptr<Component<D, Real>> make_further_pair_sums(FlowOf<D, Real>& flow) {
    auto sums = make_pair_sums<D, Real>(flow.c, flow.scheme, flow.fixed_point);
    return sums.empty() ? nullptr : std::make_unique<FurtherPairSums<D, Real>>(std::move(sums));
}

}  // namespace riffle::inline components
