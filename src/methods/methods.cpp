#include "methods/by_rates.hpp"
#include "methods/fused.hpp"
#include "methods/method.hpp"

namespace riffle::inline methods {

template <int D>
std::unique_ptr<Stepper<D>> make_stepper(Stepping stepping) {
    switch (stepping) {
        case Stepping::semi_implicit_euler:
        case Stepping::leapfrog:
            return nullptr;
        case Stepping::predictor_corrector:
            return make_predictor_corrector<D>();
        case Stepping::verlet:
            return make_verlet<D>();
        case Stepping::symplectic:
            return make_symplectic<D>();
        case Stepping::beeman:
            return make_beeman<D>();
    }
    return nullptr;
}

template <int D, class Real>
std::unique_ptr<Method<D, Real>> make_method(FlowOf<D, Real>& flow) {
    if (auto stepper = make_stepper<D>(flow.c.numerics.stepping)) {
        return std::make_unique<SteppingByRates<D, Real>>(std::move(stepper), flow);
    }
    if (flow.c.numerics.stepping == Stepping::leapfrog) return std::make_unique<Leapfrog<D, Real>>(flow.c);
    return std::make_unique<SemiImplicitEuler<D, Real>>();
}

template std::unique_ptr<Stepper<2>> make_stepper<2>(Stepping);
template std::unique_ptr<Stepper<3>> make_stepper<3>(Stepping);
template std::unique_ptr<Method<2, float>> make_method(FlowOf<2, float>&);
template std::unique_ptr<Method<2, double>> make_method(FlowOf<2, double>&);
template std::unique_ptr<Method<3, float>> make_method(FlowOf<3, float>&);
template std::unique_ptr<Method<3, double>> make_method(FlowOf<3, double>&);

}  // namespace riffle::inline methods
