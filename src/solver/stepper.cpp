#include "solver/stepper.hpp"

namespace riffle {

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

template std::unique_ptr<Stepper<2>> make_stepper<2>(Stepping);
template std::unique_ptr<Stepper<3>> make_stepper<3>(Stepping);

}  // namespace riffle
